// SPDX-License-Identifier: MIT
// A spike that flies towards the viewer, as in the programs spikes, rotspikes, camspikes and clipz.
#ifndef L3D_APPS_SPIKES_SPIKE_H
#define L3D_APPS_SPIKES_SPIKE_H

#include <l3d/random.h>
#include <l3d/camera_left_handed.h>
#include <l3d/object.h>

/// The properties that all spikes of one program share.
/// Units: lengths in world units; speeds in world units per update of the book.
struct spike_kind {
    double length = 100, width = 10;
    int spread = 1000; ///< a start is at most this far to each side
    int nearest_start = 100, farthest_start = 1099;
    int slowest = 5, fastest = 79;
    int fastest_turn = 0; ///< largest turn about each axis, in degrees per update
};

/// A spike's mesh: three sides, red, green and blue, and no base. The tip lies at the origin and
/// points to the viewer.
inline l3d_polygon_mesh spike_mesh(const spike_kind& kind) {
    const double l = kind.length, w = kind.width;
    l3d_polygon_mesh mesh;
    mesh.vertices = {{0, 0, l}, {w, w, l}, {w, 0, l}, {0, 0, 0}};
    mesh.add_face({{3, 0, 1}});
    mesh.add_face({{3, 1, 2}});
    mesh.add_face({{3, 2, 0}});
    mesh.face_colors = {0xff0000, 0x00ff00, 0x0000ff};
    return mesh;
}

/// A spike that flies towards the viewer. After its arrival, the spike starts again from another
/// place and at another speed.
///
/// Lives:   borrows the random numbers.
class spike final : public l3d_object {
public:
    spike(const spike_kind& kind, l3d_random& random)
        : l3d_object(spike_mesh(kind)), kind_(kind), random_(random) {
        start();
    }

private:
    void start() {
        for (double& p : place_)
            p = random_.between(-kind_.spread, kind_.spread);
        place_[2] = random_.between(kind_.nearest_start, kind_.farthest_start);
        speed_ = random_.between(kind_.slowest, kind_.fastest);
        for (double& turn : turns_)
            turn = random_.between(-kind_.fastest_turn, kind_.fastest_turn);
        set_placement();
    }

    void do_update(double seconds) override {
        const double updates = seconds * l3d_book_rate;
        place_[2] -= speed_ * updates;
        for (std::size_t i = 0; i < 3; ++i)
            angles_[i] += turns_[i] * updates;
        set_placement();
        if (has_arrived())
            start();
    }

    /// Makes the placement anew from the spike's angles and place, so that no rounding adds up.
    void set_placement() {
        set_transform(0, l3d_rotation_x<real>(angles_[0]));
        set_transform(1, l3d_rotation_y<real>(angles_[1]));
        set_transform(2, l3d_rotation_z<real>(angles_[2]));
        set_transform(3, l3d_translation<real>(place_[0], place_[1], place_[2]));
    }

    bool has_arrived() const {
        for (const auto& v : vertices())
            if (l3d_to_double(l3d_transformed(modeling_transform(), v)[2]) < 1)
                return true;
        return false;
    }

    spike_kind kind_;
    l3d_random& random_;
    double place_[3], speed_, turns_[3], angles_[3] = {};
};

#endif
