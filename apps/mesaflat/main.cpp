// SPDX-License-Identifier: MIT
// mesaflat: triangles by software GL, which they use unless told otherwise; they pile up.
#include "geom/random.h"
#include "pipeline/ticker.h"
#include "system/program.h"

#include <algorithm>
#include <array>

namespace {

// Step 2 of 5: the application is a pipeline.
class mesaflat_pipeline final : public l3d_pipeline_2d {
public:
    mesaflat_pipeline(l3d_canvas canvas, std::uint64_t seed)
        : l3d_pipeline_2d(std::move(canvas)), random_(seed) {}

    void update_event(double seconds) override {
        constexpr int most = 10 * 60; // of what was never seen, ten seconds hide all before
        rounds_ = std::min(rounds_ + ticker_.due(seconds), most);
    }

    bool needs_redraw() const override { return rounds_ > 0; }

private:
    void draw(l3d_rasterizer_2d& rasterizer) override {
        for (; rounds_ > 0; --rounds_)
            for (int i = 0; i < 7; ++i) {
                const auto channel = [this] { return random_.between(0, 255); };
                const auto red = channel(), green = channel(), blue = channel();
                const double x = random_.between(0, size().width - 1);
                const double y = random_.between(0, size().height - 1);
                const std::array<l3d_point_2d, 3> corners{
                    {{x, y}, {x + 100, y + 10}, {x + 70, y + 100}}};
                rasterizer.draw_polygon_flatshaded(
                    corners, l3d_screen_info::ext_to_native(red, green, blue));
            }
    }

    l3d_random random_;
    l3d_ticker ticker_;
    int rounds_ = 0; ///< due, but not yet drawn
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program("mesaflat", "Triangles by software GL pile up. Keys: F11, q.", {640, 480});
    program.options().prefer_backend("mesa");
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        mesaflat_pipeline pipeline(program.create_canvas(), program.seed());
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
