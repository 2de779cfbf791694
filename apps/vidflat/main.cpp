// SPDX-License-Identifier: MIT
// vidflat: shows a model from a file, Videoscape's or any other, by way of a plug-in.
#include <l3d/pipeline_world.h>
#include <l3d/plugin_loader.h>
#include <l3d/program.h>

namespace {

// Step 2 of 5: the world that l3d_pipeline_world shows.
class vidflat_world final : public l3d_world {
public:
    /// Errors: l3d_error(bad_input), naming the plug-in, or file and line.
    vidflat_world(l3d_size size, l3d_plugin_loader loader, const std::string& plugin,
                  const std::string& parameters)
        : l3d_world(size) {
        order = l3d_draw_order::far_first;
        camera.place = l3d_point<l3d_real>::of(0, 0, -50);
        std::string why;
        auto object = loader.load(plugin, parameters, why);
        if (!object)
            throw l3d_error(l3d_exit::bad_input, why);
        add(std::move(object));
    }
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program(
        "vidflat",
        l3d_caption{.what = "A model, read from a file by a plug-in.",
                    .teaches = "What a program can't know yet, such as a format of files, comes as "
                               "a plug-in with a line of parameters.",
                    .keys = l3d_world_keys()},
        {960, 720});
    std::string folder, plugin;
    std::string parameters = "0 0 0 1 0 0 0 1 0 0 0 1 spaceship.obj";
    program.options().add("--plugin", plugin,
                          "what reads the model, a shared library; without it, l3d's videoscape.so",
                          "FILE");
    program.options().add("--parameters", parameters,
                          "what it is told: x y z, three axes as the columns of nine numbers, a "
                          "model file",
                          "TEXT");
    program.options().add("--folder", folder, "where that file is; without it, among l3d's own",
                          "FOLDER");
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        const l3d_plugin_loader loader("vidflat", program.seed(),
                                       folder.empty() ? l3d_data_folder() : folder);
        l3d_pipeline_world pipeline(program.create_canvas(), [&](l3d_size size) {
            return std::make_unique<vidflat_world>(
                size, loader, plugin.empty() ? l3d_plugin_folder() + "/videoscape.so" : plugin,
                parameters);
        });
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
