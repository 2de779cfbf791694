// SPDX-License-Identifier: MIT
// did_you_mean: suggests the word that the user may have meant by a wrong one.
#ifndef L3D_BASE_DID_YOU_MEAN_P_H
#define L3D_BASE_DID_YOU_MEAN_P_H

#include "base/printable_p.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace l3d_detail {

/// The edit distance of two words: the least number of changes that make one word of the other. A
/// change inserts, deletes or replaces a letter, or swaps it with the next one. Capitals count as
/// small letters.
/// Source:  optimal string alignment.
inline std::size_t slips_between(std::string_view a, std::string_view b) {
    const auto same = [](char x, char y) {
        return std::tolower(static_cast<unsigned char>(x)) ==
               std::tolower(static_cast<unsigned char>(y));
    };
    // Rows of the table for a's first i - 2, i - 1 and i letters.
    std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before = std::exchange(last, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool swapped =
                i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]);
            row[j] = std::min(
                {last[j] + 1, row[j - 1] + 1, last[j - 1] + (same(a[i - 1], b[j - 1]) ? 0U : 1U)});
            if (swapped)
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row[b.size()];
}

/// Gives "; did you mean 'lid'?" for the word of `words` that is nearest to `wrong`. Gives "" if
/// the two words differ by more than one slip for every three letters of `wrong`. One slip is
/// always allowed.
template <class Words> std::string did_you_mean(std::string_view wrong, const Words& words) {
    constexpr std::size_t letters_a_slip = 3, longest = 64; // longer words are not compared
    if (wrong.size() > longest)
        return "";
    std::string_view best;
    std::size_t least = std::max<std::size_t>(1, wrong.size() / letters_a_slip) + 1;
    for (const auto& listed : words) {
        const std::string_view word = listed;
        if (word.size() > longest)
            continue;
        if (const std::size_t slips = slips_between(wrong, word); slips < least) {
            least = slips;
            best = word;
        }
    }
    return best.empty() ? "" : "; did you mean '" + printable(best) + "'?";
}

} // namespace l3d_detail

#endif
