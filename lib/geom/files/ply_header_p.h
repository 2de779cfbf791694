// SPDX-License-Identifier: MIT
// ply::header: the elements and properties that a .ply file announces.
#ifndef L3D_GEOM_FILES_PLY_HEADER_P_H
#define L3D_GEOM_FILES_PLY_HEADER_P_H

#include "geom/files/text_cursor_p.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace l3d_detail::ply {

enum class number_type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t bytes_of(number_type type);

inline bool is_whole(number_type type) {
    return type < number_type::float32;
}

/// The meaning of a property for the reader. Properties without a meaning are read and dropped.
enum class meaning {
    nothing,
    x,
    y,
    z,
    normal_x,
    normal_y,
    normal_z,
    red,
    green,
    blue,
    place_u, ///< u, measured from the left side of the picture
    place_v, ///< v, measured from the bottom of the picture
    corners, ///< list of a face's vertex indices
    places   ///< list of place_u and place_v of each corner
};

struct property {
    meaning means = meaning::nothing;
    number_type type = number_type::float32;
    std::optional<number_type> count; ///< type of a list's length
};

/// The use of an element's rows.
enum class row_kind { other, vertex, face, strip };

struct element {
    std::string_view name;
    row_kind kind = row_kind::other;
    std::int64_t count = 0;
    std::vector<property> properties;

    bool has(meaning what) const {
        return std::ranges::any_of(properties,
                                   [what](const property& p) { return p.means == what; });
    }

    bool has_color() const {
        return has(meaning::red) && has(meaning::green) && has(meaning::blue);
    }
};

/// Reads a header, line by line.
///
/// Lives:   borrows the cursor and its text.
/// Cost:    linear in the text.
class header {
public:
    explicit header(text_cursor& text) : text_(text) {}

    /// Reads the header to its end. Errors: as all functions of text_cursor.
    bool read();

    const std::vector<element>& elements() const { return elements_; }

    /// The element whose rows are of this kind, or null. Expects: not row_kind::other.
    const element* find(row_kind kind) const;

    /// The picture's name from a comment `TextureFile`, as MeshLab writes it; empty without one.
    std::string_view picture() const { return picture_; }

    /// The byte order of a binary file; nothing for a text.
    std::optional<std::endian> order() const { return order_; }

private:
    bool word(const char* what);
    bool skip_line(std::string_view word);
    bool read_format(bool& has_format);
    bool read_element_line();
    bool read_type(number_type& type);
    bool read_property_line();

    text_cursor& text_;
    std::vector<element> elements_;
    std::unordered_set<std::string_view> names_; ///< names of the elements
    std::optional<std::endian> order_;
    std::string_view picture_;
};

} // namespace l3d_detail::ply

#endif
