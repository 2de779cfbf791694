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

/// The ways to draw a model that --pipeline names.
enum class L3D_PUBLIC l3d_pipeline_kind {
    afd,     ///< patches by adaptive forward differencing
    zsort,   ///< triangles painted from far to near, and cut if they have no right order
    zbuffer, ///< triangles with a depth buffer
    mesa,    ///< triangles by Mesa's OpenGL, in memory
    suitable ///< the pipeline that suits the model
};

/// Adds options for the pipeline, and for models of polygons, to the command line of a program.
/// l3d_afd_options has the options that patches and polygons share.
///
/// Lives:   borrows `shared`; the l3d_options borrow this object until parse() is done.
class L3D_PUBLIC l3d_polygon_options {
public:
    /// Adds the options to `options`. Without --pipeline, trimmed and subdivided surfaces are drawn
    /// as patches. If `prefers_patches` is true, any model of patches alone is drawn as patches,
    /// too.
    /// Lives: borrows both arguments until parse() is done.
    l3d_polygon_options(l3d_options& options, const l3d_afd_options& shared,
                        bool prefers_patches = false);
    l3d_polygon_options(const l3d_polygon_options&) = delete;
    l3d_polygon_options& operator=(const l3d_polygon_options&) = delete;

    /// The pipeline that --pipeline names, or the one that suits the model; never `suitable`. With
    /// --drawing or --svg it is afd, which draws patches.
    /// Errors:  l3d_error(bad_input) with file and line, if the model's file must be looked into.
    l3d_pipeline_kind pipeline() const;

    /// Writes the parts of the model to the standard output, as l3d_part_options::list does. Lines
    /// count patches if the model would be drawn as patches, otherwise faces.
    /// Errors:  as model().
    void list_parts() const;

    /// The model that the user asks for, or the teapot, as polygons. Patches become triangles.
    /// Notes on skipped parts of a file go to stderr.
    /// Errors:  l3d_error(bad_input) with file and line.
    l3d_polygon_model model() const;

    /// The settings that the options ask for.
    /// Errors: as l3d_afd_options::settings; also l3d_error(usage) for options that only patches
    ///         have, such as --depth-output and --net.
    l3d_polygon_settings settings() const;

    /// The command-line options that turn a model as these settings do, with a blank before each
    /// option. The text is "" if the model is not turned.
    static std::string view_options(const l3d_polygon_settings& settings);

    /// Refuses options of polygons in a program that draws patches, as --pipeline afd asks.
    /// Errors:  l3d_error(usage) if an option of polygons has another value than its default.
    void refuse_for_patches() const;

private:
    const l3d_afd_options& shared_;
    bool prefers_patches_ = false;
    l3d_pipeline_kind pipeline_ = l3d_pipeline_kind::suitable;
    /// The result of pipeline(), kept after the first call.
    mutable std::optional<l3d_pipeline_kind> chosen_;
    bool hidden_lines_ = false, to_origin_ = false;
    l3d_vector<double, 3> rotation_ = l3d_polygon_settings().rotation;
    l3d_rotation_order rotation_order_ = l3d_polygon_settings().rotation_order;
    double crease_angle_ = l3d_usual_crease_angle;
    int facets_ = l3d_usual_facets;
    bool no_textures_ = false;
};

#endif
