// SPDX-License-Identifier: MIT
// section_keys: the plane that cuts a model open, and how keys move it.
#ifndef APPS_SURFVIEW_SECTION_KEYS_H
#define APPS_SURFVIEW_SECTION_KEYS_H

#include <l3d/camera.h>
#include <l3d/plane.h>

#include <optional>
#include <string>

/// The plane that cuts a model open, and its changes by keys. It is perpendicular to x, y, z or a
/// direction that the user gives. Only the part of the model in front of the plane is drawn.
class section_keys {
public:
    using vector = l3d_vector<double, 3>;

    /// Begins with this plane, or with none.
    explicit section_keys(const std::optional<l3d_plane<double>>& plane) : plane_(plane) {}

    const std::optional<l3d_plane<double>>& plane() const { return plane_; }

    /// Takes the next one of four states: no plane, or a plane perpendicular to x, y or z. The
    /// plane goes through the middle of a model of this reach, and cuts away the half towards the
    /// axis's positive end. Returns a line that tells the user the new state.
    std::string take_next(const l3d_reach& reach);
    /// Moves the plane along its normal by `part` of the extent of a model of this reach. Returns a
    /// line for the user.
    std::string move(double part, const l3d_reach& reach);
    /// Turns the plane round, so that the other half is drawn. Returns a line for the user.
    std::string flip();

    /// The command-line options that make this plane again, each after a blank; "" if there is no
    /// plane.
    std::string options() const;

private:
    std::string text() const;

    std::optional<l3d_plane<double>> plane_;
};

#endif
