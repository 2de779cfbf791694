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

/// A plug-in: the behaviour of an object from frame to frame, if this behaviour comes from outside
/// the object's class.
class L3D_PUBLIC l3d_object_behaviour {
public:
    l3d_object_behaviour() = default;
    l3d_object_behaviour(const l3d_object_behaviour&) = delete;
    l3d_object_behaviour& operator=(const l3d_object_behaviour&) = delete;
    virtual ~l3d_object_behaviour() = default;

    /// Lets time pass for `object`, which has this behaviour. Units: seconds.
    void update(l3d_object& object, double seconds) { do_update(object, seconds); }

    /// Makes a behaviour of the same kind, with a state of its own. `for_copy` is the copy of the
    /// object that gets this behaviour.
    /// Errors:  null if the behaviour cannot be copied.
    std::unique_ptr<l3d_object_behaviour> clone(l3d_object& for_copy) const {
        return do_clone(for_copy);
    }

private:
    virtual void do_update(l3d_object& object, double seconds) = 0;
    virtual std::unique_ptr<l3d_object_behaviour> do_clone(l3d_object& for_copy) const = 0;
};

/// A thing in a world: its polygons, its placement, and its behaviour from frame to frame.
///
/// The polygons themselves are never changed: every frame transforms a copy, so rounding deforms
/// nothing. The placement is a list of matrices, and the first matrix is applied first. The product
/// of the matrices is updated automatically. The behaviour comes from a subclass, or from a
/// plug-in.
/// Shape: faces as in l3d_polygon_mesh; a world's axes are left-handed.
class L3D_PUBLIC l3d_object {
public:
    /// The type of the numbers in which pictures are computed.
    using real = l3d_real;

    l3d_object() = default;
    /// Makes an object of these polygons. Expects: mesh.is_valid().
    explicit l3d_object(l3d_polygon_mesh mesh) { set_mesh(std::move(mesh)); }
    l3d_object& operator=(const l3d_object&) = delete;
    /// Objects that hung from this one have no parent afterwards. From then on, only their own
    /// matrices place these objects.
    virtual ~l3d_object();

    std::string name; ///< the object's name for messages; several objects may have the same name

    /// Replaces the object's polygons, and the pictures on the polygons (l3d_read_textures).
    /// Pictures are seen only if the world is drawn by depth. Expects: mesh.is_valid().
    void set_mesh(l3d_polygon_mesh mesh,
                  std::vector<std::shared_ptr<const l3d_texture>> textures = {});
    /// The polygons, in the object's own coordinates.
    const l3d_polygon_mesh& mesh() const { return mesh_; }

    /// The mesh as a model that can be drawn by depth, with creases of the usual angle.
    /// Cost: the model is made at the first call after set_mesh. Copies share its contents.
    const l3d_polygon_model& model() const;

    /// The mesh's vertices, as numbers of type `real`.
    std::span<const l3d_point<real>> vertices() const { return vertices_; }

    /// Sets the placement's matrix with this index. Matrices of lesser index that were never set
    /// are the identity.
    void set_transform(std::size_t index, const l3d_matrix<real>& m);
    /// The matrices of the placement. The first matrix is applied first.
    std::span<const l3d_matrix<real>> transforms() const { return transforms_; }

    /// The product of the placement's matrices: from the object's own coordinates to its parent's,
    /// or to the world's if the object has no parent.
    const l3d_matrix<real>& modeling_transform() const;

    /// Hangs this object to another object, its parent. From then on, the parent's placement moves
    /// this object as well. Null makes the object stand in the world without a parent.
    /// Errors: returns false, and changes nothing, if the parent is the object itself or hangs from
    ///         the object.
    /// Lives:  borrows the parent. When the parent is destroyed, the object has no parent any more.
    bool set_parent(l3d_object* parent);
    /// The object that this object hangs from; null if this object stands in the world.
    l3d_object* parent() const { return parent_; }

    /// The matrix from the object's own coordinates to the world's, with the matrices of all its
    /// parents.
    /// Cost:    a product of matrices for each parent.
    l3d_matrix<real> world_transform() const;

    /// Replaces the object's behaviour; null for none.
    void plug(std::unique_ptr<l3d_object_behaviour> behaviour) {
        behaviour_ = std::move(behaviour);
    }

    /// Lets time pass for the object: calls its class's or its plug-in's behaviour. Units: seconds.
    void update(double seconds) { do_update(seconds); }

    /// Makes a deep copy of the same class, with a behaviour of its own. The copy has the same
    /// parent and no children.
    /// Errors: none; the copy has no behaviour if the behaviour cannot be copied.
    std::unique_ptr<l3d_object> clone() const;

protected:
    /// Makes a deep copy of all but the behaviour.
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
    /// The result of model(), made of the mesh when it is first needed.
    mutable std::optional<l3d_polygon_model> model_;
    l3d_object* parent_ = nullptr;
    std::vector<l3d_object*> children_;
    std::unique_ptr<l3d_object_behaviour> behaviour_; // last: it may refer to all above
};

#endif
