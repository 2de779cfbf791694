// SPDX-License-Identifier: MIT
// l3d_object: a thing in a world: its polygons, where it is, and what it does.
#ifndef L3D_PIPELINE_WORLDS_OBJECT_H
#define L3D_PIPELINE_WORLDS_OBJECT_H

#include "base/public.h"
#include "geom/polygon_3d.h"
#include "geom/polygon_mesh.h"
#include "geom/transform.h"
#include "pipeline/polygons/polygon_model.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

class l3d_object;

/// A plug-in: an object's behaviour from frame to frame that comes from outside the object's class.
class L3D_PUBLIC l3d_object_behaviour {
public:
    l3d_object_behaviour() = default;
    l3d_object_behaviour(const l3d_object_behaviour&) = delete;
    l3d_object_behaviour& operator=(const l3d_object_behaviour&) = delete;
    virtual ~l3d_object_behaviour() = default;

    /// Lets time pass for the object that it belongs to. Units: seconds.
    void update(l3d_object& object, double seconds) { do_update(object, seconds); }

    /// The same behaviour with a state of its own, for a copy of the object.
    /// Errors:  null if it cannot be copied.
    std::unique_ptr<l3d_object_behaviour> clone(l3d_object& for_copy) const {
        return do_clone(for_copy);
    }

private:
    virtual void do_update(l3d_object& object, double seconds) = 0;
    virtual std::unique_ptr<l3d_object_behaviour> do_clone(l3d_object& for_copy) const = 0;
};

/// Geometry, placement and behaviour.
///
/// The geometry is never transformed in place: every frame starts from it, so nothing is deformed
/// by rounding. The placement is a list of matrices, the first one applied first; their product is
/// updated automatically. The behaviour comes from a subclass, or from a plug-in.
/// Shape: faces as in l3d_polygon_mesh; a world's axes are left-handed.
class L3D_PUBLIC l3d_object {
public:
    /// The numbers that pictures are computed in.
    using real = l3d_real;

    l3d_object() = default;
    /// An object of these polygons. Expects: mesh.is_valid().
    explicit l3d_object(l3d_polygon_mesh mesh) { set_mesh(std::move(mesh)); }
    l3d_object& operator=(const l3d_object&) = delete;
    /// Leaves its children without a parent, placed by their own matrices.
    virtual ~l3d_object();

    std::string name; ///< for messages; several objects may have the same one

    /// Replaces the object's polygons, and the pictures on them (l3d_read_textures), which are seen
    /// only where surfaces are filled by depth. Expects: mesh.is_valid().
    void set_mesh(l3d_polygon_mesh mesh,
                  std::vector<std::shared_ptr<const l3d_texture>> textures = {});
    /// The polygons, in the object's own coordinates.
    const l3d_polygon_mesh& mesh() const { return mesh_; }

    /// The mesh ready to be filled by depth, with creases of the usual angle.
    /// Cost: made at the first call after set_mesh; a copy shares its contents.
    const l3d_polygon_model& model() const;

    /// The mesh's vertices in the numbers that pictures are computed in.
    std::span<const l3d_point<real>> vertices() const { return vertices_; }

    /// Sets one of the placement's matrices. Earlier ones that were never set are the identity.
    void set_transform(std::size_t index, const l3d_matrix<real>& m);
    /// The matrices of the placement, the first one applied first.
    std::span<const l3d_matrix<real>> transforms() const { return transforms_; }

    /// The product of the matrices: from the object's own coordinates to its parent's, or to the
    /// world's if it has none.
    const l3d_matrix<real>& modeling_transform() const;

    /// Hangs the object to another one, whose placement then moves it as well; null puts it into
    /// the world.
    /// Errors: false, and nothing changes, if the parent is the object or hangs from it.
    /// Lives:  borrows the parent; when the parent goes, the object has none.
    bool set_parent(l3d_object* parent);
    /// The object that it hangs from; null if it stands in the world.
    l3d_object* parent() const { return parent_; }

    /// From the object's own coordinates to the world's: the matrices of all its parents, too.
    /// Cost:    a product for each parent.
    l3d_matrix<real> world_transform() const;

    /// Replaces the object's behaviour; null for none.
    void plug(std::unique_ptr<l3d_object_behaviour> behaviour) {
        behaviour_ = std::move(behaviour);
    }

    /// Lets time pass. Units: seconds.
    void update(double seconds) { do_update(seconds); }

    /// A deep copy of the same class, with a behaviour of its own. It has the same parent and no
    /// children.
    /// Errors: none; a behaviour that cannot be copied is left out.
    std::unique_ptr<l3d_object> clone() const;

protected:
    /// A deep copy of all but the behaviour.
    l3d_object(const l3d_object& other);

private:
    virtual void do_update(double seconds);
    virtual std::unique_ptr<l3d_object> do_clone() const;

    l3d_polygon_mesh mesh_;
    std::vector<std::shared_ptr<const l3d_texture>> textures_;
    std::vector<l3d_point<real>> vertices_;
    std::vector<l3d_matrix<real>> transforms_;
    mutable l3d_matrix<real> product_ = l3d_identity<real>();
    mutable bool product_is_old_ = false;
    mutable std::optional<l3d_polygon_model> model_; ///< made of the mesh once it is needed
    l3d_object* parent_ = nullptr;
    std::vector<l3d_object*> children_;
    std::unique_ptr<l3d_object_behaviour> behaviour_; // last: it may refer to all above
};

#endif
