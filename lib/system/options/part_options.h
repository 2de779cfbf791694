// SPDX-License-Identifier: MIT
// l3d_part_options: the command line that lists, hides and colours the named parts of a model.
#ifndef L3D_SYSTEM_OPTIONS_PART_OPTIONS_H
#define L3D_SYSTEM_OPTIONS_PART_OPTIONS_H

#include "base/color.h"
#include "base/public.h"
#include "geom/parts.h"
#include "pipeline/part_list.h"
#include "pipeline/polygons/polygon_model.h"
#include "scene/patch_model.h"
#include "scene/patch_scene.h"
#include "system/options/options.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Adds options that list, hide and colour the named parts of a model to the command line of a
/// program.
///
/// Lives: the l3d_options borrow this object until parse() is done.
class L3D_PUBLIC l3d_part_options {
public:
    /// Adds the options to `options`.
    explicit l3d_part_options(l3d_options& options);
    l3d_part_options(const l3d_part_options&) = delete;
    l3d_part_options& operator=(const l3d_part_options&) = delete;

    /// Whether --list-parts asks for a list of parts instead of a picture.
    bool lists() const { return lists_; }

    /// Prints a line for each part: its name, and the number of its patches or faces, such as "8
    /// patches". `things` is the word for patches or faces.
    /// Errors: l3d_error(failure) if the standard output cannot be written to.
    static void list(const l3d_parts& parts, std::string_view things);

    /// Applies --color, --hide, --show-only and --opacity to a scene. Each part that --opacity
    /// names becomes an instance of its own. The remaining patches become one instance for each
    /// opacity of their materials (l3d_patch_scene::add_by_opacity).
    /// Errors:  as applied().
    l3d_patch_scene scene(const l3d_patch_scene& whole) const;

    /// Applies only --opacity to a scene, for a viewer whose list of parts applies --color, --hide
    /// and --show-only (put_into).
    /// Errors:  l3d_error(usage) for a name of --opacity that is no part, or for too many parts.
    l3d_patch_scene scene_by_opacity(const l3d_patch_scene& whole) const;
    /// Applies --color, --hide and --show-only to a list of the model's parts.
    /// Errors:  as applied().
    void put_into(l3d_part_list& list, const l3d_parts& parts) const;
    /// Refuses --opacity, since parts of a model of polygons have no opacity. Errors:
    /// l3d_error(usage).
    void refuse_for_polygons() const;

    /// Applies --color, --hide and --show-only to a model of patches.
    /// Errors:  l3d_error(usage) for a name that is no part, with the option and a list of the
    ///          parts; also if no part is left.
    l3d_patch_model applied(const l3d_patch_model& model) const;
    /// Applies --color, --hide and --show-only to a model of polygons.
    /// Errors:  as for patches; also l3d_error(usage) if --opacity was given.
    l3d_polygon_model applied(const l3d_polygon_model& model) const;

private:
    struct colored {
        std::string part;
        l3d_color color;
    };

    struct opacity {
        std::string part;
        double value;
    };

    void check(const l3d_parts& parts) const;
    void check_opacities(const l3d_parts& parts) const;
    template <class Model> Model as_asked(const Model& model) const;
    template <class Model> Model applied_to(const Model& model) const;
    void add_by_opacity(const l3d_patch_instance& whole, l3d_patch_scene& to) const;
    void add_color(const std::string& text);
    void add_opacity(const std::string& text);

    bool lists_ = false;
    std::vector<std::string> hidden_, shown_;
    std::vector<colored> colors_;
    std::vector<opacity> opacities_;
};

#endif
