// SPDX-License-Identifier: MIT
// objcopy: copies an object, cuts both by a plane, and slides the halves apart and back.
#include <l3d/polygon_mesh.h>
#include <l3d/polygon_shapes.h>
#include <l3d/random.h>
#include <l3d/pipeline_world.h>
#include <l3d/program.h>

#include <algorithm>

namespace {

/// Slides along x, to and fro, once it has been given a speed.
class half_pyramid final : public l3d_object {
public:
    explicit half_pyramid(l3d_random& random) {
        l3d_polygon_mesh mesh = l3d_pyramid_mesh();
        for (std::size_t i = 0; i < mesh.faces(); ++i)
            mesh.face_colors.push_back(random.next() >> 8);
        set_mesh(std::move(mesh));
    }

    /// Sets the speed. Units: per update of the book.
    void set_speed(double speed) { speed_ = speed; }

private:
    void do_update(double seconds) override {
        constexpr double farthest = 5;
        x_ += speed_ * l3d_book_rate * seconds;
        if (x_ < 0 || x_ > farthest)
            speed_ = -speed_;
        x_ = std::clamp(x_, 0.0, farthest);
        set_transform(0, l3d_translation<l3d_real>(x_, 0, 0));
    }
    std::unique_ptr<l3d_object> do_clone() const override {
        return std::make_unique<half_pyramid>(*this);
    }

    double x_ = 0, speed_ = 0;
};

// Step 2 of 5: the world that l3d_pipeline_world shows.
class objcopy_world final : public l3d_world {
public:
    objcopy_world(l3d_size size, std::uint64_t seed, l3d_cut_end end) : l3d_world(size) {
        order = l3d_draw_order::far_first;
        camera.place = l3d_point<l3d_real>::of(2, 3, -15);
        l3d_random random(seed);
        auto original = std::make_unique<half_pyramid>(random);
        auto copy = original->clone();
        // -x - y - z + 3 = 0, the front towards the origin.
        const auto plane = l3d_plane<double>::through({1, 1, 1}, {-1, -1, -1});
        original->set_mesh(l3d_cut_mesh(original->mesh(), plane, end));
        copy->set_mesh(l3d_cut_mesh(copy->mesh(), plane.flipped(), end));
        static_cast<half_pyramid&>(*copy).set_speed(0.25);
        add(std::move(original));
        add(std::move(copy));
    }
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program(
        "objcopy",
        l3d_caption{.what = "A pyramid and its copy, cut into two halves by a plane.",
                    .teaches = "A copy in depth has a life of its own. Cut by a plane, the faces "
                               "of one half share new vertices.",
                    .keys = l3d_world_keys()},
        {960, 600});
    bool capped = false;
    program.options().add("--cap", capped, "close the halves where they were cut");
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        l3d_pipeline_world pipeline(program.create_canvas(), [&](l3d_size size) {
            return std::make_unique<objcopy_world>(
                size, program.seed(), capped ? l3d_cut_end::capped : l3d_cut_end::open);
        });
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
