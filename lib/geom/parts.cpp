// SPDX-License-Identifier: MIT
// l3d_parts: joins all runs of the same name into one part.
#include "geom/parts.h"

#include "base/did_you_mean_p.h"
#include "base/printable_p.h"

#include <algorithm>
#include <cassert>
#include <map>

l3d_parts::l3d_parts(std::span<const l3d_part_run> runs, std::size_t count) {
    std::map<std::string_view, std::uint32_t> places;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::size_t end = i + 1 < runs.size() ? runs[i + 1].first : count;
        assert(runs[i].first <= end && end <= count);
        if (runs[i].name.empty() || runs[i].first == end)
            continue;
        const auto next = static_cast<std::uint32_t>(names_.size());
        const auto [place, is_new] = places.try_emplace(runs[i].name, next);
        if (is_new)
            names_.push_back(runs[i].name);
        of_.resize(runs[i].first, static_cast<std::uint32_t>(none));
        of_.resize(end, place->second);
    }
    if (!names_.empty())
        of_.resize(count, static_cast<std::uint32_t>(none));
}

std::optional<std::size_t> l3d_parts::find(std::string_view name) const {
    const auto found = std::ranges::find(names_, name);
    return found == names_.end() ? std::nullopt
                                 : std::optional(static_cast<std::size_t>(found - names_.begin()));
}

std::string_view l3d_parts::name_of(std::size_t thing) const {
    const std::size_t part = of(thing);
    return part == none ? std::string_view() : names_[part];
}

std::size_t l3d_parts::size_of(std::size_t part) const {
    return static_cast<std::size_t>(std::ranges::count(of_, static_cast<std::uint32_t>(part)));
}

std::vector<bool> l3d_parts::things_of(std::span<const std::size_t> parts,
                                       std::size_t count) const {
    std::vector<bool> result(count);
    for (std::size_t i = 0; i < of_.size(); ++i)
        result[i] = std::ranges::find(parts, of(i)) != parts.end();
    return result;
}

std::vector<l3d_part_run> l3d_parts::runs() const {
    std::vector<l3d_part_run> result;
    for (std::size_t i = 0; i < of_.size(); ++i)
        if (i == 0 ? of_[0] != none : of_[i] != of_[i - 1])
            result.push_back({std::string(name_of(i)), static_cast<std::uint32_t>(i)});
    return result;
}

std::string l3d_parts::complaint(std::string_view name) const {
    if (find(name))
        return "";
    std::string why = '\'' + l3d_detail::printable(name) + "' names no part";
    if (names_.empty())
        return why + "; the model has none";
    why += "; there are ";
    constexpr std::size_t most = 40; // as many as a screen of text has room for
    for (std::size_t i = 0; i < std::min(most, names_.size()); ++i)
        why += (i > 0 ? ", " : "") + l3d_detail::printable(names_[i]);
    if (names_.size() > most)
        why += " and " + std::to_string(names_.size() - most) + " more";
    return why + l3d_detail::did_you_mean(name, names_);
}
