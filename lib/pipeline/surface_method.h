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

/// The task that a frame gives to a surface method: the scene to draw, and the picture to draw it
/// into.
///
/// Lives: the objects that its members refer to must outlive the frame.
struct L3D_PUBLIC l3d_method_frame {
    const l3d_patch_scene& scene; ///< the scene to draw
    /// The scene's materials, indexed by l3d_patch_scene::material_of; empty if all surfaces are
    /// white.
    std::span<const l3d_material> materials;
    const l3d_camera& camera;           ///< the camera that sees the scene
    const l3d_matrix<double>& to_image; ///< map from world to image, for the library's own method
    /// View for the library's own dicing; other methods use camera.image_matrix.
    const l3d_dice_view& view;
    const l3d_shading& shading; ///< lights, and the way to shade
    l3d_pixels target;          ///< the picture to draw into
    l3d_depth_buffer& depth;    ///< gets 1 / distance for each pixel of the target
    bool wants_depth;           ///< whether depth is wanted; if not, `depth` may stay as it is
    bool untouched;             ///< whether nobody wrote to the target since the last frame's end
    bool counts_pixels;         ///< whether the number of covered pixels is wanted

    /// The part of the picture to draw; the rest stays as it is. It is the whole picture if
    /// wants_depth is true, or if the method does not draw parts.
    l3d_pixel_box part;

    bool outlines = false; ///< whether the pixels that an outline may cross are wanted
    /// The way to look up the colours of pictures that lie on patches.
    l3d_texture_filter filter = l3d_texture_filter::anisotropic;
    /// Bound of the distance in the picture between patches and the surfaces that they approximate.
    /// Units: pixels.
    double curved_px = 0;

    /// Whether only a part of the picture is to be drawn.
    bool is_part() const { return part != l3d_whole(target.size()); }
};

/// A way to draw the surfaces of whole frames and to bound the error. Programs can exchange one
/// such method for another, to compare methods.
///
/// The picture that a method draws depends on the l3d_method_frame alone, not on earlier frames or
/// on threads. `counts().bound_px` is the certified bound of the drawn surfaces' error in the
/// image. It is infinite if the method cannot bound the error.
class L3D_PUBLIC l3d_surface_method {
public:
    l3d_surface_method() = default;
    l3d_surface_method(const l3d_surface_method&) = delete;
    l3d_surface_method& operator=(const l3d_surface_method&) = delete;
    virtual ~l3d_surface_method() = default;

    /// One line for reports that names the OpenGL renderer that fills surfaces; empty if the
    /// library itself fills them.
    std::string renderer() const { return do_renderer(); }

    /// Whether counts() has a bound for the error of depth.
    bool certifies_depth() const { return do_certifies_depth(); }
    /// Whether counts() has a bound for the error of shades, in frames with this shading.
    bool certifies_shade(const l3d_shading& shading) const { return do_certifies_shade(shading); }

    /// Whether the method can draw a part of a picture without the rest (l3d_method_frame::part).
    bool draws_parts() const { return do_draws_parts(); }

    /// Draws a frame, and adds the times of the stages to `times`.
    /// Expects: frame.depth has the target's size if frame.wants_depth is true.
    void draw(const l3d_method_frame& frame, l3d_stage_times& times) { do_draw(frame, times); }

    /// The counts of patches and the error bounds of the last frame.
    const l3d_dice_counts& counts() const { return do_counts(); }
    /// Counts of the work while the last frame was filled, with the number of covered pixels.
    const l3d_surface_counts& surface_counts() const { return do_surface_counts(); }

    /// The pixels of the last frame that an outline may cross, so that it is not certain which
    /// surface they show. The result is null if the frame did not ask for outlines, or was only a
    /// part of a picture. It is also null if the method does not find outlines.
    const l3d_pixel_bits* outlines() const { return do_outlines(); }

protected:
    /// The value for l3d_surface_counts::covered, counted in `depth`, the depths of all surfaces of
    /// the frame. The result is none_counted if the frame does not ask for this number.
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

/// Makes a surface method, and tells a pipeline beforehand what the method can do.
///
/// A default-constructed factory makes the library's own method: adaptive forward differencing in
/// numbers of type l3d_real.
class L3D_PUBLIC l3d_method_factory {
public:
    /// Function that makes a method. The method fills surfaces with rasterizers of this factory, on
    /// the threads of these workers.
    /// Expects: never returns null.
    /// Errors:  exceptions of the call leave the pipeline's constructor, or take_method.
    /// Lives:   the method may borrow the workers, but not the rasterizers.
    using create_call = std::function<std::unique_ptr<l3d_surface_method>(
        const l3d_rasterizer_factory& rasterizers, l3d_workers& workers)>;

    /// The factory of the library's own method.
    l3d_method_factory();

    /// Makes a factory whose methods `create` makes. `name` is the methods' name in reports and
    /// messages. `has_bound` says that the methods' counts bound the error, as mode `error` needs.
    /// `draws_parallel` says that the methods draw parallel projections, with depths as in
    /// l3d_shading. If it is false, the methods get no frames in parallel projection.
    l3d_method_factory(std::string name, create_call create, bool has_bound = false,
                       bool draws_parallel = false);

    /// The method's name in reports and messages.
    const std::string& name() const { return name_; }
    /// Whether the method's counts bound the error of each frame.
    bool has_bound() const { return has_bound_; }

    /// Whether the method draws parallel projections.
    bool draws_parallel() const { return draws_parallel_; }

    /// Whether the factory makes the library's own method. Only this method has steps for a
    /// wireframe to show.
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
