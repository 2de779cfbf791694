// SPDX-License-Identifier: MIT
// l3d_font from files: letters by FreeType.
#include "raster/shapes/font.h"

#include "raster/paths/path.h"
#include "raster/shapes/font_face_p.h"
#include "raster/shapes/text_shaper_p.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <type_traits>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace {

struct library_closer {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};
struct face_closer {
    void operator()(FT_Face face) const { FT_Done_Face(face); }
};
using unique_library = std::unique_ptr<std::remove_pointer_t<FT_Library>, library_closer>;
using unique_face = std::unique_ptr<std::remove_pointer_t<FT_Face>, face_closer>;

/// FreeType counts in 1/64 pixel.
constexpr int units = 64;

/// A glyph on its way into a path. FreeType's y points up.
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

/// What FreeType calls for each piece. Its curves are those of paths.
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

/// The letters of a file.
class l3d_font::file_face final : public face {
public:
    file_face(unique_library library, unique_face of, const std::string& file)
        : library_(std::move(library)), face_(std::move(of)), shaper_(face_.get(), file) {}

private:
    void set_size(int size) {
        if (size == size_)
            return;
        size_ = size;
        FT_Set_Pixel_Sizes(face_.get(), 0, static_cast<FT_UInt>(size));
    }

    line_heights heights(int size) override {
        set_size(size);
        const FT_Size_Metrics& all = face_->size->metrics;
        return {rounded_up(all.ascender), rounded_up(all.height)};
    }

    /// A letter that the file cannot draw is as empty as a space.
    letter make(char32_t code, int size) override {
        set_size(size);
        // Hinted in height alone: stems keep their widths, and lines their lengths.
        if (FT_Load_Char(face_.get(), code, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT) != 0)
            return {.coverage = {}, .advance = size / 2};
        const FT_GlyphSlot slot = face_->glyph;
        const FT_Bitmap& bitmap = slot->bitmap;
        letter made{.left = slot->bitmap_left,
                    .top = -slot->bitmap_top,
                    .width = static_cast<int>(bitmap.width),
                    .height = static_cast<int>(bitmap.rows),
                    .coverage = {},
                    .advance = static_cast<int>((slot->advance.x + units / 2) / units)};
        for (int y = 0; y < made.height; ++y)
            for (int x = 0; x < made.width; ++x)
                made.coverage.push_back(covered(bitmap, x, y));
        return made;
    }

    /// At the size of its em square in pixels, FreeType's numbers are 64 times the font's own. So
    /// nothing is rounded: the middle of two points is a whole number, too.
    double outline(l3d_path& to, l3d_point_2d base, std::string_view text, double size) override {
        set_size(face_->units_per_EM);
        const double scale = size / face_->units_per_EM;
        double width = 0;
        for (const l3d_detail::placed_glyph& glyph : shaper_.shape(text, width)) {
            if (FT_Load_Glyph(face_.get(), glyph.index, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) !=
                0)
                continue;
            glyph_pen pen{to, {base.x + glyph.x * scale, base.y - glyph.y * scale}, scale / units};
            FT_Outline_Decompose(&face_->glyph->outline, &drawing, &pen);
            pen.close();
        }
        return width * scale;
    }

    /// Fonts of dots give a bit for a pixel, all others a byte.
    static std::uint8_t covered(const FT_Bitmap& bitmap, int x, int y) {
        const unsigned char* const row = bitmap.buffer + y * std::ptrdiff_t{bitmap.pitch};
        if (bitmap.pixel_mode == FT_PIXEL_MODE_MONO)
            return (row[x / 8] >> (7 - x % 8) & 1) != 0 ? 255 : 0;
        return bitmap.pixel_mode == FT_PIXEL_MODE_GRAY ? row[x] : 0;
    }

    unique_library library_;
    unique_face face_; ///< closed before its library
    l3d_detail::text_shaper shaper_;
    int size_ = 0;
};

std::optional<l3d_font> l3d_font::load(const std::string& file, std::string& why) {
    FT_Library opened = nullptr;
    if (FT_Init_FreeType(&opened) != 0) {
        why = file + ": FreeType does not start";
        return std::nullopt;
    }
    unique_library library(opened);
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) {
        why = file + ": " + std::strerror(error ? error.value() : ENOENT);
        return std::nullopt;
    }
    if (!std::filesystem::is_regular_file(status)) { // to open a pipe would wait for its writer
        why = file + ": is no regular file";
        return std::nullopt;
    }
    FT_Face face = nullptr;
    if (FT_New_Face(library.get(), file.c_str(), 0, &face) != 0) {
        why = file + ": is no font that can be read";
        return std::nullopt;
    }
    unique_face owned(face);
    if (!FT_IS_SCALABLE(face)) {
        why = file + ": has letters of one size alone";
        return std::nullopt;
    }
    return l3d_font(std::make_shared<file_face>(std::move(library), std::move(owned), file), file);
}

/// Faces with many scripts come first. Their folders are those of Debian, Fedora and Arch Linux.
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
