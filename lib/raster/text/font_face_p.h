// SPDX-License-Identifier: MIT
// l3d_font::face: the interface of the code that draws the letters of a font.
#ifndef L3D_RASTER_TEXT_FONT_FACE_P_H
#define L3D_RASTER_TEXT_FONT_FACE_P_H

#include "raster/text/font.h"

/// The interface of a typeface that lays out and draws lines of text.
class l3d_font::face {
public:
    struct line_heights {
        int ascent = 0; ///< distance from the top of a line to the base line
        int line = 0;   ///< distance from the top of a line of text to the top of the next
    };

    face() = default;
    face(const face&) = delete;
    face& operator=(const face&) = delete;
    virtual ~face() = default;

    virtual line_heights heights(int size) = 0;

    /// The width of a text in pixels: l3d_font::width before it is rounded.
    virtual double width(std::string_view text, int size) = 0;

    /// Draws a line of text as l3d_font::draw does, but (x, base) is the left end of its base line.
    virtual void draw(l3d_rasterizer_2d& rasterizer, int x, int base, std::string_view text,
                      std::uint32_t color, int size) = 0;

    /// Adds the outlines of a line of text to a path, as l3d_font::outline does. Expects: size > 0.
    virtual double outline(l3d_path& to, l3d_point_2d base, std::string_view text, double size) = 0;
};

/// The built-in typeface, with the letters of l3d_draw_text.
class l3d_font::built_in_face final : public face {
    line_heights heights(int size) override;
    double width(std::string_view text, int size) override;
    void draw(l3d_rasterizer_2d& rasterizer, int x, int base, std::string_view text,
              std::uint32_t color, int size) override;
    double outline(l3d_path& to, l3d_point_2d base, std::string_view text, double size) override;
};

#endif
