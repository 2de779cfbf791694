// SPDX-License-Identifier: MIT
// thumbnail: makes a small picture of a model file, as file managers ask for it.
#include <l3d/any_model.h>
#include <l3d/error.h>
#include <l3d/image.h>
#include <l3d/options.h>
#include <l3d/rasterizer_factory.h>

#include <string>
#include <variant>

namespace {

constexpr int largest_side = 1024; // freedesktop's xx-large

/// Draws a model as seen from above and beside, on a transparent ground. The light is at the eye.
template <class Model>
void draw(const Model& model, const std::string& name, int side, const std::string& picture) {
    using pipeline_for = l3d_pipeline_for<Model>;
    std::remove_cvref_t<decltype(std::declval<pipeline_for&>().settings())> settings{};
    settings.background = l3d_background::none();
    settings.headlight = true;
    const l3d_camera::vector from = l3d_upright({0.0, 1.0, 0.0}).at(0.5, 0.5, 1);
    pipeline_for pipeline(l3d_memory_canvas({side, side}), model, l3d_camera{.eye = from},
                          settings);
    pipeline.frame_all();
    pipeline.draw_event();
    if (const std::string why = pipeline.why_empty(); !why.empty())
        throw l3d_error(l3d_exit::bad_input, name + ": the model is " + why);
    l3d_write_png(picture, pipeline.screen().pixels(), l3d_alpha::transparency);
}

} // namespace

int main(int argc, char** argv) {
    l3d_options options("thumbnail",
                        "Draws a small picture of a model file, as file managers ask for it. It "
                        "needs no display, and writes a PNG whatever the picture's name is.",
                        {256, 256});
    std::string model, picture;
    int side = options.common().size.width;
    options.add("MODEL,--model", model, "the file to draw", "FILE");
    options.add("PICTURE,--picture", picture, "the file to write", "FILE");
    options.add("-s,--side", side, "width and height of the picture, in pixels", 1, largest_side);
    options.add_example("-s 128 part.stl part.png", "a picture of 128 by 128 pixels");
    try {
        if (!options.parse(argc, argv))
            return 0;
        if (model.empty() || picture.empty())
            throw l3d_error(l3d_exit::usage, "a model and a picture are to be named (see --help)");
        std::visit([&](const auto& of) { draw(of, model, side, picture); },
                   l3d_load_any_scene(model));
        return 0;
    } catch (const std::exception& error) {
        return l3d_report(options.command(), error);
    }
}
