// SPDX-License-Identifier: MIT
// x11_visual: lists, filters and ranks the screen's visuals.
#include "tool_2d/x11/x11_visual_p.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iomanip>
#include <memory>
#include <span>
#include <sstream>
#include <tuple>
#include <vector>

#include <X11/Xutil.h>

namespace l3d_detail {
namespace {

// X's numbers for the classes of visuals are those of l3d_color_class.
static_assert(StaticGray == int(l3d_color_class::static_gray) &&
              GrayScale == int(l3d_color_class::gray_scale) &&
              StaticColor == int(l3d_color_class::static_color) &&
              PseudoColor == int(l3d_color_class::pseudo_color) &&
              TrueColor == int(l3d_color_class::true_color) &&
              DirectColor == int(l3d_color_class::direct_color));

struct x11_freer {
    void operator()(void* memory) const { XFree(memory); }
};
template <class T> using x11_list = std::unique_ptr<T[], x11_freer>;

/// Sets how pixels of the layout's depth are stored.
void set_storage(Display* display, l3d_pixel_layout& layout) {
    int count = 0;
    const x11_list<XPixmapFormatValues> formats(XListPixmapFormats(display, &count));
    layout.bits_per_pixel = 0;
    layout.byte_order =
        ImageByteOrder(display) == LSBFirst ? std::endian::little : std::endian::big;
    for (int i = 0; i < count; ++i) {
        if (formats[static_cast<std::size_t>(i)].depth == layout.depth) {
            layout.bits_per_pixel = formats[static_cast<std::size_t>(i)].bits_per_pixel;
            layout.scanline_pad = formats[static_cast<std::size_t>(i)].scanline_pad;
        }
    }
}

x11_visual with_layout(Display* display, const XVisualInfo& info) {
    x11_visual visual;
    visual.visual = info.visual;
    visual.cells = info.colormap_size;
    visual.layout.color_class = static_cast<l3d_color_class>(info.c_class);
    visual.layout.depth = info.depth;
    visual.layout.red_mask = static_cast<std::uint32_t>(info.red_mask);
    visual.layout.green_mask = static_cast<std::uint32_t>(info.green_mask);
    visual.layout.blue_mask = static_cast<std::uint32_t>(info.blue_mask);
    set_storage(display, visual.layout);
    return visual;
}

std::array<std::uint32_t, 3> masks_of(const l3d_pixel_layout& layout) {
    return {layout.red_mask, layout.green_mask, layout.blue_mask};
}

bool has_masks(const x11_visual& visual) {
    return visual.layout.color_class == l3d_color_class::true_color ||
           visual.layout.color_class == l3d_color_class::direct_color;
}

bool is_usable(const x11_visual& visual) {
    const auto& layout = visual.layout;
    if (layout.bits_per_pixel < 8 || layout.bits_per_pixel % 8 != 0)
        return false;
    // Maps of more than twelve bits are left out, as a cube of 16x16x16 needs no more.
    if (!has_masks(visual))
        return layout.bits_per_pixel <= 16 && visual.cells >= 16 && visual.cells <= 4096;
    // Masks are one run of at most 16 ones. Such a mask, shifted down and increased by one, is a
    // power of two.
    return layout.bits_per_pixel <= 32 &&
           std::ranges::all_of(masks_of(layout), [](std::uint32_t mask) {
               const auto run = mask == 0 ? 0 : mask >> std::countr_zero(mask);
               return run != 0 && run <= 0xFFFF && std::has_single_bit(run + 1);
           });
}

/// The bits of the poorest channel, at most eight.
int fewest_bits(const x11_visual& visual) {
    if (visual.layout.color_class == l3d_color_class::static_gray ||
        visual.layout.color_class == l3d_color_class::gray_scale)
        return 0;
    if (!has_masks(visual))
        return (std::bit_width(static_cast<unsigned>(visual.cells)) - 1) / 3;
    int fewest = 8;
    for (const auto mask : masks_of(visual.layout))
        fewest = std::min(fewest, std::popcount(mask));
    return fewest;
}

/// Whether channels have enough bits for shading to look smooth.
bool is_good(const x11_visual& visual) {
    return has_masks(visual) && fewest_bits(visual) >= 5;
}

/// Whether pixels have more bits than colours need: the further bits are alpha. Windows with alpha
/// are drawn in memory of their own, and then converted to the default visual.
bool has_alpha(const x11_visual& visual) {
    const auto& layout = visual.layout;
    return layout.depth == 32 && ~(layout.red_mask | layout.green_mask | layout.blue_mask) != 0;
}

auto rank(const x11_visual& visual) {
    return std::tuple(!has_alpha(visual), fewest_bits(visual),
                      visual.layout.color_class == l3d_color_class::true_color,
                      visual.layout.depth);
}

std::string refusal(const x11_visual& visual) {
    return "no usable visual on this display; its default is " + visual.layout.describe() +
           "; TrueColor or DirectColor of 8, 16, 24 or 32 bits per pixel would do, or a colormap "
           "of 16 to 4096 cells with 8 or 16";
}

} // namespace

std::vector<x11_visual> offered_x11_visuals(const x11_connection& connection) {
    XVisualInfo wanted{};
    wanted.screen = connection.screen();
    int count = 0;
    const x11_list<XVisualInfo> list(
        XGetVisualInfo(connection.display(), VisualScreenMask, &wanted, &count));
    std::vector<x11_visual> offered;
    for (const auto& info : std::span(list.get(), static_cast<std::size_t>(count)))
        offered.push_back(with_layout(connection.display(), info));
    return offered;
}

std::optional<x11_visual> choose_x11_visual(std::span<const x11_visual> offered,
                                            const Visual* preferred, std::string& why) {
    std::optional<x11_visual> best, usual;
    for (const auto& candidate : offered) {
        const bool is_preferred = candidate.visual == preferred;
        if (is_usable(candidate)) {
            if (is_preferred)
                usual = candidate;
            if (!best || rank(candidate) > rank(*best))
                best = candidate;
        } else if (is_preferred) {
            why = refusal(candidate);
        }
    }
    return usual && (is_good(*usual) || !is_good(*best)) ? usual : best;
}

std::optional<x11_visual> choose_x11_visual(const x11_connection& connection, std::string& why) {
    return choose_x11_visual(offered_x11_visuals(connection),
                             DefaultVisual(connection.display(), connection.screen()), why);
}

} // namespace l3d_detail
