// SPDX-License-Identifier: MIT
// Rational and NURBS surfaces of .obj, .bpt and geomview files that are refused, and their lines.
#include "geom/files/model_file.h"
#include "geom/files/patch_file.h"

#include "model_text.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace {

/// A change of a good text, and the complaint about it without the text's name.
struct refusal {
    std::string_view what, by, complaint;
};

template <class Read, std::size_t Count>
void expect_refused(const Read& read, std::string_view good, const refusal (&all)[Count]) {
    std::string why;
    EXPECT_TRUE(read(good, "it", why)) << why;
    for (const refusal& r : all)
        EXPECT_EQ(model_text::complaint_of(read, model_text::with(good, r.what, r.by), "it"),
                  "it:" + std::string(r.complaint))
            << r.by;
}

TEST(refused_surfaces, of_obj_files_are_told_by_line) {
    constexpr std::string_view good = "v 0 0 0 1\nv 1 0 0 .5\nv 0 1 0\nv 1 1 0\n"
                                      "cstype rat bspline\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\n"
                                      "parm u 0 0 1 1\nparm v -1 0 1 2\nend\n";
    constexpr refusal all[] = {
        {".5", "0", "10: the weight of vertex 2, a control point, is not from 1e-100 to 1e12"},
        {".5", "-.5", "10: the weight of vertex 2, a control point, is not from 1e-100 to 1e12"},
        {".5", "1e-101", "10: the weight of vertex 2, a control point, is not from 1e-100 to 1e12"},
        {".5", "1e13", "10: the weight of vertex 2, a control point, is not from 1e-100 to 1e12"},
        {".5", "nan", "2: 'nan', a weight, is not finite"},
        {".5", "1e999", "2: '1e999', a weight or colour, is out of range"},
        {".5", "half", "2: 'half', a weight or colour, is not a number"},
        {"rat bspline", "rat", "5: cstype names no type"},
        {"rat bspline", "rat nurbs", "5: 'nurbs' is no type of curve or surface"},
        {"deg 1 1", "deg 1 0", "6: '0', a degree, is not in 1 to 15"},
        {"deg 1 1", "deg 16 1", "6: '16', a degree, is not in 1 to 15"},
        {"deg 1 1", "deg 1.5 1", "6: '1.5', a degree, is not a whole number"},
        {"deg 1 1", "deg", "6: deg names no degree"},
        {"deg 1 1", "deg 1", "7: a surface before deg with two degrees"},
        {"surf 0 1", "surf 1 0", "7: the range of a parameter is empty"},
        {"surf 0 1", "surf nan 1", "7: 'nan', the range of a parameter, is not finite"},
        {"1 2 3 4", "1 2 3", "10: the surface has 3 control points; its parameters ask for 2 by 2"},
        {"1 2 3 4", "1 2 3 5", "7: '5', an index, names none of the 4 before it"},
        {"parm u 0 0 1 1\n", "", "9: parm u has fewer knots than twice the degree and 2"},
        {"u 0 0 1 1", "u 0 0 1", "10: parm u has fewer knots than twice the degree and 2"},
        {"u 0 0 1 1", "u 0 0 1 .5", "8: '.5', a parameter, is less than the one before"},
        {"u 0 0 1 1", "u 0 0 1 nan", "8: 'nan', a parameter, is not finite"},
        {"u 0 0 1 1", "u 0 0 1 1e13", "8: '1e13', a coordinate, is beyond 1e12"},
        {"u 0 0 1 1", "u 0 0 .5 .5", "10: parm u does not cover the range of surf"},
        {"u 0 0 1 1", "u 0 0 .5 .5 1 1", "10: parm u has a knot more often than the degree"},
        {"u 0 0 1 1", "u 0 0 .5 1 1",
         "10: the surface has 4 control points; its parameters ask for 3 by 2"},
        {"parm v", "parm u", "9: a second parm 'u' of a surface or curve"},
        {"parm v", "parm w", "9: parm is followed by neither u nor v"},
        {"end\n", "", "10: the text ends in a surface, before its end"},
    };
    expect_refused(l3d_read_obj, good, all);
    expect_refused(l3d_read_obj_surfaces, good, all);
}

TEST(refused_surfaces, of_bpt_files_are_told_by_line) {
    expect_refused(
        l3d_read_bpt, "1\n1 1 rational\n0 0 0 1\n1 0 0 .5\n0 1 0 2\n1 1 0 4\n",
        {{".5", "0", "4: '0', a weight in patch 1 of 1, is not from 1e-100 to 1e12"},
         {".5", "-.5", "4: '-.5', a weight in patch 1 of 1, is not from 1e-100 to 1e12"},
         {".5", "1e-101", "4: '1e-101', a weight in patch 1 of 1, is not from 1e-100 to 1e12"},
         {".5", "2e12", "4: '2e12', a weight in patch 1 of 1, is not from 1e-100 to 1e12"},
         {".5", "nan", "4: 'nan', a weight in patch 1 of 1, is not finite"},
         {".5", "half", "4: 'half', a weight in patch 1 of 1, is not a number"},
         {" 4\n", "", "6: the text ends where a weight in patch 1 of 1 should be"},
         {"rational", "", "6: '1' follows the last of 1 patches"},
         {"rational", "rationel", "2: 'rationel', a coordinate in patch 1 of 1, is not a number"},
         {"1 1 r", "16 1 r", "2: '16', the degree in u in patch 1 of 1, is not in 1 to 15"},
         {"1 1 r", "1 0 r", "2: '0', the degree in v in patch 1 of 1, is not in 1 to 15"}});
}

TEST(refused_surfaces, of_geomview_are_told_by_line) {
    constexpr std::string_view weight = "3: the weight of a control point is not from 1e-100 to "
                                        "1e12";
    expect_refused(
        l3d_read_bez, "BEZ114\n0 0 0 1\n1 0 0 .5\n0 1 0 2\n1 1 0 4\n",
        {{".5", "0", weight},
         {".5", "1e-101", weight},
         {".5", "-1e13", weight},
         {".5", "-.5", "3: patch 1 has different weights, and a negative one among them"},
         {".5", "nan", "3: 'nan', a weight, is not finite"},
         {".5", "half", "3: 'half', a weight, is not a number"},
         {"1 0 0 .5", "1 0 0 1e-13", "3: '1e-13', a coordinate, is beyond 1e12"},
         {" 4\n", "", "5: the text ends where a weight should be"},
         {"BEZ114", "BEZ115",
          "1: 'BEZ115' is neither BBP nor BEZ with two degrees of 1 to 6 and 3 or 4"},
         {"BEZ114", "BEZ014",
          "1: 'BEZ014' is neither BBP nor BEZ with two degrees of 1 to 6 and 3 or 4"},
         {"BEZ114", "BEZ174",
          "1: 'BEZ174' is neither BBP nor BEZ with two degrees of 1 to 6 and 3 or 4"}});
}

} // namespace
