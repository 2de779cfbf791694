// SPDX-License-Identifier: MIT
// l3d_font: lines of letters, and the built-in face.
#include "raster/shapes/font.h"

#include "raster/paths/path.h"
#include "raster/shapes/font_face_p.h"
#include "raster/shapes/font_p.h"
#include "raster/shapes/text.h"
#include "raster/shapes/utf8_p.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace {

using namespace l3d_detail;

/// Seven rows of capitals are 0.7 of ten.
constexpr int rows_of_em = 10;

/// The box stands for what is unknown.
int character_of(char32_t code) {
    const bool known =
        code >= static_cast<char32_t>(font_first) && code < static_cast<char32_t>(font_box);
    return known ? static_cast<int>(code) : font_box;
}

/// Smaller ones are drawn as they are.
int pixels_of_dot(int size) {
    return std::max(1, (size + rows_of_em / 2 - 1) / rows_of_em);
}

} // namespace

l3d_font::face::line_heights l3d_font::built_in_face::heights(int size) {
    const int dot = pixels_of_dot(size);
    return {dot * (font_height + 1), dot * (l3d_text_line + 1)};
}

l3d_font::face::letter l3d_font::built_in_face::make(char32_t code, int size) {
    const int dot = pixels_of_dot(size);
    const int character = character_of(code);
    letter made{.left = 0,
                .top = -dot * font_height,
                .width = dot * font_width,
                .height = dot * font_height,
                .coverage = {},
                .advance = dot * l3d_text_advance};
    for (int y = 0; y < made.height; ++y)
        for (int x = 0; x < made.width; ++x)
            made.coverage.push_back(font_ink(character, x / dot, y / dot) ? 255 : 0);
    return made;
}

/// Each run of dots in a row is a box.
double l3d_font::built_in_face::outline(l3d_path& to, l3d_point_2d base, std::string_view text,
                                        double size) {
    const double dot = size / rows_of_em;
    double x = base.x;
    for (; !text.empty(); x += dot * l3d_text_advance) {
        const int character = character_of(take_character(text));
        for (int row = 0; row < font_height; ++row)
            for (int begin = 0, end = 0; begin < font_width; begin = end + 1) {
                for (end = begin; end < font_width && font_ink(character, end, row);)
                    ++end;
                const double left = x + begin * dot, right = x + end * dot;
                const double top = base.y + (row - font_height) * dot, bottom = top + dot;
                if (begin < end)
                    to.add_polygon(std::array<l3d_point_2d, 4>{
                        {{left, top}, {right, top}, {right, bottom}, {left, bottom}}});
            }
    }
    return x - base.x;
}

l3d_font::l3d_font() : l3d_font(std::make_shared<built_in_face>(), "built-in") {}

l3d_font::l3d_font(std::shared_ptr<face> of, std::string name)
    : face_(std::move(of)), name_(std::move(name)) {}

int l3d_font::line(int size) const {
    return face_->heights(size).line;
}

int l3d_font::width(std::string_view text, int size) const {
    int sum = 0;
    while (!text.empty())
        sum += face_->at(take_character(text), size).advance;
    return sum;
}

void l3d_font::draw(l3d_rasterizer_2d& rasterizer, int x, int y, std::string_view text,
                    std::uint32_t color, int size) const {
    assert(size >= 1);
    const int base = y + face_->heights(size).ascent;
    while (!text.empty()) {
        const face::letter& next = face_->at(take_character(text), size);
        rasterizer.draw_coverage({.left = x + next.left,
                                  .top = base + next.top,
                                  .width = next.width,
                                  .height = next.height,
                                  .values = next.coverage.data(),
                                  .pitch = next.width},
                                 color);
        x += next.advance;
    }
}

double l3d_font::outline(l3d_path& to, l3d_point_2d base, std::string_view text,
                         double size) const {
    return size > 0 && std::isfinite(size) ? face_->outline(to, base, text, size) : 0;
}
