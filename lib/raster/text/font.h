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

/// Draws text in UTF-8 with smooth letters of a font file, in any size.
///
/// Lines are laid out as Unicode says. HarfBuzz kerns and joins letters. Scripts from right to left
/// stand among others as they are read. Letters that the font does not have come from another font
/// of this machine, if it has one. A character that no font has is the font's sign for that, mostly
/// a box, and so are bytes that are no UTF-8. A tab goes to the next multiple of eight blanks.
/// Other control characters and soft hyphens are not seen.
///
/// A font without a file is the built-in face of l3d_draw_text: printable ASCII in whole multiples
/// of 5 x 7 pixels, from left to right, the same bits on every machine.
///
/// Units:   sizes are the height of the face's em square in pixels; a capital is some 0.7 of it.
/// Expects: sizes of at least 1 where they are whole numbers. Copies share what they have drawn, so
///          all of them belong to one thread.
/// Cost:    a letter is made once for each size and quarter of a pixel. Then it is one
///          l3d_coverage_2d. The first letter that the font lacks has fontconfig read its lists,
///          some 10 to 100 ms.
class L3D_PUBLIC l3d_font {
public:
    /// The built-in face.
    l3d_font();

    /// Reads a file that FreeType knows, such as TrueType or OpenType.
    /// Errors:  nothing, and the reason in `why`, which names the file.
    static std::optional<l3d_font> load(const std::string& file, std::string& why);

    /// The face that this machine has for people. The environment's L3D_FONT names a file, or is
    /// "built-in". Without it, the first one found in the usual places of DejaVu, Noto, Liberation
    /// and FreeFont is taken, else the built-in one.
    /// Errors:  the built-in one for a file that cannot be read, and the reason in `why`, which
    ///          names the variable and the file.
    static l3d_font of_system(std::string& why);

    /// The file, or "built-in".
    const std::string& name() const { return name_; }

    /// The distance from one line of text to the next. Units: pixels.
    int line(int size) const;

    /// The width of a line of text, up to where a next letter would begin. Units: whole pixels,
    /// rounded up.
    int width(std::string_view text, int size) const;

    /// Draws one line of text. (x, y) is the top left corner of its line, which is line(size) high.
    /// Letters are hinted in height, and stand within 1/8 pixel of where outline() has them.
    void draw(l3d_rasterizer_2d& rasterizer, int x, int y, std::string_view text, l3d_color color,
              int size) const;

    /// Adds the outlines of one line of text to a path, exactly as the font has them: no hinting,
    /// and letters anywhere between pixels. Fill the path with l3d_winding::nonzero, stroke it, or
    /// place it anew by l3d_path::add.
    ///
    /// The base line begins at `base` and goes to the right. The built-in face has its dots, a
    /// tenth of the size wide. Returns: where a next letter would begin, in pixels to the right of
    /// `base`. Expects: a finite size above 0, else nothing is added and the result is 0.
    double outline(l3d_path& to, l3d_point_2d base, std::string_view text, double size) const;

private:
    class face;
    class built_in_face;
    class file_face;

    l3d_font(std::shared_ptr<face> of, std::string name);

    std::shared_ptr<face> face_;
    std::string name_;
};

/// A character is 5 by 7 font pixels; the next one starts 6 further right, the next line 9 lower.
inline constexpr int l3d_text_advance = 6;
/// The distance from one line of text to the next, in font pixels.
inline constexpr int l3d_text_line = 9;

/// Draws one line of text with its top left corner at (x, y), each font pixel scale by scale
/// pixels.
///
/// The text is UTF-8. Characters outside printable ASCII are drawn as a box each. Tabs, control
/// characters and soft hyphens are as in l3d_font::draw. Clipped to the target.
/// Expects: scale >= 1.
/// Cost:    one small polygon for each horizontal run of font pixels.
L3D_PUBLIC void l3d_draw_text(l3d_rasterizer_2d& rasterizer, int x, int y, std::string_view text,
                              l3d_color color, int scale = 1);

#endif
