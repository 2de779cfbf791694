// SPDX-License-Identifier: MIT
// Views: pipelines that draw frames of a scene or of polygons, one after another.
#include "docs.h"
#include "look.h"
#include "types.h"

#include <l3d/line_drawing.h>
#include <l3d/screen_memory.h>

#include <algorithm>
#include <array>
#include <type_traits>
#include <variant>

namespace python {

namespace {

/// A screen that draws each frame into an image that nobody else holds: pictures never change, and
/// a program that forgets them needs two images at the most.
class image_screen final : public l3d_screen {
public:
    explicit image_screen(l3d_size size) { images_.push_back(new_image(size)); }

    const std::shared_ptr<l3d_image>& image() const { return images_[current_]; }

    /// Takes another image if somebody holds the present one. Returns whether it did.
    bool renew() {
        if (image().use_count() == 1)
            return false;
        const l3d_size size = image()->size();
        std::erase_if(images_,
                      [&](const auto& one) { return one != image() && one.use_count() > 1; });
        current_ = static_cast<std::size_t>(
            std::ranges::find_if(images_, [](const auto& one) { return one.use_count() == 1; }) -
            images_.begin());
        if (current_ == images_.size())
            images_.push_back(new_image(size));
        return true;
    }

private:
    static std::shared_ptr<l3d_image> new_image(l3d_size size) {
        return std::make_shared<l3d_image>(size, l3d_padded_stride(size.width));
    }

    l3d_pixels do_pixels() override { return image()->pixels(); }
    const l3d_screen_info& do_info() const override { return info_; }
    void do_show(const l3d_pixel_box&) override {}
    std::string do_describe() const override { return "pictures of Python"; }
    bool do_next_event(l3d_event&) override { return false; }
    void do_wait(std::chrono::nanoseconds, int) override {}

    std::vector<std::shared_ptr<l3d_image>> images_;
    std::size_t current_ = 0;
    l3d_screen_info info_;
};

/// A pipeline that tells of a frame without a look at all of its pixels.
template <class Pipeline> class reporting final : public Pipeline {
public:
    using Pipeline::last_report;
    using Pipeline::Pipeline;
};
using patches_pipeline = std::unique_ptr<reporting<l3d_pipeline_afd>>;
using polygons_pipeline = std::unique_ptr<reporting<l3d_pipeline_zbuffer>>;

/// Asks Python whether the user wants an end, as by Ctrl+C.
bool is_interrupted() {
    const PyGILState_STATE locked = PyGILState_Ensure();
    const bool result = PyErr_CheckSignals() != 0;
    PyGILState_Release(locked);
    return result;
}

} // namespace

class view {
public:
    std::variant<patches_pipeline, polygons_pipeline> pipeline;
    image_screen* screen = nullptr; ///< the pipeline's
    reference drawn;                ///< the Scene or Model
    reference camera;               ///< a Camera, whose numbers the next frame has
    std::uint64_t changes = 0;      ///< those of the scene that the pipeline knows of
    bool is_drawing = false;        ///< in another thread
};

namespace {

/// Along which line a model is seen if nobody says it: from the right, from above and from the
/// front.
constexpr vector_3d usual_sight{1.0, 1.0, 3.0};

l3d_canvas canvas_on(std::unique_ptr<image_screen> screen) {
    return {std::move(screen), std::make_shared<l3d_rasterizer_factory_sw>()};
}

/// Refuses what no frame can be drawn of.
void check(l3d_pipeline_afd& pipeline) {
    const std::string why = l3d_afd_complaint(pipeline.camera(), pipeline.screen().pixels().size(),
                                              pipeline.settings());
    if (!why.empty())
        throw value_error(why);
}
void check(l3d_pipeline_zbuffer& pipeline) {
    if (const std::string why = pipeline.camera().complaint(); !why.empty())
        throw value_error(why);
}

l3d_camera camera_of(const arguments& a) {
    if (a.find("camera"))
        return a.object<l3d_camera>("camera");
    return {.eye = usual_sight};
}

void begin(view& of, PyObject* drawn, const l3d_patch_scene& scene, const arguments& a,
           l3d_size size) {
    l3d_afd_settings settings;
    std::vector<l3d_space_curve> curves;
    read_look(a, settings, curves);
    auto screen = std::make_unique<image_screen>(size);
    of.screen = screen.get();
    auto pipeline = std::make_unique<reporting<l3d_pipeline_afd>>(canvas_on(std::move(screen)),
                                                                  scene, camera_of(a), settings);
    pipeline->curves() = std::move(curves);
    of.pipeline = std::move(pipeline);
    of.drawn = reference::shared(drawn);
}

void begin(view& of, PyObject* drawn, const l3d_polygon_model& model, const arguments& a,
           l3d_size size) {
    l3d_polygon_settings settings;
    read_look(a, settings);
    auto screen = std::make_unique<image_screen>(size);
    of.screen = screen.get();
    const l3d_camera camera = camera_of(a);
    if (const std::string why = camera.complaint(); !why.empty())
        throw value_error(why);
    of.pipeline = std::make_unique<reporting<l3d_pipeline_zbuffer>>(canvas_on(std::move(screen)),
                                                                    model, camera, settings);
    of.drawn = reference::shared(drawn);
}

/// A view by arguments that `a` has: what, size, camera, frame, and the settings.
view_owner view_by(const arguments& a, PyObject* what) {
    l3d_size size{640, 480};
    a.read("size", size, size_of);
    const bool is_framed = a.flag("frame", a.find("camera") == nullptr);
    auto result = std::make_unique<view>();
    if (is_a<scene>(what)) {
        const scene& of = value_of<scene>(what);
        begin(*result, what, of.instances, a, size);
        result->changes = of.changes;
    } else if (is_a<l3d_any_model>(what)) {
        std::visit([&](const auto& model) { begin(*result, what, model, a, size); },
                   value_of<l3d_any_model>(what));
    } else {
        throw type_error(a.what("what") + ": a Model or a Scene is wanted, not " + shown(what));
    }
    std::visit(
        [&](auto& pipeline) {
            if (is_framed)
                pipeline->frame_all();
            result->camera = made(pipeline->camera());
        },
        result->pipeline);
    return result;
}

/// Brings the pipeline to the state of the objects that Python may have changed.
void follow(view& self) {
    const l3d_camera& camera = value_of<l3d_camera>(self.camera.get());
    std::visit(
        [&](auto& pipeline) {
            if (pipeline->camera() != camera) {
                pipeline->camera() = camera;
                pipeline->redraw();
            }
            check(*pipeline);
        },
        self.pipeline);
    if (!is_a<scene>(self.drawn.get()))
        return;
    const scene& now = value_of<scene>(self.drawn.get());
    if (now.changes != self.changes)
        std::get<patches_pipeline>(self.pipeline)->scene() = now.instances;
    self.changes = now.changes;
}

/// Adds the maps that a frame of patches has beside its pixels.
void add_maps(const l3d_pipeline_afd& pipeline, picture& to) {
    if (pipeline.settings().depth)
        to.depth = std::make_shared<const std::vector<float>>(pipeline.distances());
    if (const l3d_error_map* map = pipeline.error_map())
        to.doubts = std::make_shared<const std::vector<float>>(map->levels());
}
void add_maps(const l3d_pipeline_zbuffer&, picture&) {}

picture frame_of(view& self) {
    const busy alone(self.is_drawing, "View");
    follow(self);
    return std::visit(
        [&](auto& pipeline) {
            if (self.screen->renew())
                pipeline->resize_event(self.screen->image()->size());
            {
                const unlocked while_drawing;
                pipeline->draw_event();
            }
            const auto image = self.screen->image();
            picture result = picture_of(image, pipeline->settings().background.is_none());
            result.report = [image, report = pipeline->last_report()]() mutable {
                report.hash = l3d_hash(image->pixels());
                return report.json();
            };
            add_maps(*pipeline, result);
            return result;
        },
        self.pipeline);
}

/// A view that Ctrl+C may interrupt.
reference new_view(const arguments& a, PyObject* what) {
    view_owner result = view_by(a, what);
    std::visit([](auto& pipeline) { pipeline->interrupt_when(is_interrupted); }, result->pipeline);
    return made(std::move(result));
}

reference make_view(arguments& a) {
    a.are("View", "what size | camera frame " + look_names);
    return new_view(a, a.need("what"));
}

reference draw_frame(view_owner& self, arguments& a) {
    a.are("View.draw", "");
    return made(frame_of(*self));
}

reference change(view_owner& self, arguments& a) {
    a.are("View.change", "| " + look_names);
    const busy alone(self->is_drawing, "View");
    if (a.find("threads"))
        throw value_error(a.what("threads") + ": the number is constant in a view");
    if (auto* patches = std::get_if<patches_pipeline>(&self->pipeline)) {
        l3d_afd_settings settings = (*patches)->settings();
        auto curves = (*patches)->curves();
        read_look(a, settings, curves);
        (*patches)->settings() = settings;
        (*patches)->curves() = std::move(curves);
        (*patches)->redraw();
    } else {
        auto& polygons = std::get<polygons_pipeline>(self->pipeline);
        l3d_polygon_settings settings = polygons->settings();
        read_look(a, settings);
        polygons->settings() = settings;
        polygons->redraw();
    }
    return a.self();
}

reference frame_all(view_owner& self, arguments& a) {
    a.are("View.frame_all", "");
    const busy alone(self->is_drawing, "View");
    follow(*self);
    std::visit(
        [&](auto& pipeline) {
            pipeline->frame_all();
            value_of<l3d_camera>(self->camera.get()) = pipeline->camera();
        },
        self->pipeline);
    return a.self();
}

reference why_empty(const view_owner& self) {
    return std::visit([](const auto& pipeline) { return text(pipeline->why_empty()); },
                      self->pipeline);
}

reference pick_of(const l3d_pick& p) {
    dictionary result;
    result.add("instance", number(static_cast<std::int64_t>(p.instance)))
        .add("patch", number(static_cast<std::int64_t>(p.patch)))
        .add("part", text(p.part))
        .add("u", number(p.u))
        .add("v", number(p.v))
        .add("u_error", number(p.u_error))
        .add("v_error", number(p.v_error))
        .add("point", numbers(p.point))
        .add("point_error", number(p.point_error))
        .add("depth", number(p.depth))
        .add("normal", numbers(p.normal))
        .add("normal_error", number(p.normal_error))
        .add("gaussian", number(p.gaussian))
        .add("gaussian_error", number(p.gaussian_error))
        .add("mean", number(p.mean))
        .add("mean_error", number(p.mean_error))
        .add("is_proven", flag(p.is_proven));
    return result.get();
}

reference pick_of(const l3d_polygon_pick& p) {
    dictionary result;
    result.add("face", number(static_cast<std::int64_t>(p.face)))
        .add("part", text(p.part))
        .add("point", numbers(p.point))
        .add("point_error", number(p.point_error))
        .add("depth", number(p.depth))
        .add("normal", numbers(p.normal))
        .add("normal_error", number(p.normal_error))
        .add("weights", numbers(p.weights))
        .add("weights_error", number(p.weights_error));
    return result.get();
}

reference pick(view_owner& self, arguments& a) {
    a.are("View.pick", "x y |");
    const double x = number_of(a.need("x"), a.what("x"), -farthest_pixel, farthest_pixel);
    const double y = number_of(a.need("y"), a.what("y"), -farthest_pixel, farthest_pixel);
    const busy alone(self->is_drawing, "View");
    follow(*self);
    return std::visit(
        [&](auto& pipeline) {
            const auto found = pipeline->pick(x, y);
            return found ? pick_of(*found) : reference::none();
        },
        self->pipeline);
}

void append(const reference& list, const reference& item) {
    if (PyList_Append(list.get(), item.get()) != 0)
        throw error_is_set();
}

reference line_of(const l3d_drawn_line& line) {
    static constexpr std::array<const char*, 4> names{"contour", "crease", "border", "joint"};
    const reference pieces = reference::taken(PyList_New(0));
    const reference points = reference::taken(PyList_New(0));
    for (const std::size_t piece : line.pieces)
        append(pieces, number(static_cast<std::int64_t>(piece)));
    for (const l3d_drawn_place& p : line.points)
        append(points, numbers(l3d_vector<double, 3>(p.x, p.y, p.depth)));
    dictionary result;
    result.add("kind", text(names[static_cast<std::size_t>(line.kind)]))
        .add("is_seen", flag(line.is_seen))
        .add("instance", number(static_cast<std::int64_t>(line.instance)))
        .add("pieces", pieces)
        .add("points", points);
    return result.get();
}

reference lines(view_owner& self, arguments& a) {
    a.are("View.lines", "| tolerance hidden joints");
    l3d_line_settings settings;
    if (PyObject* const tolerance = a.find("tolerance"))
        settings.tolerance =
            number_of(tolerance, a.what("tolerance"), l3d_line_settings::least_tolerance,
                      l3d_line_settings::most_tolerance);
    settings.hidden = a.flag("hidden", settings.hidden);
    settings.joints = a.flag("joints", settings.joints);
    const busy alone(self->is_drawing, "View");
    follow(*self);
    const auto* const patches = std::get_if<patches_pipeline>(&self->pipeline);
    if (!patches)
        throw value_error("View.lines: polygons have none; a model of patches is wanted");
    l3d_line_drawing drawing;
    {
        const unlocked while_drawing;
        drawing = l3d_draw_lines((*patches)->scene(), (*patches)->camera(),
                                 self->screen->image()->size(), settings);
    }
    const reference all = reference::taken(PyList_New(0));
    for (const l3d_drawn_line& line : drawing.lines)
        append(all, line_of(line));
    dictionary result;
    result.add("bound", number(drawing.bound))
        .add("lines", all)
        .add("svg", text(l3d_svg_of(drawing)));
    return result.get();
}

reference camera(const view_owner& self) {
    return self->camera;
}
void set_camera(view_owner& self, PyObject* value) {
    self->camera = made(object_of<l3d_camera>(value, "View.camera"));
}
reference what(const view_owner& self) {
    return self->drawn;
}

picture usual_picture(reference what) {
    arguments none(nullptr, nullptr, nullptr);
    return frame_of(*view_by(none, what.get()));
}

} // namespace

picture shown_picture(const l3d_any_model& model) {
    return usual_picture(made(model));
}
picture shown_picture(const scene& of) {
    return usual_picture(made(of));
}

reference draw(arguments& a) {
    a.are("draw", "what size | camera frame " + look_names);
    const reference view = new_view(a, a.need("what"));
    return made(frame_of(*value_of<view_owner>(view.get())));
}

PyTypeObject* add_view_type(PyObject* module) {
    using v = view_owner;
    static PyMethodDef methods[] = {method<v, draw_frame>("draw", doc("View.draw")),
                                    method<v, change>("change", doc("View.change")),
                                    method<v, frame_all>("frame_all", doc("View.frame_all")),
                                    method<v, pick>("pick", doc("View.pick")),
                                    method<v, lines>("lines", doc("View.lines")),
                                    {}};
    static PyGetSetDef attributes[] = {
        attribute<v, camera, set_camera>("camera", doc("View.camera")),
        attribute<v, what>("what", doc("View.what")),
        attribute<v, why_empty>("why_empty", doc("View.why_empty")),
        {}};
    return new_type<v>(module, "l3d.View", doc("View"), methods, attributes,
                       {slot(Py_tp_new, construct<make_view>)});
}

} // namespace python
