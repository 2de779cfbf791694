// SPDX-License-Identifier: MIT
// part_tree: the parts of a mesh or surface in a tree of boxes, and the one nearest to some places.
#ifndef L3D_SCENE_AUDIT_PART_TREE_P_H
#define L3D_SCENE_AUDIT_PART_TREE_P_H

#include "scene/audit/audit_part_p.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace l3d_detail {

/// The distance from a triangle to the farthest of some places. No place of their hull is farther
/// from it.
double farthest(const flat_triangle& flat, std::span<const audit_part::vector> places);

/// An upright box.
struct audit_box {
    using vector = audit_part::vector;

    /// The box that holds the part and its flat triangle.
    static audit_box of(const audit_part& part);
    audit_box grown(double by) const;
    bool meets(const audit_box& other) const;
    void hold(const audit_box& other);
    /// The distance to the farthest of some places.
    double distance(std::span<const vector> places) const;

    vector least{0.0, 0.0, 0.0}, most{0.0, 0.0, 0.0};
};

/// A tree of boxes that finds the parts near a place. A search halves parts of patches in memory of
/// its own; the tree stays as it is.
class part_tree {
public:
    using vector = audit_part::vector;

    /// Expects: at least one part.
    explicit part_tree(std::vector<audit_part> parts);

    std::span<const audit_part> parts() const { return parts_; }

    /// Bounds of the distance from some places to a part, and the part.
    struct found {
        double least = 0; ///< the farthest of the places is at least this far from each part
        double most = 0;  ///< all places are at most this far from this part
        std::optional<audit_part> part; ///< none if none was near enough
    };

    /// The conditions under which a search ends.
    struct wanted {
        double enough;   ///< a part so near ends the search
        double hopeless; ///< parts that cannot be nearer than this are not looked at
        double slack;    ///< the search ends when most - least is no larger
        /// The most boxes and parts to open. If these are not enough, `least` is 0; `most` is
        /// valid.
        std::size_t steps = std::numeric_limits<std::size_t>::max();
    };

    /// Memory of searches, kept for the next.
    struct memory {
        struct entry {
            double least;
            std::uint32_t index;
            bool is_node;
        };
        std::vector<entry> heap;
        std::vector<audit_part> parts;
    };

    /// Finds the part with the least distance to the farthest of some places.
    found nearest(std::span<const vector> places, const wanted& until, memory& use) const;

    /// Adds to `to` the indices of the parts whose boxes are at most `distance` from the box of
    /// another part. Returns false if there are more than `most`.
    bool find_near(const audit_part& other, double distance, std::size_t most,
                   std::vector<std::uint32_t>& to) const;

private:
    struct node {
        audit_box box{};
        /// Leaves have parts from `first` to `end`; others have children at `first` and first + 1.
        std::uint32_t first = 0, end = 0;
    };

    void build(std::uint32_t at, std::uint32_t first, std::uint32_t end);

    std::vector<audit_part> parts_;
    std::vector<node> nodes_;
};

} // namespace l3d_detail

#endif
