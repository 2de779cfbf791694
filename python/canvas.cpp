// SPDX-License-Identifier: MIT
// Canvases: pictures that are drawn on in two dimensions.
#include "docs.h"
#include "types.h"

#include <l3d/background.h>
#include <l3d/placement_2d.h>
#include <l3d/rasterizer_factory.h>

#include <cmath>

namespace python {

class canvas {
public:
    canvas(l3d_size size, bool transparent)
        : image(std::make_shared<l3d_image>(size, l3d_padded_stride(size.width))),
          is_transparent(transparent), imp(l3d_rasterizer_factory_sw().create_2d(image->pixels())),
          rasterizer(*imp) {}

    std::shared_ptr<l3d_image> image;
    bool is_transparent;
    std::unique_ptr<l3d_rasterizer_2d_imp> imp;
    l3d_rasterizer_2d rasterizer;
    std::optional<l3d_font> font{}; ///< the machine's, once a text wants it
    bool is_drawing = false;        ///< in another thread
};

namespace {

reference make_canvas(arguments& a) {
    a.are("Canvas", "size | background");
    if (PyObject* given = a.find("size"); given && is_a<picture>(given)) {
        const picture& ground = value_of<picture>(given);
        auto result = std::make_unique<canvas>(ground.image->size(), ground.is_transparent);
        const l3d_pixels from = ground.image->pixels(), to = result->image->pixels();
        for (int y = 0; y < from.height; ++y)
            std::ranges::copy(from.row(y), to.row(y).begin());
        return made(std::move(result));
    }
    l3d_size size{640, 480};
    a.read("size", size, size_of);
    auto result = std::make_unique<canvas>(size, a.given("background") == Py_None);
    l3d_background ground =
        result->is_transparent ? l3d_background::none() : l3d_background::color(0xffffff);
    if (PyObject* value = a.find("background"))
        ground = l3d_background::color(color_of(value, a.what("background")));
    ground.fill(result->image->pixels());
    return made(std::move(result));
}

/// A fill. Other threads may change a path while it is drawn, so this has a copy of the clip. A
/// gradient never changes.
class fill {
public:
    explicit fill(const arguments& a) {
        is.color = a.color("color", 0); // black on white, as on paper
        is.alpha = a.number("alpha", 1, 0, 1);
        if (a.find("gradient"))
            is.gradient = &a.object<l3d_gradient>("gradient");
        if (a.find("clip"))
            is.clip = &clip_.emplace(a.object<l3d_path>("clip"));
        read_choice(a, "inside", is.inside, winding_names);
        read_choice(a, "blending", is.blending, blending_names);
    }
    fill(const fill&) = delete;
    fill& operator=(const fill&) = delete;

    l3d_fill is;

private:
    std::optional<l3d_path> clip_;
};

reference draw_path(canvas_owner& self, arguments& a) {
    a.are("Canvas.draw_path", "path color | gradient alpha inside clip blending");
    const l3d_path path = a.object<l3d_path>("path");
    const fill with(a);
    {
        const unlocked while_drawing;
        self->rasterizer.draw_path(path, with.is);
    }
    return a.self();
}

reference draw_curves(canvas_owner& self, arguments& a) {
    a.are("Canvas.draw_curves", "path color |");
    self->rasterizer.draw_curves(a.object<l3d_path>("path"), a.color("color", 0));
    return a.self();
}

reference draw_line(canvas_owner& self, arguments& a) {
    a.are("Canvas.draw_line", "from_ to color |");
    const l3d_point_2d from = a.point("from_");
    self->rasterizer.draw_line_antialiased(from, a.point("to"), a.color("color", 0));
    return a.self();
}

reference draw_points(canvas_owner& self, arguments& a) {
    a.are("Canvas.draw_points", "points color |");
    const number_array points(a.need("points"), a.what("points"));
    points.expect({-1, 2});
    const std::uint32_t color = a.color("color", 0);
    const std::vector<double> numbers = points.doubles(farthest_pixel);
    for (std::size_t i = 0; i < numbers.size(); i += 2)
        self->rasterizer.draw_point(static_cast<int>(std::floor(numbers[i] + 0.5)),
                                    static_cast<int>(std::floor(numbers[i + 1] + 0.5)), color);
    return a.self();
}

/// Patches of 4 x 4 points, or the 12 points around Coons patches.
reference draw_mesh(canvas_owner& self, arguments& a) {
    a.are("Canvas.draw_mesh", "points colors |");
    const number_array points(a.need("points"), a.what("points"));
    const bool is_coons = points.shape().size() == 3;
    is_coons ? points.expect({-1, 12, 2}) : points.expect({-1, 4, 4, 2});
    const std::size_t count = points.shape()[0];
    const number_array colors(a.need("colors"), a.what("colors"));
    colors.expect({static_cast<int>(count), 4});
    const std::vector<std::uint32_t> words = colors.indices(0xffffff);
    const std::vector<double> numbers = points.doubles(farthest_pixel);
    std::vector<l3d_mesh_patch> patches;
    const double* at = numbers.data();
    const auto next = [&at] {
        at += 2;
        return l3d_point_2d{at[-2], at[-1]};
    };
    for (std::size_t i = 0; i < count; ++i) {
        const std::array<std::uint32_t, 4> corners{words[4 * i], words[4 * i + 1], words[4 * i + 2],
                                                   words[4 * i + 3]};
        if (is_coons) {
            std::array<l3d_point_2d, 12> around;
            for (l3d_point_2d& p : around)
                p = next();
            patches.push_back(l3d_mesh_patch::coons(around, corners));
            continue;
        }
        l3d_mesh_patch& patch = patches.emplace_back();
        patch.colors = corners;
        for (auto& row : patch.points)
            for (l3d_point_2d& p : row)
                p = next();
    }
    {
        const unlocked while_drawing;
        self->rasterizer.draw_mesh(patches);
    }
    return a.self();
}

reference draw_image(canvas_owner& self, arguments& a) {
    a.are("Canvas.draw_image", "picture at size | turn filter alpha clip blending");
    const picture& image = a.object<picture>("picture");
    l3d_point_2d at{0, 0};
    a.read("at", at, point_of);
    const l3d_size own = image.image->size();
    std::vector<double> size{double(own.width), double(own.height)};
    if (PyObject* value = a.find("size"))
        size = numbers_of(value, a.what("size"), 2, farthest_pixel);
    if (!(size[0] > 0 && size[1] > 0))
        throw value_error(a.what("size") + ": a width and height above 0 are wanted");
    l3d_placed_image placed{image.image->pixels()};
    placed.place =
        l3d_placement_2d::image_in_box(own, at.x, at.y, size[0], size[1])
            .then(l3d_placement_2d::turned(a.number("turn", 0, -most_degrees, most_degrees), at));
    placed.transparent = image.is_transparent;
    read_choice(a, "filter", placed.filter, filter_names);
    const fill with(a);
    {
        const unlocked while_drawing;
        self->rasterizer.draw_image(placed, with.is);
    }
    return a.self();
}

reference draw_text(canvas_owner& self, arguments& a) {
    a.are("Canvas.draw_text", "at text color size font |");
    const l3d_point_2d at = a.point("at");
    const std::string words = text_of(a.need("text"), a.what("text"));
    if (!a.find("font") && !self->font) {
        std::string why; // the built-in face is as good as none
        self->font = l3d_font::of_system(why);
    }
    const l3d_font& font = a.find("font") ? a.object<l3d_font>("font") : *self->font;
    font.draw(self->rasterizer, static_cast<int>(at.x), static_cast<int>(at.y), words,
              a.color("color", 0), letters_of(a));
    return a.self();
}

reference clear(canvas_owner& self, arguments& a) {
    a.are("Canvas.clear", "color |");
    self->rasterizer.clear_buffer(a.color("color", 0xffffff));
    return a.self();
}

reference picture_now(canvas_owner& self, arguments& a) {
    a.are("Canvas.picture", "");
    return made(picture_of(std::make_shared<l3d_image>(*self->image), self->is_transparent));
}

reference save(canvas_owner& self, arguments& a) {
    a.are("Canvas.save", "file |");
    save_picture(l3d_image(*self->image).pixels(), self->is_transparent,
                 path_of(a.need("file"), a.what("file")));
    return a.self();
}

reference png(canvas_owner& self, arguments& a) {
    a.are("Canvas._repr_png_", "");
    return png_of(l3d_image(*self->image).pixels(), self->is_transparent);
}

reference size(const canvas_owner& self) {
    return sides(self->image->size());
}

/// A method that works alone on its canvas.
template <auto Call> reference alone(canvas_owner& self, arguments& a) {
    const busy marked(self->is_drawing, "Canvas");
    return Call(self, a);
}

} // namespace

PyTypeObject* add_canvas_type(PyObject* module) {
    using c = canvas_owner;
    static PyMethodDef methods[] = {
        method<c, alone<clear>>("clear", doc("Canvas.clear")),
        method<c, alone<draw_path>>("draw_path", doc("Canvas.draw_path")),
        method<c, alone<draw_curves>>("draw_curves", doc("Canvas.draw_curves")),
        method<c, alone<draw_line>>("draw_line", doc("Canvas.draw_line")),
        method<c, alone<draw_points>>("draw_points", doc("Canvas.draw_points")),
        method<c, alone<draw_mesh>>("draw_mesh", doc("Canvas.draw_mesh")),
        method<c, alone<draw_image>>("draw_image", doc("Canvas.draw_image")),
        method<c, alone<draw_text>>("draw_text", doc("Canvas.draw_text")),
        method<c, alone<picture_now>>("picture", doc("Canvas.picture")),
        method<c, alone<save>>("save", doc("Canvas.save")),
        method<c, alone<png>>("_repr_png_", doc("Canvas._repr_png_")),
        {}};
    static PyGetSetDef attributes[] = {attribute<c, size>("size", doc("Canvas.size")), {}};
    return new_type<c>(module, "l3d.Canvas", doc("Canvas"), methods, attributes,
                       {slot(Py_tp_new, construct<make_canvas>)});
}

} // namespace python
