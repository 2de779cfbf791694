// SPDX-License-Identifier: MIT
// Patches that are left out or cut, and that nothing depends on chance.
#include "nasty.h"
#include "picture.h"
#include "scene.h"

#include "reference/random_patches.h"

#include <gtest/gtest.h>

namespace dice_tests {
namespace {

template <class T> class patch_dicer : public ::testing::Test {};
TYPED_TEST_SUITE(patch_dicer, number_types, type_names);

/// A nearly flat patch that fills the rectangle x0..x1, y0..y1 of the picture at distance w.
reference::patch seen_at(double x0, double y0, double x1, double y1, double w) {
    const reference::camera_frame frame(oblique, {odd.width, odd.height});
    reference::patch result;
    for (std::size_t k = 0; k < 16; ++k) {
        const double a = static_cast<double>(k % 4) / 3, b = static_cast<double>(k / 4) / 3;
        const double bulge = k % 4 % 3 != 0 && k / 4 % 3 != 0 ? 1.1 : 1;
        result.points[k] = frame.unproject(x0 + a * (x1 - x0), y0 + b * (y1 - y0), w * bulge);
    }
    return result;
}

bool same(const picture& a, const picture& b) {
    for (int y = 0; y < a.size().height; ++y)
        for (int x = 0; x < a.size().width; ++x)
            if (a.inv_w(x, y) != b.inv_w(x, y))
                return false;
    return a.words() == b.words();
}

TYPED_TEST(patch_dicer, counts_what_it_leaves_out_and_why) {
    const scene s({seen_at(40, 30, 210, 160, 3), seen_at(-90, 30, -2, 160, 3),
                   seen_at(330, 30, 400, 160, 3), seen_at(40, -60, 210, -3, 3),
                   seen_at(40, 30, 210, 160, 0.1), seen_at(77.6, 50.6, 78.4, 51.4, 3),
                   seen_at(90, 200, 160, 239, 3)},
                  oblique, odd);
    picture drawn(odd), all(odd);
    const l3d_dice_counts counts = dice<TypeParam>(s, 0.25, drawn);
    EXPECT_EQ(counts.drawn, 2);
    EXPECT_EQ(counts.offscreen, 3);
    EXPECT_EQ(counts.behind, 1);
    EXPECT_EQ(counts.subpixel, 1);
    EXPECT_EQ(counts.pieces, 2);
    EXPECT_EQ(counts.clipped, 0);
    const l3d_dice_counts kept = dice<TypeParam>(s, 0.25, all, l3d_culling_switches::all());
    EXPECT_EQ(kept.drawn, 7);
    EXPECT_EQ(kept.offscreen + kept.behind + kept.subpixel, 0);
    EXPECT_TRUE(same(drawn, all));
    // 170 x 130 and 70 x 39 pixels, and nothing else.
    EXPECT_EQ(drawn.uncovered(), 317 * 241 - 170 * 130 - 70 * 39);
}

TYPED_TEST(patch_dicer, leaving_out_does_not_change_the_picture) {
    for (const reference::view& view : reference::project_views()) {
        const scene s = teapot(view, odd);
        picture drawn(odd), all(odd);
        dice<TypeParam>(s, 0.25, drawn);
        dice<TypeParam>(s, 0.25, all, l3d_culling_switches::all());
        EXPECT_TRUE(same(drawn, all)) << view.name;
    }
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const scene s(
            nasty_patches(seed, nasty_kind::around_eye, 5, oblique, {odd.width, odd.height}),
            oblique, odd);
        picture drawn(odd), all(odd);
        dice<TypeParam>(s, 0.5, drawn);
        dice<TypeParam>(s, 0.5, all, l3d_culling_switches::all());
        EXPECT_TRUE(same(drawn, all)) << "seed " << seed;
    }
}

/// Adds up everything it is given, in order.
class hash_sink {
public:
    std::uint64_t hash = 14695981039346656037u;

    void draw(diced pieces, double bound) {
        for (const l3d_diced_piece& piece : pieces) {
            const l3d_micro_grid& grid = piece.part.grid;
            for (int r = 0; r < grid.rows; ++r)
                for (int c = 0; c < grid.columns; ++c)
                    add(grid.vertex(r, c), piece.u[static_cast<std::size_t>(c)],
                        piece.v[static_cast<std::size_t>(r)]);
            for (std::size_t i = 0; i < piece.part.triangles.count; ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    add(piece.part.triangles.vertex(i, k), piece.triangle_uv[k].at(i).u,
                        piece.triangle_uv[k].at(i).v);
            add(&piece.bound, sizeof piece.bound);
        }
        add(&bound, sizeof bound);
    }

private:
    void add(const void* data, std::size_t size) { // FNV-1a
        for (std::size_t i = 0; i < size; ++i)
            hash = (hash ^ static_cast<const unsigned char*>(data)[i]) * 1099511628211u;
    }
    void add(const l3d_micro_vertex& v, double a, double b) {
        add(&v, sizeof v);
        add(&a, sizeof a);
        add(&b, sizeof b);
    }
};

TYPED_TEST(patch_dicer, gives_the_same_bits_again_whatever_it_diced_before) {
    scene_dicer<TypeParam> used;
    for (const reference::view& view : reference::project_views()) {
        const scene s = teapot(view, odd);
        hash_sink fresh, again;
        dice<TypeParam>(s, 0.1, fresh);
        used.dice(s, 0.1,
                  [&](std::size_t, diced pieces, double bound) { again.draw(pieces, bound); });
        EXPECT_EQ(fresh.hash, again.hash) << view.name;
    }
}

/// Pieces that are walked, evaluated and clipped meet there.
TYPED_TEST(patch_dicer, corners_have_one_place_however_a_piece_is_drawn) {
    int compared = 0;
    for (const reference::view& view : reference::project_views()) {
        const scene s = teapot(view, odd);
        const l3d_image_transform to_image(s.camera, s.size, s.model);
        const l3d_dice_view dice_view = to_image.view(0.25);
        const auto check = [&](std::size_t patch, diced pieces, double) {
            if (pieces.size() != 1 || pieces[0].part.grid.rows == 0)
                return;
            const l3d_micro_grid& grid = pieces[0].part.grid;
            const l3d_image_patch net = l3d_placed_net(to_image.matrix(), s.model.patches()[patch]);
            for (const bool high_v : {false, true})
                for (const bool high_u : {false, true}) {
                    const l3d_micro_vertex corner =
                        grid.vertex(high_v ? grid.rows - 1 : 0, high_u ? grid.columns - 1 : 0);
                    const l3d_clip_vertex exact =
                        l3d_canonical_vertex(net.at(high_v ? 3 : 0, high_u ? 3 : 0), dice_view);
                    EXPECT_EQ(corner.x, exact.dice.vertex.x);
                    EXPECT_EQ(corner.y, exact.dice.vertex.y);
                    EXPECT_EQ(corner.inv_w, exact.dice.vertex.inv_w);
                    ++compared;
                }
        };
        scene_dicer<TypeParam>().dice(s, 0.25, check);
    }
    EXPECT_GT(compared, 400);
}

TYPED_TEST(patch_dicer, finer_tolerance_takes_more_samples_and_cuts_in_the_end) {
    const scene s = teapot(reference::project_view("closeup"), {640, 481});
    std::int64_t before = 0;
    l3d_dice_counts counts;
    for (const double tolerance : {2.0, 0.5, 0.125, 0.03, 0.0078}) {
        hash_sink sink;
        counts = dice<TypeParam>(s, tolerance, sink);
        // A quarter of the tolerance doubles both numbers of steps, if rounding leaves any: two
        // steps, which are balanced, do for nearly three times the error of one.
        EXPECT_GT(counts.samples, before);
        if (before > 0 && tolerance > 0.02) {
            EXPECT_GT(static_cast<double>(counts.samples), 2.0 * static_cast<double>(before));
            EXPECT_LT(static_cast<double>(counts.samples), 5.5 * static_cast<double>(before));
        }
        before = counts.samples;
    }
    EXPECT_GE(counts.pieces, counts.drawn);
}

TYPED_TEST(patch_dicer, a_patch_beyond_32_steps_a_strip_is_cut) {
    // A fold of the size of the window, to a thousandth of a pixel: sqrt(M / (4 tol)) is about
    // sqrt(6 * 1000 / 0.02) = 550 steps, in strips 137.
    reference::patch bent = seen_at(20, 15, 300, 220, 3);
    std::swap(bent.points[5], bent.points[10]);
    const scene s({bent}, oblique, odd);
    hash_sink sink;
    const l3d_dice_counts counts = dice<TypeParam>(s, 0.005, sink);
    EXPECT_EQ(counts.drawn, 1);
    EXPECT_GT(counts.pieces, 1);
}

TYPED_TEST(patch_dicer, nothing_is_drawn_beyond_the_far_plane) {
    scene s = teapot(reference::project_view("full"), odd);
    picture all(odd), cut(odd), none(odd);
    dice<TypeParam>(s, 0.25, all);
    s.camera.far_z = 8.3;
    const l3d_dice_counts counts = dice<TypeParam>(s, 0.25, cut);
    EXPECT_GT(counts.beyond, 0);
    EXPECT_GT(counts.clipped, 0);
    std::int64_t near = 0, far = 0;
    for (int y = 1; y + 1 < odd.height; ++y)
        for (int x = 1; x + 1 < odd.width; ++x) {
            EXPECT_TRUE(!cut.covered(x, y) || cut.inv_w(x, y) > 1 / 8.3001f) << x << " " << y;
            // Everything well before the plane is still there, except outlines.
            bool is_near = true;
            for (int n = 0; n < 9; ++n)
                is_near = is_near && all.inv_w(x - 1 + n % 3, y - 1 + n / 3) > 1 / 8.2f;
            near += is_near;
            EXPECT_TRUE(!is_near || cut.covered(x, y)) << x << " " << y;
            far += all.covered(x, y) && !cut.covered(x, y);
        }
    EXPECT_GT(near, 1000);
    EXPECT_GT(far, 1000);
    s.camera.far_z = 4;
    EXPECT_EQ(dice<TypeParam>(s, 0.25, none).beyond, 28);
    EXPECT_EQ(none.uncovered(), 317 * 241);
}

} // namespace
} // namespace dice_tests
