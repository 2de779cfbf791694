// SPDX-License-Identifier: MIT
// audit: --audit compares a mesh with the surfaces that it stands for, in numbers and in colours.
#ifndef APPS_SURFVIEW_AUDIT_H
#define APPS_SURFVIEW_AUDIT_H

#include <l3d/camera.h>
#include <l3d/color.h>
#include <l3d/panel.h>
#include <l3d/patch_model.h>
#include <l3d/pipeline_zbuffer.h>
#include <l3d/polygon_model.h>
#include <l3d/surface_audit.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Compares a mesh with the surfaces that it stands for: the distances between them, as numbers and
/// as colours.
class mesh_audit {
public:
    using vector = l3d_surface_audit::vector;

    /// Loads the mesh, and compares it with `surface`. Distances are bounded from both sides;
    /// `tolerance` is the largest gap between the bounds, as a part of the model's diagonal.
    /// Errors: l3d_error(bad_input) with file, line and reason, also for a file of surfaces.
    mesh_audit(std::string surface_file, const l3d_patch_model& surface, std::string mesh_file,
               double tolerance);

    /// The results as a line of JSON.
    std::string json() const;
    /// A line for the user that guesses the unit of the mesh, if its size differs much from the
    /// surfaces'; otherwise "".
    std::string hint() const;

    /// The mesh, coloured by its distance from the surfaces, with a mark at the place of the
    /// largest distance.
    l3d_polygon_model picture() const;
    /// A panel that tells the meaning of the colours.
    l3d_panel legend() const;
    /// A direction from which the place of the largest distance is likely to be seen.
    vector sight() const { return sight_; }

private:
    const l3d_audited_way& worst() const;
    l3d_color color_of(double distance) const;

    std::string surface_file_, mesh_file_;
    /// Number of the file's face with the surfaces' worst place; 0 if faces have no numbers.
    std::uint32_t face_ = 0;
    std::string part_; ///< name of the part with the surfaces' worst place; may be empty
    std::size_t pieces_;
    l3d_polygon_model mesh_;
    double diagonal_, tolerance_;
    l3d_surface_audit surface_;
    l3d_mesh_audit found_;
    double seconds_ = 0;
    vector sight_{0.0, 0.0, 1.0};
};

/// A viewer that shows the picture of an audit, with its legend.
class audit_viewer : public l3d_pipeline_zbuffer {
public:
    audit_viewer(l3d_canvas canvas, const mesh_audit& audit, const l3d_camera& camera,
                 const l3d_polygon_settings& settings)
        : l3d_pipeline_zbuffer(std::move(canvas), audit.picture(), camera, settings),
          legend_(audit.legend()) {}

protected:
    l3d_standing_panel standing_panel() override { return {legend_, l3d_corner::bottom_left}; }

private:
    l3d_panel legend_;
};

#endif
