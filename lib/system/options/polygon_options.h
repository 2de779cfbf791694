// SPDX-License-Identifier: MIT
// l3d_polygon_options: the command line of programs that draw polygons.
#ifndef L3D_SYSTEM_OPTIONS_POLYGON_OPTIONS_H
#define L3D_SYSTEM_OPTIONS_POLYGON_OPTIONS_H

#include "base/public.h"
#include "pipeline/polygons/polygon_model.h"
#include "pipeline/polygons/pipeline_polygons.h"
#include "system/options/afd_options.h"
#include "system/options/options.h"

#include <optional>
#include <string>

/// The pipelines that a program may draw a model with.
enum class L3D_PUBLIC l3d_pipeline_kind {
    afd,     ///< patches by adaptive forward differencing
    zsort,   ///< triangles from far to near, cut where no order is right
    zbuffer, ///< triangles with a depth buffer
    mesa,    ///< triangles by OpenGL in memory
    suitable ///< the one that suits the model
};

/// Adds options for pipeline, projection and style. l3d_afd_options has those that patches and
/// polygons share.
///
/// Lives:   both options are borrowed until parse() is done.
class L3D_PUBLIC l3d_polygon_options {
public:
    /// Declares the options. Without --pipeline, trimmed and subdivided surfaces are drawn as
    /// patches. With `prefers_patches`, so is any model of patches alone.
    /// Lives: borrows both until parse() is done.
    l3d_polygon_options(l3d_options& options, const l3d_afd_options& shared,
                        bool prefers_patches = false);
    l3d_polygon_options(const l3d_polygon_options&) = delete;
    l3d_polygon_options& operator=(const l3d_polygon_options&) = delete;

    /// The pipeline that --pipeline names, or the one that suits the model; never `suitable`. For
    /// --drawing and --svg it is that of patches.
    /// Errors:  l3d_error(bad_input) with file and line, if it takes a look at the model.
    l3d_pipeline_kind pipeline() const;

    /// Writes the parts of the model to standard output, as l3d_part_options::list does. They are
    /// parts of patches if the model would be drawn as patches, else parts of faces.
    /// Errors:  as model().
    void list_parts() const;

    /// The polygons of the model asked for, or of the teapot. Patches become triangles. Skipped
    /// parts of a file are reported on stderr.
    /// Errors:  l3d_error(bad_input) with file and line.
    l3d_polygon_model model() const;

    /// The settings that the options ask for.
    /// Errors: as l3d_afd_options::settings; l3d_error(usage) for options of patches alone, such as
    ///         --depth-output and --net.
    l3d_polygon_settings settings() const;

    /// The options that turn and project a model as these settings do, each after a blank; "" for
    /// none.
    static std::string view_options(const l3d_polygon_settings& settings);

    /// Checks the options of a program that draws patches, as --pipeline afd asks.
    /// Errors:  l3d_error(usage) if an option of polygons has another value than its default.
    void refuse_for_patches() const;

private:
    const l3d_afd_options& shared_;
    bool prefers_patches_ = false;
    l3d_pipeline_kind pipeline_ = l3d_pipeline_kind::suitable;
    /// The answer of pipeline(), kept after the first call.
    mutable std::optional<l3d_pipeline_kind> chosen_;
    bool hidden_lines_ = false, to_origin_ = false;
    l3d_vector<double, 3> rotation_ = l3d_polygon_settings().rotation;
    l3d_rotation_order rotation_order_ = l3d_polygon_settings().rotation_order;
    double crease_angle_ = l3d_usual_crease_angle;
    int facets_ = l3d_usual_facets;
    bool no_textures_ = false;
};

#endif
