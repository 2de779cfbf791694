// SPDX-License-Identifier: MIT
// read_obj_tag: reads counts first, then the numbers that they promise.
#include "geom/files/obj_tags_p.h"

#include "base/counted_p.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace l3d_detail {

namespace {

/// A tag's name and arguments.
struct tag_numbers {
    std::string name;
    std::vector<std::uint32_t> integers;
    std::vector<float> reals;
};

bool word(text_cursor& text, const std::string& what) {
    return text.next_in_line() || text.fail("the line ends where " + what + " should be");
}

/// Reads "2/1/0": how many integers, reals and words follow.
bool read_counts(text_cursor& text, std::array<std::int64_t, 3>& counts) {
    if (!word(text, "the numbers of a tag's arguments"))
        return false;
    std::string_view rest = text.token();
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t end = i < 2 ? rest.find('/') : rest.size();
        if (end == rest.npos)
            return text.fail(quoted(text.token()) + " is not INTEGERS/REALS/WORDS");
        if (!text.integer_in_text(rest.substr(0, end), counts[i], "a number of arguments") ||
            !text.is_in(counts[i], "a number of arguments", 0, INT32_MAX))
            return false;
        rest.remove_prefix(i < 2 ? end + 1 : end);
    }
    return true;
}

/// Whether a tag has one real for each thing that it names, or one for all things. Fails otherwise.
bool has_reals(text_cursor& text, const tag_numbers& tag, std::size_t things) {
    return tag.reals.size() == 1 || tag.reals.size() == things ||
           text.fail("a tag '" + tag.name + "' of " + counted(things, tag.name + "s") + " has " +
                     counted(tag.reals.size(), "numbers"));
}

float real_of(const tag_numbers& tag, std::size_t thing) {
    return tag.reals[tag.reals.size() == 1 ? 0 : thing];
}

bool read_numbers(text_cursor& text, const l3d_polygon_mesh& mesh, tag_numbers& tag) {
    std::array<std::int64_t, 3> counts{};
    if (!read_counts(text, counts))
        return false;
    const bool is_of_faces = tag.name == "hole", is_of_things = tag.name != "interpolateboundary";
    const char* const what = !is_of_things ? "a rule for boundaries"
                             : is_of_faces ? "a face counted from 0"
                                           : "a vertex counted from 0";
    const std::size_t things = is_of_faces ? mesh.faces() : mesh.vertices.size();
    const auto last = is_of_things ? static_cast<std::int64_t>(things) - 1 : 2;
    for (std::int64_t i = 0; i < counts[0]; ++i) {
        std::int64_t number = 0;
        if (!word(text, what) || !text.integer_in_text(text.token(), number, what) ||
            !text.is_in(number, what, 0, last))
            return false;
        tag.integers.push_back(static_cast<std::uint32_t>(number));
    }
    for (std::int64_t i = 0; i < counts[1]; ++i) {
        double number = 0;
        if (!word(text, "a sharpness") || !text.number_in(text.token(), number, "a sharpness"))
            return false;
        if (!(number >= 0))
            return text.fail("a sharpness of " + std::string(text.token()) + " is negative");
        tag.reals.push_back(static_cast<float>(number < 10 ? number : 10)); // 10 stays sharp
    }
    return true;
}

bool take(text_cursor& text, const tag_numbers& tag, l3d_cage_tags& tags) {
    const std::size_t count = tag.integers.size();
    if (tag.name == "crease") {
        if (count < 2)
            return text.fail("a tag 'crease' has fewer than two vertices");
        if (!has_reals(text, tag, count - 1))
            return false;
        for (std::size_t i = 0; i + 1 < count; ++i)
            tags.creases.push_back({tag.integers[i], tag.integers[i + 1], real_of(tag, i)});
    } else if (tag.name == "corner") {
        if (!has_reals(text, tag, count))
            return false;
        for (std::size_t i = 0; i < count; ++i)
            tags.corners.push_back({tag.integers[i], real_of(tag, i)});
    } else if (tag.name == "hole") {
        tags.holes.insert(tags.holes.end(), tag.integers.begin(), tag.integers.end());
    } else if (count == 1 && tag.integers[0] > 0) {
        tags.keeps_corners = tag.integers[0] == 1;
    } else {
        text.note_once("a tag 'interpolateboundary' that leaves boundaries out is skipped");
    }
    return true;
}

} // namespace

bool read_obj_tag(text_cursor& text, const l3d_polygon_mesh& mesh, l3d_cage_tags& tags) {
    if (!word(text, "a tag's name"))
        return false;
    tag_numbers tag;
    tag.name = text.token();
    const bool is_known = tag.name == "crease" || tag.name == "corner" || tag.name == "hole" ||
                          tag.name == "interpolateboundary";
    if (!is_known) {
        text.note_once("tags " + quoted(tag.name) + " are skipped");
        while (text.next_in_line())
            ;
        return true;
    }
    if (!read_numbers(text, mesh, tag) || !take(text, tag, tags))
        return false;
    return !text.next_in_line() || text.fail(quoted(text.token()) + " at the end of a tag");
}

std::string obj_tags(const l3d_cage_tags& tags) {
    std::string text;
    for (const l3d_cage_tags::crease& crease : tags.creases) {
        text +=
            "t crease 2/1/0 " + std::to_string(crease.from) + ' ' + std::to_string(crease.to) + ' ';
        append(text, static_cast<double>(crease.sharpness), '\n');
    }
    for (const l3d_cage_tags::corner& corner : tags.corners) {
        text += "t corner 1/1/0 " + std::to_string(corner.vertex) + ' ';
        append(text, static_cast<double>(corner.sharpness), '\n');
    }
    for (const std::uint32_t hole : tags.holes)
        text += "t hole 1/0/0 " + std::to_string(hole) + '\n';
    if (tags.keeps_corners)
        text +=
            std::string("t interpolateboundary 1/0/0 ") + (*tags.keeps_corners ? '1' : '2') + '\n';
    return text;
}

} // namespace l3d_detail
