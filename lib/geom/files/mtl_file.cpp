// SPDX-License-Identifier: MIT
// l3d_read_mtl: reads the colours and highlights of Wavefront's materials.
#include "base/counted_p.h"
#include "geom/files/model_reader_p.h"

#include <charconv>
#include <cmath>
#include <map>
#include <optional>

namespace {

using l3d_detail::counted;
using l3d_detail::quoted;
using l3d_detail::text_cursor;

/// Statements of looks that are not drawn; the first statement of each kind gets a note.
constexpr std::string_view noted_statements[] = {
    "map_Ka", "map_Ks", "map_Ke", "map_Ns", "map_d",  "map_bump", "map_Bump", "bump",  "disp",
    "decal",  "refl",   "norm",   "Tf",     "map_Pr", "map_Pm",   "map_Ps",   "map_Tr"};

/// Statements skipped without a note: refraction, sharpness of reflections, smooth textures.
constexpr std::string_view silent_material_statements[] = {"Ni", "sharpness", "map_aat"};

/// Ambient and own light, and physical models: noted only if a number is not 0. Programs write "Ka
/// 1 1 1" into every file.
constexpr std::string_view numbered_statements[] = {"Ka", "Ke",  "Pr",    "Pm",    "Ps",
                                                    "Pc", "Pcr", "aniso", "anisor"};

/// The first model of lighting (`illum`) that has highlights.
constexpr std::int64_t highlights_from = 2;

class mtl_reader {
public:
    mtl_reader(text_cursor& text, std::vector<l3d_named_material>& materials)
        : text_(text), materials_(materials) {}

    void read() {
        while (text_.next()) {
            read_statement(text_.token());
            while (text_.next_in_line())
                ;
        }
        finish_material();
    }

private:
    void read_statement(std::string_view word) {
        if (word == "newmtl") {
            finish_material();
            materials_.push_back({std::string(text_.name_in_line()), {}, {}});
            has_highlights_ = true;
            opaque_ = clear_ = {};
            return;
        }
        const auto is_in = [word](const auto& list) {
            return std::ranges::find(list, word) != std::end(list);
        };
        constexpr std::string_view read_statements[] = {"Kd", "Ks", "Ns",    "illum",
                                                        "d",  "Tr", "map_Kd"};
        const bool is_read = is_in(read_statements);
        if (is_read && materials_.empty())
            text_.note(quoted(word) + " before the first newmtl is skipped");
        else if (is_read)
            read_value(word);
        else if (is_in(noted_statements) || (is_in(numbered_statements) && says_something(word)))
            text_.note_once("statements " + quoted(word) + " are skipped");
        else if (!is_in(silent_material_statements) && !is_in(numbered_statements))
            text_.note(quoted(word) + " begins no statement of an .mtl file");
    }

    /// Whether the line holds a number other than 0; for ambient light, other than 0 and 1.
    bool says_something(std::string_view word) {
        bool does = false;
        double value = 0;
        while (text_.next_in_line())
            does = does || !text_.any_number_in(text_.token(), value, "a number") ||
                   (value != 0 && !(word == "Ka" && value == 1));
        return does;
    }

    void read_value(std::string_view word) {
        l3d_material& look = materials_.back().look;
        double value = 0;
        if (word == "Kd")
            read_color(look.color);
        else if (word == "Ks")
            read_color(look.highlight);
        else if (word == "Ns" && number(value, "Ns"))
            look.sharpness = static_cast<int>(
                std::lround(std::clamp(value, 1.0, double{l3d_material::most_sharpness})));
        else if (word == "illum" && number(value, "illum"))
            has_highlights_ = value >= highlights_from;
        else if (word == "d" || word == "Tr")
            read_opacity(word, look);
        else if (word == "map_Kd")
            read_picture(materials_.back().picture);
    }

    /// Reads options and the name of a picture's file, which may have blanks. After an option comes
    /// a word or some numbers. "-clamp on" continues the picture's border instead of repeating the
    /// picture.
    void read_picture(l3d_mesh_picture& picture) {
        std::string_view line = text_.name_in_line();
        const auto word = [&] { return line.substr(0, line.find_first_of(" \t")); };
        const auto skip = [&] {
            line.remove_prefix(word().size());
            line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        };
        const auto is_number = [](std::string_view text) {
            double value = 0;
            const char* const end = text.data() + text.size();
            return std::from_chars(text.data(), end, value).ptr == end && !text.empty();
        };
        l3d_mesh_picture read;
        while (line.starts_with('-')) {
            const std::string_view option = word();
            skip();
            if (option == "-clamp")
                read.repeats_u = read.repeats_v = word() != "on";
            else
                text_.note_once("the option " + quoted(option) + " of a picture is skipped");
            if (!is_number(word()))
                skip();
            while (is_number(word()))
                skip();
        }
        if (line.empty())
            return text_.note("'map_Kd' without a name is skipped");
        read.name = line;
        picture = read;
    }

    /// Reads opacity: "d" is how opaque a material is, "Tr" how clear. Files have either or both.
    /// "-halo" would make surfaces more opaque where they are seen edge on.
    void read_opacity(std::string_view word, l3d_material& look) {
        double value = 0;
        if (!text_.next_in_line())
            return text_.note(quoted(word) + " without a number is skipped");
        if (word == "d" && text_.token() == "-halo") {
            text_.note("'-halo' is not drawn: the material is as opaque from all sides");
            if (!text_.next_in_line())
                return text_.note(quoted(word) + " without a number is skipped");
        }
        if (!text_.number_in(text_.token(), value, "an opacity"))
            return text_.note(quoted(word) + " without a number is skipped");
        if (!(value >= 0 && value <= 1))
            return text_.note(quoted(word) + " is " + quoted(text_.token()) +
                              ", which is not from 0 to 1: skipped");
        (word == "d" ? opaque_ : clear_) = value;
        look.opacity = static_cast<float>(opaque_ ? *opaque_ : 1 - *clear_);
        constexpr double same = 1e-3; // files round them to a few digits
        if (opaque_ && clear_ && std::abs(*opaque_ + *clear_ - 1) > same)
            text_.note("'Tr' and 'd' do not add up to 1: 'd' is taken");
    }

    /// Reads one number from the line; a fault becomes a note.
    bool number(double& value, const char* what) {
        if (text_.next_in_line() && text_.number_in(text_.token(), value, what))
            return true;
        text_.note(std::string(what) + " without a number is skipped");
        return false;
    }

    /// Reads three components from 0 to 1, or one number for all three. Spectra and CIE's X, Y, Z
    /// are not read.
    void read_color(std::uint32_t& color) {
        std::array<double, 3> components{};
        std::size_t count = 0;
        while (count < components.size() && text_.next_in_line())
            if (!text_.number_in(text_.token(), components[count++], "a colour")) {
                text_.note(quoted(text_.token()) + ", a colour, is not a number: skipped");
                return;
            }
        if (count == 0 || count == 2) {
            text_.note("a colour of " + counted(count, "components") + " is skipped");
            return;
        }
        if (count == 1)
            components = {components[0], components[0], components[0]};
        color = l3d_detail::color_of(text_, components.data());
    }

    void finish_material() {
        if (!materials_.empty() && !has_highlights_)
            materials_.back().look.highlight = 0;
    }

    text_cursor& text_;
    std::vector<l3d_named_material>& materials_;
    bool has_highlights_ = true;           ///< whether the current `illum` has highlights
    std::optional<double> opaque_, clear_; ///< "d" and "Tr" of the current material
};

} // namespace

std::vector<l3d_named_material> l3d_read_mtl(std::string_view text, std::string_view name,
                                             std::vector<std::string>& notes) {
    text_cursor cursor(text, name, '#');
    std::vector<l3d_named_material> materials;
    mtl_reader(cursor, materials).read();
    for (std::string& note : cursor.take_notes())
        notes.push_back(std::move(note));
    return materials;
}

void l3d_give_looks(l3d_polygon_mesh& mesh, std::span<const l3d_named_material> materials) {
    std::map<std::string_view, const l3d_named_material*> by_name;
    for (const l3d_named_material& material : materials)
        by_name[material.name] = &material;
    mesh.looks.resize(mesh.materials.size());
    for (std::size_t i = 0; i < mesh.materials.size(); ++i) {
        const auto found = by_name.find(mesh.materials[i]);
        if (found == by_name.end())
            continue;
        mesh.looks[i] = found->second->look;
        const l3d_mesh_picture& picture = found->second->picture;
        if (picture.name.empty())
            continue;
        const auto same = std::ranges::find(mesh.pictures, picture);
        mesh.looks[i].picture = static_cast<int>(same - mesh.pictures.begin());
        if (same == mesh.pictures.end())
            mesh.pictures.push_back(picture);
    }
}
