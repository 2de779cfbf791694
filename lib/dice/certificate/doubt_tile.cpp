// SPDX-License-Identifier: MIT
// l3d_doubt_tile: halves cells and pieces together.
#include "dice/certificate/doubt_tile.h"

#include "raster/color/srgb_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace {

/// The finest cells are 2^-fineness pixels wide. The fineness is finest_contrast where cells may
/// show surfaces of different looks, and finest_surface where cells show one surface. Cells that
/// judge the drawing are at least 2^-3 pixel wide, and about twice as wide as the bound of places.
constexpr int finest_contrast = 4, finest_surface = 3, finest_drawing = 3;

/// A pixel whose level is known to within fine_levels is not cut any further. A cell is a small
/// part of its pixel. So the cell's own level may be less certain, in proportion to 1 / its width.
constexpr double fine_levels = 1;

/// Cutting cells of 2^-costly pixels or less is costly. So cells of this size are cut only if their
/// pixel's level is not known to within costly_levels.
constexpr int costly = 3;
constexpr double costly_levels = 4;

/// The limits up to which a piece is plain and is not halved: for its size, for the error of its
/// level, and for the error of its picture.
/// Units: pixels; levels in cells of a whole pixel; parts of a cell.
constexpr double largest_plain = 6, plain_levels = 0.3, plain_part = 1.0 / 16;

/// The largest number of leaves of a tile. If a tile needs more, nothing is known of its pixels.
constexpr std::size_t most_leaves = 100'000;

/// The least size of a piece, along u or v, as a part of its patch. Only pieces around the eye get
/// so small without becoming small in the picture.
constexpr double least_part = 0x1p-24;

/// The largest area whose light a tile may leave out. Where sRGB's curve is steepest, an area of 1
/// changes 12.92 * 255 levels. So this area changes at most a third of the allowance for rounding.
constexpr double most_left_out = 1e-8;

/// The area of a box that certainly holds a piece's picture. The box runs along the line from one
/// corner to the farthest control point. Points may err by `pad`. The picture lies in the convex
/// hull of the piece's control points.
double area_along(const l3d_image_patch& net, double pad) {
    const auto place = [](const l3d_image_point& p) {
        return std::array<double, 2>{p[0] / p[2], p[1] / p[2]};
    };
    const std::array<double, 2> from = place(net.points[0]);
    double length = 0, x = 0, y = 0;
    for (const l3d_image_point& p : net.points) {
        const auto [px, py] = place(p);
        if (const double far = std::hypot(px - from[0], py - from[1]); far > length) {
            length = far;
            x = (px - from[0]) / far;
            y = (py - from[1]) / far;
        }
    }
    double low = 0, high = 0;
    for (const l3d_image_point& p : net.points) {
        const auto [px, py] = place(p);
        const double aside = (py - from[1]) * x - (px - from[0]) * y;
        low = std::min(low, aside);
        high = std::max(high, aside);
    }
    return 2 * (length + pad) *
           (high - low + 2 * pad); // twice the length: points may lie on either side of the first
}

} // namespace

void l3d_doubt_tile::begin(const l3d_doubt_view& view, const l3d_pixel_box& tile) {
    view_ = &view;
    tile_ = tile;
    judges_drawing_ = std::isfinite(view.bound_px + view.depth_bound_px);
    finest_drawing_ = 0;
    while (finest_drawing_ < finest_drawing &&
           std::ldexp(1.0, -finest_drawing_) > 2 * view.bound_px)
        ++finest_drawing_;
    is_too_much_ = false;
    areas_left_out_ = 0;
    fineness_ = 0;
    pixels_.assign(static_cast<std::size_t>(tile.area()), {});
    leaves_.clear();
    std::vector<cell> cells;
    for (int row = 0; row < tile.bottom - tile.top; ++row)
        for (int column = 0; column < tile.right - tile.left; ++column)
            cells.push_back({.column = column, .row = row, .of_drawing = judges_drawing_});
    begin_cells(std::move(cells));
}

void l3d_doubt_tile::begin_cells(std::vector<cell>&& cells) {
    cells_ = std::move(cells);
    grown_ = 0;
    if (cells_.empty()) // the finer grid would be large
        return;
    const std::size_t across = static_cast<std::size_t>(side) << fineness_;
    grid_.assign(across * across, -1);
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const cell& c = cells_[i];
        grid_[static_cast<std::size_t>(c.row) * across + static_cast<std::size_t>(c.column)] =
            static_cast<std::int32_t>(i);
        if (c.of_drawing)
            grown_ = view_->bound_px;
    }
}

l3d_image_box l3d_doubt_tile::box_of(const cell& c) const {
    const double size = std::ldexp(1.0, -fineness_);
    const double left = tile_.left + c.column * size, top = tile_.top + c.row * size;
    return {left, top, left + size, top + size};
}

/// Calls visit(index) for each cell that, grown by grown_, meets a box, until `visit` returns
/// false.
template <class Visit>
void l3d_doubt_tile::for_cells(const l3d_image_box& box, const Visit& visit) const {
    const int across = side << fineness_;
    const auto place = [&](double at, int begin) {
        return static_cast<int>(
            std::clamp(std::floor(std::ldexp(at - begin, fineness_)), -1.0, double(across)));
    };
    const l3d_image_box reached = box.grown(grown_);
    const int left = std::max(0, place(reached.left, tile_.left)),
              right = std::min(across - 1, place(reached.right, tile_.left)),
              top = std::max(0, place(reached.top, tile_.top)),
              bottom = std::min(across - 1, place(reached.bottom, tile_.top));
    for (int row = top; row <= bottom; ++row)
        for (int column = left; column <= right; ++column)
            if (const std::int32_t i = grid_[static_cast<std::size_t>(row * across + column)];
                i >= 0 && !visit(static_cast<std::size_t>(i)))
                return;
}

bool l3d_doubt_tile::is_wanted(const l3d_image_box& box) const {
    bool is_any = false;
    for_cells(box, [&](std::size_t) {
        is_any = true;
        return false;
    });
    return is_any;
}

void l3d_doubt_tile::add(const l3d_doubt_piece& whole) {
    cut(whole, leaves_);
}

/// Whether halving a piece would not bound it better. A piece whose picture and light are nearly
/// linear need not be as small as a cell.
bool l3d_doubt_tile::is_plain(const l3d_doubt_bounds& b) const {
    const double of_cell = std::ldexp(1.0, -fineness_);
    const double size = std::max(b.box.width(), b.box.height());
    // A box is larger than its piece by twice the points' error, which halving leaves as it is.
    return size <= std::max(of_cell, 4 * b.point_off) ||
           (size <= largest_plain && b.facing != 0 && !b.may_end &&
            b.level.off <= std::ldexp(plain_levels, fineness_) &&
            b.picture_off <= std::max(plain_part * of_cell, 2 * b.point_off));
}

/// Whether a piece that reaches past the eye lies beside the tile. Most of the piece is far beside
/// the picture. The piece would be halved until its parts are as small as the near distance. The
/// tile is grown by the control points' error at the near plane, and by a pixel to spare.
bool l3d_doubt_tile::is_beside_all(const l3d_doubt_piece& piece, double near) const {
    const l3d_dice_view& view = view_->view;
    const l3d_image_box window = view.window(tile_).grown(grown_);
    const double off = (piece.of->error_xy + window.reach() * piece.of->error_w) / near;
    return l3d_outside(piece.net.points, window.grown(1 + off), near - piece.of->error_w, view.far);
}

/// Whether a piece is seen so nearly edge-on that its light may be left out. If so, the piece's
/// area is added to areas_left_out_.
bool l3d_doubt_tile::takes_no_area(const l3d_doubt_piece& piece) {
    const l3d_doubt_patch& of = *piece.of;
    const double least = piece.net.w().least;
    if (least <= 2 * of.error_w)
        return false;
    const double reach = piece.net.box().reach();
    const double area = area_along(
        piece.net, l3d_vertex_error(of.error_xy, of.error_w, reach, least) + 0x1p-48 * reach);
    if (!(areas_left_out_ + area <= most_left_out))
        return false;
    areas_left_out_ += area;
    return true;
}

/// Halves a piece until its bounds are good enough, and adds its parts to `into`. Leaves out parts
/// that reach no cell.
void l3d_doubt_tile::cut(const l3d_doubt_piece& piece, std::vector<l3d_doubt_leaf>& into) {
    const l3d_dice_view& view = view_->view;
    const double near = view.camera_near > 0 ? view.camera_near : view.near;
    const l3d_doubt_patch& of = *piece.of;
    const l3d_depth_range& w = piece.net.w();
    if (is_too_much_ || w.most + of.error_w <= near || w.least - of.error_w >= view.far)
        return;
    if (w.least <= 2 * of.error_w && is_beside_all(piece, near))
        return;
    bool along_u = piece.u1 - piece.u0 >= piece.v1 - piece.v0;
    bool may_be_plain = piece.u1 - piece.u0 < least_part || piece.v1 - piece.v0 < least_part;
    const bool is_smallest = may_be_plain;
    if (w.least > 2 * of.error_w) {
        const l3d_image_box& hull = piece.net.box();
        const double pad =
            1.0 / 64 + l3d_vertex_error(of.error_xy, of.error_w, hull.reach(), w.least);
        const double x = view.size.width / 2.0, y = view.size.height / 2.0;
        if (!is_wanted(
                l3d_image_box{hull.left + x, hull.top + y, hull.right + x, hull.bottom + y}.grown(
                    pad)))
            return;
        may_be_plain = may_be_plain || std::max(hull.width(), hull.height()) <= largest_plain;
        const auto [in_u, in_v] = l3d_image_gaps_of(piece.net);
        along_u = is_smallest || in_u >= in_v;
    }
    if (may_be_plain) {
        const l3d_doubt_bounds bounds = l3d_bounds_of(piece, *view_);
        const bool has_no_area = bounds.facing == 0 && takes_no_area(piece);
        if (is_smallest || has_no_area || is_plain(bounds)) {
            is_too_much_ = into.size() >= most_leaves;
            into.push_back({piece, bounds, has_no_area});
            return;
        }
    }
    ++cuts_;
    auto halves = l3d_halves(piece, along_u);
    if (piece.there == l3d_doubt_piece::left::part) {
        auto regions =
            along_u ? piece.trims.halves(0, halves[0].u1) : piece.trims.halves(1, halves[0].v1);
        for (std::size_t i = 0; i < halves.size(); ++i)
            halves[i].take(std::move(regions[i]));
    }
    for (const l3d_doubt_piece& half : halves)
        cut(half, into);
}

/// Lists for each cell the leaves that touch it, in their order.
void l3d_doubt_tile::sort_leaves() {
    first_.assign(cells_.size() + 1, 0);
    for (const l3d_doubt_leaf& leaf : leaves_)
        for_cells(leaf.bounds.box, [&](std::size_t i) {
            ++first_[i + 1];
            return true;
        });
    for (std::size_t i = 1; i < first_.size(); ++i)
        first_[i] += first_[i - 1];
    touching_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t k = 0; k < leaves_.size(); ++k)
        for_cells(leaves_[k].bounds.box, [&](std::size_t i) {
            touching_[next[i]++] = static_cast<std::uint32_t>(k);
            return true;
        });
}

l3d_doubt_pixel& l3d_doubt_tile::pixel_of(const cell& c) {
    return pixels_[static_cast<std::size_t>((c.row >> fineness_) * (tile_.right - tile_.left) +
                                            (c.column >> fineness_))];
}

/// Bounds the light in a cell, and adds the result to the cell's pixel. If smaller cells may tell
/// more, is_cut() takes the result back.
void l3d_doubt_tile::judge_cell(cell& c, std::span<const std::uint32_t> touching) {
    const l3d_image_box box = box_of(c);
    const double part = std::ldexp(1.0, -2 * fineness_);
    l3d_doubt_pixel& pixel = pixel_of(c);
    bool is_alone = false;
    if (c.of_drawing) {
        is_alone =
            judge_.is_drawn_alone(box.grown(view_->bound_px), touching, leaves_, view_->view);
        if (is_alone || fineness_ == finest_drawing_ || judge_.is_hopeless()) {
            pixel.unsure_drawn += is_alone ? 0 : part;
            c.of_drawing = false;
        } else {
            judge_.mark_seen(is_needed_);
        }
    }
    if (!c.of_light)
        return;
    const l3d_light_bounds background = view_->background_light(tile_.top + (c.row >> fineness_));
    const l3d_doubt_verdict v = is_alone
                                    ? judge_.judge_alone(box, background)
                                    : judge_.judge(box, touching, leaves_, view_->view, background);
    c.light = l3d_light_bounds::none();
    c.light.add(v.light, part);
    c.unsure = v.is_certain ? 0 : part;
    c.covered = v.is_covered ? part : 0;
    pixel.light.add(c.light);
    pixel.unsure += c.unsure;
    pixel.covered += c.covered;
    const int finest = v.is_certain ? finest_surface : finest_contrast;
    c.of_light = v.spread > std::ldexp(fine_levels, fineness_) && fineness_ < finest &&
                 !judge_.is_hopeless();
    if (c.of_light)
        judge_.mark_seen(is_needed_);
}

/// Whether smaller cells may tell more than a cell. If so, the cell's own result is subtracted from
/// its pixel.
bool l3d_doubt_tile::is_cut(cell& c) {
    l3d_doubt_pixel& pixel = pixel_of(c);
    c.of_light = c.of_light && pixel.is_open;
    if (c.of_light) {
        pixel.light.add(c.light, -1);
        pixel.unsure -= c.unsure;
        pixel.covered -= c.covered;
    }
    return c.of_light || c.of_drawing;
}

/// Judges all cells, and returns the quarters of the cells that are to be cut.
std::vector<l3d_doubt_tile::cell> l3d_doubt_tile::judge_cells() {
    for (std::size_t i = 0; i < cells_.size(); ++i)
        judge_cell(cells_[i], std::span(touching_).subspan(first_[i], first_[i + 1] - first_[i]));
    const double enough = fineness_ < costly ? fine_levels : costly_levels;
    for (const cell& c : cells_)
        if (c.of_light) {
            l3d_doubt_pixel& pixel = pixel_of(c);
            pixel.is_open = pixel.light.levels_apart() > enough;
        }
    std::vector<cell> quarters;
    for (cell& c : cells_)
        if (is_cut(c))
            for (const int row : {0, 1})
                for (const int column : {0, 1})
                    quarters.push_back({.column = 2 * c.column + column,
                                        .row = 2 * c.row + row,
                                        .of_light = c.of_light,
                                        .of_drawing = c.of_drawing});
    return quarters;
}

void l3d_doubt_tile::give_up() {
    std::fill(pixels_.begin(), pixels_.end(),
              l3d_doubt_pixel{l3d_light_bounds::any(), 1, 1, 0, false});
}

std::span<const l3d_doubt_pixel> l3d_doubt_tile::finish() {
    while (!cells_.empty() && !is_too_much_) {
        sort_leaves();
        is_needed_.assign(leaves_.size(), false);
        std::vector<cell> quarters = judge_cells();
        ++fineness_;
        begin_cells(std::move(quarters));
        if (cells_.empty())
            break;
        next_leaves_.clear();
        for (std::size_t k = 0; k < leaves_.size(); ++k)
            if (is_needed_[k] && (leaves_[k].has_no_area || is_plain(leaves_[k].bounds)))
                next_leaves_.push_back(leaves_[k]);
            else if (is_needed_[k])
                cut(leaves_[k].piece, next_leaves_);
        std::swap(leaves_, next_leaves_);
    }
    if (is_too_much_)
        give_up();
    return pixels_;
}
