// SPDX-License-Identifier: MIT
// l3d_font::face: what makes the letters of a font.
#ifndef L3D_RASTER_SHAPES_FONT_FACE_P_H
#define L3D_RASTER_SHAPES_FONT_FACE_P_H

#include "raster/shapes/font.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

/// Keeps each letter that was drawn once.
class l3d_font::face {
public:
    /// A letter of one size, as it covers pixels around its place on the base line.
    struct letter {
        int left = 0, top = 0; ///< of its coverage, from the place; top is above, so negative
        int width = 0, height = 0;
        std::vector<std::uint8_t> coverage; ///< row by row
        int advance = 0;                    ///< to the next letter's place
    };
    struct line_heights {
        int ascent = 0; ///< from the top of a line to the base line
        int line = 0;   ///< from one line to the next
    };

    face() = default;
    face(const face&) = delete;
    face& operator=(const face&) = delete;
    virtual ~face() = default;

    const letter& at(char32_t code, int size) {
        const auto [found, is_new] = letters_.try_emplace({size, code});
        if (is_new)
            found->second = make(code, size);
        return found->second;
    }

    virtual line_heights heights(int size) = 0;

    /// As l3d_font::outline. Expects: size > 0.
    virtual double outline(l3d_path& to, l3d_point_2d base, std::string_view text, double size) = 0;

private:
    virtual letter make(char32_t code, int size) = 0;

    std::map<std::pair<int, char32_t>, letter> letters_;
};

/// The letters of l3d_draw_text.
class l3d_font::built_in_face final : public face {
    line_heights heights(int size) override;
    letter make(char32_t code, int size) override;
    double outline(l3d_path& to, l3d_point_2d base, std::string_view text, double size) override;
};

#endif
