// SPDX-License-Identifier: MIT
// Reads grids of heights, in the text form of geographic programs.
#include "geom/files/model_reader_p.h"
#include "geom/files/patch_file.h"

#include <cctype>
#include <string>

namespace {

using l3d_detail::text_cursor;

/// The values of the header, whose statements come in any order, in capitals or not.
struct grid_header {
    std::int64_t columns = 0, rows = 0;
    double spacing = 1, missing = -9999; // missing: the format's default
};

std::string lower_case(std::string_view word) {
    std::string result(word);
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

/// Reads the value of the statement `word`.
bool read_statement(text_cursor& text, const std::string& word, grid_header& header) {
    double place = 0;
    if (word == "ncols")
        return text.integer_in(header.columns, "the number of columns", 2, l3d_most_heights / 2);
    if (word == "nrows")
        return text.integer_in(header.rows, "the number of rows", 2, l3d_most_heights / 2);
    if (word == "cellsize")
        return text.coordinate(header.spacing) &&
               (header.spacing > 0 ||
                text.fail("cellsize is " + l3d_detail::quoted(text.token()) + ", not positive"));
    if (word == "nodata_value")
        return text.any_number(header.missing, "nodata_value");
    if (word == "xllcorner" || word == "yllcorner" || word == "xllcenter" || word == "yllcenter")
        return text.number(place, "a place of the grid"); // unused: the model is around the origin
    return text.fail(l3d_detail::quoted(text.token()) +
                     " is none of ncols, nrows, xllcorner, yllcorner, xllcenter, yllcenter, "
                     "cellsize and nodata_value");
}

bool is_number_begin(std::string_view token) {
    return token.find_first_of("0123456789.") < 2; // a sign may stand before the digits
}

bool read_grid(text_cursor& text, l3d_model_file& model) {
    grid_header header;
    bool has_token = text.next();
    const auto is_name = [&] {
        return !is_number_begin(text.token()) && lower_case(text.token()) != "nan";
    };
    for (; has_token && is_name(); has_token = text.next())
        if (!read_statement(text, lower_case(text.token()), header))
            return false;
    if (header.columns == 0 || header.rows == 0)
        return text.fail(header.columns == 0 ? "ncols is missing" : "nrows is missing");
    const std::int64_t count = header.columns * header.rows;
    if (count > l3d_most_heights)
        return text.fail(std::to_string(header.columns) + " x " + std::to_string(header.rows) +
                         " heights are more than " + std::to_string(l3d_most_heights));
    constexpr std::size_t shortest = 2; // a digit and a blank; the first height is taken already
    if (!text.plausible(count - 1, "heights", shortest))
        return false;
    l3d_height_field field{static_cast<std::size_t>(header.columns), {}, header.spacing};
    for (std::int64_t i = 0; i < count; ++i) {
        text.set_place(" of height", static_cast<std::size_t>(i) + 1,
                       static_cast<std::size_t>(count));
        double height = 0;
        if (i == 0 ? !(has_token ? text.any_number_in(text.token(), height, "y")
                                 : text.fail("no heights follow"))
                   : !text.any_number(height, "y"))
            return false;
        if (height == header.missing || std::isnan(height))
            height = std::numeric_limits<double>::quiet_NaN();
        else if (!text.is_coordinate(height))
            return false;
        field.heights.push_back(height);
    }
    text.forget_place();
    if (text.next())
        return text.fail(l3d_detail::quoted(text.token()) + " follows the last of " +
                         std::to_string(count) + " heights");
    const std::string why = field.complaint();
    if (!why.empty())
        return text.fail(why);
    model.patches = l3d_height_patches(field);
    return !model.patches.empty() || text.fail("no four neighbours have heights");
}

} // namespace

std::optional<l3d_model_file> l3d_read_grid(std::string_view text, std::string_view name,
                                            std::string& why) {
    return l3d_detail::read_model_by(read_grid, text, name, why);
}
