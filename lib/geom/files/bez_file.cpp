// SPDX-License-Identifier: MIT
// Reads geomview's Bezier patches: BEZ and BBP, text or binary.
#include "geom/files/model_reader_p.h"

#include <algorithm>
#include <cmath>

namespace {

using l3d_detail::quoted;
using l3d_detail::text_cursor;

/// The kind of a file, by the first word: [ST]BBP or [C]BEZ<u><v><n>[_ST].
struct bez_kind {
    int degree_u = 3, degree_v = 3, components = 3;
    bool color = false, texture = false;
};

std::optional<bez_kind> bez_kind_of(std::string_view word) {
    bez_kind kind;
    if (word == "BBP" || word == "STBBP") {
        kind.texture = word != "BBP";
        return kind;
    }
    kind.color = word.starts_with("C");
    if (kind.color)
        word.remove_prefix(1);
    kind.texture = word.ends_with("_ST");
    if (kind.texture)
        word.remove_suffix(3);
    if (!word.starts_with("BEZ") || word.size() != 6)
        return std::nullopt;
    kind.degree_u = word[3] - '0';
    kind.degree_v = word[4] - '0';
    kind.components = word[5] - '0';
    const auto degree = [](int number) { return number >= 1 && number <= 6; };
    const bool well = degree(kind.degree_u) && degree(kind.degree_v) &&
                      (kind.components == 3 || kind.components == 4);
    return well ? std::optional(kind) : std::nullopt;
}

class bez_reader {
public:
    bez_reader(text_cursor& text, std::vector<l3d_patch_points>& patches)
        : text_(text), patches_(patches) {}

    bool read() {
        if (!read_header())
            return false;
        while (!at_end()) {
            l3d_patch_points& patch = patches_.emplace_back();
            patch.degree_u = kind_.degree_u;
            patch.degree_v = kind_.degree_v;
            if (!read_points(patch) || !skip(kind_.texture ? 4 * 2 : 0) ||
                !skip(kind_.color ? 4 * 4 : 0))
                return false;
        }
        return !patches_.empty() || text_.fail("there is no patch");
    }

private:
    bool read_header() {
        if (!text_.next())
            return text_.fail("the text ends where BBP or BEZ should be");
        const auto kind = bez_kind_of(text_.token());
        if (!kind)
            return text_.fail(quoted(text_.token()) +
                              " is neither BBP nor BEZ with two degrees of 1 to 6 and 3 or 4");
        kind_ = *kind;
        if (kind_.texture)
            text_.note("texture coordinates are skipped");
        if (kind_.color)
            text_.note("the colours of corners are skipped");
        is_binary_ = text_.take_in_line("BINARY");
        return !is_binary_ || text_.next_line() || text_.fail("the text ends after BINARY");
    }

    bool at_end() { return is_binary_ ? text_.rest().empty() : text_.at_end(); }

    bool any_real(double& value, const char* what) {
        return text_.any_number_or_float(value, is_binary_, what);
    }
    bool real(double& value, const char* what) {
        return any_real(value, what) && text_.is_finite(value, what);
    }

    bool skip(int numbers) {
        double skipped = 0;
        for (int i = 0; i < numbers; ++i)
            if (!any_real(skipped, "a colour or texture coordinate"))
                return false;
        return true;
    }

    bool read_points(l3d_patch_points& patch) {
        for (int i = 0; i < (kind_.degree_u + 1) * (kind_.degree_v + 1); ++i) {
            std::array<double, 3>& p = patch.points.emplace_back();
            for (double& value : p)
                if (!real(value, "a coordinate") || !text_.is_coordinate(value))
                    return false;
            if (kind_.components == 4 && !divide(p, patch.weights))
                return false;
        }
        // A weight that all points of a patch share has no effect.
        if (std::ranges::all_of(patch.weights, [&](double w) { return w == patch.weights[0]; }))
            patch.weights.clear();
        return true;
    }

    /// Divides a homogeneous point by its weight, and appends the weight to `weights`. A patch's
    /// weights may be negative if all are equal.
    bool divide(std::array<double, 3>& p, std::vector<double>& weights) {
        double weight = 0;
        if (!real(weight, "a weight"))
            return false;
        if (!text_.is_weight(std::abs(weight), "the weight of a control point"))
            return false;
        weights.push_back(weight);
        if (weight != weights.front() && std::min(weight, weights.front()) < 0)
            return text_.fail("patch " + std::to_string(patches_.size()) +
                              " has different weights, and a negative one among them");
        for (double& value : p) {
            value /= weight;
            if (!text_.is_coordinate(value))
                return false;
        }
        return true;
    }

    text_cursor& text_;
    std::vector<l3d_patch_points>& patches_;
    bez_kind kind_;
    bool is_binary_ = false;
};

} // namespace

std::optional<l3d_model_file> l3d_read_bez(std::string_view text, std::string_view name,
                                           std::string& why) {
    const auto read = [](text_cursor& cursor, l3d_model_file& model) {
        return bez_reader(cursor, model.patches).read();
    };
    return l3d_detail::read_model_by(read, text, name, why, '#');
}
