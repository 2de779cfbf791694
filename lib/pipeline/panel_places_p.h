// SPDX-License-Identifier: MIT
// panel_places: finds places for the panels of a picture, so that none covers another.
#ifndef L3D_PIPELINE_PANEL_PLACES_P_H
#define L3D_PIPELINE_PANEL_PLACES_P_H

#include "raster/rasterizer_2d.h"
#include "raster/text/panel.h"
#include "tool_2d/pixels.h"
#include "tool_2d/screen.h"

#include <vector>

namespace l3d_detail {

/// The style of a screen's panels. Letters have a size that suits the screen's picture, and the
/// ground is opaque if the screen is slow.
inline l3d_panel_style panel_style_of(l3d_screen& screen, const l3d_font& font) {
    l3d_panel_style style;
    style.font = font;
    style.size = l3d_panel_style::size_for(screen.pixels().size(), screen.text_scale());
    if (screen.is_slow())
        style.ground_coverage = l3d_panel_style::opaque;
    return style;
}

/// Finds places for panels, so that none covers another. It keeps a list of the largest rectangles
/// of the picture that are still free; these may overlap.
///
/// A panel goes into a free rectangle that holds the panel without further wrapping. If several
/// rectangles do, the panel goes where it stands nearest to its corner of the picture, first in x,
/// then in y. If no rectangle does, the panel's lines are wrapped to fit the largest rectangle in
/// which all text has room. If no rectangle has room for all text, the panel gets smaller letters
/// in the largest rectangle.
class panel_places {
public:
    panel_places(const l3d_pixel_box& picture, const l3d_panel_style& style)
        : style_(style), picture_(picture), free_{picture_} {}

    /// Keeps a place for a panel without drawing the panel. Returns whether the panel has room with
    /// letters of the style's size.
    bool take(const l3d_panel& panel, l3d_corner corner);

    /// Draws a panel in the place that is found for it, and keeps the place. Returns the box that
    /// the panel covers; the box is empty if no place was found.
    l3d_pixel_box draw(l3d_rasterizer_2d& rasterizer, const l3d_panel& panel, l3d_corner corner);

private:
    l3d_pixel_box place_for(const l3d_panel& panel, l3d_corner corner) const;
    void remove(const l3d_pixel_box& box);

    l3d_panel_style style_;
    l3d_pixel_box picture_;
    /// The largest free rectangles; no rectangle lies inside another.
    std::vector<l3d_pixel_box> free_;
};

} // namespace l3d_detail

#endif
