// SPDX-License-Identifier: MIT
// l3d_pipeline_afd: draws lines of patches on top of the finished picture.
#include "pipeline/afd/pipeline_afd_p.h"

#include "dice/near_clip.h"
#include "pipeline/wire_p.h"
#include "scene/placed_net.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace {

constexpr std::uint32_t mark_color = 0x00ffd873;

/// Collects lines between points of the image, to draw nets and marked parts. A line that several
/// patches share is collected once. A line that reaches behind the near plane is left out.
class image_lines {
public:
    explicit image_lines(const l3d_dice_view& view) : view_(view) {}

    void add(const l3d_image_point& from, const l3d_image_point& to) {
        const l3d_clip_vertex a = l3d_canonical_vertex(from, view_);
        const l3d_clip_vertex b = l3d_canonical_vertex(to, view_);
        const l3d_detail::wire line{a.dice.vertex.x, a.dice.vertex.y, b.dice.vertex.x,
                                    b.dice.vertex.y};
        if (a.drawable && b.drawable && shared_.add(line))
            lines_.push_back(line);
    }

    const std::vector<l3d_detail::wire>& all() const { return lines_; }

private:
    const l3d_dice_view& view_;
    std::vector<l3d_detail::wire> lines_;
    l3d_detail::shared_wires shared_;
};

using curve = std::array<l3d_image_point, 4>;

l3d_image_point at(curve p, double t) {
    for (std::size_t left = 3; left > 0; --left)
        for (std::size_t i = 0; i < left; ++i)
            p[i] = p[i] * (1 - t) + p[i + 1] * t;
    return p[0];
}

void add_curve(image_lines& to, const curve& of) {
    constexpr int chords = 16; // a quarter circle of 400 px radius: within half a pixel
    for (int i = 0; i < chords; ++i)
        to.add(at(of, static_cast<double>(i) / chords),
               at(of, static_cast<double>(i + 1) / chords));
}

} // namespace

/// Draws the control net of every patch: 24 lines each.
void l3d_pipeline_afd::draw_nets() {
    untouched_ = false;
    image_lines lines(stages_->view);
    const l3d_patch_scene there = what_is_there();
    for (const l3d_patch_instance& instance : there.instances()) {
        const l3d_matrix<double> to_image = stages_->transform.matrix() * instance.placement();
        for (const l3d_patch_model::patch& patch : instance.model().patches()) {
            const l3d_image_patch net = l3d_placed_net(to_image, patch);
            for (int line = 0; line < 4; ++line)
                for (int i = 0; i < 3; ++i) {
                    lines.add(net.at(line, i), net.at(line, i + 1));
                    lines.add(net.at(i, line), net.at(i + 1, line));
                }
        }
    }
    // Smooth lines are no use on transparent pixels, since they would not cover these.
    const bool smooth = settings_.antialias && !settings_.background.is_none();
    l3d_detail::wire_drawer(rasterizer_, l3d_detail::net_color, smooth, screen_->text_scale())
        .draw(lines.all());
}

void l3d_pipeline_afd::mark_part(const std::string& name) {
    image_lines lines(stages_->view);
    for (const l3d_patch_instance& instance : scene_.instances()) {
        const l3d_patch_model& model = instance.model();
        const std::optional<std::size_t> part = model.parts().find(name);
        if (!part)
            continue;
        const l3d_matrix<double> to_image = stages_->transform.matrix() * instance.placement();
        const std::vector<bool> marked = model.parts().things_of(std::array{*part}, model.pieces());
        for (std::size_t i = 0; i < model.patches().size(); ++i) {
            if (!marked[model.piece_of(i)])
                continue;
            const l3d_image_patch net = l3d_placed_net(to_image, model.patches()[i]);
            for (const int side : {0, 3}) {
                add_curve(lines,
                          {net.at(side, 0), net.at(side, 1), net.at(side, 2), net.at(side, 3)});
                add_curve(lines,
                          {net.at(0, side), net.at(1, side), net.at(2, side), net.at(3, side)});
            }
        }
    }
    const double width = 2 * std::max(1.0, screen_->text_scale()); // visible on any ground
    l3d_detail::wire_drawer(rasterizer(), mark_color, true, width).draw(lines.all());
}
