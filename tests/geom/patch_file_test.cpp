// SPDX-License-Identifier: MIT
// Patch files: what is read, what is refused and how it is said, and the teapots that we ship.
#include "base/printable_p.h"
#include "geom/files/patch_file.h"

#include "patch_points.h"

#include "model_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <locale>
#include <random>
#include <sstream>

namespace {

using model_text::with;

using patches = std::vector<l3d_patch_points>;

/// Two patches: degrees 1 and 2, then 2 and 1; twelve points, each number different.
constexpr std::string_view small_text = "2\n"
                                        "1 2\n"
                                        "0.5 1.25 -2\n3 4 5.5\n"
                                        "6 7 8\n9 10 11\n"
                                        "12 13 14\n15 16 17.75\n"
                                        "2 1\n"
                                        "18 19 20\n21 22 23\n24 25 26\n"
                                        "27 28 29\n30 31 32\n33 34 -3.5e-2\n";

patches read(std::string_view text) {
    return model_text::read_by(l3d_read_bpt, text, "some.bpt");
}

std::string complaint(std::string_view text) {
    return model_text::complaint_of(l3d_read_bpt, text, "some.bpt");
}

TEST(patch_file, has_degrees_and_then_points_with_u_fastest) {
    const patches result = read(small_text);
    ASSERT_EQ(result.size(), 2u);
    EXPECT_EQ(result[0].degree_u, 1);
    EXPECT_EQ(result[0].degree_v, 2);
    const std::vector<triple> first{{0.5, 1.25, -2}, {3, 4, 5.5},  {6, 7, 8},
                                    {9, 10, 11},     {12, 13, 14}, {15, 16, 17.75}};
    EXPECT_EQ(result[0].points, first);
    EXPECT_EQ(result[1].degree_u, 2);
    EXPECT_EQ(result[1].degree_v, 1);
    ASSERT_EQ(result[1].points.size(), 6u);
    EXPECT_EQ(result[1].points[5], (triple{33, 34, -0.035}));
}

TEST(patch_file, accepts_any_white_space_and_number_style) {
    const patches expected = read(small_text);
    std::string crlf;
    std::string one_line;
    std::string spread;
    for (const char c : small_text) {
        crlf += c == '\n' ? "\r\n" : std::string(1, c);
        one_line += c == '\n' ? '\t' : c;
        spread += c == ' ' || c == '\n' ? "\n \n\n" : std::string(1, c);
    }
    EXPECT_EQ(read(crlf), expected);
    EXPECT_EQ(read(one_line), expected);
    EXPECT_EQ(read("\n\r\n  " + spread), expected);
    EXPECT_EQ(read(small_text.substr(0, small_text.size() - 1)), expected);
    EXPECT_EQ(read(with(small_text, "0.5 1.25 -2", "+.5 125e-2 -0.2E+1")), expected);
    EXPECT_EQ(read(with(small_text, "12 13 14", "+12. 13.0 1.4e1")), expected);
}

TEST(patch_file, does_not_depend_on_the_locale) {
    struct comma final : std::numpunct<char> {
        comma() : numpunct(1) {} // 1: the locale does not delete it
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\1"; }
    };
    const comma facet;
    const patches expected = read(small_text);
    const std::locale before =
        std::locale::global(std::locale(std::locale::classic(), const_cast<comma*>(&facet)));
    std::ostringstream check;
    check << 12.5;
    EXPECT_EQ(check.str(), "1.2,5");
    EXPECT_EQ(read(small_text), expected);
    EXPECT_EQ(read(l3d_write_bpt(expected)), expected);
    std::locale::global(before);
}

TEST(patch_file, has_weights_where_it_says_so) {
    const std::string text = "2\n1 1 rational # of a circle\n0 0 0 1\n1 0 0 .5\n0 1 0 2\n1 1 0 4\n"
                             "1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
    const patches expected = read(text);
    ASSERT_EQ(expected.size(), 2u);
    EXPECT_EQ(expected[0].weights, (std::vector<double>{1, 0.5, 2, 4}));
    EXPECT_TRUE(expected[1].weights.empty());
    EXPECT_EQ(expected[0].points, expected[1].points);
    EXPECT_EQ(read(l3d_write_bpt(expected)), expected);
}

TEST(patch_file, says_where_and_what_is_wrong) {
    EXPECT_EQ(complaint(""), "some.bpt:1: the text ends where the number of patches should be");
    EXPECT_EQ(complaint("\n\n"), "some.bpt:3: the text ends where the number of patches should be");
    EXPECT_EQ(complaint("two"), "some.bpt:1: 'two', the number of patches, is not a whole number");
    EXPECT_EQ(complaint("2.5"), "some.bpt:1: '2.5', the number of patches, is not a whole number");
    EXPECT_EQ(complaint("\n0 3 3"), "some.bpt:2: the number of patches is 0, not positive");
    EXPECT_EQ(complaint("-4 3 3"), "some.bpt:1: the number of patches is -4, not positive");
    EXPECT_EQ(complaint(with(small_text, "2\n", "9000000000000000000\n")),
              "some.bpt:1: the text is too short for 9000000000000000000 patches");
    EXPECT_EQ(complaint(with(small_text, "2\n", "9000000000000000000000\n")),
              "some.bpt:1: '9000000000000000000000', the number of patches, is out of range");
    EXPECT_EQ(complaint(with(small_text, "1 2\n", "0 2\n")),
              "some.bpt:2: '0', the degree in u in patch 1 of 2, is not in 1 to 15");
    EXPECT_EQ(complaint(with(small_text, "2 1\n", "2 16\n")),
              "some.bpt:9: '16', the degree in v in patch 2 of 2, is not in 1 to 15");
    EXPECT_EQ(complaint(with(small_text, "9 10", "9 1O")),
              "some.bpt:6: '1O', a coordinate in patch 1 of 2, is not a number");
    EXPECT_EQ(complaint(with(small_text, "9 10", "nan 10")),
              "some.bpt:6: 'nan', a coordinate in patch 1 of 2, is not finite");
    EXPECT_EQ(complaint(with(small_text, "30", "-inf")),
              "some.bpt:14: '-inf', a coordinate in patch 2 of 2, is not finite");
    EXPECT_EQ(complaint(with(small_text, "30", "1e999")),
              "some.bpt:14: '1e999', a coordinate in patch 2 of 2, is out of range");
    EXPECT_EQ(complaint(with(small_text, "30", "1.0001e12")),
              "some.bpt:14: '1.0001e12', a coordinate in patch 2 of 2, is beyond 1e12");
    EXPECT_EQ(complaint(with(small_text, "30", "-2e12")),
              "some.bpt:14: '-2e12', a coordinate in patch 2 of 2, is beyond 1e12");
    EXPECT_EQ(complaint(std::string(small_text) + "\n7"),
              "some.bpt:17: '7' follows the last of 2 patches");
    EXPECT_EQ(complaint(small_text.substr(0, small_text.find(" -3.5e-2"))),
              "some.bpt:15: the text ends where a coordinate in patch 2 of 2 should be");
    EXPECT_EQ(complaint(with(small_text, "9 10", "9 0x1")),
              "some.bpt:6: '0x1', a coordinate in patch 1 of 2, is not a number");
    EXPECT_EQ(complaint(with(small_text, "9 10", "9 +-1")),
              "some.bpt:6: '+-1', a coordinate in patch 1 of 2, is not a number");
    EXPECT_EQ(read(with(small_text, "30", "-1e12"))[1].points[4][0], -1e12);
}

TEST(patch_file, shows_strange_tokens_escaped_and_shortened) {
    EXPECT_EQ(complaint(std::string_view("\x1b[2J\0'\\\xff", 8)),
              "some.bpt:1: '\\x1b[2J\\x00\\x27\\x5c\\xff', the number of patches, "
              "is not a whole number");
    EXPECT_EQ(complaint("gr\xc3\xbcn\xc3"),
              "some.bpt:1: 'gr\xc3\xbcn\\xc3', the number of patches, is not a whole number");
    EXPECT_EQ(complaint(std::string(23, 'a') + "\xc3\xbc" + "a"),
              "some.bpt:1: 'aaaaaaaaaaaaaaaaaaaaaaa\xc3\xbc...', the number of patches, "
              "is not a whole number");
    EXPECT_EQ(complaint(std::string(100000, 'a')),
              "some.bpt:1: 'aaaaaaaaaaaaaaaaaaaaaaaa...', the number of patches, "
              "is not a whole number");
}

TEST(patch_file, truncated_anywhere_is_an_error) {
    for (const std::string& text :
         {std::string(small_text), model_text::of_file("data/teapot_bottom.bpt")}) {
        // A cut within the last number may leave a number.
        const std::size_t last_number = text.find_last_of(' ') + 1;
        for (std::size_t length = 0; length <= last_number; ++length) {
            std::string why;
            // A buffer of its own: a read beyond its end is seen by the sanitizer.
            const std::vector<char> copy(text.begin(),
                                         text.begin() + static_cast<std::ptrdiff_t>(length));
            ASSERT_FALSE(l3d_read_bpt({copy.data(), copy.size()}, "cut", why)) << length;
            ASSERT_TRUE(why.starts_with("cut:")) << why;
        }
    }
}

std::string mutated(std::string text, std::mt19937& random) {
    static constexpr std::string_view pieces[] = {
        "nan", "inf", "1e999", "-1", "16", "0", "99999999999999999999", " ", "\n", "1e-999",
        "-",   "+",   ".",     "e",  "\r", "2", "1000000000",           ",", "#",  "0x1p3"};
    const auto below = [&](std::size_t end) { return random() % std::max<std::size_t>(end, 1); };
    for (auto count = 1 + below(4); count > 0; --count) {
        const auto at = below(text.size() + 1);
        const auto length = below(6);
        switch (below(5)) {
        case 0:
            text.erase(at, length);
            break;
        case 1:
            text.insert(at, 1, static_cast<char>(random()));
            break;
        case 2:
            text.insert(at, pieces[below(std::size(pieces))]);
            break;
        case 3:
            text.replace(at, std::min(length, text.size() - at), pieces[below(std::size(pieces))]);
            break;
        default:
            text.insert(at, text.substr(below(text.size()), below(text.size())));
        }
    }
    return text;
}

TEST(patch_file, random_damage_is_survived_and_explained) {
    constexpr unsigned seed = 31415;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    int read = 0;
    for (int i = 0; i < 100'000; ++i) {
        const std::string text = mutated(std::string(small_text), random);
        const std::vector<char> copy(text.begin(), text.end());
        std::string why;
        const auto result = l3d_read_bpt({copy.data(), copy.size()}, "bad", why);
        if (result) {
            ++read;
            std::string unused;
            ASSERT_EQ(l3d_read_bpt(l3d_write_bpt(*result), "again", unused), result) << text;
            for (const l3d_patch_points& patch : *result)
                static_cast<void>(l3d_as_bicubic(patch));
        } else {
            ASSERT_TRUE(why.starts_with("bad:")) << why;
            ASSERT_LT(why.size(), 250u) << why;
            ASSERT_EQ(l3d_detail::printable(why), why);
        }
    }
    EXPECT_GT(read, 1000); // the damage is not always fatal, else the test shows little
    EXPECT_LT(read, 50'000);
}

TEST(patch_file, writing_and_reading_gives_the_same_bits) {
    constexpr unsigned seed = 271;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    patches written(100);
    for (l3d_patch_points& patch : written) {
        patch.degree_u = static_cast<int>(1 + random() % 15);
        patch.degree_v = static_cast<int>(1 + random() % 15);
        patch.points.resize(points_along(patch.degree_u) * points_along(patch.degree_v));
        for (triple& p : patch.points)
            for (double& value : p)
                do
                    value = std::bit_cast<double>(random());
                while (!(std::abs(value) <= 1e12));
    }
    written[1].points[0] = {-0.0, 5e-324, -1e12};
    written[1].points[1] = {0.1, 2.2250738585072014e-308, 1.0 / 3};
    const patches again = read(l3d_write_bpt(written));
    ASSERT_EQ(again, written);
    EXPECT_TRUE(std::signbit(again[1].points[0][0]));
}

using row = std::vector<triple>;

/// The four boundary rows of a bicubic patch: v = 0, v = 1, u = 0, u = 1.
std::array<row, 4> boundary(const l3d_patch_points& patch) {
    const auto& p = patch.points;
    return {row{p[0], p[1], p[2], p[3]}, row{p[12], p[13], p[14], p[15]},
            row{p[0], p[4], p[8], p[12]}, row{p[3], p[7], p[11], p[15]}};
}

TEST(teapot, is_the_body_and_with_a_bottom_has_four_patches_more) {
    const patches body = read(model_text::of_file("data/teapot.bpt"));
    const patches closed = read(model_text::of_file("data/teapot_bottom.bpt"));
    ASSERT_EQ(body.size(), 28u);
    ASSERT_EQ(closed.size(), 32u);
    EXPECT_TRUE(std::equal(body.begin(), body.end(), closed.begin()));
    for (const l3d_patch_points& patch : closed)
        EXPECT_TRUE(patch.degree_u == 3 && patch.degree_v == 3);
}

TEST(teapot, bottom_shares_its_boundary_bit_for_bit) {
    const patches closed = read(model_text::of_file("data/teapot_bottom.bpt"));
    ASSERT_EQ(closed.size(), 32u);
    for (std::size_t i = 28; i < 32; ++i) {
        const auto edges = boundary(closed[i]);
        const std::size_t next = i == 31 ? 28 : i + 1;
        EXPECT_EQ(edges[3], boundary(closed[next])[2]) << i;
        // Patches 8 to 11 are the lower body; their last row is the rim.
        EXPECT_EQ(edges[0], boundary(closed[i - 20])[1]) << i;
        for (const triple& p : edges[1])
            EXPECT_EQ(p, (triple{0, -0.15, 0}));
    }
}

TEST(teapot, bottom_is_the_rim_moved_down_and_in) {
    const patches closed = read(model_text::of_file("data/teapot_bottom.bpt"));
    ASSERT_EQ(closed.size(), 32u);
    for (std::size_t i = 28; i < 32; ++i)
        for (std::size_t k = 0; k < 4; ++k) {
            const auto& p = closed[i].points;
            EXPECT_EQ(p[4 + k], (triple{p[k][0], -0.075, p[k][2]})) << i;
            // 1.425 of 1.5, tangents alike: 0.95.
            EXPECT_NEAR(p[8 + k][0], 0.95 * p[k][0], 1e-15) << i;
            EXPECT_NEAR(p[8 + k][2], 0.95 * p[k][2], 1e-15) << i;
            EXPECT_EQ(p[8 + k][1], -0.15) << i;
        }
}

TEST(teapot, bottom_faces_outward_as_the_body_does) {
    const patches closed = read(model_text::of_file("data/teapot_bottom.bpt"));
    ASSERT_EQ(closed.size(), 32u);
    for (std::size_t i = 4; i < 32; i = i == 11 ? 28 : i + 1) {
        constexpr double h = 1e-4;
        const triple p = on_surface(closed[i], 0.4, 0.3);
        const triple du = on_surface(closed[i], 0.4 + h, 0.3);
        const triple dv = on_surface(closed[i], 0.4, 0.3 + h);
        double outward = 0; // (S_u x S_v) . (p - (0, 1, 0)), a point inside
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t l = (k + 1) % 3;
            const std::size_t m = (k + 2) % 3;
            const double normal = (du[l] - p[l]) * (dv[m] - p[m]) - (du[m] - p[m]) * (dv[l] - p[l]);
            outward += normal * (p[k] - (k == 1 ? 1 : 0));
        }
        EXPECT_GT(outward / (h * h), 0.1) << i;
    }
}

} // namespace
