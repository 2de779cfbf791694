// SPDX-License-Identifier: MIT
// l3d_font: draws lines of letters, and has the built-in font.
#include "raster/text/font.h"

#include "raster/paths/path.h"
#include "raster/text/font_face_p.h"
#include "raster/text/font_p.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace {

using namespace l3d_detail;

/// The number of rows of dots in an em: the seven rows of a capital are 0.7 em.
constexpr int rows_of_em = 10;

/// The width of a dot, in pixels, in letters of some size. It is at least 1.
int pixels_of_dot(int size) {
    return std::max(1, (size + rows_of_em / 2 - 1) / rows_of_em);
}

} // namespace

l3d_font::face::line_heights l3d_font::built_in_face::heights(int size) {
    const int dot = pixels_of_dot(size);
    return {dot * (font_height + 1), dot * (l3d_text_line + 1)};
}

double l3d_font::built_in_face::width(std::string_view text, int size) {
    return pixels_of_dot(size) * visit_characters(text, [](int, int) {});
}

void l3d_font::built_in_face::draw(l3d_rasterizer_2d& rasterizer, int x, int base,
                                   std::string_view text, std::uint32_t color, int size) {
    const int dot = pixels_of_dot(size);
    l3d_draw_text(rasterizer, x, base - dot * font_height, text, color, dot);
}

/// Adds a box for each run of dots in a row.
double l3d_font::built_in_face::outline(l3d_path& to, l3d_point_2d base, std::string_view text,
                                        double size) {
    const double dot = size / rows_of_em;
    const auto add = [&](int character, int x) {
        for (int row = 0; row < font_height; ++row)
            for (int begin = 0, end = 0; begin < font_width; begin = end + 1) {
                for (end = begin; end < font_width && font_ink(character, end, row);)
                    ++end;
                const double left = base.x + (x + begin) * dot, right = base.x + (x + end) * dot;
                const double top = base.y + (row - font_height) * dot, bottom = top + dot;
                if (begin < end)
                    to.add_polygon(std::array<l3d_point_2d, 4>{
                        {{left, top}, {right, top}, {right, bottom}, {left, bottom}}});
            }
    };
    return dot * visit_characters(text, add);
}

l3d_font::l3d_font() : l3d_font(std::make_shared<built_in_face>(), "built-in") {}

l3d_font::l3d_font(std::shared_ptr<face> of, std::string name)
    : face_(std::move(of)), name_(std::move(name)) {}

int l3d_font::line(int size) const {
    return face_->heights(size).line;
}

int l3d_font::width(std::string_view text, int size) const {
    return static_cast<int>(std::ceil(face_->width(text, size)));
}

void l3d_font::draw(l3d_rasterizer_2d& rasterizer, int x, int y, std::string_view text,
                    std::uint32_t color, int size) const {
    assert(size >= 1);
    face_->draw(rasterizer, x, y + face_->heights(size).ascent, text, color, size);
}

double l3d_font::outline(l3d_path& to, l3d_point_2d base, std::string_view text,
                         double size) const {
    return size > 0 && std::isfinite(size) ? face_->outline(to, base, text, size) : 0;
}

namespace {

using namespace l3d_detail;

/// Draws one row of the character whose top left corner is given.
void draw_row(l3d_rasterizer_2d& rasterizer, int character, int row, l3d_point_2d corner,
              std::uint32_t color, double scale) {
    const double top = corner.y + row * scale, bottom = top + scale;
    for (int begin = 0; begin < font_width; ++begin) {
        int end = begin;
        while (end < font_width && font_ink(character, end, row))
            ++end;
        if (end == begin)
            continue;
        const double left = corner.x + begin * scale, right = corner.x + end * scale;
        const std::array<l3d_point_2d, 4> run{
            {{left, top}, {right, top}, {right, bottom}, {left, bottom}}};
        rasterizer.draw_polygon_flatshaded(run, color);
        begin = end;
    }
}

} // namespace

void l3d_draw_text(l3d_rasterizer_2d& rasterizer, int x, int y, std::string_view text,
                   std::uint32_t color, int scale) {
    assert(scale >= 1);
    visit_characters(text, [&](int character, int from) {
        const l3d_point_2d corner{x + double(from) * scale, double(y)};
        for (int row = 0; row < font_height; ++row)
            draw_row(rasterizer, character, row, corner, color, scale);
    });
}
