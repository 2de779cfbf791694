// SPDX-License-Identifier: MIT
// Worlds of 10 to 10^4 objects that all move, by the book's painter and by depth; one thread, in
// processor time.
//
// Boxes of 6 faces tumble on orbits of their own, all in view, 1024 x 768. `scaled` ones are half
// as wide as high by a matrix. Of those that `come and go`, each frame removes the oldest
// hundredth and adds as many. Then the exponent of the time in the number of objects, from 100 on.
#include "allocations.h"
#include "geom/polygon_shapes.h"
#include "geom/random.h"
#include "pipeline/worlds/world.h"
#include "raster/rasterizer_factory.h"
#include "tool_2d/screen_memory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <vector>

namespace {

constexpr l3d_size size{1024, 768};
constexpr double largest = 10000; ///< objects
constexpr std::array<std::size_t, 4> counts{10, 100, 1000, static_cast<std::size_t>(largest)};

enum class kind { rigid, scaled, come_and_go };

/// A box on a circle about the y axis.
class orbiter final : public l3d_object {
public:
    orbiter(l3d_random& random, kind of)
        : l3d_object(colored(random)), radius_(random.between(5, 60)),
          height_(random.between(-40, 40)), degrees_(random.between(0, 360)),
          speed_(random.between(10, 90)) {
        if (of == kind::scaled)
            set_transform(0, l3d_scaling<l3d_real>(0.5, 1, 1));
        do_update(0);
    }

private:
    static l3d_polygon_mesh colored(l3d_random& random) {
        l3d_polygon_mesh mesh = l3d_box_mesh();
        for (std::size_t i = 0; i < mesh.faces(); ++i)
            mesh.face_colors.push_back(random.next() >> 8);
        return mesh;
    }

    void do_update(double seconds) override {
        degrees_ += speed_ * seconds;
        set_transform(1, l3d_rotation_x<l3d_real>(3 * degrees_));
        set_transform(2, l3d_translation<l3d_real>(radius_, height_, 0));
        set_transform(3, l3d_rotation_y<l3d_real>(degrees_));
    }

    double radius_, height_, degrees_, speed_;
};

/// Milliseconds of processor time, which other programs take no part of.
double now() {
    return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
    std::ranges::nth_element(values,
                             values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    return values[values.size() / 2];
}

struct measured {
    double update = 0, draw = 0; ///< medians, milliseconds
    long allocated = 0;          ///< by the last frame
    std::size_t drawn = 0;       ///< polygons, or triangles
};

measured measure(std::size_t objects, l3d_draw_order order, kind of) {
    l3d_world world(size);
    l3d_random random(1);
    world.order = order;
    world.camera.place = l3d_point<l3d_real>::of(0, 20, -120);
    world.camera.near_z = 1;
    for (std::size_t i = 0; i < objects; ++i)
        world.add(std::make_unique<orbiter>(random, of));
    const l3d_rasterizer_factory_sw factory;
    l3d_screen_memory screen(size);
    l3d_workers workers(1);
    const auto imp = factory.create_2d(screen.pixels());
    const auto surfaces = factory.create_surface(workers);
    l3d_rasterizer_2d rasterizer(*imp);
    const l3d_world_target target{rasterizer, screen.pixels(), surfaces.get(), &workers};
    const int frames = std::clamp(static_cast<int>(2e5 / static_cast<double>(objects)), 20, 200);
    std::vector<double> updates, draws;
    measured result;
    for (int i = 0; i < frames + 2; ++i) {
        const long before = allocations;
        double start = now();
        for (std::size_t k = 0; of == kind::come_and_go && k < objects / 100; ++k) {
            world.remove(*world.objects().front());
            world.add(std::make_unique<orbiter>(random, of));
        }
        world.update_all(1 / l3d_book_rate);
        updates.push_back(now() - start);
        start = now();
        for (int y = 0; y < size.height && order != l3d_draw_order::by_depth; ++y)
            std::ranges::fill(screen.pixels().row(y), 0);
        result.drawn = world.draw_all(target);
        rasterizer.finish();
        draws.push_back(now() - start);
        result.allocated = allocations - before;
        if (i < 2) { // its memory was still growing
            updates.clear();
            draws.clear();
        }
    }
    result.update = median(updates);
    result.draw = median(draws);
    return result;
}

} // namespace

int main() {
    std::printf("%-12s %-8s %8s %9s %9s %9s %9s %8s\n", "objects", "by", "number", "update ms",
                "draw ms", "frames/s", "allocated", "drawn");
    constexpr std::pair<kind, const char*> kinds[] = {
        {kind::rigid, "rigid"}, {kind::scaled, "scaled"}, {kind::come_and_go, "come and go"}};
    for (const auto& [of, name] : kinds)
        for (const auto order : {l3d_draw_order::far_first, l3d_draw_order::by_depth}) {
            double at_hundred = 0, last = 0;
            for (const std::size_t count : counts) {
                const measured m = measure(count, order, of);
                last = m.update + m.draw;
                if (count == 100)
                    at_hundred = last;
                std::printf("%-12s %-8s %8zu %9.3f %9.3f %9.1f %9ld %8zu\n", name,
                            order == l3d_draw_order::by_depth ? "depth" : "painter", count,
                            m.update, m.draw, 1000 / last, m.allocated, m.drawn);
                std::fflush(stdout);
            }
            std::printf("%-12s exponent from 100 objects on: %.2f\n", name,
                        std::log(last / at_hundred) / std::log(largest / 100));
        }
}
