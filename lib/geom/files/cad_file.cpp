// SPDX-License-Identifier: MIT
// l3d_read_cad: reads STEP and IGES, whose surfaces a plug-in gives.
#include "geom/files/model_file.h"

#include "base/error.h"
#include "base/printable_p.h"
#include "geom/files/cad_plugin_p.h"
#include "geom/files/reading_progress_p.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace {

using l3d_detail::cad_reader;
using l3d_detail::cad_record;
using vector = l3d_nurbs_surface::vector;

constexpr std::size_t most_notes = 20;

/// Whether a STEP or IGES text ends as its format demands. If not, the text was cut off.
bool is_whole(std::string_view text, bool is_iges) {
    constexpr std::size_t column = 72; // an IGES line has a letter for its kind there
    while (text.ends_with('\n') || text.ends_with('\r') || text.ends_with(' '))
        text.remove_suffix(1);
    if (!is_iges)
        return text.find("END-ISO-10303-21",
                         text.size() - std::min<std::size_t>(text.size(), 4096)) != text.npos;
    const std::string_view last = text.substr(text.find_last_of("\r\n") + 1);
    return last.size() > column && last[column] == 'T';
}

/// Splits an array with four numbers for each point into points and weights. Weights are left out
/// if all are equal.
struct weighted_points {
    std::vector<vector> points;
    std::vector<double> weights;

    explicit weighted_points(const std::vector<double>& numbers) {
        for (std::size_t i = 0; i + 3 < numbers.size(); i += 4) {
            points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
            weights.push_back(numbers[i + 3]);
        }
        if (std::ranges::all_of(weights, [&](double w) { return w == weights[0]; }))
            weights.clear();
    }
};

/// The degree and knots along one direction. Parameters run from the first knot to the last, as for
/// clamped knots.
l3d_bspline_direction direction(std::uint64_t degree, std::vector<double> knots) {
    l3d_bspline_direction result;
    // The surface or curve refuses degrees that are out of range.
    result.degree = static_cast<int>(std::min<std::uint64_t>(degree, 1000));
    result.knots = std::move(knots);
    if (!result.knots.empty()) {
        result.from = result.knots.front();
        result.to = result.knots.back();
    }
    return result;
}

/// Whether trimming leaves nothing of a piece. The piece's trims are then a single point
/// (l3d_trims_in).
bool is_outside(const l3d_patch_points& piece) {
    return piece.trims.size() == 1 && piece.trims[0].size() == 1 &&
           piece.trims[0][0].points.size() == 2 &&
           piece.trims[0][0].points[0] == piece.trims[0][0].points[1];
}

/// Makes a model from the plug-in's records.
class builder {
public:
    explicit builder(std::string name) : name_(std::move(name)) {}

    void read(const std::string& bytes) {
        cad_reader from(bytes);
        while (!from.is_over())
            read_record(from);
    }

    bool is_complete() const { return is_complete_; }
    /// The first note about a difference from the file; empty if there is none.
    const std::string& first_note() const { return first_; }

    l3d_model_file finish() {
        if (left_out_ > 0)
            note(std::to_string(left_out_) + " more notes are left out");
        // If each shape stands at only one place, shapes share nothing. A model without shapes is
        // then plainer.
        if (model_.placements.size() <= model_.shapes.size())
            return l3d_flattened(model_);
        return std::move(model_);
    }

private:
    void note(const std::string& text) {
        model_.notes.push_back(l3d_detail::printable(name_) + ": " + l3d_detail::printable(text));
    }

    void note_first(const std::string& text) {
        if (first_.empty())
            first_ = text;
        if (model_.notes.size() < most_notes)
            note(text);
        else
            ++left_out_;
    }

    static l3d_nurbs_curve curve(cad_reader& from) {
        const std::uint64_t degree = from.count();
        l3d_bspline_direction along = direction(degree, from.numbers());
        weighted_points at(from.numbers());
        return {std::move(along), std::move(at.points), std::move(at.weights)};
    }

    void read_record(cad_reader& from) {
        switch (static_cast<cad_record>(from.count())) {
        case cad_record::end:
            is_complete_ = true;
            break;
        case cad_record::effort:
            read_effort(from);
            break;
        case cad_record::note:
            note_first(from.text());
            break;
        case cad_record::material:
            material_ = material(from);
            break;
        case cad_record::of_place:
            material_ = l3d_material_of_place;
            break;
        case cad_record::shape:
            model_.shapes.push_back({static_cast<std::uint32_t>(model_.patches.size()),
                                     static_cast<std::uint32_t>(model_.curves.size())});
            break;
        case cad_record::place:
            read_place(from);
            break;
        case cad_record::edge: {
            const double tolerance = from.number();
            model_.edges.push_back({curve(from), tolerance});
            break;
        }
        case cad_record::curve:
            model_.curves.push_back(curve(from));
            model_.curve_materials.push_back(material_);
            break;
        case cad_record::face:
            read_face(from);
            break;
        }
    }

    /// Adds a note on the time that reading took, unless it is too short to be noticed.
    void read_effort(cad_reader& from) {
        constexpr double noticed = 1; // second
        const double seconds = from.number(), bytes = from.number();
        if (seconds < noticed)
            return;
        std::array<char, 100> text{};
        std::snprintf(text.data(), text.size(),
                      "%zu faces; Open CASCADE took %.1f s and %.0f MB to read them", faces_,
                      seconds, bytes / 1e6);
        note(text.data());
    }

    std::uint32_t material(cad_reader& from) {
        l3d_material look;
        look.color = static_cast<l3d_color>(from.count());
        look.opacity = static_cast<float>(from.number());
        auto& looks = model_.mesh.looks;
        const auto found = std::ranges::find(looks, look);
        const auto result = static_cast<std::uint32_t>(found - looks.begin());
        if (found == looks.end()) {
            looks.push_back(look);
            model_.mesh.materials.push_back("material " + std::to_string(looks.size()));
        }
        return result;
    }

    void read_place(cad_reader& from) {
        l3d_model_placement at;
        at.shape = static_cast<std::uint32_t>(from.count());
        at.name = from.text();
        at.material = material(from);
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column)
                at.place(row, column) = from.number();
        if (at.shape < model_.shapes.size())
            model_.placements.push_back(std::move(at));
    }

    void read_face(cad_reader& from) {
        ++faces_;
        const std::uint64_t degree_u = from.count();
        l3d_bspline_direction u = direction(degree_u, from.numbers());
        const std::uint64_t degree_v = from.count();
        l3d_bspline_direction v = direction(degree_v, from.numbers());
        weighted_points at(from.numbers());
        std::vector<l3d_trim_loop> loops;
        for (std::uint64_t n = from.count(); n > 0 && !from.is_over(); --n)
            loops.push_back(loop(from));
        try {
            l3d_nurbs_surface surface(std::move(u), std::move(v), std::move(at.points),
                                      std::move(at.weights));
            for (l3d_patch_points& piece : surface.trimmed(std::move(loops)).pieces())
                if (!is_outside(piece)) {
                    model_.patches.push_back(std::move(piece));
                    model_.patch_materials.push_back(material_);
                    model_.patch_faces.push_back(static_cast<std::uint32_t>(faces_));
                }
        } catch (const l3d_error& error) {
            note_first("face " + std::to_string(faces_) + " is left out: " + error.what());
        }
    }

    static l3d_trim_loop loop(cad_reader& from) {
        std::vector<l3d_nurbs_curve> curves;
        std::vector<l3d_edge_use> edges;
        for (std::uint64_t n = from.count(); n > 0 && !from.is_over(); --n) {
            const auto edge = static_cast<std::uint32_t>(from.count());
            const double first = from.number(), last = from.number();
            edges.push_back({edge, first, last});
            curves.push_back(curve(from));
        }
        return l3d_trim_loop_of(curves, edges);
    }

    std::string name_;
    std::string first_;
    l3d_model_file model_;
    std::uint32_t material_ = l3d_material_of_place;
    std::size_t faces_ = 0, left_out_ = 0;
    bool is_complete_ = false;
};

} // namespace

std::optional<l3d_model_file> l3d_read_cad(std::string_view text, std::string_view name,
                                           std::string& why) {
    return l3d_detail::read_cad(text, name, why, {});
}

std::optional<l3d_model_file> l3d_detail::read_cad(std::string_view text, std::string_view name,
                                                   std::string& why,
                                                   const reading_progress& progress) {
    const auto fail = [&](const std::string& reason) {
        why = l3d_detail::printable(name) + ": " + reason;
        return std::nullopt;
    };
    const bool is_iges = l3d_model_format_of(text) == l3d_model_format::iges;
    if (!is_whole(text, is_iges))
        return fail(is_iges ? "it is cut off: its last line is not the one of kind T"
                            : "it is cut off: END-ISO-10303-21 is not at its end");
    std::string reason;
    const auto* const plugin = static_cast<const l3d_detail::cad_plugin*>(l3d_detail::load_plugin(
        "cad", l3d_detail::cad_version, sizeof(l3d_detail::cad_plugin), reason));
    if (!plugin)
        return fail(reason);
    struct receiver {
        std::string bytes;
        const reading_progress& progress;
    } to{{}, progress};
    std::array<char, 512> complaint{};
    const auto take = [](void* of, const void* from, std::size_t size) {
        static_cast<receiver*>(of)->bytes.append(static_cast<const char*>(from), size);
    };
    const auto tell = [](void* of, double share) {
        const auto& told = static_cast<receiver*>(of)->progress;
        return !told || told(share) ? 1 : 0;
    };
    if (plugin->read(text.data(), text.size(), is_iges, &to, take, tell, complaint.data(),
                     complaint.size()) == 0)
        return fail(l3d_detail::printable(complaint.data()));
    if (progress)
        progress(1);
    builder made{std::string(name)};
    try {
        made.read(to.bytes);
    } catch (const l3d_error& error) { // a curve or surface is not valid
        return fail(error.what());
    }
    if (!made.is_complete())
        return fail("the plug-in's surfaces are cut off");
    l3d_model_file model = made.finish();
    if (model.patches.empty())
        return fail("it holds no surfaces" +
                    (made.first_note().empty() ? "" : "; " + made.first_note()));
    return model;
}
