// SPDX-License-Identifier: MIT
// patches_in_parts, polygons_in_parts: models as a list of parts and a section leave them.
#ifndef APPS_SURFVIEW_SHOWN_PARTS_H
#define APPS_SURFVIEW_SHOWN_PARTS_H

#include <l3d/part_list.h>
#include <l3d/pipeline_afd_viewer.h>
#include <l3d/pipeline_polygons.h>
#include <l3d/plane.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using section_plane = std::optional<l3d_plane<double>>;

/// A viewer of patches that draws the parts that a list shows, cut by a section. Patches are cut
/// while they are drawn, so the model stays whole.
class patches_in_parts : public l3d_pipeline_afd_viewer {
public:
    using l3d_pipeline_afd_viewer::l3d_pipeline_afd_viewer;

protected:
    l3d_part_list& list() { return parts().list(); }

    /// Shows the parts as the list says, cut by the section. If no part would be left, it takes the
    /// list's last change back and returns false.
    bool apply(const section_plane& section) {
        settings().section = section;
        redraw();
        return parts().apply();
    }

    /// How far all shown parts reach in each direction, for l3d_framed.
    l3d_reach reach_of_all() { return l3d_reach_of(scene()); }
    l3d_reach reach_of_part(const std::string& name) {
        alone_ = {};
        for (const l3d_patch_instance& instance : scene().instances())
            if (const auto part = instance.model().parts().find(name))
                alone_.add(instance.model().only(std::array{*part}), instance.placement());
        return l3d_reach_of(alone_);
    }

    /// Whether the model was turned, so that apply() must cut it anew.
    bool is_turned() const { return false; }

private:
    l3d_patch_scene alone_; ///< the part of the last reach_of_part, whose result borrows it
};

/// A viewer of polygons that draws the parts that a list shows, cut by a section. The mesh itself
/// is cut, anew whenever the model is turned.
template <class Pipeline> class polygons_in_parts : public Pipeline {
public:
    template <class... Arguments>
    polygons_in_parts(l3d_canvas canvas, const l3d_polygon_model& model,
                      const Arguments&... arguments)
        : Pipeline(std::move(canvas), model, arguments...), whole_(model) {
        list_.set_names(whole_.parts().names());
    }

protected:
    l3d_part_list& list() { return list_; }

    bool apply(const section_plane& section) {
        l3d_polygon_model shown = whole_;
        std::vector<std::size_t> hidden;
        for (const l3d_listed_part& part : list_.parts()) {
            const std::size_t index = *whole_.parts().find(part.name);
            if (part.is_hidden)
                hidden.push_back(index);
            else if (part.color)
                shown = shown.part_painted(index, {.color = *part.color});
        }
        if (!hidden.empty())
            shown = shown.without(hidden);
        if (shown.triangles().empty() && !whole_.triangles().empty()) {
            list_.undo();
            return false;
        }
        rotation_ = this->settings().rotation;
        uncut_ = shown;
        this->take_model(section ? shown.cut(in_model(*section)) : shown);
        is_cut_ = section.has_value();
        return true;
    }

    l3d_reach reach_of_all() { return reach_of(uncut_); }
    l3d_reach reach_of_part(const std::string& name) {
        const auto part = whole_.parts().find(name);
        return part ? reach_of(whole_.only(std::array{*part})) : reach_of_all();
    }

    bool is_turned() { return is_cut_ && this->settings().rotation != rotation_; }

private:
    l3d_matrix<double> placement() {
        return l3d_euler_rotation(this->settings().rotation, whole_.centre(),
                                  this->settings().rotation_order);
    }

    /// A plane of the world in the model's coordinates.
    l3d_plane<double> in_model(const l3d_plane<double>& plane) {
        const l3d_matrix<double> m = placement();
        l3d_plane<double> result{{0.0, 0.0, 0.0}, plane.d};
        for (int k = 0; k < 3; ++k) {
            result.d += plane.normal[k] * m(k, 3);
            for (int i = 0; i < 3; ++i)
                result.normal[i] += plane.normal[k] * m(k, i);
        }
        return result;
    }

    l3d_reach reach_of(const l3d_polygon_model& model) {
        return [model, m = placement()](const l3d_vector<double, 3>& direction) {
            double most = -std::numeric_limits<double>::infinity();
            for (const l3d_model_triangle& triangle : model.triangles())
                for (const std::uint32_t corner : triangle.corners) {
                    const auto& p = model.mesh().vertices[corner];
                    const auto at = m * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0);
                    most = std::max(most, l3d_dot(direction, {at[0], at[1], at[2]}));
                }
            return most;
        };
    }

    l3d_part_list list_;
    l3d_polygon_model whole_, uncut_ = whole_;
    l3d_vector<double, 3> rotation_{0.0, 0.0, 0.0};
    bool is_cut_ = false;
};

#endif
