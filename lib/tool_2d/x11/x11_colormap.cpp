// SPDX-License-Identifier: MIT
// x11_colormap: searches for the largest palette by distances of colours, and finds, shares or
// writes its cells.
#include "tool_2d/x11/x11_colormap_p.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace l3d_detail {
namespace {

using channels = std::array<int, 3>;

channels channels_of(std::uint32_t word) {
    return {static_cast<int>(word >> 16 & 255), static_cast<int>(word >> 8 & 255),
            static_cast<int>(word & 255)};
}

// The cubes to look for in a map that nobody can change. 8x8x4 is the cube of maps whose eight bits
// are divided as if by masks.
constexpr std::array<palette_shape, 8> cubes{
    {{16, 16, 16}, {8, 8, 8}, {8, 8, 4}, {6, 6, 6}, {5, 5, 5}, {4, 4, 4}, {3, 3, 3}, {2, 2, 2}}};
constexpr std::array<palette_shape, 8> ramps{{{256, 1, 1},
                                              {128, 1, 1},
                                              {64, 1, 1},
                                              {32, 1, 1},
                                              {16, 1, 1},
                                              {8, 1, 1},
                                              {4, 1, 1},
                                              {2, 1, 1}}};

std::optional<l3d_palette> palette_of_shape(const palette_shape& shape,
                                            std::span<const std::uint32_t> cells) {
    std::vector<std::uint32_t> pixels;
    int deviation = 0;
    for (int place = 0; place < shape.size(); ++place) {
        const auto color = shape.color(place);
        const auto nearest = std::ranges::min_element(
            cells, {}, [&](std::uint32_t cell) { return shape.distance(cell, color); });
        if (nearest == cells.end() || !shape.is_near(*nearest, color))
            return std::nullopt;
        pixels.push_back(static_cast<std::uint32_t>(nearest - cells.begin()));
        deviation = std::max(deviation, channel_difference(*nearest, color));
    }
    return shape.palette(std::move(pixels), deviation);
}

// The fewest bits of a channel for which masks are used. A palette replaces masks of fewer bits.
constexpr int undithered_bits = 5;

// Levels wanted in a shared map, and the fewest that are better than a map of our own. A cube of
// 6x6x6 leaves 40 of 256 cells to others.
constexpr int shared_cube = 6, fewest_in_cube = 4;
constexpr int shared_ramp = 64, fewest_in_ramp = 16;

// X has channels of 16 bits where this library has 8: 65535 = 255 * 257.
constexpr unsigned x11_per_value = 257;

XColor x11_color_of(std::uint32_t word, unsigned long pixel = 0) {
    const auto channel = [&](int shift) {
        return static_cast<unsigned short>((word >> shift & 255) * x11_per_value);
    };
    return {pixel, channel(16), channel(8), channel(0), DoRed | DoGreen | DoBlue, 0};
}

std::uint32_t word_of(const XColor& color) {
    const auto value = [](unsigned channel) {
        return static_cast<int>((channel + x11_per_value / 2) / x11_per_value);
    };
    return l3d_rgb(value(color.red), value(color.green), value(color.blue));
}

bool is_gray(const x11_visual& visual) {
    return visual.layout.color_class == l3d_color_class::static_gray ||
           visual.layout.color_class == l3d_color_class::gray_scale;
}

/// The largest palette that fits into a map.
palette_shape largest_shape(const x11_visual& visual) {
    if (is_gray(visual))
        return palette_shape::ramp(std::min(visual.cells, 256));
    int levels = 2;
    while (palette_shape::cube(levels + 1).size() <= visual.cells)
        ++levels;
    return palette_shape::cube(levels);
}

std::vector<XColor> query_cells(Display* display, Colormap map, int count) {
    std::vector<XColor> cells(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < cells.size(); ++i)
        cells[i].pixel = i;
    XQueryColors(display, map, cells.data(), count);
    return cells;
}

/// Takes cells of a map that other programs use, too.
class cell_sharer {
public:
    cell_sharer(const x11_connection& connection, Colormap map, int cells)
        : connection_(connection), map_(map),
          found_(query_cells(connection.display(), map, cells)) {}

    /// The palette of a shape, in cells of exactly its colours.
    /// Errors:  returns nothing if a cell is missing, and frees all cells that it took.
    std::optional<l3d_palette> share_exactly(const palette_shape& shape) {
        return has_room_for(shape) ? share(shape, true) : std::nullopt;
    }

    /// The palette of a shape. If the map is full, the palette has other programs' cells of similar
    /// colours.
    /// Errors:  as share_exactly, if a colour has no similar cell.
    std::optional<l3d_palette> share_nearly(const palette_shape& shape) {
        return share(shape, false);
    }

    std::vector<unsigned long> take_allocated() { return std::exchange(allocated_, {}); }

private:
    bool has_room_for(const palette_shape& shape) const;
    std::optional<l3d_palette> share(const palette_shape& shape, bool exactly);
    bool allocate(XColor& color);
    bool allocate_nearest(const palette_shape& shape, std::uint32_t wanted, XColor& color);

    const x11_connection& connection_;
    Colormap map_;
    std::vector<XColor> found_; ///< the map's colours, without cells that turned out to be private
    std::vector<unsigned long> allocated_;
};

/// Whether the map has room for a shape. All missing cells are allocated at once and freed again,
/// in one round trip. Single allocations would take one round trip each.
bool cell_sharer::has_room_for(const palette_shape& shape) const {
    std::set<std::uint32_t> there;
    for (const auto& color : found_)
        there.insert(word_of(color));
    std::vector<unsigned long> room;
    for (int place = 0; place < shape.size(); ++place) {
        if (!there.contains(shape.color(place)))
            room.push_back(0);
    }
    const int count = static_cast<int>(room.size());
    if (count == 0)
        return true;
    if (XAllocColorCells(connection_.display(), map_, False, nullptr, 0, room.data(),
                         static_cast<unsigned>(count)) == 0)
        return false;
    XFreeColors(connection_.display(), map_, room.data(), count, 0);
    return true;
}

std::optional<l3d_palette> cell_sharer::share(const palette_shape& shape, bool exactly) {
    std::vector<std::uint32_t> pixels;
    int deviation = 0;
    bool is_full = false;
    for (int place = 0; place < shape.size(); ++place) {
        const auto wanted = shape.color(place);
        auto color = x11_color_of(wanted);
        is_full = is_full || !allocate(color);
        if (is_full && (exactly || !allocate_nearest(shape, wanted, color))) {
            XFreeColors(connection_.display(), map_, allocated_.data(),
                        static_cast<int>(allocated_.size()), 0);
            allocated_.clear();
            return std::nullopt;
        }
        pixels.push_back(static_cast<std::uint32_t>(color.pixel));
        deviation = std::max(deviation, channel_difference(word_of(color), wanted));
    }
    return shape.palette(std::move(pixels), deviation);
}

bool cell_sharer::allocate(XColor& color) {
    if (connection_.lost() || XAllocColor(connection_.display(), map_, &color) == 0)
        return false;
    allocated_.push_back(color.pixel);
    return true;
}

/// Asks for a cell of a near colour. The request names the exact colour of the nearest cell. The
/// request gets this cell unless the cell's owner may change the colour.
bool cell_sharer::allocate_nearest(const palette_shape& shape, std::uint32_t wanted,
                                   XColor& color) {
    while (!found_.empty()) {
        const auto nearest = std::ranges::min_element(found_, {}, [&](const XColor& other) {
            return shape.distance(word_of(other), wanted);
        });
        if (!shape.is_near(word_of(*nearest), wanted))
            return false;
        color = *nearest;
        if (allocate(color))
            return true;
        found_.erase(nearest);
    }
    return false;
}

/// The shapes to share, in order of preference.
std::vector<palette_shape> shared_shapes(const palette_shape& largest) {
    const bool ramp = largest.is_ramp();
    const int fewest = std::min(ramp ? fewest_in_ramp : fewest_in_cube, largest.red);
    std::vector<palette_shape> shapes;
    for (int levels = std::min(ramp ? shared_ramp : shared_cube, largest.red); levels >= fewest;
         levels = ramp ? levels / 2 : levels - 1)
        shapes.push_back(ramp ? palette_shape::ramp(levels) : palette_shape::cube(levels));
    return shapes;
}

} // namespace

std::uint32_t palette_shape::color(int place) const {
    const auto value = [](int level, int levels) { return l3d_palette::value_of(level, levels); };
    if (is_ramp())
        return static_cast<std::uint32_t>(value(place, red)) * 0x010101;
    return l3d_rgb(value(place / (green * blue), red), value(place / blue % green, green),
                   value(place % blue, blue));
}

int palette_shape::distance(std::uint32_t one, std::uint32_t other) const {
    const auto a = channels_of(one), b = channels_of(other);
    // A step between levels is 255 / (levels - 1). On a ramp, red stands for all channels.
    const channels steps{red - 1, green - 1, blue - 1};
    int worst = 0;
    for (std::size_t i = 0; i < steps.size(); ++i)
        worst = std::max(worst, 2 * std::abs(a[i] - b[i]) * steps[i]);
    return worst;
}

int channel_difference(std::uint32_t one, std::uint32_t other) {
    const auto a = channels_of(one), b = channels_of(other);
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

std::optional<l3d_palette> palette_of_cells(std::span<const std::uint32_t> cells, bool ramp) {
    for (const auto& shape : ramp ? ramps : cubes) {
        if (static_cast<std::size_t>(shape.size()) > cells.size())
            continue;
        if (auto palette = palette_of_shape(shape, cells))
            return palette;
    }
    return std::nullopt;
}

l3d_palette palette_of_masks(const l3d_screen_info& info) {
    const palette_shape shape{1 << info.red().width, 1 << info.green().width,
                              1 << info.blue().width};
    std::vector<std::uint32_t> pixels;
    for (int place = 0; place < shape.size(); ++place) {
        const auto level = [&](int distance, int levels, l3d_channel channel) {
            return static_cast<std::uint32_t>(place / distance % levels) << channel.shift;
        };
        pixels.push_back(level(shape.green * shape.blue, shape.red, info.red()) |
                         level(shape.blue, shape.green, info.green()) |
                         level(1, shape.blue, info.blue()));
    }
    return shape.palette(std::move(pixels), 0);
}

std::unique_ptr<x11_colormap> x11_colormap::make(const x11_connection& connection,
                                                 const x11_visual& visual, l3d_service& refusal) {
    std::unique_ptr<x11_colormap> map(new x11_colormap(connection, visual));
    switch (visual.layout.color_class) {
    case l3d_color_class::static_gray:
    case l3d_color_class::static_color:
        if (map->use_fixed_cells())
            break;
        refusal = {l3d_service::level::not_here,
                   "the display's colours are too few, and cannot be changed: " +
                       visual.layout.describe()};
        map.reset();
        break;
    case l3d_color_class::gray_scale:
    case l3d_color_class::pseudo_color:
        if (!map->share_cells())
            map->store_cells();
        break;
    case l3d_color_class::true_color:
        map->use_masks();
        break;
    case l3d_color_class::direct_color:
        map->store_ramps();
        map->use_masks();
        break;
    }
    if (connection.lost()) {
        refusal = {l3d_service::level::display_lost, x11_server_went_away};
        return nullptr;
    }
    return map;
}

x11_colormap::x11_colormap(const x11_connection& connection, const x11_visual& visual)
    : connection_(connection), visual_(visual),
      id_(DefaultColormap(connection.display(), connection.screen())) {
    const bool is_dynamic = visual.layout.color_class == l3d_color_class::direct_color ||
                            visual.layout.color_class == l3d_color_class::pseudo_color ||
                            visual.layout.color_class == l3d_color_class::gray_scale;
    if (!is_of_default_visual())
        own(is_dynamic ? AllocAll : AllocNone);
}

x11_colormap::~x11_colormap() {
    auto* display = connection_.display();
    if (connection_.lost())
        return;
    if (owned_)
        XFreeColormap(display, id_);
    else if (!allocated_.empty())
        XFreeColors(display, id_, allocated_.data(), static_cast<int>(allocated_.size()), 0);
}

bool x11_colormap::is_of_default_visual() const {
    return visual_.visual == DefaultVisual(connection_.display(), connection_.screen());
}

/// Makes a map of our own, which nobody else writes, unless there is one already.
void x11_colormap::own(int alloc) {
    if (std::exchange(owned_, true))
        return;
    id_ = XCreateColormap(connection_.display(), connection_.root(), visual_.visual, alloc);
}

void x11_colormap::use_masks() {
    info_ = l3d_screen_info(visual_.layout);
    const int fewest = std::min({info_.red().width, info_.green().width, info_.blue().width});
    if (fewest < undithered_bits)
        info_ = l3d_screen_info(visual_.layout, palette_of_masks(info_));
}

bool x11_colormap::use_fixed_cells() {
    std::vector<std::uint32_t> words;
    for (const auto& cell : query_cells(connection_.display(), id_, visual_.cells))
        words.push_back(word_of(cell));
    auto palette = palette_of_cells(words, is_gray(visual_));
    if (palette)
        info_ = l3d_screen_info(visual_.layout, std::move(*palette));
    return palette.has_value();
}

bool x11_colormap::share_cells() {
    if (owned_)
        return false;
    const auto shapes = shared_shapes(largest_shape(visual_));
    cell_sharer sharer(connection_, id_, visual_.cells);
    std::optional<l3d_palette> palette;
    for (std::size_t i = 0; i < shapes.size() && !palette; ++i)
        palette = sharer.share_exactly(shapes[i]);
    for (std::size_t i = 0; i < shapes.size() && !palette; ++i)
        palette = sharer.share_nearly(shapes[i]);
    if (!palette)
        return false;
    allocated_ = sharer.take_allocated();
    info_ = l3d_screen_info(visual_.layout, std::move(*palette));
    return true;
}

void x11_colormap::store_cells() {
    own(AllocAll);
    const auto shape = largest_shape(visual_);
    const auto left_over = static_cast<std::size_t>(visual_.cells - shape.size());
    std::vector<XColor> cells;
    if (is_of_default_visual() && left_over > 0) {
        cells = query_cells(connection_.display(),
                            DefaultColormap(connection_.display(), connection_.screen()),
                            visual_.cells);
        cells.resize(left_over);
    }
    std::vector<std::uint32_t> pixels;
    for (int place = 0; place < shape.size(); ++place) {
        pixels.push_back(static_cast<std::uint32_t>(left_over) + static_cast<std::uint32_t>(place));
        cells.push_back(x11_color_of(shape.color(place), pixels.back()));
    }
    XStoreColors(connection_.display(), id_, cells.data(), static_cast<int>(cells.size()));
    info_ = l3d_screen_info(visual_.layout, shape.palette(std::move(pixels), 0));
}

/// Fills the map with one ramp per channel: entry i of n has the part i / (n - 1) of full light.
void x11_colormap::store_ramps() {
    own(AllocAll);
    const l3d_screen_info masks(visual_.layout);
    const std::array channels{masks.red(), masks.green(), masks.blue()};
    const std::array<char, 3> flags{DoRed, DoGreen, DoBlue};
    std::vector<XColor> entries;
    for (std::size_t c = 0; c < channels.size(); ++c) {
        const unsigned long largest = (1UL << channels[c].width) - 1;
        for (unsigned long i = 0; i <= largest; ++i) {
            const auto value = static_cast<unsigned short>((i * 65535 + largest / 2) / largest);
            entries.push_back({i << channels[c].shift, value, value, value, flags[c], 0});
        }
    }
    XStoreColors(connection_.display(), id_, entries.data(), static_cast<int>(entries.size()));
}

} // namespace l3d_detail
