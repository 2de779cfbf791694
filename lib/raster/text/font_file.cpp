// SPDX-License-Identifier: MIT
// l3d_font from files: draws letters by FreeType.
#include "raster/text/font.h"

#include "raster/paths/path.h"
#include "raster/text/font_face_p.h"
#include "raster/text/text_shaper_p.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace {

/// The number of FreeType's units in a pixel.
constexpr int units = 64;

/// Adds a glyph's outlines to a path. FreeType's y points up.
struct glyph_pen {
    l3d_path& to;
    l3d_point_2d origin;
    double scale;
    bool open = false;

    void close() {
        if (open)
            to.close();
        open = false;
    }
    void move(const FT_Vector& p) {
        close();
        to.move_to(at(p));
        open = true;
    }
    l3d_point_2d at(const FT_Vector& p) const {
        return {origin.x + static_cast<double>(p.x) * scale,
                origin.y - static_cast<double>(p.y) * scale};
    }
};

glyph_pen& pen_of(void* user) {
    return *static_cast<glyph_pen*>(user);
}

/// The functions that FreeType calls for the pieces of an outline. FreeType has the same kinds of
/// curves as l3d_path.
const FT_Outline_Funcs drawing{
    .move_to =
        [](const FT_Vector* to, void* user) {
            pen_of(user).move(*to);
            return 0;
        },
    .line_to =
        [](const FT_Vector* to, void* user) {
            pen_of(user).to.line_to(pen_of(user).at(*to));
            return 0;
        },
    .conic_to =
        [](const FT_Vector* control, const FT_Vector* to, void* user) {
            pen_of(user).to.quadratic_to(pen_of(user).at(*control), pen_of(user).at(*to));
            return 0;
        },
    .cubic_to =
        [](const FT_Vector* first, const FT_Vector* second, const FT_Vector* to, void* user) {
            pen_of(user).to.cubic_to(pen_of(user).at(*first), pen_of(user).at(*second),
                                     pen_of(user).at(*to));
            return 0;
        },
    .shift = 0,
    .delta = 0};

int rounded_up(FT_Pos length) {
    return static_cast<int>((length + units - 1) / units);
}

} // namespace

/// The face of a font file. Characters that the file lacks come from other files.
class l3d_font::file_face final : public face {
public:
    explicit file_face(std::unique_ptr<l3d_detail::font_source> first)
        : first_(std::move(first)), shaper_(*first_) {}

private:
    /// The coverage of a letter of one size, around its place on the base line.
    struct letter {
        /// Its first column and row, relative to the place on the base line; rows above the line
        /// are negative.
        int left = 0, top = 0;
        int width = 0, height = 0;
        /// The coverage of each of the letter's pixels, row by row.
        std::vector<std::uint8_t> coverage;
    };
    /// Font, glyph, size, and the place's distance from the pixel on its left, in parts of 1 /
    /// `phases`.
    using letter_key = std::tuple<const l3d_detail::font_source*, unsigned, int, int>;

    /// The number of places within a pixel. Letters are drawn at the nearest of these places, at
    /// most 1/8 pixel away from the exact place.
    static constexpr int phases = 4;

    static FT_Face sized(const l3d_detail::font_source& source, int size) {
        FT_Set_Pixel_Sizes(source.face(), 0, static_cast<FT_UInt>(size));
        return source.face();
    }

    line_heights heights(int size) override {
        const FT_Size_Metrics& all = sized(*first_, size)->size->metrics;
        return {rounded_up(all.ascender), rounded_up(all.height)};
    }

    double width(std::string_view text, int size) override {
        return shaper_.shape(text).width * size / first_->face()->units_per_EM;
    }

    void draw(l3d_rasterizer_2d& rasterizer, int x, int base, std::string_view text,
              std::uint32_t color, int size) override {
        const double scale = static_cast<double>(size) / first_->face()->units_per_EM;
        for (const l3d_detail::placed_glyph& glyph : shaper_.shape(text).glyphs) {
            const auto steps = static_cast<int>(std::floor(phases * glyph.x * scale + 0.5));
            const int column = steps >= 0 ? steps / phases : -((phases - 1 - steps) / phases);
            const letter& next = at({glyph.source, glyph.index, size, steps - phases * column});
            const auto up = static_cast<int>(std::lround(glyph.y * scale));
            rasterizer.draw_coverage({.left = x + column + next.left,
                                      .top = base - up + next.top,
                                      .width = next.width,
                                      .height = next.height,
                                      .values = next.coverage.data(),
                                      .pitch = next.width},
                                     color);
        }
    }

    const letter& at(const letter_key& key) {
        const auto [found, is_new] = letters_.try_emplace(key);
        if (is_new)
            found->second = make(key);
        return found->second;
    }

    /// Draws a letter. If the file cannot draw the letter, the result is as empty as a space.
    static letter make(const letter_key& key) {
        const auto [source, index, size, phase] = key;
        const FT_Face face = sized(*source, size);
        const FT_GlyphSlot slot = face->glyph;
        // Hinted only in height: stems keep their widths, and lines their lengths.
        if (FT_Load_Glyph(face, index, FT_LOAD_TARGET_LIGHT | FT_LOAD_NO_BITMAP) != 0)
            return {};
        FT_Outline_Translate(&slot->outline, phase * units / phases, 0);
        if (FT_Render_Glyph(slot, FT_RENDER_MODE_LIGHT) != 0)
            return {};
        const FT_Bitmap& bitmap = slot->bitmap;
        letter made{.left = slot->bitmap_left,
                    .top = -slot->bitmap_top,
                    .width = static_cast<int>(bitmap.width),
                    .height = static_cast<int>(bitmap.rows),
                    .coverage = {}};
        for (int y = 0; y < made.height; ++y) {
            const unsigned char* const row = bitmap.buffer + y * std::ptrdiff_t{bitmap.pitch};
            made.coverage.insert(made.coverage.end(), row, row + made.width);
        }
        return made;
    }

    /// Adds a text's outlines to a path. At a size of units_per_EM pixels, FreeType's numbers are
    /// 64 times the font's own. So nothing is rounded: the middle of two points is a whole number,
    /// too.
    double outline(l3d_path& to, l3d_point_2d base, std::string_view text, double size) override {
        const double scale = size / first_->face()->units_per_EM;
        const l3d_detail::shaped_line& line = shaper_.shape(text);
        for (const l3d_detail::placed_glyph& glyph : line.glyphs) {
            const int em = glyph.source->face()->units_per_EM;
            const FT_Face opened = sized(*glyph.source, em);
            if (FT_Load_Glyph(opened, glyph.index, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0)
                continue;
            glyph_pen pen{
                to, {base.x + glyph.x * scale, base.y - glyph.y * scale}, size / em / units};
            FT_Outline_Decompose(&opened->glyph->outline, &drawing, &pen);
            pen.close();
        }
        return line.width * scale;
    }

    std::unique_ptr<l3d_detail::font_source> first_;
    l3d_detail::text_shaper shaper_;
    std::map<letter_key, letter> letters_;
};

std::optional<l3d_font> l3d_font::load(const std::string& file, std::string& why) {
    auto source = l3d_detail::font_source::open(file, 0, why);
    if (!source)
        return std::nullopt;
    return l3d_font(std::make_shared<file_face>(std::move(source)), file);
}

/// The font that L3D_FONT names, or the first file of this list that the system has, or the
/// built-in font. Faces with many scripts come first, and the folders are those of Debian, Fedora
/// and Arch Linux.
l3d_font l3d_font::of_system(std::string& why) {
    constexpr std::array places{
        "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
        "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
        "/usr/share/fonts/TTF/DejaVuSans.ttf",
        "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
        "/usr/share/fonts/noto/NotoSans-Regular.ttf",
        "/usr/share/fonts/truetype/liberation2/LiberationSans-Regular.ttf",
        "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
        "/usr/share/fonts/liberation-sans/LiberationSans-Regular.ttf",
        "/usr/share/fonts/truetype/freefont/FreeSans.ttf",
    };
    why.clear();
    if (const char* const named = std::getenv("L3D_FONT"); named != nullptr && *named != '\0') {
        if (std::string_view(named) == "built-in")
            return {};
        if (auto font = load(named, why))
            return *std::move(font);
        why.insert(0, "L3D_FONT: ");
        return {};
    }
    std::string ignored; // a place that has no font, or a bad one, is passed over
    for (const char* const place : places)
        if (auto font = load(place, ignored))
            return *std::move(font);
    return {};
}
