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
    as_added, ///< in the order of addition: later polygons cover earlier ones
    /// From far to near, by the mean distance of a polygon's corners. Polygons that are equally far
    /// are drawn in the order of addition.
    far_first,
    by_depth, ///< in any order: each pixel shows the polygon that is nearest there
};

/// Transforms, clips and projects the polygons of a world's objects, and holds them for one frame,
/// to draw them in a given order (l3d_draw_order).
///
/// Each vertex of an object is transformed once, however many polygons share it. Polygons are cut
/// at near_z, and far outside the picture. Polygons wholly beyond far_z are left out.
/// Cost:   time linear in vertices and polygons, apart from sorting. Memory is kept for as many
///         polygons as any frame had so far, at most 2^32.
/// Source: the order of the steps is that of l3d_world::draw_all in the book.
class L3D_PUBLIC l3d_facet_list {
public:
    /// The numbers that pictures are computed in.
    using real = l3d_real;

    /// Starts a frame for this camera and size of the picture, and forgets the last frame. Expects:
    /// 0 < near_z <= far_z, fovx and fovy > 0.
    void begin(const l3d_camera_left_handed<real>& camera, l3d_size size);

    /// Adds an object's polygons that may be seen. Returns the number of vertices that were
    /// transformed.
    std::size_t add(const l3d_object& object);

    /// The number of polygons that were added since begin(). Polygons that cannot be seen do not
    /// count.
    std::size_t polygons() const { return polygons_.size(); }

    /// Draws the polygons added since begin(), each in its own colour. The order `by_depth` is
    /// drawn as far_first.
    void draw(l3d_rasterizer_2d& rasterizer, l3d_draw_order order);

    /// The corners in the picture of polygon `which`, counted from 0 in the order of addition.
    /// Units: pixels.
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
    /// Vertices of one object in the camera's coordinates, followed by the vertices that cuts make.
    std::vector<l3d_point<real>> points_;
    std::vector<std::uint32_t> clipped_, before_; ///< corners of the polygon that is being clipped
    std::vector<l3d_point_2d> corners_;           ///< corners of all polygons
    std::vector<polygon> polygons_;
    /// For each polygon, a sort key and the polygon's index. Keys fall as depth rises. In the order
    /// as_added, all keys are 0.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order_;
};

class l3d_world_surfaces;

/// The picture that a world is drawn into, and the rasterizers that draw into this picture.
///
/// The picture may be a part of a larger one. Then `pixels` has the part's first word and size, and
/// the stride of the larger picture. So a second call of draw_all can draw a mirror, or a window
/// onto another place.
/// Expects: `rasterizer` draws into `pixels`.
/// Lives:   borrowed while drawing.
struct L3D_PUBLIC l3d_world_target {
    l3d_rasterizer_2d& rasterizer; ///< draws lines, and polygons that are not drawn by depth
    l3d_pixels pixels;             ///< the picture
    /// Fills polygons by depth. If it is null, the order `by_depth` is drawn as `far_first`.
    l3d_surface_rasterizer* surfaces = nullptr;
    /// The threads that `surfaces` was made with; null without `surfaces`.
    l3d_workers* workers = nullptr;
};

/// A left-handed world: objects, and the camera that looks at them. A program derives a class,
/// whose constructor adds the objects.
class L3D_PUBLIC l3d_world {
public:
    /// The type of a world's camera.
    using camera_type = l3d_camera_left_handed<l3d_real>;

    /// Makes an empty world, with a camera for pictures of this size.
    explicit l3d_world(l3d_size size) : l3d_world(std::make_unique<camera_type>(size)) {}
    /// Makes an empty world that owns this camera. The camera may be of a subclass. Expects: not
    /// null.
    explicit l3d_world(std::unique_ptr<camera_type> seen_by);
    l3d_world(const l3d_world&) = delete;
    l3d_world& operator=(const l3d_world&) = delete;
    virtual ~l3d_world();

    /// The camera that looks at the world.
    camera_type& camera;
    /// The order in which polygons are drawn.
    l3d_draw_order order = l3d_draw_order::by_depth;
    /// The look of polygons that are drawn by depth. The settings headlight and rotation have no
    /// effect. Lights are given in the left-handed world. The initial settings look like the book:
    /// one shade for each face, hard edges, a black ground, one thread.
    l3d_polygon_settings surfaces{
        .shade = l3d_shade::flat, .background = {}, .antialias = false, .threads = 1};
    /// Whether objects stand still, so that only the camera moves.
    bool frozen = false;

    /// Puts an object into the world, as the last of its objects. This is allowed at any time: an
    /// object that is added during an update takes part in the next update. Expects: not null.
    /// Returns: the object.
    l3d_object& add(std::unique_ptr<l3d_object> object);

    /// Takes an object out of the world. This is allowed at any time. During an update, the object
    /// is not updated any more, and lives until the update ends; so an object may remove itself.
    /// Errors:  returns false if the object is not in the world.
    bool remove(const l3d_object& object);

    /// All objects of the world, in the order of addition.
    /// Errors:  none.
    /// Lives:   until the next add or remove.
    std::span<const std::unique_ptr<l3d_object>> objects() const { return objects_; }

    /// Lets time pass for every object, then for the camera. Units: seconds.
    virtual void update_all(double seconds);

    /// Draws all objects that the camera sees. In the order by_depth, the background of `surfaces`
    /// is drawn first; in the two other orders, objects are drawn over the old picture.
    /// Returns: the number of polygons drawn; in the order by_depth, the number of triangles drawn.
    virtual std::size_t draw_all(const l3d_world_target& target);

private:
    class update_scope;

    void drop_removed();

    std::unique_ptr<camera_type> owned_camera_; ///< the camera that `camera` refers to
    std::vector<std::unique_ptr<l3d_object>> objects_;
    /// Objects that were removed during an update, and are dropped after it.
    std::unordered_set<const l3d_object*> removed_;
    int updates_ = 0; ///< number of calls of update_all that have not returned yet
    l3d_facet_list facets_;
    std::unique_ptr<l3d_world_surfaces> drawn_; ///< draws by depth; made for the first such frame
};

#endif
