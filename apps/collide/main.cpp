// SPDX-License-Identifier: MIT
// collide: lets bodies fall to one place, and bounce off each other by their bounding spheres.
#include "../morph3d/lit_faces.h"

#include <l3d/bounding_sphere.h>
#include <l3d/pipeline_world.h>
#include <l3d/polygon_shapes.h>
#include <l3d/program.h>
#include <l3d/random.h>
#include <l3d/pipeline.h>

#include <array>
#include <memory>
#include <vector>

namespace {

using vector = l3d_vector<double, 3>;

constexpr double step = 1.0 / 60; // seconds

/// A coloured body that flies, tumbles, and glows for a moment after a hit.
class body final : public l3d_object {
public:
    /// `is_painted` tells that the faces' colours already contain the light.
    body(l3d_polygon_mesh mesh, std::uint32_t color, bool is_painted, const vector& place,
         const vector& turn)
        : place_(place), turn_(turn), color_(color), is_painted_(is_painted),
          mesh_(std::move(mesh)), ball_(l3d_bounding_sphere::of(mesh_.vertices)) {
        show();
    }

    l3d_bounding_sphere ball() const { return ball_.placed(placement()); }
    double mass() const { return ball_.radius * ball_.radius * ball_.radius; }
    const vector& velocity() const { return velocity_; }

    void push(const vector& change) { velocity_ += change; }
    void glow() { glow_ = 1; }

    /// Moves the body by a step of time. A pull to the centre grows with the distance, as a
    /// spring's.
    void fly() {
        constexpr double pull = 0.6, fading = 0.94;
        velocity_ -= place_ * (pull * step);
        place_ += velocity_ * step;
        angles_ += turn_ * step;
        glow_ *= fading;
    }

    void show() {
        const l3d_matrix<double> at = placement();
        mesh_.face_colors.clear();
        for (std::size_t face = 0; face < mesh_.faces(); ++face) {
            const double light = is_painted_ ? light_on(mesh_, face, at) : 1;
            mesh_.face_colors.push_back(mixed(mixed(0, color_, light), 0xffffff, glow_));
        }
        set_mesh(mesh_);
        set_transform(0, l3d_rotation_x<l3d_real>(angles_[0]));
        set_transform(1, l3d_rotation_y<l3d_real>(angles_[1]));
        set_transform(2, l3d_translation<l3d_real>(place_[0], place_[1], place_[2]));
    }

private:
    l3d_matrix<double> placement() const {
        return l3d_translation<double>(place_[0], place_[1], place_[2]) *
               l3d_rotation_y<double>(angles_[1]) * l3d_rotation_x<double>(angles_[0]);
    }

    vector place_, velocity_{0.0}, angles_{0.0}, turn_;
    std::uint32_t color_;
    bool is_painted_;
    double glow_ = 0;
    l3d_polygon_mesh mesh_;
    l3d_bounding_sphere ball_;
};

/// Lets two balls bounce if they touch. They are smooth and hard: they keep momentum and energy.
void bounce(body& a, body& b) {
    const l3d_bounding_sphere one = a.ball(), other = b.ball();
    if (!one.touches(other))
        return;
    const vector normal = l3d_normalized(other.centre - one.centre);
    const double approach = l3d_dot(a.velocity() - b.velocity(), normal);
    if (approach <= 0) // they already part
        return;
    const double share = 2 * approach / (a.mass() + b.mass());
    a.push(normal * (-share * b.mass()));
    b.push(normal * (share * a.mass()));
    a.glow();
    b.glow();
}

/// An invisible object that moves all bodies as time passes.
///
/// Lives: borrows them.
class laws final : public l3d_object {
public:
    explicit laws(std::vector<body*> bodies) : bodies_(std::move(bodies)) {}

private:
    void do_update(double seconds) override {
        for (int due = ticker_.due(seconds); due > 0; --due) {
            for (body* each : bodies_)
                each->fly();
            for (std::size_t i = 0; i < bodies_.size(); ++i)
                for (std::size_t k = 0; k < i; ++k)
                    bounce(*bodies_[i], *bodies_[k]);
        }
        for (body* each : bodies_)
            each->show();
    }

    std::vector<body*> bodies_;
    l3d_ticker ticker_;
};

// Step 2 of 5: the world that l3d_pipeline_world shows.
class collide_world final : public l3d_world {
public:
    collide_world(l3d_size size, std::uint64_t seed, int count, bool is_painted) : l3d_world(size) {
        order = l3d_draw_order::far_first;
        camera.place = l3d_point<l3d_real>::of(0, 0, -60);
        l3d_random random(seed);
        constexpr std::array<std::uint32_t, 6> colors{0xe0952f, 0x4f7fc8, 0xc8557b,
                                                      0x4fa84f, 0xd8d0b8, 0x8f6fc0};
        std::vector<body*> bodies;
        for (int i = 0; i < count; ++i) {
            const auto one_of = [&](int most) -> double { return random.between(-most, most); };
            const double radius = random.between(3, 6);
            const int around = random.between(3, 8);
            const double x = one_of(34), y = one_of(26), z = one_of(26);
            const double pitch = one_of(90), yaw = one_of(90);
            auto made =
                std::make_unique<body>(l3d_sphere_mesh(around, around / 2 + 1, radius),
                                       colors[static_cast<std::size_t>(i) % colors.size()],
                                       is_painted, vector(x, y, z), vector(pitch, yaw, 0.0));
            bodies.push_back(made.get());
            add(std::move(made));
        }
        add(std::make_unique<laws>(std::move(bodies)));
    }
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program("collide",
                        l3d_caption{.what = "Bodies bounce off each other where their spheres "
                                            "meet. A body that was hit glows white for a moment.",
                                    .teaches = "Where two spheres meet, the bodies in them push "
                                               "each other off, and keep momentum and energy.",
                                    .keys = l3d_world_keys()},
                        {960, 720});
    int count = 24;
    program.options().add("--bodies", count, "number of bodies", 1, 200);
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        l3d_pipeline_world pipeline(program.create_canvas(), [&](l3d_size size) {
            return std::make_unique<collide_world>(size, program.seed(), count,
                                                   program.is_classic());
        });
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
