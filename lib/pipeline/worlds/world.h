// SPDX-License-Identifier: MIT
// l3d_world: objects and the camera that looks at them; their facets from far to near.
#ifndef L3D_PIPELINE_WORLDS_WORLD_H
#define L3D_PIPELINE_WORLDS_WORLD_H

#include "base/color.h"
#include "base/public.h"
#include "pipeline/polygons/pipeline_polygons.h"
#include "pipeline/worlds/camera_left_handed.h"
#include "pipeline/worlds/object.h"
#include "raster/rasterizer_2d.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_set>
#include <utility>
#include <vector>

/// The order in which polygons are drawn.
enum class L3D_PUBLIC l3d_draw_order {
    as_added,  ///< later ones cover earlier ones
    far_first, ///< the painter's: by the mean distance of the corners, equal ones as added
    by_depth,  ///< each pixel shows the polygon that is nearest there
};

/// Transforms, clips and projects polygons, and holds the result for one frame.
///
/// Each vertex of an object is transformed once, however many polygons share it. Polygons are cut
/// at near_z, and far outside the picture. Polygons wholly beyond far_z are left out. Vertices that
/// cuts make follow the object's own in one list.
/// Cost:   time linear in vertices and polygons, but for sorting; memory for the most polygons of
///         any frame so far, and no limit to their number but 2^32.
/// Source: the order of steps is that of l3d_world::draw_all in the book.
class L3D_PUBLIC l3d_facet_list {
public:
    /// The numbers that pictures are computed in.
    using real = l3d_real;

    /// Forgets the last frame. Expects: 0 < near_z <= far_z, fovx and fovy > 0.
    void begin(const l3d_camera_left_handed<real>& camera, l3d_size size);

    /// Adds the polygons of an object that may be seen. Returns the number of vertices transformed.
    std::size_t add(const l3d_object& object);

    /// The number of polygons added that are neither behind the eye nor outside the picture.
    std::size_t polygons() const { return polygons_.size(); }

    /// Draws the polygons added since begin(), each in its own colour; `by_depth` is drawn as
    /// far_first.
    void draw(l3d_rasterizer_2d& rasterizer, l3d_draw_order order);

    /// The corners of a polygon; polygons count from 0, in the order of addition. Units: pixels.
    std::span<const l3d_point_2d> corners(std::size_t which) const;

private:
    struct polygon {
        std::size_t first_corner, corners;
        l3d_color color;
        real depth;
    };

    bool clip(std::span<const std::uint32_t> face);
    bool clip_sideways(int axis, real scale);
    void project(l3d_color color);

    l3d_camera_left_handed<real> camera_{l3d_size{1, 1}};
    l3d_size size_{1, 1};
    l3d_matrix<real> viewing_ = l3d_identity<real>();
    std::vector<l3d_point<real>> points_; ///< points of one object, in the camera's coordinates
    std::vector<std::uint32_t> clipped_, before_; ///< corners of one polygon
    std::vector<l3d_point_2d> corners_;           ///< corners of all polygons
    std::vector<polygon> polygons_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>>
        order_; ///< keys that fall as depth rises; places
};

class l3d_world_surfaces;

/// The picture that a world is drawn into, and the rasterizers for it.
///
/// The picture may be a part of another one. Then `pixels` has the part's first word and size, and
/// the stride of the whole. So a second call of draw_all can draw a mirror, or a window onto
/// another place.
/// Expects: the rasterizer draws into the same pixels.
/// Lives:   borrowed while drawing.
struct L3D_PUBLIC l3d_world_target {
    l3d_rasterizer_2d& rasterizer; ///< draws lines, and polygons that are painted in an order
    l3d_pixels pixels;             ///< the picture
    /// Fills surfaces by depth. Null: the order `by_depth` is painted as `far_first`.
    l3d_surface_rasterizer* surfaces = nullptr;
    /// The threads that `surfaces` was made with; null without `surfaces`.
    l3d_workers* workers = nullptr;
};

/// A left-handed world. A program populates it in the constructor of a subclass.
class L3D_PUBLIC l3d_world {
public:
    /// The kind of camera that a world has.
    using camera_type = l3d_camera_left_handed<l3d_real>;

    /// An empty world, whose camera makes pictures of this size.
    explicit l3d_world(l3d_size size) : l3d_world(std::make_unique<camera_type>(size)) {}
    /// An empty world that owns this camera, which may be of a subclass. Expects: not null.
    explicit l3d_world(std::unique_ptr<camera_type> seen_by);
    l3d_world(const l3d_world&) = delete;
    l3d_world& operator=(const l3d_world&) = delete;
    virtual ~l3d_world();

    /// The camera that looks at the world.
    camera_type& camera;
    /// The order in which polygons are drawn.
    l3d_draw_order order = l3d_draw_order::by_depth;
    /// The look of surfaces drawn by depth. Its headlight and its rotation have no effect. Lights
    /// are given in the left-handed world. At first they are as in the book: one grey for each
    /// face, hard edges, on black, by one thread.
    l3d_polygon_settings surfaces{
        .shade = l3d_shade::flat, .background = {}, .antialias = false, .threads = 1};
    /// Whether objects stand still, so that only the camera moves.
    bool frozen = false;

    /// Puts an object into the world, after the others. Allowed at any time: an object added during
    /// an update is updated from the next time on. Expects: not null.
    /// Returns: the object.
    l3d_object& add(std::unique_ptr<l3d_object> object);

    /// Takes an object out of the world. Allowed at any time: while objects are updated, it takes
    /// part in nothing more and lives until the update ends, so it may remove itself.
    /// Errors:  false if the object is not in the world.
    bool remove(const l3d_object& object);

    /// All that is in the world, in the order of addition.
    /// Errors:  none.
    /// Lives:   until the next add or remove.
    std::span<const std::unique_ptr<l3d_object>> objects() const { return objects_; }

    /// Lets time pass for every object, then for the camera. Units: seconds.
    virtual void update_all(double seconds);

    /// Draws all that the camera sees. By depth, the background of `surfaces` comes first; else the
    /// old picture stays below.
    /// Returns: the number of polygons drawn; by depth, of the triangles that they are made of.
    virtual std::size_t draw_all(const l3d_world_target& target);

private:
    class update_scope;

    void drop_removed();

    std::unique_ptr<camera_type> owned_camera_; ///< the camera that `camera` names
    std::vector<std::unique_ptr<l3d_object>> objects_;
    /// Objects that were removed during an update, and are dropped after it.
    std::unordered_set<const l3d_object*> removed_;
    int updates_ = 0; ///< calls of update_all that have not returned
    l3d_facet_list facets_;
    std::unique_ptr<l3d_world_surfaces> drawn_; ///< made by the first frame that is drawn by depth
};

#endif
