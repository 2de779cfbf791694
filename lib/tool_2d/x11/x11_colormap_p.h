// SPDX-License-Identifier: MIT
// x11_colormap: the map by which the pixels of a window's visual show our colours.
#ifndef L3D_TOOL_2D_X11_X11_COLORMAP_P_H
#define L3D_TOOL_2D_X11_X11_COLORMAP_P_H

#include "tool_2d/screen.h"
#include "tool_2d/x11/x11_connection_p.h"
#include "tool_2d/x11/x11_visual_p.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace l3d_detail {

/// The number of levels in each channel of a palette. A ramp has its grays in `red`; green and blue
/// are 1.
struct palette_shape {
    int red = 0;
    int green = 0;
    int blue = 0;

    static palette_shape cube(int levels) { return {levels, levels, levels}; }
    static palette_shape ramp(int levels) { return {levels, 1, 1}; }

    bool is_ramp() const { return green == 1; }
    int size() const { return red * green * blue; }

    /// The colour at an index of the palette, as a pixel word.
    std::uint32_t color(int place) const;

    /// Distance of two colours in their worst channel, in 510ths of a step of that channel.
    int distance(std::uint32_t one, std::uint32_t other) const;

    /// Whether two colours differ by no more than half a step in each channel. If all cells of a
    /// palette are so near to its colours, a dither still mixes colours from a level on each side.
    bool is_near(std::uint32_t one, std::uint32_t other) const {
        return distance(one, other) <= 255;
    }

    /// Makes a palette of this shape. Expects: size() pixels.
    l3d_palette palette(std::vector<std::uint32_t> pixels, int deviation) const {
        return {red, green, blue, std::move(pixels), deviation};
    }
};

/// The largest difference of two words in a channel, 0..255.
int channel_difference(std::uint32_t one, std::uint32_t other);

/// The largest palette for a map whose cells cannot be changed. Each of its colours is shown by the
/// nearest cell.
/// Shape:   `cells` has the colour of each cell, as a pixel word. `ramp` asks for grays only.
/// Errors:  nothing if the map lacks cells near black or white or, except for a ramp, near one of
///          the other six corners of the cube.
std::optional<l3d_palette> palette_of_cells(std::span<const std::uint32_t> cells, bool ramp);

/// The palette of all pixels that masks of few bits can make. This palette replaces the masks.
l3d_palette palette_of_masks(const l3d_screen_info& info);

/// A colormap, our cells in it, and the format of its pixels.
///
/// - TrueColor: nothing need be written. A palette replaces masks of fewer than five bits.
/// - DirectColor: a map of our own, with a straight ramp in each channel; then like TrueColor.
/// - StaticColor, StaticGray: the largest palette_of_cells.
/// - PseudoColor, GrayScale, if the visual is the screen's default: cells of the default map,
///   shared with programs that ask for the same colours. There are 6x6x6 colours, or 64 grays. If
///   there is no room, there are fewer levels, down to 4x4x4 or 16 grays. If even these have no
///   room, all numbers of levels are tried once more. Then cells of other programs serve, too, if
///   no channel is off by more than half a step.
/// - If sharing fails, or the visual is not the default: a map of our own with an exact palette. On
///   a display with one map in its hardware, other windows show wrong colours while ours has the
///   focus. So cells that are left over get the colours of the default map, which are those of
///   menus and borders.
class x11_colormap {
public:
    /// Makes the colormap for windows of this visual.
    /// Errors:  null, with `refusal` filled: a map that nobody can change has too few colours, or
    ///          the server went away.
    /// Lives:   the connection outlives the colormap.
    /// Cost:    with masks nothing, or one request; with static maps one round trip. A shared map
    ///          gives cells singly: a round trip for each, and four to read the map. With room,
    ///          there are at most 220 round trips: 5 ms locally, and 4 s on a line of 20 ms.
    ///          Without room, there are three times as many: 216 + 125 + 64 tries for the three
    ///          cubes, and one for each of 256 cells that turn out to be private.
    static std::unique_ptr<x11_colormap> make(const x11_connection& connection,
                                              const x11_visual& visual, l3d_service& refusal);

    x11_colormap(const x11_colormap&) = delete;
    x11_colormap& operator=(const x11_colormap&) = delete;
    ~x11_colormap();

    Colormap id() const { return id_; }
    const l3d_screen_info& info() const { return info_; }

    /// Whether this is the default map, which other programs use too.
    bool is_shared() const { return !owned_; }

    /// Installs a map of our own, as a window manager does for the window that has the focus.
    void install() const {
        if (owned_)
            XInstallColormap(connection_.display(), id_);
    }

private:
    x11_colormap(const x11_connection& connection, const x11_visual& visual);

    bool is_of_default_visual() const;
    void own(int alloc);
    void use_masks();
    bool use_fixed_cells();
    bool share_cells();
    void store_cells();
    void store_ramps();

    const x11_connection& connection_;
    x11_visual visual_;
    l3d_screen_info info_;
    Colormap id_;
    bool owned_ = false;
    std::vector<unsigned long> allocated_; ///< the cells of a shared map that we have taken
};

} // namespace l3d_detail

#endif
