// SPDX-License-Identifier: MIT
// l3d_afd_options: the command line of programs that draw patches.
#ifndef L3D_SYSTEM_OPTIONS_AFD_OPTIONS_H
#define L3D_SYSTEM_OPTIONS_AFD_OPTIONS_H

#include "base/public.h"
#include "geom/files/model_file.h"
#include "scene/camera.h"
#include "scene/patch_model.h"
#include "pipeline/pipeline_afd.h"
#include "system/options/options.h"

#include <functional>
#include <optional>
#include <string>

/// Adds options for model, accuracy, camera and shading to the command line of a program, and makes
/// models, cameras and settings of their values.
///
/// Lives:   borrows the l3d_options, which borrow this object until parse() is done.
class L3D_PUBLIC l3d_afd_options {
public:
    /// Adds the options to `options`.
    explicit l3d_afd_options(l3d_options& options);
    l3d_afd_options(const l3d_afd_options&) = delete;
    l3d_afd_options& operator=(const l3d_afd_options&) = delete;

    /// The camera that --eye, --target and the other options of the view ask for. Values that are
    /// not given come from the camera of --file-camera, or else from teapot_view(), turned so that
    /// the direction of --up points up.
    /// Errors:  l3d_error(usage) that names the option, if the values do not make a camera, or if
    ///          the file has no camera with the name that --file-camera gives; l3d_error(bad_input)
    ///          as file().
    l3d_camera camera() const;

    /// The camera of camera() if places_camera() is true. Otherwise `framed` turns this camera into
    /// one that shows the model; --near still sets the near plane. If `framed` changes the camera,
    /// models of files are seen from higher up than the teapot.
    /// Errors:  as camera().
    l3d_camera camera(const std::function<l3d_camera(const l3d_camera&)>& framed) const;

    /// The options that make this camera again, with blanks between them. The text always has --eye
    /// and --target, and other options only if their values are not the defaults.
    static std::string view_options(const l3d_camera& camera);

    /// The settings that the options ask for.
    /// Errors: l3d_error(usage) for options that contradict each other or have no effect, and for a
    ///         direction of length 0.
    l3d_afd_settings settings() const;

    /// The model that the user asks for, or the teapot. Notes on skipped parts of a file go to
    /// stderr.
    /// Errors:  l3d_error(bad_input) with file and line, or for a file without patches.
    l3d_patch_model model() const;

    /// The model of model() as a scene. A shape that stands at many places in the file is one model
    /// with many instances.
    /// Errors:  as model().
    l3d_patch_scene scene() const;

    /// Lays the picture of --texture on all instances of a scene. If the picture cannot be read,
    /// stderr gets a line, and surfaces keep their own colours.
    void lay_picture(l3d_patch_scene& scene) const;

    /// Writes the line drawing of a scene that --svg asks for. The camera shows all of the scene,
    /// unless the user places a camera. Returns whether --svg was given. If it was, the program has
    /// nothing more to do. If the drawing is empty, a line on stderr tells why.
    /// Errors: l3d_error(usage) beside --output and --frames; l3d_error(failure) that names the
    ///         file and the system's reason.
    bool write_svg(const l3d_patch_scene& scene) const;
    /// Whether --svg was given.
    bool gives_svg() const { return !svg_.empty(); }
    /// Whether --svg or --drawing asks for a line drawing of patches.
    bool wants_drawing() const { return gives_svg() || settings_.drawing; }

    /// Whether --texture was given.
    bool gives_texture() const { return !texture_.empty(); }

    /// The NURBS surfaces of a model, for programs that change control points. An exact shape or an
    /// .obj file has NURBS surfaces of its own; any other model gets one surface for each patch.
    /// Divided into patches, the surfaces give the model again.
    /// Expects: the result of model().
    /// Errors:  l3d_error(bad_input) with file and line.
    std::vector<l3d_nurbs_surface> surfaces(const l3d_patch_model& model) const;

    /// The contents of the model's file, subdivided if the user asks for it. The file is read only
    /// once, even if camera() or has_trims() has looked into it before.
    /// Expects: model_file() is not empty.
    /// Errors:  l3d_error(bad_input) with file and line.
    l3d_model_file file() const;
    /// Whether any surface of the model's file is trimmed; false without a file.
    /// Errors:  as file().
    bool has_trims() const;

    /// Whether --subdivide was given.
    bool subdivides() const { return subdivides_; }

    /// Whether the model consists of patches alone, so that it is best drawn as patches. The
    /// model's file is read, and kept for file().
    /// Errors:  as file().
    bool is_of_patches() const;

    /// The name of the model's file, as the user gave it; empty for the teapot.
    const std::string& model_file() const { return model_file_; }

    /// The model's name for titles: the file's name without folder and ending, or "Utah teapot".
    std::string model_title() const;

    /// The camera that looks at the teapot unless the user says otherwise. All values except eye
    /// and target are the defaults of l3d_camera.
    static l3d_camera teapot_view() { return {.eye = {3.2, 3.6, 7.4}, .target = {0.2, 1.3, 0.0}}; }

    /// Whether --eye, --target or --file-camera was given.
    bool places_camera() const {
        return eye_.has_value() || target_.has_value() || !file_camera_.empty();
    }

    /// Whether --light differs from its default.
    bool places_light() const { return settings_.light != l3d_usual_light; }

    /// Whether --tolerance was given.
    bool gives_tolerance() const { return tolerance_.has_value(); }

    /// The angle of --turntable, in degrees from frame to frame; 0 if there is none.
    double turntable() const { return turntable_; }
    /// The factor of --turn-speed, which multiplies the usual angles of turning by keys and mouse.
    double turn_speed() const { return turn_speed_; }
    /// The file of --depth-output, which gets the distances of the last frame's pixels; empty if
    /// there is none.
    const std::string& depth_output() const { return depth_output_; }
    /// The file of --error-output, which gets the error bounds of the last frame's pixels; empty if
    /// there is none.
    const std::string& error_output() const { return error_output_; }
    /// The file of --report, which gets a line of JSON for each frame. Empty if there is none; "-"
    /// stands for the standard output.
    const std::string& report() const { return report_; }
    /// Whether --explain asks which work the last frame skipped.
    bool explain() const { return explain_; }
    /// Whether --statistics asks for the number of polygons and the seconds of the whole run.
    bool statistics() const { return statistics_; }

    /// The place in the picture that --pick names, in pixels from the upper left corner; nothing if
    /// the option was not given.
    const std::optional<l3d_vector<double, 2>>& pick() const { return pick_; }

    /// Refuses a place of --pick that is outside of a picture of this size.
    /// Errors:  l3d_error(usage).
    void check_pick(l3d_size size) const;

    /// Whether the user asked for neither a model nor a camera, so that the usual picture of the
    /// teapot is shown.
    bool shows_the_usual() const;

private:
    void add_model_options(l3d_options& options);
    void add_camera_options(l3d_options& options);
    void add_accuracy_options(l3d_options& options);
    void add_surface_options(l3d_options& options);
    void add_light_options(l3d_options& options);
    void add_work_options(l3d_options& options);
    static void add_notes(l3d_options& options);
    template <class Made>
    Made made_of_file(const std::function<std::string(const Made& made)>& edges_note) const;
    void read_fog(const std::string& text);
    void add_light(const std::string& text);
    void add_point_light(const std::string& text);
    l3d_camera asked_camera() const;
    double svg_tolerance() const;
    const l3d_model_camera& camera_of_file() const;
    void subdivide(l3d_model_file& file) const;

    const l3d_options& options_;
    std::string model_file_, file_camera_, texture_;
    /// The model's file, if it was read and file() has not handed it out yet.
    mutable std::optional<l3d_model_file> file_;
    mutable std::optional<l3d_model_camera> camera_of_file_;
    l3d_vector<double, 3> shade_direction_{0.0, 1.0, 0.0};
    bool gives_light_ = false;
    bool subdivides_ = false;
    l3d_subdivision subdivision_;
    std::optional<double> subdivide_error_, crease_angle_;
    enum class headlight { unless_lit, on, off };
    headlight headlight_ = headlight::unless_lit;
    l3d_camera camera_ = teapot_view();
    std::optional<l3d_camera::vector> eye_, target_;
    std::optional<double> near_, fov_;
    bool parallel_ = false;
    std::optional<l3d_vector<double, 2>> pick_;
    l3d_afd_settings settings_;
    double turntable_ = 0, turn_speed_ = 1;
    std::string depth_output_, error_output_, svg_, report_;
    bool explain_ = false, statistics_ = false, keep_all_ = false;
    std::optional<double> tolerance_;
    std::optional<l3d_background> background_;
    std::optional<int> threads_, most_samples_;
};

#endif
