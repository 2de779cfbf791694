// SPDX-License-Identifier: MIT
// text_shaper: cuts characters into runs, and turns runs into glyphs.
#include "raster/text/text_shaper_p.h"

#include "raster/text/utf8_p.h"

#include <fribidi/fribidi.h>

#include <algorithm>
#include <cmath>

namespace l3d_detail {

namespace {

constexpr char32_t first_right_to_left = 0x590; // no earlier character is Hebrew or Arabic
constexpr double blanks_of_tab = 8;

bool is_blank(char32_t code) {
    return code == U' ' || code == U'\t';
}

/// Whether a character has no form of its own and belongs to the character before it.
bool is_joined(char32_t code) {
    switch (hb_unicode_general_category(hb_unicode_funcs_get_default(), code)) {
    case HB_UNICODE_GENERAL_CATEGORY_FORMAT:
    case HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK:
        return true;
    default:
        return false;
    }
}

bool is_shared(hb_script_t script) {
    return script == HB_SCRIPT_COMMON || script == HB_SCRIPT_INHERITED ||
           script == HB_SCRIPT_UNKNOWN;
}

} // namespace

const shaped_line& text_shaper::shape(std::string_view text) {
    if (const auto known = lines_.find(text); known != lines_.end())
        return known->second;
    if (lines_.size() >= most_lines)
        lines_.clear();
    shaped_line& line = lines_[std::string(text)];
    text_.clear();
    while (!text.empty())
        if (const char32_t code = take_character(text); !is_unseen(code))
            text_.push_back(code);
    find_levels();
    find_scripts();
    find_sources();
    place(runs_from_left(), line);
    return line;
}

/// Finds the level of nesting of each character, which is odd from right to left. Source: Unicode
/// Standard Annex #9. This function also applies the annex's rule L1, for blanks before tabs and at
/// the end.
void text_shaper::find_levels() {
    levels_.assign(text_.size(), 0);
    if (std::ranges::all_of(text_, [](char32_t c) { return c < first_right_to_left; }))
        return;
    const auto count = static_cast<FriBidiStrIndex>(text_.size());
    const std::vector<FriBidiChar> codes(text_.begin(), text_.end());
    std::vector<FriBidiCharType> types(text_.size());
    std::vector<FriBidiBracketType> brackets(text_.size());
    std::vector<FriBidiLevel> levels(text_.size());
    fribidi_get_bidi_types(codes.data(), count, types.data());
    fribidi_get_bracket_types(codes.data(), count, types.data(), brackets.data());
    FriBidiParType base = FRIBIDI_PAR_ON;
    if (fribidi_get_par_embedding_levels_ex(types.data(), brackets.data(), count, &base,
                                            levels.data()) == 0)
        return; // the library had no memory
    const unsigned of_line = FRIBIDI_IS_RTL(base) ? 1 : 0;
    bool ends = true;
    for (std::size_t i = text_.size(); i-- > 0;) {
        ends = text_[i] == U'\t' || (ends && is_blank(text_[i]));
        levels_[i] = ends ? of_line : static_cast<unsigned>(levels[i]);
    }
}

/// Finds the script of each character. Blanks, digits and marks take the script of the letter
/// before them, or the text's first script.
void text_shaper::find_scripts() {
    scripts_.resize(text_.size());
    std::ranges::transform(text_, scripts_.begin(), [](char32_t code) {
        return hb_unicode_script(hb_unicode_funcs_get_default(), code);
    });
    const auto first =
        std::ranges::find_if(scripts_, [](hb_script_t script) { return !is_shared(script); });
    hb_script_t last = first != scripts_.end() ? *first : HB_SCRIPT_COMMON;
    for (hb_script_t& script : scripts_)
        last = script = is_shared(script) ? last : script;
}

/// Finds the font of each character: the first font if it has the letter, else another font that
/// has it. If no font has it, the first font shows its sign for missing letters. Characters without
/// a form of their own stay with the letter before them.
void text_shaper::find_sources() {
    sources_.assign(text_.size(), &first_);
    for (std::size_t i = 0; i < text_.size(); ++i) {
        if (i > 0 && is_joined(text_[i]))
            sources_[i] = sources_[i - 1];
        else if (!is_blank(text_[i]) && !is_joined(text_[i]) && !first_.has(text_[i]))
            if (const font_source* const other = others_.find(text_[i]))
                sources_[i] = other;
    }
}

/// The runs from left to right. Rule L2 of the annex gives this order: for each level of nesting
/// from the deepest on, it reverses all sequences of runs that are at least as deep.
std::vector<text_shaper::run> text_shaper::runs_from_left() const {
    std::vector<run> runs;
    for (std::size_t i = 0; i < text_.size(); ++i) {
        const bool is_tab = text_[i] == U'\t';
        const font_source* const source = is_tab ? nullptr : sources_[i];
        if (!is_tab && !runs.empty() && runs.back().source == source &&
            runs.back().level == levels_[i] && runs.back().script == scripts_[i]) {
            runs.back().end = i + 1;
            continue;
        }
        run& next = runs.emplace_back();
        static_cast<text_run&>(next) = {text_, i, i + 1, scripts_[i], levels_[i] % 2 == 1};
        next.source = source;
        next.level = levels_[i];
    }
    const auto deepest = std::ranges::max_element(runs, {}, &run::level);
    for (unsigned level = deepest != runs.end() ? deepest->level : 0; level > 0; --level)
        for (auto begin = runs.begin(); begin != runs.end();) {
            begin = std::find_if(begin, runs.end(), [&](const run& r) { return r.level >= level; });
            const auto end =
                std::find_if(begin, runs.end(), [&](const run& r) { return r.level < level; });
            std::reverse(begin, end);
            begin = end;
        }
    return runs;
}

void text_shaper::place(const std::vector<run>& runs, shaped_line& line) const {
    std::vector<shaped_glyph> glyphs;
    double x = 0;
    for (const run& r : runs) {
        if (r.source == nullptr) {
            const char32_t blank = U' ';
            glyphs.clear();
            const double stop =
                blanks_of_tab * first_.shape({.text = {&blank, 1}, .begin = 0, .end = 1}, glyphs);
            if (stop > 0)
                x = (std::floor(x / stop) + 1) * stop;
            continue;
        }
        glyphs.clear();
        const double scale = static_cast<double>(first_.face()->units_per_EM) /
                             static_cast<double>(r.source->face()->units_per_EM);
        const double advance = scale * r.source->shape(r, glyphs);
        for (const shaped_glyph& glyph : glyphs)
            line.glyphs.push_back({{glyph.index, x + scale * glyph.x, scale * glyph.y}, r.source});
        x += advance;
    }
    line.width = x;
}

} // namespace l3d_detail
