// SPDX-License-Identifier: MIT
// The error of forward differencing without a bound, as a table and, given a path, as a picture.
#include "geom/fixed_failure.h"
#include "geom/normal_net.h"
#include "tool_2d/image.h"

#include <cstdio>
#include <exception>
#include <vector>

namespace {

using namespace fixed_failure;

/// Panels side by side, each the view at half its size, so that points a pixel apart leave no gap.
constexpr int panel_width = width / 2, panel_height = height / 2;
constexpr std::size_t panel_pixels = std::size_t{panel_width} * panel_height;

/// The grey of a surface point, lit from both sides as the programs do it.
std::uint32_t grey_of(const l3d_bezier_patch<double, 3>& patch, const l3d_normal_net& normals,
                      double u, double v) {
    using vector = l3d_vector<double, 3>;
    const vector light = l3d_normalized(vector{0.4, 0.8, 0.45});
    vector n = l3d_normalized(normals.evaluate(u, v));
    if (l3d_dot(n, vector(eye - patch.evaluate(u, v))) < 0)
        n = -n;
    const double level = 255 * (0.1 + 0.9 * std::max(0.0, l3d_dot(n, light)));
    return 0x010101u * static_cast<std::uint32_t>(std::lround(level));
}

/// One panel: every walked point where it came out, with the grey and the depth it should have.
class panel {
public:
    panel(const l3d_pixels& pixels, std::size_t left)
        : pixels_(pixels), left_(left),
          nearest_(panel_pixels, std::numeric_limits<double>::infinity()) {}

    void draw(const l3d_image_point& walked, double w, std::uint32_t grey) {
        const double x = (walked[0] / walked[2] + width / 2.0) / 2;
        const double y = (walked[1] / walked[2] + height / 2.0) / 2;
        if (!(walked[2] > 0 && x >= 0 && x < panel_width && y >= 0 && y < panel_height))
            return;
        const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
        double& nearest = nearest_[row * panel_width + column];
        if (w >= nearest)
            return;
        nearest = w;
        pixels_.row(static_cast<int>(row))[left_ + column] = grey;
    }

private:
    l3d_pixels pixels_;
    std::size_t left_;
    std::vector<double> nearest_;
};

void run(const char* picture_path) {
    constexpr std::size_t panels = 3; // 16.16 in its three ways
    constexpr int all = int{panels} * panel_width;
    l3d_image image({all, panel_height}, all);
    std::array<panel, panels> picture{{{image.pixels(), 0},
                                       {image.pixels(), panel_width},
                                       {image.pixels(), std::size_t{2} * panel_width}}};

    const auto ways = methods();
    std::vector<error_statistics> errors(ways.size());
    for (const auto& patch : teapot("data/teapot.bpt")) {
        const l3d_image_patch seen = in_view_full(patch);
        const l3d_normal_net normals(patch);
        const steps n = steps_of_one_pixel(seen);
        const points exact = exact_points(seen, n);
        for (std::size_t way = 0; way < ways.size(); ++way) {
            const points walked = ways[way].walk(seen, n);
            errors[way].add(exact, walked);
            if (way >= panels || picture_path == nullptr)
                continue;
            std::size_t at = 0;
            for (int i = 0; i <= n.u; ++i)
                for (int j = 0; j <= n.v; ++j, ++at)
                    picture[way].draw(walked[at], exact[at][2],
                                      grey_of(patch, normals, static_cast<double>(i) / n.u,
                                              static_cast<double>(j) / n.v));
        }
    }
    print_header();
    for (std::size_t way = 0; way < ways.size(); ++way)
        print_row(ways[way], errors[way]);
    if (picture_path != nullptr)
        l3d_write_image(picture_path, image.pixels());
}

} // namespace

/// Usage: fixed_failure_bench [picture.png]; run from the project's folder.
int main(int argc, char** argv) try {
    // Options are for the other benchmarks, which are run with the same arguments.
    run(argc > 1 && argv[1][0] != '-' ? argv[1] : nullptr);
} catch (const std::exception& error) {
    std::fprintf(stderr, "fixed_failure_bench: %s\n", error.what());
    return 1;
}
