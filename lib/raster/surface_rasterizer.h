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

/// How the surfaces of a frame get their colours.
struct L3D_PUBLIC l3d_shading {
    l3d_shade mode = l3d_shade::lambert; ///< how the colour of a pixel is found
    std::array<float, 3> light{0, 0, 1}; ///< unit vector towards the light, world space

    /// From the eye through the picture's top left corner, and what a pixel to the right and one
    /// down add to that. World space, any length. All zero if normals are turned to the eye
    /// already.
    std::array<float, 3> ray{0, 0, -1}, ray_right{}, ray_down{};

    bool keep_unit_normals = false; ///< lambert: one in each pixel, even where less would do

    /// Pixels at edges show the mean, over their squares, of the light of all that is seen there.
    /// Light is linear: levels are decoded by the sRGB curve, and the mean is encoded again. A
    /// rasterizer that cannot do it draws as without (l3d_surface_rasterizer::antialiases).
    bool antialias = false;

    /// The picture's colours where no surface covers a pixel, or a part of it.
    l3d_background background{};

    /// The colour that far surfaces fade into. A rasterizer that inspects has fog, others draw
    /// without.
    l3d_fog fog{};

    /// Depths are 1 / distance where `depth_step` is 0, and depth_base + depth_step distance in a
    /// parallel projection. Units: distances along the view axis.
    double depth_base = 0, depth_step = 0;

    /// The distance along the view axis that a depth stands for. Expects: a depth > 0.
    float distance(float depth) const {
        return depth_step == 0 ? 1 / depth
                               : static_cast<float>((double{depth} - depth_base) / depth_step);
    }

    /// A pixel word as it looks behind the fog, whose colour in the pixel's row is given.
    /// Expects: fog that is on; a depth > 0.
    std::uint32_t fogged(std::uint32_t word, l3d_color fog_color, float depth) const {
        return l3d_fog::word(word, fog_color, fog.amount(distance(depth)));
    }

    l3d_lighting lighting{}; ///< colours of lights, and lights beside `light`

    /// From the eye to a place, as `ray` has it, whether or not normals are turned to the eye.
    std::array<float, 3> look{0, 0, -1}, look_right{}, look_down{};

    /// The place that a pixel shows is eye + aside + distance / look_depth look, where `aside`
    /// grows with the pixel's place as `look` does. It is 0 in perspective; in a parallel
    /// projection `look` is the same everywhere. World space.
    std::array<double, 3> eye{};
    float look_depth = 1;
    std::array<float, 3> aside{}, aside_right{}, aside_down{};

    /// The quantity that inspecting shades show, and its settings. Such shades expect patches,
    /// vertices with their parameters u and v in place of the first two numbers of normals, and
    /// parts whose material is the index of their patch.
    l3d_inspection inspection{};
    const l3d_inspected_patches* inspected = nullptr; ///< borrowed until the frame's finish
    const l3d_own_shade* own = nullptr; ///< function of l3d_shade::own; borrowed likewise

    /// Triangles that have colours of their own; borrowed until the frame's finish. Parts name them
    /// as materials. Expects: null for a mode that is not light.
    const l3d_face_paints* paints = nullptr;

    /// Whether surfaces of these materials take more than one level in each pixel: unless the
    /// lights are the usual ones and nothing has highlights. Modes that are not light never do.
    /// Gouraud and levels then are as lambert.
    bool is_lit(std::span<const l3d_material> materials) const {
        return l3d_is_light(mode) &&
               !(lighting.is_usual() && std::ranges::all_of(materials, [](const l3d_material& m) {
                     return m.highlight == 0;
                 }));
    }

    /// A pixel depends on what is drawn in pixels so near in x and y. A jump of level to one beside
    /// it is told by that one and the next.
    int reach() const { return antialias ? 2 : 0; }

    friend bool operator==(const l3d_shading&, const l3d_shading&) = default;
};

/// The error of levels that quads other than parallelograms, and the change of w in them, may add
/// in polygons of which anything is said. Units: levels of 255.
inline constexpr double l3d_most_level_error = 0.25;

/// The same of normals that are interpolated over polygons in lit frames: their length.
inline constexpr double l3d_most_normal_error = 1.0 / 256;

/// Counts of the work of one frame.
struct L3D_PUBLIC l3d_surface_counts {
    std::int64_t quads = 0; ///< micro-quads and triangles handed in
    /// Pixel centres tested against the depth buffer. How many are not, because a whole block is
    /// seen to be hidden, depends on how the work was divided, but not among how many threads.
    std::int64_t samples = 0;
    std::int64_t written = 0; ///< tested pixels that were nearer than the depth there
    std::int64_t covered = 0; ///< pixels that show something; none_counted if nobody asked

    static constexpr std::int64_t none_counted = -1; ///< the value of `covered` if nobody asked

    /// Polygons, each as often as it was set up, whose light is a plane instead of that of a unit
    /// normal in each pixel.
    std::int64_t by_plane = 0;

    std::int64_t refined = 0; ///< pixels at edges, whose light is a mean over their squares

    /// Adds the counts of other parts of the picture.
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

    /// Mode `levels`: how far a level may be from the one that the corners' levels and bends give
    /// for the same parameters. Units: levels; at most l3d_most_level_error.
    double level_error = 0;
    /// Lit frames: how far a normal may be from the one that the corners' normals give for the same
    /// parameters, but for a quarter of what they are off one plane. At most l3d_most_normal_error.
    double normal_error = 0;
    /// Shades that inspect a surface: tested pixels whose exact place on their patch was not found.
    /// They show what is at the place between the drawn vertices.
    std::int64_t unsolved = 0;
    std::int64_t unproven_levels =
        0; ///< polygons where it may be more, as often as they are set up
};

/// A rectangle of the picture. Units: 1/256 pixel from its top left corner, ends included.
struct L3D_PUBLIC l3d_subpixel_box {
    /// The first and the last column and row.
    std::int32_t left = 0, top = 0, right = 0, bottom = 0;
};

/// Fills surfaces into a picture and a depth buffer of the same size.
///
/// A pixel belongs to a polygon if its centre (x + 1/2, y + 1/2) is inside, or on a left or top
/// edge. Vertices are exact 1/256 pixel integers, and the rule is evaluated exactly. So polygons
/// that share an edge cover each pixel once: no gap, no double hit. Surfaces are two-sided: normals
/// are turned to the eye. The nearer (larger inv_w) sample wins; of equals, one of them, always the
/// same.
class L3D_PUBLIC l3d_surface_rasterizer {
public:
    l3d_surface_rasterizer() = default;
    l3d_surface_rasterizer(const l3d_surface_rasterizer&) = delete;
    l3d_surface_rasterizer& operator=(const l3d_surface_rasterizer&) = delete;
    virtual ~l3d_surface_rasterizer() = default;

    /// One line on what fills, for reports; empty if that is the processors.
    std::string describe() const { return do_describe(); }

    /// Whether mode `levels` may be asked for.
    bool takes_levels() const { return do_takes_levels(); }

    /// Whether it obeys l3d_shading::antialias.
    bool antialiases() const { return do_antialiases(); }

    /// Whether it draws the shades that inspect a surface.
    bool inspects() const { return do_inspects(); }

    /// Starts a frame: from now on, the picture shows the background, and depth is 0. Each
    /// rasterizer decides when it sets their memory, at finish at the latest.
    ///
    /// Without a depth buffer nobody wants depth afterwards, and one call of draw makes the whole
    /// frame; that is the fastest. In a picture that is `untouched` since the last finish, empty
    /// parts need not be set again.
    /// Expects: target and depth of equal size; both outlive the frame. `untouched` only if nobody
    ///          else wrote to the target's words since then, should it be the same target.
    void begin(l3d_pixels target, l3d_depth_buffer* depth, const l3d_shading& shading,
               bool untouched = false) {
        begin_frame(shading);
        do_begin(target, depth, shading, untouched);
    }

    /// The materials that parts name by their place here, in frames that are begun from now on; at
    /// first and if there are none, all surfaces are white. Shades that are not light have no use
    /// for them.
    /// Expects: at most most_materials, with those that the shading's paints name; parts name none
    ///          beyond the last.
    /// Lives:   until the frame's finish; the next frame needs the call again.
    void use_materials(std::span<const l3d_material> materials) { materials_ = materials; }

    /// The most materials that a frame may have: their numbers share a word with levels.
    static constexpr std::size_t most_materials = std::size_t{1} << 24;

    /// Whether frames that are begun from now on count covered pixels; at first they do. That takes
    /// some 2 % of a frame. With GL, `samples` and `written` are counted only then, too, for each
    /// is drawing all once more.
    void count_pixels(bool wanted) { counting_wanted_ = wanted; }

    /// Whether begin_part may be called: not where a picture is kept elsewhere and comes whole.
    bool draws_parts() const { return do_draws_parts(); }

    /// Starts a frame that draws a part of a picture again: what is outside of it stays as it is.
    ///
    /// Inside, the pixels are the same bits as if the frame were drawn whole. Polygons that touch
    /// no pixel of the part need not be handed in. The counts are of the part, or of things near
    /// it.
    /// Expects: as begin; draws_parts(); the part is not empty and lies in the picture. Depth has
    ///          no meaning after the frame.
    void begin_part(l3d_pixels target, l3d_depth_buffer* depth, const l3d_shading& shading,
                    const l3d_pixel_box& part) {
        begin_frame(shading);
        do_begin_part(target, depth, shading, part);
    }

    /// Fills the quads and triangles of the parts. Convex quads are covered as such, folded ones
    /// as four triangles around their projective centre. It is fastest if the first parts are
    /// mostly the nearest.
    /// Expects: called once a frame if there is no depth buffer.
    /// Lives:   with anti-aliasing, parts until finish.
    void draw(std::span<const l3d_surface_part* const> parts) { do_draw(parts); }

    /// Whether all that is in a box and no nearer than `nearest_inv_w` would change no pixel,
    /// because of what earlier calls of draw drew in this frame. False when in doubt.
    ///
    /// Cost:    some nanoseconds for each 16 x 8 pixels of the box. Any number of threads may ask
    ///          while none draws.
    bool hidden(const l3d_subpixel_box& box, float nearest_inv_w) const {
        return do_hidden(box, nearest_inv_w);
    }

    /// Afterwards, the target's pixels and depth hold everything drawn. Call it before anybody else
    /// reads or writes them; then the frame is over.
    void finish() { do_finish(); }

    /// Counts of the drawing between begin and the last finish.
    const l3d_surface_counts& counts() const { return do_counts(); }

protected:
    /// Whether the frame that was begun last counts pixels.
    bool counts_pixels() const { return counts_pixels_; }

    /// The materials of the frame that was begun last; none if its mode shows no light.
    std::span<const l3d_material> materials() const { return materials_of_frame_; }

    /// The first step of each kind of begin: takes the settings of the next frame.
    void begin_frame(const l3d_shading& shading) {
        counts_pixels_ = counting_wanted_;
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
    std::span<const l3d_material> materials_, materials_of_frame_;
};

#endif
