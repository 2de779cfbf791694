// SPDX-License-Identifier: MIT
// fltsim: flies through a world of pyramids. Ten of them are a class, one is a plug-in.
#include <l3d/polygon_shapes.h>
#include <l3d/random.h>
#include <l3d/pipeline_world.h>
#include <l3d/plugin_loader.h>
#include <l3d/program.h>

#include <iostream>

namespace {

/// A pyramid that turns about the x axis, by 10 degrees in each update of the book.
class pyramid final : public l3d_object {
public:
    pyramid(double x, l3d_random& random) {
        l3d_polygon_mesh mesh = l3d_pyramid_mesh();
        for (std::size_t i = 0; i < mesh.faces(); ++i)
            mesh.face_colors.push_back(random.next() >> 8);
        set_mesh(std::move(mesh));
        set_transform(1, l3d_translation<l3d_real>(x, 1, 1));
    }

private:
    void do_update(double seconds) override {
        degrees_ += 10 * l3d_book_rate * seconds;
        set_transform(0, l3d_rotation_x<l3d_real>(degrees_));
    }

    double degrees_ = 0;
};

// Step 2 of 5: the world that l3d_pipeline_world shows.
class fltsim_world final : public l3d_world {
public:
    fltsim_world(l3d_size size, std::uint64_t seed, const std::string& plugin) : l3d_world(size) {
        order = l3d_draw_order::far_first;
        camera.place = l3d_point<l3d_real>::of(0, 0, -50);
        l3d_random random(seed);
        for (int i = 0; i < 10; ++i)
            add(std::make_unique<pyramid>(1 + 20 * i, random));
        std::string why;
        l3d_plugin_loader loader("fltsim", seed);
        if (auto object = loader.load(plugin, "", why))
            add(std::move(object));
        else
            std::cerr << "fltsim: going on without the plug-in: " << why << '\n';
    }
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program(
        "fltsim",
        l3d_caption{.what = "A flight among pyramids, one of them from a plug-in.",
                    .teaches = "A class gives all its objects one behaviour; a plug-in gives one "
                               "to an object of a program that is finished.",
                    .keys = l3d_world_keys()},
        {960, 600});
    std::string plugin;
    program.options().add(
        "--plugin", plugin,
        "a shared library that makes one more object; without it, l3d's pyramid.so", "FILE");
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        l3d_pipeline_world pipeline(program.create_canvas(), [&](l3d_size size) {
            return std::make_unique<fltsim_world>(
                size, program.seed(),
                plugin.empty() ? l3d_plugin_folder() + "/pyramid.so" : plugin);
        });
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
