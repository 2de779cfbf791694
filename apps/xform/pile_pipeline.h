// SPDX-License-Identifier: MIT
// pile_pipeline: things of random colours that pile up, as xform and mesaflat show them.
#ifndef L3D_APPS_XFORM_PILE_PIPELINE_H
#define L3D_APPS_XFORM_PILE_PIPELINE_H

#include <l3d/random.h>
#include <l3d/lesson.h>
#include <l3d/pipeline.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

/// A lesson in which things of random colours pile up in the picture: seven in each 60th of a
/// second, and one where the user drags. A subclass draws each thing.
class pile_pipeline : public l3d_lesson {
public:
    pile_pipeline(l3d_canvas canvas, std::uint64_t seed)
        : l3d_lesson(std::move(canvas)), seed_(seed), random_(seed) {}

private:
    /// Draws a thing at a random place.
    virtual void draw_one(l3d_rasterizer_2d& rasterizer, l3d_random& random,
                          std::uint32_t color) = 0;
    /// Draws a thing whose middle is at (x, y). Units: pixels.
    virtual void draw_at(l3d_rasterizer_2d& rasterizer, int x, int y, std::uint32_t color) = 0;

    void advance(double seconds) final {
        constexpr int most = 10 * 60; // ten seconds of unseen drawing hide all before
        rounds_ = std::min(rounds_ + ticker_.due(seconds), most);
    }

    void restart() final {
        random_ = l3d_random(seed_);
        rounds_ = 0;
        dragged_.clear();
    }

    void drag(int x, int y, int, int) final { dragged_.emplace_back(x, y); }

    void draw_lesson(l3d_rasterizer_2d& rasterizer) final {
        for (; rounds_ > 0; --rounds_)
            for (int i = 0; i < 7; ++i)
                draw_one(rasterizer, random_, random_color());
        for (const auto& [x, y] : dragged_)
            draw_at(rasterizer, x, y, random_color());
        dragged_.clear();
    }

    std::uint32_t random_color() {
        const auto channel = [this] { return random_.between(0, 255); };
        const auto red = channel(), green = channel(), blue = channel();
        return l3d_rgb(red, green, blue);
    }

    std::uint64_t seed_;
    l3d_random random_;
    l3d_ticker ticker_;
    int rounds_ = 0; ///< rounds of seven things that are due, but not drawn yet
    std::vector<std::pair<int, int>> dragged_;
};

#endif
