// SPDX-License-Identifier: MIT
// The proof that a piece maps one to one: its derivatives and its contraction, checked by sampling.
#include "reference/hits.h"
#include "reference/random_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace reference {
namespace {

constexpr camera oblique{{2.5, 3.1, 6.3}, {0.4, 0.2, -0.3}, {0.1, 1, 0.05}, 41, 0.2};
constexpr picture_size small{157, 118};
constexpr rect everywhere{-1e9, -1e9, 1e9, 1e9};

/// Pieces that are proved, from the coarsest cut that allows it.
void add_proved(const net& piece, int depth, std::vector<net>& proved) {
    if (make_chart(piece, everywhere)) {
        proved.push_back(piece);
    } else if (depth < 12) {
        const auto [low, high] = halves(piece);
        add_proved(low, depth + 1, proved);
        add_proved(high, depth + 1, proved);
    }
}

std::vector<net> proved_pieces(std::uint64_t seed, patch_kind kind) {
    const camera_frame frame(oblique, small);
    std::vector<net> result;
    for (const patch& surface : random_patches(seed, kind, 3, oblique, small))
        add_proved(make_net(surface, frame), 0, result);
    return result;
}

TEST(evaluate, derivatives_are_the_limits_of_differences) {
    constexpr double h = 1e-5;
    const net piece = proved_pieces(313, patch_kind::folded).front();
    for (const double u : {0.13, 0.5, 0.83})
        for (const double v : {0.07, 0.44, 0.91}) {
            const jet at = evaluate(piece, u, v);
            const hpoint left = evaluate(piece, u - h, v).value;
            const hpoint right = evaluate(piece, u + h, v).value;
            const hpoint above = evaluate(piece, u, v - h).value;
            const hpoint below = evaluate(piece, u, v + h).value;
            // The remainder is h^2 / 6 of the third derivative; 1e3 px and 1e-16 / h of rounding.
            EXPECT_NEAR(at.by_u.x, (right.x - left.x) / (2 * h), 1e-6);
            EXPECT_NEAR(at.by_u.w, (right.w - left.w) / (2 * h), 1e-8);
            EXPECT_NEAR(at.by_v.y, (below.y - above.y) / (2 * h), 1e-6);
            EXPECT_NEAR(at.by_v.w, (below.w - above.w) / (2 * h), 1e-8);
        }
}

/// Row sum of |inverse DF_c - 1| at one place, c one picture point.
double measured_contraction(const net& piece, const chart& map, double u, double v, double cx,
                            double cy) {
    const jet at = evaluate(piece, u, v);
    double result = 0;
    for (int row = 0; row < 2; ++row) {
        double sum = 0;
        for (int column = 0; column < 2; ++column) {
            const hpoint& d = column == 0 ? at.by_u : at.by_v;
            sum += std::abs(map.inverse[row][0] * (d.x - cx * d.w) +
                            map.inverse[row][1] * (d.y - cy * d.w) - (row == column));
        }
        result = std::max(result, sum);
    }
    return result;
}

TEST(chart, contraction_holds_everywhere_on_the_piece_and_in_its_box) {
    double largest_part = 0;
    std::size_t pieces = 0;
    for (const auto kind : {patch_kind::moderate, patch_kind::folded, patch_kind::stiff})
        for (const net& piece : proved_pieces(271, kind)) {
            const chart map = *make_chart(piece, everywhere);
            const rect box = bounding_box(piece);
            ++pieces;
            for (const double u : {0.0, 0.4, 1.0})
                for (const double v : {0.0, 0.7, 1.0})
                    for (const double cx : {box.x0, box.x1})
                        for (const double cy : {box.y0, box.y1}) {
                            const double found = measured_contraction(piece, map, u, v, cx, cy);
                            ASSERT_LE(found, map.contraction * (1 + 1e-9) + 1e-9);
                            largest_part = std::max(largest_part, found / map.contraction);
                        }
        }
    EXPECT_GT(pieces, 100u);
    EXPECT_GT(largest_part, 0.8) << "the bound is loose or the sampling is poor";
}

} // namespace
} // namespace reference
