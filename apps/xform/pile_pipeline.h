// SPDX-License-Identifier: MIT
// pile_pipeline: things of random colours that pile up, as xform and mesaflat show them.
#ifndef L3D_APPS_XFORM_PILE_PIPELINE_H
#define L3D_APPS_XFORM_PILE_PIPELINE_H

#include <l3d/random.h>
#include <l3d/pipeline_2d.h>
#include <l3d/ticker.h>

#include <algorithm>
#include <cstdint>
#include <utility>

/// Seven things more in each 60th of a second. A subclass draws one.
class pile_pipeline : public l3d_pipeline_2d {
public:
    pile_pipeline(l3d_canvas canvas, std::uint64_t seed)
        : l3d_pipeline_2d(std::move(canvas)), random_(seed) {}

    void update_event(double seconds) final {
        constexpr int most = 10 * 60; // of what was never seen, ten seconds hide all before
        rounds_ = std::min(rounds_ + ticker_.due(seconds), most);
    }

    bool needs_redraw() const final { return rounds_ > 0; }

private:
    virtual void draw_one(l3d_rasterizer_2d& rasterizer, l3d_random& random,
                          std::uint32_t color) = 0;

    void draw(l3d_rasterizer_2d& rasterizer) final {
        for (; rounds_ > 0; --rounds_)
            for (int i = 0; i < 7; ++i) {
                const auto channel = [this] { return random_.between(0, 255); };
                const auto red = channel(), green = channel(), blue = channel();
                draw_one(rasterizer, random_, l3d_screen_info::ext_to_native(red, green, blue));
            }
    }

    l3d_random random_;
    l3d_ticker ticker_;
    int rounds_ = 0; ///< due, but not yet drawn
};

#endif
