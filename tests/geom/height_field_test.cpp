// SPDX-License-Identifier: MIT
// Height fields: patches through all heights that join without a gap or a crease, and their files.
#include "geom/files/patch_file.h"
#include "geom/files/model_file.h"

#include "base/error.h"
#include "model_text.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

using point = std::array<double, 3>;

l3d_height_field hills(std::size_t columns, std::size_t rows) {
    l3d_height_field field{.columns = columns, .heights = {}, .spacing = 0.3};
    for (std::size_t i = 0; i < columns * rows; ++i)
        field.heights.push_back(std::sin(static_cast<double>(i * i % 37)));
    return field;
}

/// A patch's point: u runs along z, v along x.
const point& at(const l3d_patch_points& patch, std::size_t u, std::size_t v) {
    return patch.points[4 * v + u];
}

TEST(height_field, goes_through_all_heights_and_joins_without_gap_or_crease) {
    constexpr std::size_t columns = 7, rows = 5;
    const l3d_height_field field = hills(columns, rows);
    const auto patches = l3d_height_patches(field);
    ASSERT_EQ(patches.size(), (columns - 1) * (rows - 1));
    for (std::size_t r = 0; r + 1 < rows; ++r)
        for (std::size_t c = 0; c + 1 < columns; ++c) {
            const l3d_patch_points& here = patches[r * (columns - 1) + c];
            const point& corner = at(here, 0, 0);
            EXPECT_EQ(corner[1], field.heights[r * columns + c]);
            EXPECT_EQ(at(here, 3, 3)[1], field.heights[(r + 1) * columns + c + 1]);
            EXPECT_NEAR(corner[0], 0.3 * (static_cast<double>(c) - 3), 1e-15);
            EXPECT_NEAR(corner[2], 0.3 * (static_cast<double>(r) - 2), 1e-15);
            for (std::size_t i = 0; i < 4; ++i) {
                if (c + 2 < columns) {
                    const l3d_patch_points& right = patches[r * (columns - 1) + c + 1];
                    EXPECT_EQ(at(here, i, 3), at(right, i, 0));
                    EXPECT_NEAR(at(here, i, 3)[1] - at(here, i, 2)[1],
                                at(right, i, 1)[1] - at(right, i, 0)[1], 1e-14);
                }
                if (r + 2 < rows) {
                    const l3d_patch_points& below = patches[(r + 1) * (columns - 1) + c];
                    EXPECT_EQ(at(here, 3, i), at(below, 0, i));
                    EXPECT_NEAR(at(here, 3, i)[1] - at(here, 2, i)[1],
                                at(below, 1, i)[1] - at(below, 0, i)[1], 1e-14);
                }
            }
        }
}

/// Where the heights are a plane, so is the surface, up to its borders.
TEST(height_field, of_a_plane_is_that_plane_and_turns_its_front_upwards) {
    l3d_height_field field{.columns = 4, .heights = {}};
    for (int i = 0; i < 12; ++i)
        field.heights.push_back(2 * (i % 4) - 3 * (i / 4));
    for (const l3d_patch_points& patch : l3d_height_patches(field)) {
        for (const point& p : patch.points)
            EXPECT_NEAR(p[1], 2 * (p[0] + 1.5) - 3 * (p[2] + 1), 1e-13);
        const point &o = at(patch, 0, 0), &u = at(patch, 3, 0), &v = at(patch, 0, 3);
        const double up = (u[2] - o[2]) * (v[0] - o[0]) - (u[0] - o[0]) * (v[2] - o[2]);
        EXPECT_GT(up, 0);
    }
}

TEST(height_field, leaves_out_what_has_a_missing_corner_and_refuses_what_is_no_field) {
    l3d_height_field field = hills(5, 5);
    field.heights[12] = std::nan(""); // in the middle: a corner of four patches
    const auto patches = l3d_height_patches(field);
    EXPECT_EQ(patches.size(), 12U);
    for (const l3d_patch_points& patch : patches)
        for (const point& p : patch.points)
            EXPECT_TRUE(std::isfinite(p[1]));
    field.spacing = 0;
    EXPECT_THROW(l3d_height_patches(field), l3d_error);
    field = hills(5, 5);
    field.heights.pop_back();
    EXPECT_THROW(l3d_height_patches(field), l3d_error);
    field = hills(5, 5);
    field.heights[7] = 2e12;
    EXPECT_NE(field.complaint().find("row 2, column 3"), std::string::npos) << field.complaint();
}

const std::string grid = "ncols 3\nnrows 2\nxllcorner 500000\nyllcorner 4e6\ncellsize 10\n"
                         "NODATA_value -1\n0 1 2\n3 4.5 6\n"; // eight lines

TEST(height_field, is_read_from_a_grid) {
    const l3d_model_file model = model_text::read_by(l3d_read_model, grid, "hill.asc");
    l3d_height_field field{.columns = 3, .heights = {0, 1, 2, 3, 4.5, 6}, .spacing = 10};
    EXPECT_EQ(model.patches, l3d_height_patches(field));
    const std::string missing = model_text::with(grid, "0 1 2", "-1 1 2");
    EXPECT_EQ(model_text::read_by(l3d_read_model, missing, "hill.asc").patches.size(), 1U);
}

TEST(height_field, of_a_bad_grid_says_where_and_what_is_wrong) {
    const auto says = [](const char* old, const char* replacement, const char* what) {
        EXPECT_EQ(model_text::complaint_of(l3d_read_model, model_text::with(grid, old, replacement),
                                           "hill.asc"),
                  what);
    };
    says("ncols 3", "ncols 1", "hill.asc:1: '1', the number of columns, is not in 2 to 524288");
    says("nrows 2\n", "", "hill.asc:6: nrows is missing");
    says("cellsize 10", "cellsize 0", "hill.asc:5: cellsize is '0', not positive");
    says("cellsize", "dx",
         "hill.asc:5: 'dx' is none of ncols, nrows, xllcorner, yllcorner, "
         "xllcenter, yllcenter, cellsize and nodata_value");
    says("4.5", "x", "hill.asc:8: 'x', y of height 5 of 6, is not a number");
    says("5 6\n", "5 6 7\n", "hill.asc:8: '7' follows the last of 6 heights");
    says("-1\n0 1 2", "0\n0 0 0", "hill.asc:9: no four neighbours have heights");
    says("ncols 3\nnrows 2", "ncols 2000\nnrows 2000",
         "hill.asc:7: 2000 x 2000 heights are more than 1048576");
}

} // namespace
