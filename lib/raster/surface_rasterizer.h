// SPDX-License-Identifier: MIT
// l3d_surface_rasterizer: fills micro-quads and triangles with depth and shading.
#ifndef L3D_RASTER_SURFACE_RASTERIZER_H
#define L3D_RASTER_SURFACE_RASTERIZER_H

#include "base/color.h"
#include "base/public.h"
#include "geom/material.h"
#include "raster/background.h"
#include "raster/depth_buffer.h"
#include "raster/shade.h"
#include "raster/lighting.h"
#include "raster/surface_part.h"
#include "raster/textures/texture.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

/// The way in which the surfaces of a frame get their colours.
struct L3D_PUBLIC l3d_shading {
    l3d_shade mode = l3d_shade::lambert; ///< the way in which pixels get their colours
    std::array<float, 3> light{0, 0, 1}; ///< unit vector towards the light, world space

    /// The ray from the eye through the picture's top left corner, and its change for one pixel to
    /// the right and one down. World space, any length. All zero if normals are turned to the eye
    /// already.
    std::array<float, 3> ray{0, 0, -1}, ray_right{}, ray_down{};

    /// Whether mode lambert finds a unit normal in each pixel, even where a plane of light would
    /// do.
    bool keep_unit_normals = false;

    /// Whether pixels at edges show the mean light over their squares. Light is linear: levels are
    /// decoded by the sRGB curve, and the mean is encoded again. A rasterizer that cannot smooth
    /// edges ignores this member (l3d_surface_rasterizer::antialiases).
    bool antialias = false;

    /// The picture's colours where no surface covers a pixel, or a part of a pixel.
    l3d_background background{};

    /// The colour that far surfaces fade into. Only rasterizers that inspect
    /// (l3d_surface_rasterizer::inspects) draw fog.
    l3d_fog fog{};

    /// The meaning of depths in a depth buffer. They are 1 / distance if `depth_step` is 0. In a
    /// parallel projection they are depth_base + depth_step * distance.
    /// Units: distances along the view axis.
    double depth_base = 0, depth_step = 0;

    /// The distance along the view axis that a depth stands for. Expects: a depth > 0.
    float distance(float depth) const {
        return depth_step == 0 ? 1 / depth
                               : static_cast<float>((double{depth} - depth_base) / depth_step);
    }

    /// The pixel word of a surface as it looks behind the fog. The fog's colour is that of the
    /// pixel's row.
    /// Expects: fog that is on; a depth > 0.
    std::uint32_t fogged(std::uint32_t word, l3d_color fog_color, float depth) const {
        return l3d_fog::word(word, fog_color, fog.amount(distance(depth)));
    }

    l3d_lighting lighting{}; ///< the colours of lights, and the lights besides `light`

    /// The same rays as `ray`, `ray_right` and `ray_down`. They are set in every frame, also if
    /// normals are turned to the eye already.
    std::array<float, 3> look{0, 0, -1}, look_right{}, look_down{};

    /// The eye, in world space. A pixel shows the place eye + aside + distance / look_depth * look.
    /// Both `aside` and `look` change linearly with the pixel's place. In perspective `aside` is 0;
    /// in a parallel projection `look` is the same everywhere.
    std::array<double, 3> eye{};
    float look_depth = 1;
    std::array<float, 3> aside{}, aside_right{}, aside_down{};

    /// The settings of the shades that inspect a surface. These shades expect patches in
    /// `inspected`, and vertices with the parameters u and v in the first two numbers of normals. A
    /// part's material is the index of its patch.
    l3d_inspection inspection{};
    /// The exact patches, for shades that need them; borrowed until the frame's finish.
    const l3d_inspected_patches* inspected = nullptr;
    /// The program's function, for l3d_shade::own; borrowed until the frame's finish.
    const l3d_own_shade* own = nullptr;

    /// Triangles that have colours of their own; borrowed until the frame's finish. Parts refer to
    /// these triangles by numbers of materials.
    /// Expects: null for a mode that does not show light.
    const l3d_face_paints* paints = nullptr;

    /// Whether pixels of these materials need more than a grey level. They need more if the lights
    /// are not the usual lights, or if a material has highlights. In modes that do not show light,
    /// they never need more. If pixels need more, modes `gouraud` and `levels` are drawn as
    /// `lambert`.
    bool is_lit(std::span<const l3d_material> materials) const {
        return l3d_is_light(mode) &&
               !(lighting.is_usual() && std::ranges::all_of(materials, [](const l3d_material& m) {
                     return m.highlight == 0;
                 }));
    }

    /// The distance in x and y, in pixels, within which other pixels can change a pixel. With
    /// anti-aliasing, a jump of level towards a neighbour is found from this neighbour and the
    /// pixel behind it.
    int reach() const { return antialias ? 2 : 0; }

    friend bool operator==(const l3d_shading&, const l3d_shading&) = default;
};

/// The largest error of interpolated levels that frames report; polygons with a larger error are
/// counted in `unproven_levels`. Errors come from quads that are not parallelograms, and from
/// changes of w.
/// Units: levels of 255.
inline constexpr double l3d_most_level_error = 0.25;

/// The largest error of interpolated normals that lit frames report. An error is the length of the
/// difference from the exact normal. Polygons with a larger error are counted in `unproven_levels`.
inline constexpr double l3d_most_normal_error = 1.0 / 256;

/// Counts of the work of one frame, for reports and tests.
struct L3D_PUBLIC l3d_surface_counts {
    std::int64_t quads = 0; ///< micro-quads and triangles that were handed to draw()
    /// Pixel centres tested against the depth buffer. Blocks that are found hidden as a whole are
    /// not tested. So the number depends on how the work was divided, but not on the number of
    /// threads.
    std::int64_t samples = 0;
    /// Tested pixels whose surface was nearer than the depth in the buffer.
    std::int64_t written = 0;
    /// Pixels that show a surface; none_counted if count_pixels(false) was called.
    std::int64_t covered = 0;

    /// The value of `covered` if pixels were not counted.
    static constexpr std::int64_t none_counted = -1;

    /// Polygons whose light is computed as a plane, not by a unit normal in each pixel. Each
    /// polygon counts as often as it was set up.
    std::int64_t by_plane = 0;

    std::int64_t refined = 0; ///< pixels at edges, whose light is a mean over their squares

    /// Adds the counts that another part of the same picture has.
    void add(const l3d_surface_counts& other) {
        quads += other.quads;
        samples += other.samples;
        written += other.written;
        covered = other.covered == none_counted ? none_counted : covered + other.covered;
        by_plane += other.by_plane;
        refined += other.refined;
        level_error = std::max(level_error, other.level_error);
        normal_error = std::max(normal_error, other.normal_error);
        unproven_levels += other.unproven_levels;
        unsolved += other.unsolved;
    }

    /// The largest error of levels in mode `levels`, compared with the levels that the corners'
    /// levels and bends give for the same parameters.
    /// Units: levels; at most l3d_most_level_error.
    double level_error = 0;
    /// The largest error of normals in lit frames, compared with the normals that the corners'
    /// normals give for the same parameters. The error is at most l3d_most_normal_error. This
    /// number leaves out a quarter of the corners' deviation from one plane.
    double normal_error = 0;
    /// Tested pixels whose exact place on their patch was not found, in shades that inspect a
    /// surface. Such pixels show values interpolated between the drawn vertices.
    std::int64_t unsolved = 0;
    /// Polygons whose errors exceed l3d_most_level_error or l3d_most_normal_error, counted at each
    /// set-up.
    std::int64_t unproven_levels = 0;
};

/// A rectangle of the picture. Units: 1/256 pixel from the picture's top left corner, ends
/// included.
struct L3D_PUBLIC l3d_subpixel_box {
    /// The first and the last column and row. All four are inside of the rectangle.
    std::int32_t left = 0, top = 0, right = 0, bottom = 0;
};

/// Fills surfaces into a picture and a depth buffer of the same size.
///
/// A pixel belongs to a polygon if its centre (x + 1/2, y + 1/2) is inside, or on a left or top
/// edge. Vertices are integers in 1/256 pixel, and the rule is evaluated exactly. So polygons that
/// share an edge cover each pixel once: no gap, no double hit. Surfaces are two-sided: normals are
/// turned to the eye. The nearer sample, with larger inv_w, is seen. Among samples of equal inv_w,
/// the choice is always the same.
class L3D_PUBLIC l3d_surface_rasterizer {
public:
    l3d_surface_rasterizer() = default;
    l3d_surface_rasterizer(const l3d_surface_rasterizer&) = delete;
    l3d_surface_rasterizer& operator=(const l3d_surface_rasterizer&) = delete;
    virtual ~l3d_surface_rasterizer() = default;

    /// Describes in one line, for reports, the library that fills, such as GL; empty if l3d itself
    /// fills.
    std::string describe() const { return do_describe(); }

    /// Whether this rasterizer draws mode l3d_shade::levels.
    bool takes_levels() const { return do_takes_levels(); }

    /// Whether this rasterizer obeys l3d_shading::antialias.
    bool antialiases() const { return do_antialiases(); }

    /// Whether this rasterizer draws the shades that inspect a surface.
    bool inspects() const { return do_inspects(); }

    /// Starts a frame: the picture shows the background, and depth is 0. Each rasterizer decides
    /// when it writes background and depth to memory, at finish at the latest.
    ///
    /// A null depth buffer is the fastest: depth is not kept, and a single call of draw makes the
    /// whole frame. A picture that is `untouched` since the last finish need not be cleared where
    /// it is empty.
    /// Expects: target and depth of equal size; both outlive the frame. `untouched` is true only if
    ///          the target is another one, or nobody else wrote to its words since the last finish.
    void begin(l3d_pixels target, l3d_depth_buffer* depth, const l3d_shading& shading,
               bool untouched = false) {
        begin_frame(shading);
        do_begin(target, depth, shading, untouched);
    }

    /// Sets the materials of frames that are begun later. Parts name a material by its index in
    /// `materials`. At first, and if there are no materials, all surfaces are white. Shades that do
    /// not show light ignore materials.
    /// Expects: at most most_materials, including those that the shading's paints name; parts name
    ///          none beyond the last.
    /// Lives:   until the frame's finish; the next frame needs the call again.
    void use_materials(std::span<const l3d_material> materials) { materials_ = materials; }

    /// The most materials that a frame may have: a material's number shares a pixel word with a
    /// level of 8 bits.
    static constexpr std::size_t most_materials = std::size_t{1} << 24;

    /// Sets whether frames that are begun later count covered pixels; at first they do. Counting
    /// takes some 2 % of a frame. With GL, `samples` and `written` are counted only if wanted, too,
    /// as each of these two counts needs everything drawn once more.
    void count_pixels(bool wanted) { counting_wanted_ = wanted; }

    /// Sets whether frames that are begun later leave a depth everywhere, 0 where nothing is drawn;
    /// at first they do. If not wanted, depth has no meaning after the frame.
    void leave_depth(bool wanted) { depth_wanted_ = wanted; }

    /// Whether begin_part may be called. A rasterizer does not allow it if it keeps the picture
    /// outside of memory, as with GL, and copies the whole picture.
    bool draws_parts() const { return do_draws_parts(); }

    /// Starts a frame that draws a part of a picture again and leaves the rest as it is.
    ///
    /// The part's pixels are the same bits as if the frame were drawn whole. Polygons that touch no
    /// pixel of the part need not be handed in. Counts cover only the part, or things near it.
    /// Expects: as begin; draws_parts(); the part is not empty and lies in the picture. Depth has
    ///          no meaning after the frame.
    void begin_part(l3d_pixels target, l3d_depth_buffer* depth, const l3d_shading& shading,
                    const l3d_pixel_box& part) {
        begin_frame(shading);
        do_begin_part(target, depth, shading, part);
    }

    /// Fills the quads and triangles of the parts. A convex quad is one polygon, a folded quad is
    /// four triangles around its projective centre. Drawing is fastest if the nearest parts come
    /// first.
    /// Expects: called once a frame if there is no depth buffer.
    /// Lives:   with anti-aliasing, borrows the parts until finish.
    void draw(std::span<const l3d_surface_part* const> parts) { do_draw(parts); }

    /// Whether earlier calls of draw in this frame hide everything in a box that is no nearer than
    /// `nearest_inv_w`. False when in doubt.
    ///
    /// Cost:    some nanoseconds for each 16 x 8 pixels of the box. Any number of threads may call
    ///          hidden() while no thread draws.
    bool hidden(const l3d_subpixel_box& box, float nearest_inv_w) const {
        return do_hidden(box, nearest_inv_w);
    }

    /// Completes the frame: afterwards, the target's pixels and the depth buffer hold everything
    /// drawn. Call finish() before anybody else reads or writes the pixels or depths.
    void finish() { do_finish(); }

    /// Counts of the drawing between begin and the last finish.
    const l3d_surface_counts& counts() const { return do_counts(); }

protected:
    /// Whether the frame that was begun last counts pixels.
    bool counts_pixels() const { return counts_pixels_; }

    /// Whether the frame that was begun last leaves a depth everywhere.
    bool leaves_depth() const { return leaves_depth_; }

    /// The materials of the frame that was begun last; none if its mode shows no light.
    std::span<const l3d_material> materials() const { return materials_of_frame_; }

    /// Takes the settings of the next frame, as the first step of each kind of begin.
    void begin_frame(const l3d_shading& shading) {
        counts_pixels_ = counting_wanted_;
        leaves_depth_ = depth_wanted_;
        materials_of_frame_ =
            l3d_is_light(shading.mode) ? materials_ : std::span<const l3d_material>();
        materials_ = {};
    }

private:
    virtual void do_begin(l3d_pixels, l3d_depth_buffer*, const l3d_shading&, bool untouched) = 0;
    virtual std::string do_describe() const { return {}; }
    virtual bool do_takes_levels() const { return false; }
    virtual bool do_draws_parts() const { return false; }
    virtual bool do_antialiases() const { return false; }
    virtual bool do_inspects() const { return false; }
    virtual void do_begin_part(l3d_pixels, l3d_depth_buffer*, const l3d_shading&,
                               const l3d_pixel_box&) {}
    virtual void do_draw(std::span<const l3d_surface_part* const>) = 0;
    virtual bool do_hidden(const l3d_subpixel_box&, float) const { return false; }
    virtual void do_finish() = 0;
    virtual const l3d_surface_counts& do_counts() const = 0;

    bool counting_wanted_ = true, counts_pixels_ = true;
    bool depth_wanted_ = true, leaves_depth_ = true;
    std::span<const l3d_material> materials_, materials_of_frame_;
};

#endif
