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

/// The distance from a triangle to the farthest of some places. No place in the hull of these
/// places is farther from the triangle.
double farthest(const flat_triangle& flat, std::span<const audit_part::vector> places);

/// A box whose sides are parallel to the axes, around the parts of a tree's node.
struct audit_box {
    using vector = audit_part::vector;

    /// The box that holds the part and its flat triangle.
    static audit_box of(const audit_part& part);
    audit_box grown(double by) const;
    bool meets(const audit_box& other) const;
    void hold(const audit_box& other);
    /// The distance from the box to the farthest of some places.
    double distance(std::span<const vector> places) const;

    vector least{0.0, 0.0, 0.0}, most{0.0, 0.0, 0.0};
};

/// A tree of boxes that finds the parts near a place. A search may halve parts of patches, in
/// memory of its own. The tree stays as it is.
class part_tree {
public:
    using vector = audit_part::vector;

    /// Expects: at least one part.
    explicit part_tree(std::vector<audit_part> parts);

    std::span<const audit_part> parts() const { return parts_; }

    /// The result of a search: the part that is nearest to some places, and bounds of its distance.
    struct found {
        double least = 0; ///< lower bound: every part is at least this far from one of the places
        double most = 0;  ///< upper bound: no place is farther than this from `part`
        std::optional<audit_part> part; ///< the nearest part; nothing if no part was near enough
    };

    /// The conditions under which a search ends.
    struct wanted {
        double enough;   ///< a part no farther than this ends the search
        double hopeless; ///< parts that cannot be nearer than this are not looked at
        double slack;    ///< the search ends when most - least is at most this
        /// The largest number of boxes and parts to open. If the search needs more, found::least is
        /// 0; found::most is valid.
        std::size_t steps = std::numeric_limits<std::size_t>::max();
    };

    /// Memory of a search, kept for the next search.
    struct memory {
        struct entry {
            double least;
            std::uint32_t index;
            bool is_node;
        };
        std::vector<entry> heap;
        std::vector<audit_part> parts;
    };

    /// Finds the part for which the distance to the farthest of some places is least.
    found nearest(std::span<const vector> places, const wanted& until, memory& use) const;

    /// Adds to `to` the indices of the parts whose boxes are at most `distance` from the box of
    /// another part. Returns false if these are more than `most` parts.
    bool find_near(const audit_part& other, double distance, std::size_t most,
                   std::vector<std::uint32_t>& to) const;

private:
    struct node {
        audit_box box{};
        /// A leaf has the parts from index `first` to before `end`. Any other node has its children
        /// at `first` and first + 1 of nodes_.
        std::uint32_t first = 0, end = 0;
    };

    void build(std::uint32_t at, std::uint32_t first, std::uint32_t end);

    std::vector<audit_part> parts_;
    std::vector<node> nodes_;
};

} // namespace l3d_detail

#endif
