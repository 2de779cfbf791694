// SPDX-License-Identifier: MIT
// l3d_afd_options: declares the options and checks their values.
#include "system/options/afd_options.h"

#include "base/counted_p.h"
#include "base/printable_p.h"
#include "pipeline/polygons/polygon_model.h"
#include "raster/parallel/workers.h"
#include "scene/line_drawing.h"
#include "system/options/color_text_p.h"
#include "system/options/model_names_p.h"
#include "system/options/number_text.h"
#include "system/options/output_names_p.h"
#include "system/frame_writer.h"
#include "system/long_work_p.h"
#include "tool_2d/output_file_p.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <cstdio>
#include <iostream>
#include <limits>
#include <numbers>
#include <utility>

namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double least_positive = std::numeric_limits<double>::min();

std::string text_of(const l3d_camera::vector& v) {
    return l3d_number_text(v[0]) + ',' + l3d_number_text(v[1]) + ',' + l3d_number_text(v[2]);
}

void check_place(const char* option, const l3d_camera::vector& place,
                 double farthest = l3d_bpt_largest_coordinate) {
    for (int i = 0; i < 3; ++i)
        if (!(std::abs(place[i]) <= farthest))
            throw l3d_error(l3d_exit::usage, std::string(option) + ": '" + text_of(place) +
                                                 "' is farther than " +
                                                 (farthest == l3d_farthest_eye ? "1e15" : "1e12") +
                                                 " from the origin");
}

/// A camera at the same distance from the target, but some 25 degrees above and beside it. From
/// this place, three sides of a box are seen. The teapot's usual view is from a lower place.
l3d_camera seen_from_above(l3d_camera camera) {
    const l3d_camera::vector direction = l3d_upright(camera.up).at(0.5, 0.5, 1);
    camera.eye = camera.target + l3d_normalized(direction) * l3d_length(camera.eye - camera.target);
    return camera;
}

/// Loads a model.
/// Errors:  as l3d_detail::load_named_model; l3d_error(usage) if --output would overwrite a picture
///          that lies on the model's faces. The picture of chair.obj often is chair.png.
l3d_model_file loaded(const std::string& name, const l3d_options& options) {
    l3d_model_file result = l3d_detail::load_named_model(name, options.load_watch());
    const l3d_frame_settings frames = options.frame_settings();
    const l3d_frame_writer writer(frames.output, frames.alpha);
    for (const l3d_mesh_picture& picture : result.mesh.pictures)
        if (picture.bytes.empty() && writer.has_frame_in(picture.name))
            throw l3d_error(l3d_exit::usage, "--output: '" + frames.output +
                                                 "' is the file of a picture of '" + name +
                                                 "', too");
    return result;
}

/// Refuses options that have no effect together with the other options that were given.
/// Errors:  l3d_error(usage).
void check_shown(const l3d_afd_settings& asked, bool has_texture) {
    const std::string shade = l3d_shade_names[static_cast<std::size_t>(asked.shade)].first;
    const bool is_light = l3d_is_light(asked.shade), is_none = asked.background.is_none();
    l3d_refuse({
        {"--error-output", asked.error_map && (asked.wireframe || asked.drawing || !is_light),
         "only surfaces that show light have an exact picture, and neither lines nor --shade "
         "normals, error or an inspection does"},
        {"--error-output", asked.error_map && asked.lighting.point_count > 0,
         "colours by --point-light have no bounds"},
        {"--error-output", asked.error_map && is_none,
         "pixels have bounds on a background, and --background none has none"},
        {"--texture", has_texture && (asked.wireframe || asked.drawing || !is_light),
         "shades of light show it, and " +
             (is_light ? std::string("lines do") : "--shade " + shade + " does") + " not"},
        {"--error-output", has_texture && asked.error_map,
         "pictures on surfaces have no bounds, and --texture lays one on"},
        {"--wireframe", asked.wireframe && asked.shade != l3d_afd_settings().shade,
         "lines have one colour, and show nothing of --shade " + shade},
        {"--drawing", asked.drawing && asked.shade != l3d_afd_settings().shade,
         "lines have one colour, and show nothing of --shade " + shade},
        {"--drawing", asked.drawing && asked.wireframe, "--wireframe shows other lines"},
        {"--fog", asked.fog.is_on() && l3d_has_scale(asked.shade),
         "the scale of --shade " + shade + " has no colours for it"},
        {"--fog", asked.fog.is_on() && !asked.fog.color && is_none,
         "it needs a colour, as --background none has none to fade into"},
    });
}

} // namespace

l3d_afd_options::l3d_afd_options(l3d_options& options) : options_(options) {
    add_model_options(options);
    add_camera_options(options);
    add_accuracy_options(options);
    add_surface_options(options);
    add_light_options(options);
    add_work_options(options);
    add_notes(options);
}

void l3d_afd_options::add_model_options(l3d_options& options) {
    options.begin_group("Model");
    options.add(
        "FILE,--model", model_file_,
        "model to draw: a file, or the name of one of l3d's own; the option's name may be left "
        "out",
        "FILE");
    options.add("--subdivide", subdivides_,
                "draw the smooth Catmull-Clark surface that the file's polygons are the cage of; "
                "takes the package l3d-subdivision");
    options.add("--subdivide-error", subdivide_error_, subdivision_.error,
                "largest distance from that surface, as a share of the model's size", 1e-7, 1.0);
    options.add("--subdivide-crease", crease_angle_, subdivision_.crease_angle,
                "its polygons meet in a sharp crease where they turn by more degrees", 0.0, 180.0);
    options.add_choice<l3d_cage_boundary>(
        "--subdivide-boundary", subdivision_.boundary,
        "corners of its boundaries: sharp, rounded, or as the file's tags say",
        {{"tagged", l3d_cage_boundary::as_tagged},
         {"corners", l3d_cage_boundary::corners},
         {"smooth", l3d_cage_boundary::smooth}});
}

void l3d_afd_options::add_camera_options(l3d_options& options) {
    options.begin_group("Camera");
    options.add("--eye", eye_,
                "where the camera is; without it and --target, where the whole model is seen");
    options.add("--target", target_, "what it looks at");
    options.add("--up", camera_.up, "what is upright in the picture");
    options.add("--file-camera", file_camera_,
                "look through this camera of the file; what the other options say comes first",
                "NAME");
    options.add("--fov", fov_, camera_.fov, "vertical field of view in degrees", 0.001, 179.9);
    options.add("--near", near_, camera_.near_z,
                "nearest distance that is drawn; without it, less for small models",
                l3d_least_distance, largest);
    options.add("--far", camera_.far_z, "farthest distance that is drawn", least_positive, largest);
    options.add("--parallel", parallel_,
                "parallel projection: far things look as large as those at the target");
    options.add("--turntable", turntable_, "degrees that the eye turns from frame to frame", -360.0,
                360.0);
    options.add("--turn-speed", turn_speed_,
                "how much more keys and the mouse turn than usual: 5 degrees a key, 1 a pixel",
                0.01, 100.0);
}

void l3d_afd_options::add_accuracy_options(l3d_options& options) {
    options.begin_group("Accuracy");
    // Vertices lie on a grid of 1/256 pixel. With the weights of docs/NUMERICS.md, section 9, their
    // rounding takes 0.0069 of the tolerance. So finer tolerances only add quads.
    options.add("--tolerance", tolerance_, settings_.tolerance,
                "largest error of places and depth allowed, in pixels; kept down to 0.01; below, "
                "the report "
                "says what was reached",
                0.005, 1000.0);
    options.add(
        "--shade-tolerance", settings_.shade_tolerance,
        "largest error of a grey allowed, in levels of 255, for --shade lambert; kept where "
        "quads of 6 pixels are small enough",
        1.0, 255.0);
    options.add("--lateral-only", settings_.lateral_only,
                "keep places in the picture within the tolerance, and neither depth nor shade");
    options.add("--most-samples", most_samples_,
                "what a frame may spend on patches that have to be cut or clipped, in samples; "
                "without it 65536 and 2 a pixel, more below 0.05 px; the report tells where it did "
                "not suffice",
                1, std::numeric_limits<int>::max());
}

void l3d_afd_options::add_surface_options(l3d_options& options) {
    options.begin_group("Surfaces");
    options.add_choice<l3d_shade>(
        "--shade", settings_.shade,
        "how the surface is coloured; error: by the bound of each piece's error, from green, "
        "none, to red, the tolerance or more; zebra: by stripes of reflected rays; isophotes: of "
        "equal light; gaussian, mean: by curvature; draft: by the angle to --shade-direction",
        {l3d_shade_names.begin(), l3d_shade_names.end()});
    options.add("--shade-direction", shade_direction_,
                "what --shade zebra and draft tell angles from");
    options.add("--shade-scale", settings_.inspection.scale,
                "the number at the end of the scale of --shade gaussian, mean and draft; 0 takes "
                "one that suits the model, and 15 degrees",
                0, largest);
    options.add("--stripes", settings_.inspection.stripe,
                "how wide stripes of --shade zebra and isophotes are, in degrees", 0.1, 180.0);
    options.add_choice<bool>("--legend", settings_.legend,
                             "whether the picture has the scale of such a shade",
                             {{"on", true}, {"off", false}});
    options.add("--texture", texture_,
                "picture (.png, .jpg) that lies on patches, once on each by its parameters; shown "
                "by shades of light",
                "FILE");
    options.add_choice<l3d_texture_filter>(
        "--texture-filter", settings_.texture_filter, "how pictures on surfaces are looked up",
        {l3d_texture_filter_names.begin(), l3d_texture_filter_names.end()});
    options.add("--wireframe", settings_.wireframe, "the adaptive steps as lines");
    options.add("--drawing", settings_.drawing,
                "contours, creases and borders as lines, hidden ones dashed");
    options.add("--net", settings_.net, "the control nets on top");
    options.add("--edges", settings_.edges,
                "black lines where faces of the model meet at an edge or end");
    options.add("--one-sided", settings_.one_sided,
                "leave out what shows nothing but its back: faces, patches, or sixteenths of large "
                "patches; backs beside a fold stay");
}

void l3d_afd_options::add_light_options(l3d_options& options) {
    options.begin_group("Light, edges and background");
    options.add_each("--light",
                     "direction towards a light and, if it is not white, its colour, as "
                     "1,1,0,orange; each further --light adds one",
                     "X,Y,Z[,COLOR]", text_of(l3d_usual_light),
                     [this](const std::string& text) { add_light(text); });
    options.add_each("--point-light",
                     "place of a light, the distance at which it is as bright as its colour, 0: at "
                     "each, and its colour, if not white; each further one adds one",
                     "X,Y,Z,REACH[,COLOR]", "",
                     [this](const std::string& text) { add_point_light(text); });
    options.add_choice<headlight>(
        "--headlight", headlight_,
        "whether the only light goes with the eye; auto: unless one is given; off: lights stay "
        "in the world",
        {{"auto", headlight::unless_lit}, {"on", headlight::on}, {"off", headlight::off}});
    options.add_each("--ambient", "light that comes from everywhere", l3d_detail::color_kind,
                     "25.5,25.5,25.5", [this](const std::string& text) {
                         settings_.lighting.ambient =
                             l3d_detail::read_light_color("--ambient", text);
                     });
    options.add_choice<bool>("--antialias", settings_.antialias,
                             "whether pixels at edges show the mean of all that is seen in them",
                             {{"on", true}, {"off", false}});
    options.add("--background", background_,
                "what is seen where no surface is: a quiet gradient, as unless told otherwise; "
                "nothing, which needs a .png; or a colour");
    options.add_each("--fog",
                     "where surfaces begin to fade and where they are gone, in distances along the "
                     "view axis, and into which colour; without one, into the background; black "
                     "is depth cueing",
                     "NEAR,FAR[,COLOR]", "", [this](const std::string& text) { read_fog(text); });
}

void l3d_afd_options::add_work_options(l3d_options& options) {
    options.begin_group("Work and its results");
    options.add("--threads", threads_,
                "threads to draw with; without it, as many as processors, at most " +
                    std::to_string(l3d_most_usual_threads) + "; the picture is the same for any",
                1, l3d_most_threads);
    options.add("--keep-all", keep_all_,
                "do all work, also what rules leave out; the picture is as good");
    options.add("--report", report_,
                "write one line of JSON per frame that is drawn; - is the standard output", "FILE");
    options.add(
        "--depth-output", depth_output_,
        "write the last frame's distances along the view axis (.pfm); - is the standard output",
        "FILE");
    options.add("--error-output", error_output_,
                "write how far each pixel of the last frame may be from the exact picture, in "
                "levels of 255 (.pfm); - is the standard output",
                "FILE");
    options.add("--svg", svg_,
                "show nothing; write the lines of --drawing as an .svg file, exact to the "
                "tolerance; - is the standard output",
                "FILE");
    options.add("--pick", pick_,
                "tell what the last frame shows at this place, in pixels from the left upper "
                "corner: patch, parameters, point, normal and curvature, each with its error");
    options.add("--explain", explain_, "tell what the last frame did not need, and why");
    options.add("--statistics", statistics_,
                "tell at the end how many polygons were drawn, in how many seconds");
    for (const char* const name :
         {"--depth-output", "--error-output", "--report", "--explain", "--statistics", "--svg"})
        options.has_result(name);
    options.prints_result("--pick");
}

/// Adds the notes at the end of --help.
void l3d_afd_options::add_notes(l3d_options& options) {
    options.add_note("COLOR is " + std::string(l3d_detail::color_forms) +
                     ". Names are those of CSS: " + l3d_detail::color_names() + '.');
    std::string names;
    for (const std::string& name : l3d_detail::model_names())
        names += ' ' + name;
    if (!names.empty())
        options.add_note("Models by name:" + names + ". Without one, the teapot.");
    options.add_example("teapot_bottom --turntable 1", "a model by its name, which turns");
    options.add_example("model.bpt --backend memory --output model.png", "a picture, no window");
    options.add_example("cone --parallel --svg cone.svg", "its lines, seen and hidden, as a file");
    options.add_example("--shade zebra --light 1,1,1,orange", "stripes of reflection under a lamp");
}

std::string l3d_afd_options::model_title() const {
    return model_file_.empty() ? "Utah teapot" : std::filesystem::path(model_file_).stem().string();
}

bool l3d_afd_options::shows_the_usual() const {
    return model_file_.empty() && camera() == teapot_view();
}

l3d_camera l3d_afd_options::camera() const {
    const std::string no_up = "'" + text_of(camera_.up) + "' is zero or along the line of sight";
    check_place("--up", camera_.up);
    l3d_refuse({{"--up", camera_.up == l3d_camera::vector{0.0, 0.0, 0.0}, no_up}});
    l3d_camera result = asked_camera();
    const l3d_upright stands(camera_.up);
    const auto upright = [&](const l3d_camera::vector& v) { return stands.at(v[0], v[1], v[2]); };
    result.eye = eye_.value_or(places_camera() ? result.eye : upright(camera_.eye));
    result.target = target_.value_or(places_camera() ? result.target : upright(camera_.target));
    result.near_z = near_.value_or(camera_.near_z);
    check_place("--eye", result.eye, l3d_farthest_eye);
    check_place("--target", result.target);
    l3d_refuse({
        {"--target", result.eye == result.target,
         "'" + text_of(result.target) + "' is the eye's place"},
        {"--far", !(result.near_z < result.far_z),
         "'" + l3d_number_text(result.far_z) + "' is not beyond --near " +
             l3d_number_text(result.near_z)},
        {"--up", !result.is_valid(), no_up},
    });
    return result;
}

/// The camera to which --eye and --target are applied: the camera of --file-camera, or else the
/// usual camera.
l3d_camera l3d_afd_options::asked_camera() const {
    l3d_camera result = camera_;
    if (!file_camera_.empty()) {
        const l3d_model_camera& file = camera_of_file();
        const l3d_size size = options_.common().size;
        constexpr double degree = std::numbers::pi / 180;
        result.eye = file.eye;
        result.target = file.target;
        result.up = camera_.up == teapot_view().up ? file.up : camera_.up;
        // A file's angle spans the picture's width, and l3d_camera's spans the height.
        result.fov =
            2 / degree * std::atan(std::tan(file.fov * degree / 2) * size.height / size.width);
    }
    result.fov = fov_.value_or(result.fov);
    if (parallel_)
        result.projection = l3d_projection::parallel;
    return result;
}

const l3d_model_camera& l3d_afd_options::camera_of_file() const {
    if (camera_of_file_)
        return *camera_of_file_;
    const std::string asked = "--file-camera: '" + l3d_detail::printable(file_camera_);
    if (model_file_.empty())
        throw l3d_error(l3d_exit::usage, asked + "' is sought in a FILE, and none is given");
    if (!file_)
        file_ = loaded(model_file_, options_);
    std::string names;
    for (const l3d_model_camera& camera : file_->cameras) {
        if (camera.name == file_camera_)
            return camera_of_file_.emplace(camera);
        names += (names.empty() ? " '" : ", '") + l3d_detail::printable(camera.name) + '\'';
    }
    throw l3d_error(l3d_exit::usage, asked + "' is no camera of " +
                                         l3d_detail::printable(model_file_) + ", which has" +
                                         (names.empty() ? " none" : names));
}

l3d_model_file l3d_afd_options::file() const {
    l3d_model_file result = file_ ? *std::move(file_) : loaded(model_file_, options_);
    file_.reset();
    if (subdivides_)
        subdivide(result);
    return result;
}

bool l3d_afd_options::has_trims() const {
    if (model_file_.empty())
        return false;
    if (!file_)
        file_ = loaded(model_file_, options_);
    return std::ranges::any_of(file_->patches,
                               [](const l3d_patch_points& patch) { return !patch.trims.empty(); });
}

void l3d_afd_options::subdivide(l3d_model_file& file) const {
    const auto work = l3d_detail::tell_work("subdividing", model_file_);
    l3d_subdivision how = subdivision_;
    how.error = subdivide_error_.value_or(how.error);
    how.crease_angle = crease_angle_.value_or(how.crease_angle);
    std::string why;
    if (!l3d_subdivide(file, how, model_file_, why))
        throw l3d_error(l3d_exit::bad_input, why);
}

bool l3d_afd_options::is_of_patches() const {
    if (model_file_.empty())
        return true;
    if (!file_)
        file_ = loaded(model_file_, options_);
    return !file_->patches.empty() && file_->mesh.faces() == 0;
}

l3d_camera
l3d_afd_options::camera(const std::function<l3d_camera(const l3d_camera&)>& framed) const {
    const l3d_camera asked = camera();
    if (places_camera())
        return asked;
    l3d_camera result = framed(asked);
    if (!model_file_.empty() && !(result == asked))
        result = framed(seen_from_above(asked));
    result.near_z = near_.value_or(result.near_z);
    return result;
}

std::string l3d_afd_options::view_options(const l3d_camera& camera) {
    const l3d_camera usual = teapot_view();
    std::string text = "--eye " + text_of(camera.eye) + " --target " + text_of(camera.target);
    if (camera.up != usual.up)
        text += " --up " + text_of(camera.up);
    const auto add = [&](const char* option, double value, double usual_value) {
        if (value != usual_value)
            text += std::string(" ") + option + ' ' + l3d_number_text(value);
    };
    add("--fov", camera.fov, usual.fov);
    add("--near", camera.near_z, usual.near_z);
    add("--far", camera.far_z, usual.far_z);
    return camera.is_parallel() ? text + " --parallel" : text;
}

void l3d_afd_options::check_pick(l3d_size size) const {
    if (!pick_)
        return;
    const auto [x, y] = std::pair{(*pick_)[0], (*pick_)[1]};
    if (!(x >= 0 && x <= size.width && y >= 0 && y <= size.height))
        throw l3d_error(l3d_exit::usage, "--pick: '" + l3d_number_text(x) + ',' +
                                             l3d_number_text(y) + "' is outside of the picture, " +
                                             std::to_string(size.width) + 'x' +
                                             std::to_string(size.height));
}

l3d_afd_settings l3d_afd_options::settings() const {
    l3d_afd_settings result = settings_;
    const bool has_points = result.lighting.point_count > 0;
    const std::string alone = "nothing is seen of it without --subdivide";
    l3d_refuse({{"--subdivide", subdivides_ && model_file_.empty(),
                 "it takes a FILE of polygons, and the teapot has patches"},
                {"--subdivide-error", subdivide_error_ && !subdivides_, alone},
                {"--subdivide-crease", crease_angle_ && !subdivides_, alone},
                {"--subdivide-boundary",
                 subdivision_.boundary != l3d_cage_boundary::as_tagged && !subdivides_, alone}});
    const std::string outshone = "nothing is seen of it beside --headlight on, the only light";
    l3d_refuse({{"--light", headlight_ == headlight::on && gives_light_, outshone},
                {"--point-light", headlight_ == headlight::on && has_points, outshone}});
    result.headlight = headlight_ == headlight::on ||
                       (headlight_ == headlight::unless_lit && !gives_light_ && !has_points);
    if (has_points && !gives_light_)
        result.lighting.color = {0, 0, 0};
    result.tolerance = tolerance_.value_or(settings_.tolerance);
    result.most_samples = most_samples_.value_or(0);
    result.count_pixels = !report_.empty();
    result.outlines = !report_.empty() || explain_;
    result.threads = threads_.value_or(settings_.threads);
    l3d_detail::check_ending("--depth-output", depth_output_, ".pfm");
    l3d_detail::check_ending("--error-output", error_output_, ".pfm");
    l3d_detail::check_ending("--svg", svg_, ".svg");
    result.depth = !depth_output_.empty();
    result.error_map = !error_output_.empty();
    result.inspection.direction = shade_direction_;
    if (shade_direction_ == l3d_camera::vector{0.0, 0.0, 0.0})
        throw l3d_error(l3d_exit::usage, "--shade-direction: '0,0,0' has no direction");
    check_place("--shade-direction", shade_direction_);
    result.background = background_.value_or(settings_.background);
    check_shown(result, !texture_.empty());
    if (keep_all_)
        result.keep = l3d_kept_work::all();
    return result;
}

bool l3d_afd_options::write_svg(const l3d_patch_scene& scene) const {
    if (svg_.empty())
        return false;
    const l3d_common_options& common = options_.common();
    l3d_refuse({{"--svg", !common.output.empty(), "it shows nothing, and --output wants pictures"},
                {"--svg", common.frames > 0, "it shows nothing, and --frames wants pictures"}});
    const l3d_reach reach = l3d_reach_of(scene);
    const l3d_camera view = camera(
        [&](const l3d_camera& usual) { return l3d_framed_unless_well(usual, common.size, reach); });
    const l3d_line_drawing drawing =
        l3d_draw_lines(scene, view, common.size, {.tolerance = svg_tolerance()});
    const std::string text = l3d_svg_of(drawing, {.title = model_title()});
    const auto write = [&](std::FILE* to, const std::string& name) {
        if (std::fwrite(text.data(), 1, text.size(), to) != text.size() || std::fflush(to) != 0)
            l3d_detail::throw_write_error(name);
    };
    if (svg_ == "-") {
        write(stdout, "standard output");
    } else {
        l3d_detail::output_file file(svg_);
        write(file.get(), svg_);
        file.commit();
    }
    if (drawing.lines.empty())
        std::cerr << options_.command() << ": the drawing is empty, as the model is "
                  << l3d_why_unseen(view, common.size, reach) << '\n';
    return true;
}

/// The tolerance of --svg. Paper shows finer lines than a screen, so this is the usual tolerance of
/// drawings, not that of pictures.
double l3d_afd_options::svg_tolerance() const {
    return std::clamp(tolerance_.value_or(l3d_line_settings().tolerance),
                      l3d_line_settings::least_tolerance, l3d_line_settings::most_tolerance);
}

void l3d_afd_options::lay_picture(l3d_patch_scene& scene) const {
    if (texture_.empty())
        return;
    std::vector<std::string> notes;
    const l3d_laid_picture picture{l3d_read_texture(texture_, notes)};
    for (const std::string& note : notes)
        std::cerr << note << '\n';
    for (std::size_t i = 0; i < scene.instances().size(); ++i)
        scene.lay(i, picture);
}

l3d_patch_model l3d_afd_options::model() const {
    if (model_file_.empty())
        return l3d_patch_model::teapot();
    return made_of_file<l3d_patch_model>(
        [](const l3d_patch_model& model) { return model.edges_note(); });
}

l3d_patch_scene l3d_afd_options::scene() const {
    if (model_file_.empty())
        return l3d_patch_model::teapot();
    return made_of_file<l3d_patch_scene>([](const l3d_patch_scene& scene) {
        std::string note; // the note of the first model that has one
        for (auto at = scene.instances().begin(); note.empty() && at != scene.instances().end();
             ++at)
            note = at->model().edges_note();
        return note;
    });
}

/// Makes a model or a scene (`Made`) of the model's file, and prints notes about the file on
/// stderr.
template <class Made>
Made l3d_afd_options::made_of_file(
    const std::function<std::string(const Made& made)>& edges_note) const {
    const l3d_model_file file = this->file();
    const std::string polygons = l3d_detail::counted(file.mesh.faces(), "polygons");
    if (file.patches.empty())
        throw l3d_error(l3d_exit::bad_input,
                        model_file_ + ": holds " + polygons +
                            " and no patches; modelview --pipeline zbuffer shows them");
    std::string why;
    auto made = [&] {
        const auto work = l3d_detail::tell_work("preparing", model_file_);
        return Made::from_file(file, model_file_, why);
    }();
    if (!made)
        throw l3d_error(l3d_exit::bad_input, why);
    for (const std::string& note : file.notes)
        std::cerr << note << '\n';
    if (const std::string note = edges_note(*made); !note.empty())
        std::cerr << l3d_detail::printable(model_file_) << ": " << note << '\n';
    if (file.mesh.faces() > 0)
        std::cerr << l3d_detail::printable(model_file_) << ": " << polygons
                  << (file.mesh.faces() == 1 ? " is" : " are")
                  << " skipped; modelview --pipeline zbuffer shows them\n";
    return *std::move(made);
}

std::vector<l3d_nurbs_surface> l3d_afd_options::surfaces(const l3d_patch_model& model) const {
    std::vector<l3d_nurbs_surface> surfaces;
    if (!model_file_.empty() && !subdivides_)
        surfaces = l3d_detail::load_named_surfaces(model_file_);
    return surfaces.empty() ? model.surfaces() : surfaces;
}
