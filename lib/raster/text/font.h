// SPDX-License-Identifier: MIT
// l3d_font: a typeface, and text drawn with it or with the small built-in font.
#ifndef L3D_RASTER_TEXT_FONT_H
#define L3D_RASTER_TEXT_FONT_H

#include "base/color.h"
#include "base/public.h"
#include "raster/rasterizer_2d.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

/// Draws text in UTF-8 with the smooth letters of a font file, in any size.
///
/// Lines are laid out by the rules of Unicode, also where scripts from right to left stand among
/// scripts from left to right. HarfBuzz kerns and joins letters. A letter that the font lacks comes
/// from another font of this machine, if one has it. Otherwise the font's sign for a missing letter
/// is shown, mostly a box; bytes that are not UTF-8 show this sign, too. A tab goes to the next
/// multiple of eight blanks. Other control characters and soft hyphens are invisible.
///
/// A font without a file has the built-in face of l3d_draw_text: printable ASCII in whole multiples
/// of 5 x 7 pixels, from left to right, the same bits on every machine.
///
/// Units:   sizes are the height of the face's em square in pixels; a capital is some 0.7 of this
///          height.
/// Expects: whole sizes are at least 1. Copies share the letters that they have drawn, so all
///          copies belong to one thread.
/// Cost:    a letter is rendered once for each size and quarter of a pixel, and drawn by
///          draw_coverage. The first letter that the font lacks makes fontconfig read its lists,
///          some 10 to 100 ms.
class L3D_PUBLIC l3d_font {
public:
    /// Makes a font with the built-in face of l3d_draw_text.
    l3d_font();

    /// Reads a file that FreeType knows, such as TrueType or OpenType.
    /// Errors:  returns nothing, and sets `why` to the reason, which names the file.
    static std::optional<l3d_font> load(const std::string& file, std::string& why);

    /// The face that this machine uses for text. The environment variable L3D_FONT names a file, or
    /// is "built-in". Without this variable, the usual places of DejaVu, Noto, Liberation and
    /// FreeFont are searched. If none is found, the font is the built-in one.
    /// Errors:  returns the built-in font if a file cannot be read, and sets `why` to the reason,
    ///          which names the variable and the file.
    static l3d_font of_system(std::string& why);

    /// The name of the font's file, or "built-in".
    const std::string& name() const { return name_; }

    /// The distance from one line of text to the next. Units: pixels.
    int line(int size) const;

    /// The width of a line of text, up to the place where a next letter would begin.
    /// Units: whole pixels, rounded up.
    int width(std::string_view text, int size) const;

    /// Draws one line of text. (x, y) is the top left corner of the line, which is line(size) high.
    /// Letters are hinted in height, and stand within 1/8 pixel of their places in outline().
    void draw(l3d_rasterizer_2d& rasterizer, int x, int y, std::string_view text, l3d_color color,
              int size) const;

    /// Adds the outlines of one line of text to a path, exactly as in the font: without hinting,
    /// and at any place between pixels. Fill the path with l3d_winding::nonzero, stroke it, or move
    /// it by l3d_path::add.
    ///
    /// The base line begins at `base` and goes to the right. The built-in face gives its dots, a
    /// tenth of the size wide and high.
    /// Returns: the place where a next letter would begin, in pixels to the right of `base`.
    /// Expects: a finite size above 0, else nothing is added and the result is 0.
    double outline(l3d_path& to, l3d_point_2d base, std::string_view text, double size) const;

private:
    class face;
    class built_in_face;
    class file_face;

    l3d_font(std::shared_ptr<face> of, std::string name);

    std::shared_ptr<face> face_;
    std::string name_;
};

/// The distance from one character to the next, in font pixels. A font pixel is a dot of the
/// built-in face; a character has 5 x 7 dots.
inline constexpr int l3d_text_advance = 6;
/// The distance from one line of text to the next, in font pixels.
inline constexpr int l3d_text_line = 9;

/// Draws one line of text with the built-in face. The line's top left corner is (x, y), and each
/// font pixel is a square of `scale` x `scale` pixels.
///
/// The text is UTF-8. A character outside of printable ASCII is drawn as a box. Tabs, control
/// characters and soft hyphens are as in l3d_font::draw. Drawing is clipped to the target.
/// Expects: scale >= 1.
/// Cost:    one small polygon for each horizontal run of font pixels.
L3D_PUBLIC void l3d_draw_text(l3d_rasterizer_2d& rasterizer, int x, int y, std::string_view text,
                              l3d_color color, int scale = 1);

#endif
