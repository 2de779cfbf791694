// SPDX-License-Identifier: MIT
// section_keys: the plane that cuts a model open, and how keys move it.
#ifndef APPS_SURFVIEW_SECTION_KEYS_H
#define APPS_SURFVIEW_SECTION_KEYS_H

#include <l3d/camera.h>
#include <l3d/plane.h>

#include <optional>
#include <string>

/// A plane across x, y, z or a direction that the user gives. Only its front is drawn.
class section_keys {
public:
    using vector = l3d_vector<double, 3>;

    /// Begins with this plane, which may be none.
    explicit section_keys(const std::optional<l3d_plane<double>>& plane) : plane_(plane) {}

    const std::optional<l3d_plane<double>>& plane() const { return plane_; }

    /// Takes the next one of four states: no plane, or a plane across x, y or z. The plane goes
    /// through the middle of a model of this reach, and cuts away the half towards the axis's tip.
    /// Returns a line for people.
    std::string take_next(const l3d_reach& reach);
    /// Moves the plane along its normal by a part of the model's extent.
    std::string move(double part, const l3d_reach& reach);
    /// Draws the other half.
    std::string flip();

    /// The options that make this plane again, each after a blank; "" for none.
    std::string options() const;

private:
    std::string text() const;

    std::optional<l3d_plane<double>> plane_;
};

#endif
