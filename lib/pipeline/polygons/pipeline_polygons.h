// SPDX-License-Identifier: MIT
// l3d_pipeline_polygons: models of polygons that can be turned, zoomed and inspected.
#ifndef L3D_PIPELINE_POLYGONS_PIPELINE_POLYGONS_H
#define L3D_PIPELINE_POLYGONS_PIPELINE_POLYGONS_H

#include "base/public.h"
#include "scene/camera.h"
#include "pipeline/pipeline.h"
#include "pipeline/pipeline_2d.h"
#include "pipeline/polygons/polygon_model.h"
#include "pipeline/polygons/polygon_view.h"
#include "pipeline/frame_report.h"
#include "pipeline/viewer_controls.h"
#include "raster/rasterizer_2d.h"
#include "raster/textures/texture.h"
#include "raster/parallel/workers.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

class l3d_polygon_frame;
class l3d_polygon_wires;

/// The way in which a model's faces are drawn.
enum class L3D_PUBLIC l3d_polygon_style {
    solid,        ///< filled faces
    wireframe,    ///< the sides of all faces that are not culled
    hidden_lines, ///< the sides of faces, without the parts of sides that faces hide
};

/// The text that l3d_pipeline_polygons::why_empty returns if all faces were left out because they
/// are seen from behind.
inline constexpr const char* l3d_turning_its_back = "turning its back";

/// The settings by which l3d_pipeline_polygons draws a model.
struct L3D_PUBLIC l3d_polygon_settings {
    /// Whether faces are filled, or drawn as lines.
    l3d_polygon_style style = l3d_polygon_style::solid;

    /// The way in which filled faces get their colours.
    l3d_shade shade = l3d_shade::lambert;

    /// The direction towards the light. Units: world space, any length.
    l3d_vector<double, 3> light = l3d_usual_light;

    /// The colours of lights, and further lights.
    l3d_lighting lighting{};

    /// Whether one light goes with the eye, so that no side that is seen is in the dark. It
    /// replaces `light` and the further lights of `lighting`.
    bool headlight = false;

    /// The angles by which the model is turned about the directions x, y and z, through the middle
    /// of the model's box. Units: degrees.
    l3d_vector<double, 3> rotation{0.0, 0.0, 0.0};

    /// The order of the three turns of `rotation`.
    l3d_rotation_order rotation_order = l3d_rotation_order::xyz;

    /// A material for all faces, in place of the model's own. A picture of this material is not
    /// shown.
    std::optional<l3d_material> material{};

    /// The way to look up the colours of pictures on faces; nothing if no pictures are to be shown.
    std::optional<l3d_texture_filter> textures = l3d_texture_filter::anisotropic;

    /// Whether faces that are seen from behind are left out. Otherwise both sides of all faces are
    /// drawn, with the normals turned to the eye. In both cases, faces of closed bodies that are
    /// seen from behind cost nothing, since the bodies' fronts hide these faces.
    bool cull = false;

    /// The picture's colours where nothing is drawn.
    l3d_background background = l3d_background::gradient();

    /// The fog that far surfaces and lines fade into.
    l3d_fog fog{};

    /// Whether edges and lines are smooth: pixels at edges show the mean light over their squares
    /// (l3d_shading::antialias).
    bool antialias = true;

    /// Whether the report has the number of pixels that faces cover.
    bool count_pixels = false;

    /// The number of drawing threads, as for l3d_workers. Changes after the pipeline's construction
    /// have no effect.
    int threads = l3d_usual_threads();
};

/// Draws a model of polygons. A subclass finds which polygon is in front.
///
/// Keys and mouse turn, zoom and inspect the model; the help lists them.
/// Expects: light not zero.
/// Errors:  draw_event throws l3d_error for an invalid camera, and for a shade that is not of
///          normals (l3d_shades_of_normals): polygons have neither bounds nor exact derivatives.
/// Lives:   owns screen, rasterizers and workers; shares the model.
class L3D_PUBLIC l3d_pipeline_polygons : public l3d_pipeline {
public:
    ~l3d_pipeline_polygons() override;

    /// The screen that shows the pictures.
    l3d_screen& screen() { return *screen_; }
    /// The canvas's letters, for text in draw_overlay.
    const l3d_font& font() const { return font_; }

    /// The report of the last frame. Each call computes the hash of the picture.
    l3d_polygon_report report() const;

    /// The camera that the next frame is drawn for, for the program to change. A program with a
    /// dispatcher calls redraw() after a change of camera or settings.
    l3d_camera& camera() { return camera_; }
    /// The settings that the next frame is drawn by, for the program to change.
    l3d_polygon_settings& settings() { return settings_; }
    /// Draws another model from the next frame on. Expects: no frame is being drawn.
    void take_model(const l3d_polygon_model& model);
    /// Asks for a new picture, since camera or settings have changed.
    void redraw() { stale_ = true; }

    /// Moves the camera forwards or back, and sideways, without turning it, so that the picture
    /// shows the whole model (l3d_framed).
    void frame_all();

    /// Returns the camera `usual` if it shows the model well (l3d_shows_well), else a camera that
    /// shows the whole model.
    l3d_camera framed_unless_well(const l3d_camera& usual) const;

    /// The reason why the last picture shows nothing: the text of l3d_why_unseen,
    /// l3d_turning_its_back or l3d_without_area. It is "" if the picture may show something.
    std::string why_empty() const;

    /// Finds the face that is seen at (x, y) of the picture, by l3d_polygon_pick_at with the
    /// present camera and settings. The result is nothing if no face is there.
    std::optional<l3d_polygon_pick> pick(double x, double y) const;

    /// The viewer's keys, mouse and lines of text.
    l3d_viewer_controls& controls() { return controls_; }

    void any_event(const l3d_event& event) override { controls_.note(event); }
    void key_event(int key) override;
    void pointer_event(const l3d_event& event) override;
    void resize_event(l3d_size size) override;
    void update_event(double seconds) override;
    /// Whether the controls are at rest. Nothing else in the viewer changes with time. A subclass
    /// that overrides update_event overrides this function, too.
    bool is_at_rest() const override { return controls_.is_at_rest(); }
    double rest_left() const override { return controls_.rest_left(); }
    void rest_event(double seconds) override;
    void draw_event() override;
    void interrupt_when(std::function<bool()> wanted) override {
        workers_.interrupt_when(std::move(wanted));
    }
    void frame_event(const l3d_frame_times& times) override;
    bool skip_event() override {
        ++report_.frame;
        return true;
    }
    bool needs_redraw() const override { return stale_; }
    std::string take_remark() override { return workers_.take_shortage(); }

protected:
    /// The inputs of a frame, for the subclass that draws it.
    struct scene {
        l3d_pixels target;              ///< the picture to draw into
        const l3d_polygon_frame& frame; ///< the model's triangles in the picture
        /// Materials of the triangles; empty if all are plain.
        std::span<const l3d_material> materials;
        l3d_shading shading; ///< lights, and the way to shade
        bool count_pixels;   ///< whether covered pixels are to be counted
        bool smooth_lines;   ///< whether the sides of faces are drawn as smooth lines
    };

    /// A pipeline that draws this model on this canvas. Errors: as l3d_workers and
    /// l3d_rasterizer_factory::create_2d.
    l3d_pipeline_polygons(l3d_canvas canvas, l3d_polygon_model model, const l3d_camera& camera,
                          const l3d_polygon_settings& settings);

    /// The report of the present frame for draw_overlay, without the hash. Times after drawing the
    /// model are not known yet.
    const l3d_polygon_report& last_report() const { return report_; }

    /// The rasterizer by which draw_overlay draws points, lines and polygons on the picture.
    l3d_rasterizer_2d& rasterizer() { return rasterizer_; }

    /// Draws on top of the finished model; the report counts its time as `overlay`. The viewer's
    /// panels are drawn afterwards, and do not cover standing_panel().
    virtual void draw_overlay() {}

    /// A panel that a subclass shows in every picture. The viewer's own panels do not cover it.
    virtual l3d_standing_panel standing_panel() { return {}; }

    /// The threads that draw.
    l3d_workers& workers() { return workers_; }

private:
    /// draw_solid and draw_hidden_lines draw the whole picture, and add to the report's times and
    /// counts.
    virtual void draw_solid(const scene& what, l3d_polygon_report& report) = 0;
    virtual void draw_hidden_lines(const scene& what, l3d_polygon_report& report) = 0;
    virtual const char* name() const = 0;
    /// Whether draw_solid or draw_hidden_lines needs the frame's parts (l3d_polygon_frame::parts).
    /// Without parts, these functions use the frame's list of triangles alone
    /// (l3d_polygon_frame::list).
    virtual bool draws_parts(const l3d_shading&) const { return true; }

    void draw_model(l3d_polygon_report& report);
    void draw_panels();
    void tell_empty();
    l3d_polygon_view view() const;
    l3d_camera framed(const l3d_camera& camera) const;
    l3d_viewed viewed();
    std::vector<l3d_viewer_row> own_rows();
    void reset_view();

    std::unique_ptr<l3d_screen> screen_;
    l3d_font font_;
    l3d_workers workers_;
    std::unique_ptr<l3d_rasterizer_2d_imp> imp_;
    l3d_rasterizer_2d rasterizer_;

    l3d_polygon_model model_;
    l3d_camera camera_;
    l3d_polygon_settings settings_, first_settings_;
    std::unique_ptr<l3d_polygon_frame> frame_;
    std::unique_ptr<l3d_polygon_wires> wires_;
    l3d_polygon_report report_;
    bool stale_ = true;
    l3d_viewer_controls controls_;
};

#endif
