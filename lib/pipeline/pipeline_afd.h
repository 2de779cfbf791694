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
/// benchmarks set these switches, to measure how much each rule for skipping saves.
struct L3D_PUBLIC l3d_kept_work : l3d_culling_switches {
    /// Whether mode lambert computes a unit normal in each pixel, even where shade levels could be
    /// interpolated between vertices.
    bool unit_normals = false;
    bool drawing = false; ///< whether a frame is drawn again, even if nothing changed

    /// All switches on, as if no rule could skip any work.
    static constexpr l3d_kept_work all() { return {l3d_culling_switches::all(), true, true}; }
};

/// The settings by which l3d_pipeline_afd draws a scene.
struct L3D_PUBLIC l3d_afd_settings {
    /// The largest error that is allowed for places in the picture and for depth. Units: pixels.
    double tolerance = 0.25;

    /// The largest error that is allowed for shades. Units: shade levels of 0 to 255.
    double shade_tolerance = 2;

    /// Whether the tolerance holds for places in the picture alone, not for depth and shades.
    bool lateral_only = false;

    /// The way in which the filled surface gets its colours.
    l3d_shade shade = l3d_shade::lambert;

    /// The quantity, with its scale, that the inspecting shades show. Only the library's own method
    /// draws these shades.
    l3d_inspection inspection{};

    /// The function whose values l3d_shade::own shows. Only the library's own method draws this
    /// shade. If the function starts to give other values, call redraw().
    l3d_own_shade own{};

    /// Whether viewers draw the scale of an inspecting shade into the picture.
    bool legend = true;

    /// The direction towards the light. Units: world space, any length.
    l3d_vector<double, 3> light = l3d_usual_light;

    /// The colours of lights, and further lights. With highlights, or with lights other than the
    /// usual light, the report's bound of shades holds for each colour channel, and is larger.
    /// error_map() bounds each pixel more closely.
    l3d_lighting lighting{};

    /// Whether one light goes with the eye, so that no side that is seen is in the dark. It
    /// replaces `light` and the further lights of `lighting`.
    bool headlight = false;

    /// Whether edges are smooth: pixels at edges show the mean light over their squares
    /// (l3d_shading::antialias).
    bool antialias = true;

    /// The fog that far surfaces fade into. Only the library's own method draws fog, for shades of
    /// light and normals. In fog, the certified bound of shades is larger, since an error of depth
    /// changes the amount of fog (NUMERICS, section 23).
    l3d_fog fog{};

    /// The way to look up the colours of pictures that lie on patches (l3d_patch_scene::lay). Only
    /// the library's own method draws such pictures. Their colours have no certificate: the bound
    /// of shades is infinite.
    l3d_texture_filter texture_filter = l3d_texture_filter::anisotropic;

    /// The picture's colours where nothing is drawn.
    l3d_background background = l3d_background::gradient();

    /// Whether the lines of the adaptive grid are drawn instead of the filled surface.
    bool wireframe = false;

    /// Whether contours, creases and borders are drawn instead of the filled surface. Hidden lines
    /// are dashed (l3d_draw_lines).
    bool drawing = false;

    /// Whether the control nets are drawn on top of the surface.
    bool net = false;

    /// Whether edges are drawn as black lines, where no surface hides these edges. Edges are the
    /// curves at which trimmed faces end. If the model stores no such curves, edges are the borders
    /// of trims, and the sides of patches that are open or creased.
    bool edges = false;

    /// Work that frames do although they could skip it; for benchmarks.
    l3d_kept_work keep{};

    /// Whether surfaces show only their front, the side that dS/du x dS/dv points to. A patch is
    /// left out if all of it turns its back to the eye. Otherwise, each of the patch's sixteen
    /// blocks is left out if all of the block turns its back to the eye. A block that shows both a
    /// front and a back is drawn whole. The front depends on the model, not on its placement: a
    /// mirrored model shows the same side.
    bool one_sided = false;

    /// Whether the depth of each pixel is kept, for depth() and distances().
    bool depth = false;

    /// Whether the report has the number of pixels that surfaces cover.
    bool count_pixels = false;

    /// The budget of a frame for patches that have to be cut or clipped (l3d_dice_budget). 0 stands
    /// for l3d_usual_samples. If the budget does not suffice, some of these patches are drawn
    /// coarsely. The certified bound includes the error of such patches.
    std::int64_t most_samples = 0;

    /// Whether the pixels that an outline may cross are kept, for outlines(), and counted in the
    /// report.
    bool outlines = false;

    /// Whether the error of each pixel's colour is bounded, for error_map().
    bool error_map = false;

    /// The plane in the world that cuts the scene open: only surfaces and lines in front of the
    /// plane are drawn. The tolerance holds along the cut, too. Cut bodies are open, and show their
    /// inside. Only the library's own method draws sections. A frame with a section has no
    /// outlines() and no error_map().
    std::optional<l3d_plane<double>> section{};

    /// The number of drawing threads, as for l3d_workers. Changes after the pipeline's construction
    /// have no effect.
    int threads = l3d_usual_threads();

    /// Makes the method that fills surfaces. After the pipeline's construction, only
    /// l3d_pipeline_afd::take_method changes the method.
    l3d_method_factory method{};
};

/// The reason why nothing can be drawn with these values, such as which value is out of its range.
/// It is "" if all values are valid.
L3D_PUBLIC std::string l3d_afd_complaint(const l3d_camera& camera, l3d_size size,
                                         const l3d_afd_settings& settings);

/// Draws models of bicubic patches, with a certified error bound in every frame. The method is
/// adaptive forward differencing, unless the settings have another one.
///
/// A program that only wants pictures uses this class as it is: the program changes scene(),
/// camera() and settings(), and calls draw_event. A program with keys or with things of its own to
/// draw derives a class. If nothing changed since the last frame, a frame draws nothing. If
/// instances were only moved, it draws the parts of the picture at their old and new places, unless
/// things are drawn on top of surfaces. Otherwise it draws the whole picture.
///
/// Expects: camera and settings without an l3d_afd_complaint, in every frame. draw_event throws
///          l3d_error if a number is wrong, such as a camera's, and leaves the picture as it was.
/// Lives:   owns screen, workers, rasterizers and scene, and shares the models of the scene.
/// Cost:    filled surfaces allocate nothing once the largest frame has been seen.
class L3D_PUBLIC l3d_pipeline_afd : public l3d_pipeline {
public:
    /// A pipeline that draws this scene on this canvas.
    /// Errors: throws l3d_error with the text of l3d_afd_complaint. It also throws if the scene has
    ///         trimmed surfaces and the method is not the library's own.
    l3d_pipeline_afd(l3d_canvas canvas, l3d_patch_scene scene, const l3d_camera& camera,
                     const l3d_afd_settings& settings);
    ~l3d_pipeline_afd() override;

    /// The screen that shows the pictures.
    /// Expects: nobody writes to the screen's pixels. To draw on top, use pixels() or rasterizer()
    ///          in draw_overlay. These functions note that the picture is changed, so that the next
    ///          frame clears the picture.
    l3d_screen& screen() { return *screen_; }
    /// The canvas's letters, for text in draw_overlay.
    const l3d_font& font() const { return font_; }

    /// The scene that is drawn, for the program to change. The next draw_event draws with scene,
    /// camera and settings as they are at that time. A program with a dispatcher calls redraw()
    /// after a change of camera or settings. Only the pipeline calls the scene's forget_changes().
    l3d_patch_scene& scene() { return scene_; }
    /// Curves in space that are drawn as lines over the finished surfaces, and over the curves of
    /// the scene's models. The program may change these curves, and then calls redraw().
    ///
    /// A surface hides the lines behind it, pixel by pixel, even if the surface is transparent. A
    /// line that lies on a surface is seen whole, since the test allows for the surface's slope and
    /// for twice the tolerance. Curves are drawn within the tolerance, with the settings' fog, and
    /// smooth if antialias is set. Later lines are drawn over earlier ones. In a wireframe nothing
    /// hides a line.
    /// Cost: each frame with curves is drawn whole, and keeps the depth of its pixels.
    std::vector<l3d_space_curve>& curves() { return curves_; }
    /// The camera that the next frame is drawn for, for the program to change.
    l3d_camera& camera() { return camera_; }
    /// The settings that the next frame is drawn by, for the program to change.
    l3d_afd_settings& settings() { return settings_; }
    /// The settings that the next frame is drawn by, read-only.
    const l3d_afd_settings& settings() const { return settings_; }

    /// Moves the camera forwards or back, and sideways, without turning it, so that the picture
    /// shows the whole scene (l3d_framed).
    void frame_all();

    /// Returns the camera `usual` if it shows the scene well, else a camera that shows the whole
    /// scene (l3d_framed_unless_well).
    l3d_camera framed_unless_well(const l3d_camera& usual) const;

    /// The reason why the last picture shows nothing: the text of l3d_why_unseen, or
    /// l3d_without_area. It is "" if the picture may show something.
    std::string why_empty() const;

    /// The inspection that the next frame shows, as the settings ask for it. If the settings leave
    /// the scale open, the result has a scale that suits the scene. The result's colours are
    /// l3d_inspection_colors.
    /// Cost: after a change of scene or shade, the search for an open scale of curvature takes some
    ///       7 us a patch, but at most 30 ms.
    l3d_inspection inspection();

    /// Finds the surface that is seen at (x, y) of the picture, by l3d_pick_at with the present
    /// camera and settings. The result is nothing if no surface is there.
    std::optional<l3d_pick> pick(double x, double y) const;

    /// Fills surfaces with another method from the next frame on. If the method cannot draw
    /// parallel projections, the camera returns to perspective.
    /// Expects: no frame is being drawn.
    /// Errors:  exceptions of the factory; then the old method stays.
    void take_method(const l3d_method_factory& method);

    /// Asks for a new picture, since the camera, the settings or things drawn on top have changed.
    void redraw() { stale_ = true; }

    /// The depths of the last frame's pixels; empty for a wireframe. Expects: the setting `depth`
    /// is on.
    const l3d_depth_buffer& depth() const { return depth_; }

    /// The depths of the last frame's pixels as distances along the view axis, +infinity where no
    /// surface is.
    /// Shape: row by row from the top, width values each.
    std::vector<float> distances() const;

    /// The pixels of the last frame that an outline may cross. The result is null if the setting
    /// `outlines` was off, if the method does not find outlines, or if only a part of the picture
    /// was drawn.
    const l3d_pixel_bits* outlines() const;

    /// The bound of each pixel's difference from the exact picture, with the settings' lights and
    /// fog. The result is null if the setting `error_map` was off. It is also null for a wireframe,
    /// for shades that are not light, with point lights, and without a background.
    const l3d_error_map* error_map() const;

    /// The report of the last frame. Each call computes the hash of the picture.
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
    /// The rasterizer by which draw_overlay draws points, lines and polygons on the picture. After
    /// this call, the next frame with changes is drawn whole, not only in the parts that changed.
    l3d_rasterizer_2d& rasterizer() {
        touch();
        return rasterizer_;
    }

    /// The report for draw_overlay, without the hash. Counts and bounds are those of the present
    /// frame already. Frame number, size and times are still those of the frame before.
    const l3d_frame_report& last_report() const { return report_; }

    /// The certified error bound of the surfaces that this frame has drawn, for draw_overlay.
    /// Units: pixels.
    double bound() const { return report_.dice.bound_px; }

    /// The picture, for draw_overlay and paint_surfaces to write into. After this call, the next
    /// frame with changes is drawn whole, not only in the parts that changed.
    l3d_pixels pixels() {
        touch();
        return screen_->pixels();
    }

    /// Draws the borders of all patches of a part over the picture, even where surfaces hide them.
    /// It draws nothing if no model has a part of that name. Call it from draw_overlay or
    /// draw_panels.
    void mark_part(const std::string& name);

    /// Changes pixels of the finished surfaces, before control nets are drawn over them. Called in
    /// the same frames as draw_overlay.
    virtual void paint_surfaces() {}

    /// Draws on top of the finished surfaces; the report counts its time as `overlay`. Called in
    /// each frame that draws anything or that redraw() asked for. A viewer's panels are drawn
    /// afterwards.
    virtual void draw_overlay() {}

private:
    /// Draws the panels of a viewer on top of everything else.
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
    bool untouched_ = false; ///< whether nothing was drawn over the surfaces since they were filled
    bool is_foreign_ = false; ///< whether somebody changed the pixels while no frame was drawn
    bool is_drawing_ = false;
    l3d_pixel_box changed_;
    l3d_frame_report report_;
    /// The shade for which a scale of curvature was last found, and the scale's end. It is empty
    /// until such a scale is needed.
    std::optional<std::pair<l3d_shade, double>> usual_curvature_;
    std::unique_ptr<stages> stages_;
};

#endif
