// SPDX-License-Identifier: MIT
// font_fallbacks: asks fontconfig, of which no other source knows.
#include "raster/text/font_fallbacks_p.h"

#include <fontconfig/fontconfig.h>

#include <algorithm>
#include <string>

namespace l3d_detail {

namespace {

struct fontconfig_closer {
    void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
    void operator()(FcCharSet* letters) const { FcCharSetDestroy(letters); }
};
template <class T> using unique = std::unique_ptr<T, fontconfig_closer>;

/// The machine's best font with this letter: smooth, not slanted, and without colours of its own.
unique<FcPattern> best_with(char32_t code) {
    const unique<FcPattern> wanted(FcPatternCreate());
    const unique<FcCharSet> letters(FcCharSetCreate());
    FcCharSetAddChar(letters.get(), code);
    FcPatternAddCharSet(wanted.get(), FC_CHARSET, letters.get());
    FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("sans-serif"));
    FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
    FcPatternAddBool(wanted.get(), FC_COLOR, FcFalse);
    FcPatternAddBool(wanted.get(), FC_VARIABLE, FcFalse);
    FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
    FcDefaultSubstitute(wanted.get());
    FcResult result = FcResultNoMatch;
    return unique<FcPattern>(FcFontMatch(nullptr, wanted.get(), &result));
}

} // namespace

const font_source* font_fallbacks::find(char32_t code) {
    const auto [found, is_new] = known_.try_emplace(code, nullptr);
    if (!is_new)
        return found->second;
    const auto has_it = [code](const auto& source) { return source->has(code); };
    const auto open = std::ranges::find_if(open_, has_it);
    found->second = open != open_.end() ? open->get() : ask(code);
    return found->second;
}

/// Asks fontconfig for a font with a letter. Then tests whether the font has the letter, as the
/// font that fontconfig finds nearest need not have it.
const font_source* font_fallbacks::ask(char32_t code) {
    const unique<FcPattern> best = best_with(code);
    FcChar8* file = nullptr;
    int index = 0;
    if (!best || FcPatternGetString(best.get(), FC_FILE, 0, &file) != FcResultMatch)
        return nullptr;
    FcPatternGetInteger(best.get(), FC_INDEX, 0, &index);
    std::string why; // a bad file is as good as none
    auto source = font_source::open(reinterpret_cast<const char*>(file), index, why);
    if (!source || !source->has(code))
        return nullptr;
    return open_.emplace_back(std::move(source)).get();
}

} // namespace l3d_detail
