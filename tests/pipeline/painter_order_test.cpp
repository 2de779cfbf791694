// SPDX-License-Identifier: MIT
// The painter's pictures against the nearest triangle of each pixel, and against depth buffers.
#include "effort.h"
#include "pipeline/zsort/painter_order.h"

#include "painter_scenes.h"
#include "pipeline/zsort/painter_cover_p.h"
#include "pipeline/zsort/cycle_cutter_p.h"
#include "raster/surfaces/surface_rasterizer_scalar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <numeric>
#include <random>

namespace pipeline_tests {
namespace {

constexpr l3d_size window{57, 41};
constexpr std::ptrdiff_t stride = 61;

std::vector<std::uint32_t> packed(const std::vector<std::uint32_t>& words, l3d_size size) {
    std::vector<std::uint32_t> result;
    for (int y = 0; y < size.height; ++y)
        result.insert(result.end(), words.begin() + y * stride,
                      words.begin() + y * stride + size.width);
    return result;
}

class canvas {
public:
    canvas() : words_(static_cast<std::size_t>(stride * window.height), 0xbadu) {}
    l3d_pixels pixels() { return {words_.data(), window.width, window.height, stride}; }
    std::vector<std::uint32_t> picture() const { return packed(words_, window); }

private:
    std::vector<std::uint32_t> words_;
};

l3d_shading shaded(l3d_shade mode) {
    return {mode, {0.6f, 0, 0.8f}, {0, 0, -1}, {}, {}};
}

class painting {
public:
    explicit painting(int threads = 1, bool with_sides = true)
        : workers_(threads), with_sides_(with_sides) {}

    std::vector<std::uint32_t> paint(const std::vector<l3d_painter_triangle>& triangles,
                                     const l3d_shading& shading, bool resolve = true) {
        canvas on;
        order_.make(triangles, window, {.resolve = resolve, .sides = with_sides_});
        painter_.paint(on.pixels(), shading, materials_of(shading, triangles.size()),
                       order_.triangles(), order_.pieces(), order_.cuts());
        return on.picture();
    }

    std::vector<std::uint32_t> paint_lines() {
        canvas on;
        l3d_shading shading;
        shading.background = {0x102030, 0x405060};
        painter_.paint_lines(on.pixels(), shading, order_.triangles(), order_.pieces(),
                             order_.cuts(), {.smooth = true});
        return on.picture();
    }

    const l3d_painter_order& order() const { return order_; }
    std::int64_t written() const { return painter_.counts().written; }

private:
    l3d_workers workers_;
    bool with_sides_;
    l3d_painter_order order_{workers_};
    l3d_painter painter_{workers_};
};

std::vector<std::uint32_t> by_depth_buffer(const std::vector<l3d_painter_triangle>& triangles,
                                           const l3d_shading& shading) {
    canvas on;
    l3d_depth_buffer depth;
    depth.resize(window);
    l3d_surface_rasterizer_scalar rasterizer;
    const std::vector<l3d_material> materials = materials_of(shading, triangles.size());
    rasterizer.use_materials(materials);
    rasterizer.begin(on.pixels(), &depth, shading);
    for (const l3d_painter_triangle& t : triangles) {
        l3d_surface_part part;
        part.triangles.add(t.v[0], t.v[1], t.v[2]);
        part.material = materials.empty() ? 0 : t.material;
        const std::array<const l3d_surface_part*, 1> parts{&part};
        rasterizer.draw(parts);
    }
    rasterizer.finish();
    return on.picture();
}

/// Pixels that differ by more than so many levels of grey, though neither of the two nearest depths
/// ties.
int differences(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b,
                const nearest_triangles& exact, std::int64_t levels = 0) {
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        count += std::abs(std::int64_t{a[i]} - b[i]) > levels * 0x010101 && !exact.tied[i];
    return count;
}

TEST(painter_order, thousands_of_scenes_are_right_in_every_pixel) {
    painting painted(1, false);
    std::int64_t tied = 0, covered = 0, knots = 0, cuts = 0, wrong_unresolved = 0;
    const unsigned count = thorough ? 10000 : 3000;
    for (unsigned seed = 1; seed <= count; ++seed) {
        std::mt19937 random(seed);
        auto triangles = random_triangles(random, window);
        for (l3d_painter_triangle& t : triangles)
            for (l3d_micro_vertex& v : t.v) {
                v.normal[0] = static_cast<float>(random() % 255) / 256;
                v.normal[2] = std::sqrt(1 - v.normal[0] * v.normal[0]);
            }
        const nearest_triangles exact = find_nearest(triangles, window);
        const auto numbers = painted.paint(triangles, show_numbers());
        ASSERT_EQ(differences(numbers, exact.number, exact), 0) << "seed " << seed;
        ASSERT_EQ(differences(numbers, by_depth_buffer(triangles, show_numbers()), exact), 0)
            << "seed " << seed;
        const l3d_shading shading = shaded(seed % 2 ? l3d_shade::lambert : l3d_shade::gouraud);
        ASSERT_EQ(differences(painted.paint(triangles, shading),
                              by_depth_buffer(triangles, shading), exact, 1),
                  0)
            << "shaded, seed " << seed;
        tied += std::ranges::count(exact.tied, true);
        covered += std::ranges::count_if(exact.number, [](std::uint32_t n) { return n > 0; });
        knots += painted.order().counts().knots;
        cuts += painted.order().counts().cuts;
        wrong_unresolved +=
            differences(painted.paint(triangles, show_numbers(), false), exact.number, exact) > 0;
    }
    // The scenes must be hard: most are wrong when only sorted, and many need cuts.
    EXPECT_GT(wrong_unresolved, count / 2);
    EXPECT_GT(knots, count / 2);
    EXPECT_LT(tied * 50, covered); // and what is excluded is little
    RecordProperty("knots", static_cast<int>(knots));
    std::cout << "knots " << knots << ", cuts " << cuts << ", pixels " << covered << ", tied "
              << tied << ", wrong when only sorted " << wrong_unresolved << '\n';
}

/// Large triangles at all angles through each other.
std::vector<l3d_painter_triangle> bush(unsigned count, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<l3d_painter_triangle> triangles(count);
    const auto below = [&](int most) { return static_cast<int>(random() % unsigned(most)); };
    for (unsigned i = 0; i < count; ++i) {
        triangles[i].material = i + 1;
        for (l3d_micro_vertex& v : triangles[i].v)
            v = {below(window.width << l3d_subpixel_bits),
                 below(window.height << l3d_subpixel_bits),
                 static_cast<float>(1 + below(1 << 20)) / (1 << 20),
                 {0, 0, 1}};
    }
    return triangles;
}

TEST(painter_order, a_bush_of_crossing_triangles_is_cut_only_where_it_is_seen) {
    painting painted;
    for (const unsigned count : {49u, 60u, 300u, 1000u}) {
        const auto triangles = bush(count, count);
        const nearest_triangles exact = find_nearest(triangles, window);
        EXPECT_EQ(differences(painted.paint(triangles, show_numbers()), exact.number, exact), 0)
            << count;
        EXPECT_EQ(painted.order().counts().knots, 1);
        // Each with each would be cut into more than count * count / 2 pieces.
        EXPECT_LT(painted.order().pieces().size(), 20u * count);
        std::cout << count << ": " << painted.order().pieces().size() << " pieces, "
                  << painted.order().counts().cuts << " cuts\n";
    }
}

/// Small triangles all over the window, each over some others.
std::vector<l3d_painter_triangle> confetti(unsigned count, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<l3d_painter_triangle> triangles(count);
    const auto below = [&](int most) { return static_cast<int>(random() % unsigned(most)); };
    constexpr int reach = 4 << l3d_subpixel_bits;
    for (unsigned i = 0; i < count; ++i) {
        triangles[i].material = i + 1;
        const int x = below(window.width << l3d_subpixel_bits);
        const int y = below(window.height << l3d_subpixel_bits);
        const auto inv_w = static_cast<float>(1 + below(1 << 20));
        for (l3d_micro_vertex& v : triangles[i].v)
            v = {x + below(reach),
                 y + below(reach),
                 (inv_w + static_cast<float>(below(1 << 12))) / (1 << 21),
                 {static_cast<float>(below(256)) / 256, 0, 1}};
    }
    return triangles;
}

using piece_numbers = std::vector<std::array<std::uint32_t, 2>>;
using cut_numbers = std::vector<std::array<std::uint32_t, 3>>;

piece_numbers numbers_of(std::span<const l3d_painter_piece> pieces) {
    piece_numbers all;
    for (const l3d_painter_piece& piece : pieces)
        all.push_back({piece.triangle, piece.cut});
    return all;
}

cut_numbers numbers_of(std::span<const l3d_painter_cut> cuts) {
    cut_numbers all;
    for (const l3d_painter_cut& cut : cuts)
        all.push_back({cut.splitter, cut.in_front, cut.next});
    return all;
}

TEST(painter_order, any_number_of_threads_gives_the_same_order_and_the_same_bits) {
    std::vector<std::vector<l3d_painter_triangle>> scenes{
        {}, bush(60, 3), confetti(300, 4), confetti(5000, 5)};
    for (unsigned seed = 1; seed <= 100; ++seed) {
        std::mt19937 random(seed);
        scenes.push_back(random_triangles(random, window));
    }
    painting alone;
    std::int64_t out_of_turn = 0;
    for (const int threads : {2, 3, 7}) {
        painting shared(threads);
        for (const auto& scene : scenes) {
            const auto words = alone.paint(scene, show_numbers());
            ASSERT_EQ(shared.paint(scene, show_numbers()), words);
            const l3d_painter_order &one = alone.order(), &many = shared.order();
            ASSERT_EQ(numbers_of(many.pieces()), numbers_of(one.pieces()));
            ASSERT_EQ(numbers_of(many.cuts()), numbers_of(one.cuts()));
            ASSERT_EQ(many.counts().pairs, one.counts().pairs);
            ASSERT_EQ(shared.written(), alone.written());
            ASSERT_EQ(shared.paint_lines(), alone.paint_lines());
            ASSERT_EQ(shared.paint(scene, shaded(l3d_shade::gouraud)),
                      alone.paint(scene, shaded(l3d_shade::gouraud)));
            for (std::size_t i = 1; i < one.pieces().size(); ++i)
                out_of_turn += one.pieces()[i].triangle < one.pieces()[i - 1].triangle;
        }
    }
    EXPECT_GT(out_of_turn, 1000); // so both ways to find what a triangle needs are taken
}

std::vector<std::uint32_t> members_of(std::span<const l3d_painter_piece> pieces) {
    std::vector<std::uint32_t> members;
    for (const l3d_painter_piece& piece : pieces)
        members.push_back(piece.triangle);
    return members;
}

/// The slow twin cuts and paints all members, whether or not they are hidden.
TEST(painter_order, what_a_knot_leaves_out_would_not_show) {
    std::vector<std::vector<l3d_painter_triangle>> scenes{bush(60, 3)};
    for (unsigned seed = 1; seed <= 500; ++seed) {
        std::mt19937 random(seed);
        scenes.push_back(random_triangles(random, window));
    }
    std::size_t left_out = 0;
    for (const auto& scene : scenes) {
        l3d_workers worker(1);
        l3d_painter_order order(worker); // sorts, and drops what has no area
        order.make(scene, window, {.resolve = false});
        const nearest_triangles exact = find_nearest(scene, window);
        std::array<std::vector<l3d_painter_piece>, 2> pieces;
        std::array<std::vector<std::uint32_t>, 2> pictures;
        const std::vector<l3d_material> materials = materials_of(show_numbers(), scene.size());
        for (const std::size_t i : {0u, 1u}) {
            l3d_detail::cycle_cutter knot(i == 0 ? 0 : scene.size());
            std::vector<l3d_painter_cut> cuts;
            knot.untie(worker, window, order.triangles(), members_of(order.pieces()), pieces[i],
                       cuts);
            canvas on;
            l3d_painter painter(worker);
            painter.paint(on.pixels(), show_numbers(), materials, order.triangles(), pieces[i],
                          cuts);
            pictures[i] = on.picture();
        }
        ASSERT_EQ(differences(pictures[0], pictures[1], exact), 0);
        left_out += pieces[1].size() - pieces[0].size();
    }
    EXPECT_GT(left_out, 1000u);
    std::cout << left_out << " pieces left out\n";
}

TEST(painter_order, a_knot_that_was_interrupted_is_untied_afterwards) {
    const auto scene = bush(60, 3);
    l3d_workers asked(1), worker(1);
    l3d_painter_order order(worker);
    order.make(scene, window, {.resolve = false});
    asked.interrupt_when([] { return true; });
    l3d_detail::cycle_cutter knot;
    std::array<std::vector<l3d_painter_piece>, 2> pieces;
    std::vector<l3d_painter_cut> cuts;
    const auto members = members_of(order.pieces());
    EXPECT_THROW(knot.untie(asked, window, order.triangles(), members, pieces[0], cuts),
                 l3d_interrupted);
    pieces[0].clear();
    cuts.clear();
    knot.untie(worker, window, order.triangles(), members, pieces[0], cuts);
    cuts.clear();
    l3d_detail::cycle_cutter().untie(worker, window, order.triangles(), members, pieces[1], cuts);
    EXPECT_EQ(members_of(pieces[0]), members_of(pieces[1]));
}

/// The slow twin paints.
TEST(painter_order, a_piece_is_hidden_if_its_area_and_its_sides_are_covered) {
    int hidden = 0, shown_by_sides = 0;
    for (unsigned seed = 1; seed <= 300; ++seed) {
        std::mt19937 random(seed);
        l3d_workers worker(1);
        l3d_painter_order order(worker);
        const auto triangles = random_triangles(random, window);
        order.make(triangles, window);
        const std::vector<l3d_painter_cut> cuts(order.cuts().begin(), order.cuts().end());
        const auto pieces = order.pieces();
        l3d_detail::painter_cover cover;
        cover.begin(window, triangles, cuts);
        l3d_painter painter(worker);
        const std::vector<l3d_material> materials = materials_of(show_numbers(), triangles.size());
        canvas on;
        for (std::size_t i = pieces.size(); i > 0; --i) {
            const auto piece = pieces.subspan(i - 1, 1), in_front = pieces.subspan(i);
            painter.paint(on.pixels(), show_numbers(), materials, triangles, in_front, cuts);
            const auto covered = on.picture();
            painter.paint(on.pixels(), show_numbers(), materials, triangles, piece, cuts);
            const auto area = on.picture();
            painter.paint_lines(on.pixels(), {}, triangles, piece, cuts, {});
            const auto lines = on.picture();
            painter.paint_lines(on.pixels(), {}, triangles, piece, cuts, {.smooth = true});
            const auto smooth_lines = on.picture();
            const auto hides = [&](const std::vector<std::uint32_t>& picture) {
                for (std::size_t p = 0; p < picture.size(); ++p)
                    if (picture[p] != 0 && covered[p] == 0)
                        return false;
                return true;
            };
            ASSERT_EQ(cover.hides(piece.front()),
                      hides(area) && hides(lines) && hides(smooth_lines))
                << "seed " << seed;
            hidden += hides(area) && hides(lines) && hides(smooth_lines);
            shown_by_sides += hides(area) && !hides(lines);
            cover.add(piece.front());
        }
    }
    EXPECT_GT(hidden, 100);
    EXPECT_GT(shown_by_sides, 100);
}

TEST(painter_order, the_cycle_of_three_rectangles) {
    const auto triangles = rectangle_cycle(window);
    const nearest_triangles exact = find_nearest(triangles, window);
    painting painted;
    EXPECT_EQ(differences(painted.paint(triangles, show_numbers()), exact.number, exact), 0);
    EXPECT_EQ(painted.order().counts().knots, 1);
    EXPECT_GE(painted.order().counts().cuts, 1);
    EXPECT_GT(differences(painted.paint(triangles, show_numbers(), false), exact.number, exact), 0);
}

/// A corner of the first one, which has the farthest corner of all, is in front of the second one.
/// It lies between the centres of two columns, so the boxes have no pixel in common.
TEST(painter_order, triangles_that_meet_beside_all_pixels_are_ordered_for_their_sides) {
    const auto corner = [](double x, double y, float inv_w) {
        return l3d_micro_vertex{static_cast<int>(256 * x), static_cast<int>(256 * y), inv_w, {}};
    };
    const std::vector<l3d_painter_triangle> triangles{
        {{corner(8, 5, 0.1f), corner(18.25, 10, 0.9f), corner(8, 15, 0.1f)}},
        {{corner(18.0625, 2, 0.5f), corner(18.0625, 18, 0.5f), corner(28, 10, 0.5f)}}};
    l3d_workers workers(1);
    l3d_painter_order order(workers);
    order.make(triangles, window, {.sides = true});
    EXPECT_EQ(members_of(order.pieces()), (std::vector<std::uint32_t>{1, 0}));
    order.make(triangles, window, {.sides = false});
    EXPECT_EQ(members_of(order.pieces()), (std::vector<std::uint32_t>{0, 1}));
}

TEST(painter_order, nothing_and_what_covers_nothing) {
    painting painted;
    EXPECT_EQ(painted.paint({}, show_numbers()), std::vector<std::uint32_t>(57 * 41, 0u));
    l3d_painter_triangle flat{};
    for (int i = 0; i < 3; ++i)
        flat.v[static_cast<std::size_t>(i)] = {1000 * i, 2000 * i, 1, {0, 0, 1}};
    flat.material = 1;
    painted.paint({flat}, show_numbers());
    EXPECT_TRUE(painted.order().pieces().empty());
}

} // namespace
} // namespace pipeline_tests
