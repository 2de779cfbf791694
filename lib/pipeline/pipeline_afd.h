// SPDX-License-Identifier: MIT
// l3d_pipeline_afd: draws bicubic patches by adaptive forward differencing.
#ifndef L3D_PIPELINE_PIPELINE_AFD_H
#define L3D_PIPELINE_PIPELINE_AFD_H

#include "base/public.h"
#include "geom/plane.h"
#include "pipeline/frame_report.h"
#include "pipeline/surface_method.h"
#include "pipeline/pipeline.h"
#include "raster/depth_buffer.h"
#include "raster/lighting.h"
#include "raster/rasterizer_factory.h"
#include "scene/camera.h"
#include "scene/counts.h"
#include "scene/patch_scene.h"
#include "scene/space_curve.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class l3d_error_map;
struct l3d_frame_lights;
class l3d_pixel_bits;
class l3d_pixel_boxes;

/// Switches that make a frame do work that it could skip; the picture is the same, or as good. Only
/// benchmarks set them, to measure what each rule saves.
struct L3D_PUBLIC l3d_kept_work : l3d_culling_switches {
    /// Whether mode lambert makes a unit normal in each pixel, even where levels could be
    /// interpolated.
    bool unit_normals = false;
    bool drawing = false; ///< draws a frame again, even if nothing changed

    /// All of this work, as if no rule could skip any.
    static constexpr l3d_kept_work all() { return {l3d_culling_switches::all(), true, true}; }
};

/// The settings by which a scene is drawn.
struct L3D_PUBLIC l3d_afd_settings {
    /// The largest error of places and of depth that is allowed. Units: pixels.
    double tolerance = 0.25;

    /// The largest error of shades that is allowed. Units: levels of 255.
    double shade_tolerance = 2;

    /// Whether the tolerance holds for places in the picture alone, not for depth and shades.
    bool lateral_only = false;

    /// The way in which the filled surface gets its colours.
    l3d_shade shade = l3d_shade::lambert;

    /// The quantity that the inspecting shades show. Only the library's own method draws them.
    l3d_inspection inspection{};

    /// The function that l3d_shade::own shows. Only the library's own method draws it. After a
    /// change of what the function does, call redraw().
    l3d_own_shade own{};

    /// Whether viewers draw the scale of an inspecting shade into the picture.
    bool legend = true;

    /// The direction towards the light. Units: world space, any length.
    l3d_vector<double, 3> light = l3d_usual_light;

    /// The colours of lights, and further lights. With unusual lights or with highlights, the
    /// report's bound of shades holds for each channel, and is larger. The map of doubt bounds each
    /// pixel more closely.
    l3d_lighting lighting{};

    /// Whether one light goes with the eye (l3d_headlight), in place of `light` and `lighting`, so
    /// that no side is in the dark.
    bool headlight = false;

    /// Whether edges are smooth: means over pixels, not stairs; see l3d_shading.
    bool antialias = true;

    /// The fog that far surfaces fade into. Only the library's own method draws it, for shades of
    /// light and normals. The certified bound of shades then includes the effect of errors of depth
    /// on the fog (NUMERICS, section 23).
    l3d_fog fog{};

    /// The way to look up pictures that lie on patches (l3d_patch_scene::lay). Only the library's
    /// own method draws them. Their colours have no certificate: the bound of shades is infinite.
    l3d_texture_filter texture_filter = l3d_texture_filter::anisotropic;

    /// The picture's colours where nothing is drawn.
    l3d_background background = l3d_background::gradient();

    /// Whether the lines of the adaptive grid are drawn instead of the filled surface.
    bool wireframe = false;

    /// Whether contours, creases and borders are drawn instead of the filled surface, hidden ones
    /// dashed (l3d_draw_lines).
    bool drawing = false;

    /// Whether the control nets are drawn on top.
    bool net = false;

    /// Whether edges are drawn as black lines, where no surface hides them. Edges are where trimmed
    /// faces end. A model without these has borders of trims, and sides of patches that are open or
    /// creased.
    bool edges = false;

    /// Work that is done although it could be skipped.
    l3d_kept_work keep{};

    /// Whether surfaces show only their front, the side that dS/du x dS/dv points to. A patch is
    /// left out if all of it turns its back to the eye, and so is a sixteenth of a large patch. A
    /// back in the same piece as a front stays. The model decides which side is the front, not its
    /// placement, so a mirrored model shows the same side.
    bool one_sided = false;

    /// Whether the distance of each pixel is kept, for depth().
    bool depth = false;

    /// Whether the number of covered pixels is reported.
    bool count_pixels = false;

    /// The budget of a frame for patches that have to be cut or clipped (l3d_dice_budget).
    /// 0 stands for l3d_usual_samples. If it does not suffice, the rest is drawn coarsely, and the
    /// bound says so.
    std::int64_t most_samples = 0;

    /// Whether the pixels that outlines reach are kept, and their number is reported.
    bool outlines = false;

    /// Whether the error of each pixel is bounded, for error_map().
    bool error_map = false;

    /// The plane of the world that cuts the scene open: surfaces and lines are drawn in front of it
    /// alone. Places along the cut are as near to the exact surface as all others. Cut bodies are
    /// open, and show their inside. Only the library's own method draws it. A frame with a section
    /// has no outlines() and no error_map().
    std::optional<l3d_plane<double>> section{};

    /// The number of drawing threads, as for l3d_workers. It is constant from the first frame
    /// on.
    int threads = l3d_usual_threads();

    /// Makes the method that fills surfaces. From the first frame on only
    /// l3d_pipeline_afd::take_method changes it.
    l3d_method_factory method{};
};

/// The reason why these values cannot be used to draw, naming the one at fault; "" if they can.
L3D_PUBLIC std::string l3d_afd_complaint(const l3d_camera& camera, l3d_size size,
                                         const l3d_afd_settings& settings);

/// Draws models of bicubic patches with a certified error bound in every frame: by adaptive forward
/// differencing, unless the settings have another method.
///
/// A program that only wants pictures uses it as it is: it changes scene(), camera() and settings()
/// and calls draw_event. A program with keys or things of its own to draw derives a class. A frame
/// draws only what changed since the last one. If nothing changed, it draws nothing. If instances
/// were only moved and nothing is drawn on top, it draws the parts of the picture at their old and
/// new places.
///
/// Expects: camera and settings without an l3d_afd_complaint, in every frame.
/// Lives:   owns screen, workers, rasterizers and scene, and shares the models of the scene.
/// Cost:    filled surfaces allocate nothing once the largest frame has been seen.
class L3D_PUBLIC l3d_pipeline_afd : public l3d_pipeline {
public:
    /// A pipeline that draws this scene on this canvas.
    /// Errors: throws l3d_error with the text of l3d_afd_complaint, or for trimmed surfaces and a
    ///         method that is not the library's own.
    l3d_pipeline_afd(l3d_canvas canvas, l3d_patch_scene scene, const l3d_camera& camera,
                     const l3d_afd_settings& settings);
    ~l3d_pipeline_afd() override;

    /// The screen that shows the pictures.
    /// Expects: nobody writes to its pixels. To draw on top, use pixels() or rasterizer() in
    ///          draw_overlay: they note that the picture is changed, so the next frame clears it.
    l3d_screen& screen() { return *screen_; }
    /// The canvas's letters, for text in draw_overlay.
    const l3d_font& font() const { return font_; }

    /// The scene that is drawn; a reference to change it. The next draw_event draws what scene,
    /// camera and settings say then. A program with a dispatcher calls redraw() after a change of
    /// camera or settings. Only the pipeline calls the scene's forget_changes().
    l3d_patch_scene& scene() { return scene_; }
    /// Lines in space, drawn over the finished surfaces and over the lines of the scene's models; a
    /// reference to change them. After a change, call redraw().
    ///
    /// A surface hides the lines behind it, pixel by pixel, also if it is transparent. A line that
    /// lies on a surface is seen whole, since the test allows for the surface's slope and for twice
    /// the tolerance. Curves are drawn within the tolerance, with the fog, and smooth if edges are.
    /// Later lines lie on earlier ones. In a wireframe nothing hides a line.
    /// Cost: each frame with lines is drawn whole and keeps its depth.
    std::vector<l3d_space_curve>& curves() { return curves_; }
    /// The eye that the next frame is drawn for; a reference to change it.
    l3d_camera& camera() { return camera_; }
    /// How the next frame is to be drawn; a reference to change it.
    l3d_afd_settings& settings() { return settings_; }
    /// How the next frame is to be drawn.
    const l3d_afd_settings& settings() const { return settings_; }

    /// Moves the camera along the line of sight, and beside it, so that the whole scene is seen:
    /// l3d_framed.
    void frame_all();

    /// Returns `usual` if it shows the scene well, else a camera that shows the whole scene:
    /// l3d_framed_unless_well.
    l3d_camera framed_unless_well(const l3d_camera& usual) const;

    /// The reason why the last picture shows nothing: the text of l3d_why_unseen, or
    /// l3d_without_area. It is "" if the picture may show something.
    std::string why_empty() const;

    /// The inspection that the next frame shows. It is that of the settings; if they leave the
    /// scale open, it has one that suits the scene. Its colours are l3d_inspection_colors.
    /// Cost: if the scene changed, some 7 us a patch, but at most 30 ms.
    l3d_inspection inspection();

    /// Finds the surface at (x, y) of the picture: l3d_pick_at, with the present camera and
    /// settings.
    std::optional<l3d_pick> pick(double x, double y) const;

    /// Fills surfaces with another method from the next frame on. The camera returns to perspective
    /// if the method draws nothing else.
    /// Expects: no frame is being drawn.
    /// Errors:  exceptions of the factory; then the old method stays.
    void take_method(const l3d_method_factory& method);

    /// Asks for the next frame to be drawn: camera, settings or what is drawn on top may differ.
    void redraw() { stale_ = true; }

    /// The depth of the last frame, empty for a wireframe. Expects: settings asked for it.
    const l3d_depth_buffer& depth() const { return depth_; }

    /// The depth of the last frame as distances along the view axis, +infinity where nothing is.
    /// Shape: row by row from the top, width values each.
    std::vector<float> distances() const;

    /// The pixels that outlines reach in the last frame. It is null if nobody asked for them, if
    /// the method does not find them, or if only a part of the picture was drawn.
    const l3d_pixel_bits* outlines() const;

    /// The bound of each pixel's difference from the exact picture, with the settings' lights and
    /// fog. It is null if nobody asked for it, for a wireframe, for shades that are not light, with
    /// point lights, and without a background.
    const l3d_error_map* error_map() const;

    /// The report of the last frame drawn; each call computes the hash.
    l3d_frame_report report() const;

    void resize_event(l3d_size size) override;
    void draw_event() override;
    void interrupt_when(std::function<bool()> wanted) override;
    void frame_event(const l3d_frame_times& times) override;
    bool skip_event() override {
        ++report_.frame;
        return true;
    }
    l3d_pixel_box changed() const override { return changed_; }
    bool needs_redraw() const override {
        return stale_ || scene_.is_changed() || settings_.keep.drawing;
    }
    std::string take_remark() override;

protected:
    /// The rasterizer for draw_overlay: points, lines and polygons on the picture. After this call,
    /// the next frame that differs is drawn whole.
    l3d_rasterizer_2d& rasterizer() {
        touch();
        return rasterizer_;
    }

    /// The report of the previous frame, without the hash, for draw_overlay of the present one.
    const l3d_frame_report& last_report() const { return report_; }

    /// The certified bound of what has been drawn in this frame. Units: pixels.
    double bound() const { return report_.dice.bound_px; }

    /// The picture, for draw_overlay and paint_surfaces to write into. After this call, the next
    /// frame that differs is drawn whole.
    l3d_pixels pixels() {
        touch();
        return screen_->pixels();
    }

    /// Draws the borders of all patches of a part on the picture, hidden ones too; for
    /// draw_overlay. It draws nothing if no model has a part of that name.
    void mark_part(const std::string& name);

    /// Changes the finished surface's pixels, before control nets are drawn over it. Called
    /// whenever draw_overlay is.
    virtual void paint_surfaces() {}

    /// Draws on top of the finished surface; timed as `overlay`. It is called in frames that draw
    /// anything or that redraw() asked for. A viewer's panels lie on top of it.
    virtual void draw_overlay() {}

private:
    /// Draws the panels of a viewer.
    virtual void draw_panels() {}

    struct basis;
    struct drawing;
    struct stages;

    l3d_frame_lights lights() const;
    void touch() {
        untouched_ = false;
        is_foreign_ = is_foreign_ || !is_drawing_;
    }
    basis begin_frame();
    l3d_pixel_boxes parts_to_draw(const basis& now);
    l3d_pixel_boxes parts_that_moved(std::int64_t most, int reach);
    void keep_picture();
    void fill_surfaces(const basis& now, const l3d_pixel_boxes& parts, l3d_stage_times& times);
    void draw_surfaces(const basis& now, const drawing& of, l3d_stage_times& times);
    void draw_transparent(const basis& now, l3d_stage_times& times);
    static double shade_bound_of_mix(double of_each);
    double shade_bound_of_fog() const;
    double shade_bound_of_lights(const l3d_shading& shading) const;
    void keep_bounds(const l3d_dice_counts& kept);
    void find_doubts(bool has_levels, l3d_stage_times& times);
    void draw_on_top(const l3d_shading& shading);
    l3d_patch_scene what_is_there() const;
    void draw_wireframe(const l3d_shading& shading);
    void draw_drawing(const l3d_shading& shading);
    void draw_nets();
    void draw_curves(const l3d_shading& shading);
    bool has_curves() const { return settings_.edges || !curves_.empty() || scene_.has_curves(); }
    bool wants_depth() const { return settings_.depth || has_curves(); }

    std::unique_ptr<l3d_screen> screen_;
    l3d_font font_;
    std::shared_ptr<const l3d_rasterizer_factory> rasterizers_;
    std::unique_ptr<l3d_rasterizer_2d_imp> imp_;
    l3d_rasterizer_2d rasterizer_;
    l3d_depth_buffer depth_;

    l3d_patch_scene scene_;
    std::vector<l3d_space_curve> curves_;
    l3d_camera camera_;
    l3d_afd_settings settings_;
    bool stale_ = true;
    bool untouched_ = false;  ///< the pixels are unchanged since surfaces were filled
    bool is_foreign_ = false; ///< somebody changed them while no frame was drawn
    bool is_drawing_ = false;
    l3d_pixel_box changed_;
    l3d_frame_report report_;
    /// The shade of the last curvature scale, and the scale's end; none until it is needed.
    std::optional<std::pair<l3d_shade, double>> usual_curvature_;
    std::unique_ptr<stages> stages_;
};

#endif
