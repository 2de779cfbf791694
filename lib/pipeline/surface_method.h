// SPDX-License-Identifier: MIT
// l3d_surface_method: a way to draw a scene's surfaces; the seam between methods that are compared.
#ifndef L3D_PIPELINE_SURFACE_METHOD_H
#define L3D_PIPELINE_SURFACE_METHOD_H

#include "base/public.h"
#include "geom/matrix.h"
#include "pipeline/frame_report.h"
#include "raster/depth_buffer.h"
#include "raster/surface_rasterizer.h"
#include "scene/camera.h"
#include "scene/counts.h"
#include "scene/patch_scene.h"
#include "tool_2d/pixels.h"

#include <functional>
#include <memory>
#include <span>
#include <string>

class l3d_pixel_bits;
struct l3d_dice_view;

/// The task of a frame: the scene to draw, and the picture to draw it into.
///
/// Lives: everything that it refers to must outlive the frame.
struct L3D_PUBLIC l3d_method_frame {
    const l3d_patch_scene& scene; ///< the scene to draw
    /// The scene's materials, indexed by l3d_patch_scene::material_of; none if all is white.
    std::span<const l3d_material> materials;
    const l3d_camera& camera;           ///< the camera
    const l3d_matrix<double>& to_image; ///< world to image; for the library's own methods
    const l3d_dice_view& view;          ///< for them, too; others use the camera's image_matrix
    const l3d_shading& shading;         ///< light, and the way to shade
    l3d_pixels target;                  ///< the picture, to be drawn into
    l3d_depth_buffer& depth;            ///< 1 / distance for each pixel of the target
    bool wants_depth;                   ///< whether depth is wanted; else the buffer may stay as is
    bool untouched;     ///< whether nobody wrote to the target since the last frame's end
    bool counts_pixels; ///< whether the number of covered pixels is wanted

    /// The part of the picture that is drawn; the rest stays as it is. It is the whole picture,
    /// unless the method draws parts and nobody wants depth.
    l3d_pixel_box part;

    bool outlines = false; ///< whether the pixels that outlines reach are wanted
    /// How the pictures that lie on patches are looked up.
    l3d_texture_filter filter = l3d_texture_filter::anisotropic;
    double curved_px = 0; ///< bound of the patches' distance from the surfaces that they
                          ///< approximate

    /// Whether less than the whole picture is drawn.
    bool is_part() const { return part != l3d_whole(target.size()); }
};

/// Draws the surfaces of whole frames, and bounds the error.
///
/// The picture of a method depends on the frame alone, not on frames before or on threads.
/// `counts().bound_px` is the certified image error of the drawn surfaces. It is infinite for
/// methods that cannot give any.
class L3D_PUBLIC l3d_surface_method {
public:
    l3d_surface_method() = default;
    l3d_surface_method(const l3d_surface_method&) = delete;
    l3d_surface_method& operator=(const l3d_surface_method&) = delete;
    virtual ~l3d_surface_method() = default;

    /// The renderer that fills, in one line for reports; empty for the processors.
    std::string renderer() const { return do_renderer(); }

    /// Whether counts() bound the error of depth.
    bool certifies_depth() const { return do_certifies_depth(); }
    /// Whether counts() bound the error of greys, in frames shaded like this.
    bool certifies_shade(const l3d_shading& shading) const { return do_certifies_shade(shading); }

    /// Whether it can draw a part of a picture without the rest (l3d_method_frame::part).
    bool draws_parts() const { return do_draws_parts(); }

    /// Draws a frame; adds the times of its stages to `times`.
    /// Expects: a depth buffer of the target's size if `wants_depth`.
    void draw(const l3d_method_frame& frame, l3d_stage_times& times) { do_draw(frame, times); }

    /// The counts of the last frame.
    const l3d_dice_counts& counts() const { return do_counts(); }
    /// The counts of the last frame's filling, covered pixels among them.
    const l3d_surface_counts& surface_counts() const { return do_surface_counts(); }

    /// The pixels of the last frame in which it is not certain what is seen, since an outline may
    /// lie there. It is null if the frame did not ask for them, or was only a part of a picture.
    /// Methods that do not find them give null, too.
    const l3d_pixel_bits* outlines() const { return do_outlines(); }

protected:
    /// The value of l3d_surface_counts::covered, from the depth of everything drawn in the frame.
    static std::int64_t covered_of(const l3d_method_frame& frame, const l3d_depth_buffer& depth) {
        return frame.counts_pixels ? l3d_covered(depth) : l3d_surface_counts::none_counted;
    }

private:
    virtual std::string do_renderer() const { return {}; }
    virtual bool do_certifies_depth() const { return false; }
    virtual bool do_certifies_shade(const l3d_shading&) const { return false; }
    virtual bool do_draws_parts() const { return false; }
    virtual void do_draw(const l3d_method_frame& frame, l3d_stage_times& times) = 0;
    virtual const l3d_dice_counts& do_counts() const = 0;
    virtual const l3d_surface_counts& do_surface_counts() const = 0;
    virtual const l3d_pixel_bits* do_outlines() const { return nullptr; }
};

class l3d_rasterizer_factory;
class l3d_surface_method;
class l3d_workers;

/// Makes a surface method, and tells what a pipeline must know of it beforehand.
///
/// A default one makes the library's own method: adaptive forward differencing in l3d_real.
class L3D_PUBLIC l3d_method_factory {
public:
    /// Makes a method that fills with surfaces of these rasterizers, by these workers.
    /// Expects: never returns null.
    /// Errors:  exceptions of the call leave the pipeline's constructor.
    /// Lives:   the method may borrow the workers, but not the rasterizers.
    using create_call = std::function<std::unique_ptr<l3d_surface_method>(
        const l3d_rasterizer_factory& rasterizers, l3d_workers& workers)>;

    /// The factory of the library's own method.
    l3d_method_factory();

    /// Makes factories of methods that `create` makes. Reports and messages call these methods by
    /// `name`. `has_bound` says that their counts bound the error, which mode `error` needs.
    /// `draws_parallel` says that they draw parallel projections, with the depths that l3d_shading
    /// has there; other methods get no such frames.
    l3d_method_factory(std::string name, create_call create, bool has_bound = false,
                       bool draws_parallel = false);

    /// The name that reports and messages give the method.
    const std::string& name() const { return name_; }
    /// Whether the method's counts bound the error of each frame.
    bool has_bound() const { return has_bound_; }

    /// Whether the method draws parallel projections.
    bool draws_parallel() const { return draws_parallel_; }

    /// Whether it makes the library's own method, whose steps the wireframe shows.
    bool is_default() const { return is_default_; }

    /// Makes a method; never null.
    /// Errors: exceptions of the call.
    /// Lives:  the method borrows the workers.
    std::unique_ptr<l3d_surface_method> create(const l3d_rasterizer_factory& rasterizers,
                                               l3d_workers& workers) const;

private:
    std::string name_;
    create_call create_;
    bool has_bound_, draws_parallel_, is_default_;
};

#endif
