// SPDX-License-Identifier: MIT
// l3d_parts: the named parts of a model, such as the lid of a teapot.
#ifndef L3D_GEOM_PARTS_H
#define L3D_GEOM_PARTS_H

#include "base/public.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Consecutive faces or patches with a common name. The run ends where the next run begins.
struct L3D_PUBLIC l3d_part_run {
    std::string name;        ///< the part's name; empty if the run belongs to no part
    std::uint32_t first = 0; ///< index of the run's first face or patch
    /// Whether names and first indices are the same.
    friend bool operator==(const l3d_part_run&, const l3d_part_run&) = default;
};

/// The parts of a model: names, and the things (faces or patches) that belong to each.
///
/// Runs of one name are one part. A part has at least one thing, and a thing belongs to one part at
/// most.
/// Cost: four bytes for each thing, if there is a part.
class L3D_PUBLIC l3d_parts {
public:
    /// A model without parts.
    l3d_parts() = default;

    /// The parts of `count` things.
    /// Expects: runs in the order of their first things, none beyond `count`.
    l3d_parts(std::span<const l3d_part_run> runs, std::size_t count);

    /// The names of the parts, each once, in the order of their first things.
    std::span<const std::string> names() const { return names_; }

    /// The index of a part in names(); nothing if there is none of this name.
    std::optional<std::size_t> find(std::string_view name) const;

    /// The index of a thing's part in names(), or `none`. Expects: thing < count.
    std::size_t of(std::size_t thing) const { return of_.empty() ? none : of_[thing]; }

    /// The name of a thing's part; empty if it belongs to none. Expects: as of().
    std::string_view name_of(std::size_t thing) const;

    /// The number of things of a part. Expects: an index of names().
    std::size_t size_of(std::size_t part) const;

    /// For each thing, whether it belongs to one of these parts.
    /// Expects: indices of names(), and the count of the constructor.
    std::vector<bool> things_of(std::span<const std::size_t> parts, std::size_t count) const;

    /// The parts as runs of things, as the constructor takes them.
    std::vector<l3d_part_run> runs() const;

    /// The error message for a name that no part has; "" if a part has it. The message lists 40
    /// parts at most, and suggests a similar name.
    std::string complaint(std::string_view name) const;

    /// The index that stands for no part.
    static constexpr std::size_t none = ~std::uint32_t{0};

private:
    std::vector<std::string> names_;
    std::vector<std::uint32_t> of_; ///< the part of each thing; empty if there are no names
};

#endif
