// SPDX-License-Identifier: MIT
// l3d_outline_search: halves pieces, bounds them, and marks nearly straight outlines.
#include "dice/outlines/outline_search.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <tuple>

namespace {

using vector = l3d_vector<double, 3>;
using place = l3d_picture_place;

/// The smallest size of a piece that is tested for being hidden. Around smaller pieces, the surface
/// at an outline cannot be told apart from a surface that hides the outline.
/// Units: pixels.
constexpr double least_asked = 8;

/// The largest size of a piece whose sides and folds are marked as lines, and the greatest length
/// of such a line.
/// Units: pixels.
constexpr double longest_line = 16;

/// The largest number of halvings of a patch, down to 2^-20 of it along both directions. Pieces
/// that would have to be halved more often are marked as boxes.
constexpr int most_levels = 40;

/// The largest number of pieces in a frame. If there are more, each further piece is marked as a
/// box.
constexpr std::int64_t most_pieces = std::int64_t{1} << 21;

/// Bounds the relative rounding of normals, which are sums of 36 products of differences of
/// coordinates.
constexpr double rounding = 256 * 0x1p-53;

double mean(double a, double b) {
    return (a + b) / 2;
}

/// Bounds the distance of a piece's or a curve's picture from a linear function with value X. The
/// distance is the sum B_i (x_i - X w_i) over w. With d_i = x_i - X_i w_i, and since sum B_i X_i =
/// X, the sum equals sum B_i d_i + sum B_i (X_i - X) (w_i - w_mean).
struct linear_error {
    double most = 0, least_w = 0, most_w = 0;

    void add(const l3d_image_point& p, const place& linear) {
        most = std::max(most, std::hypot(p[0] - linear.x * p[2], p[1] - linear.y * p[2]));
    }
    double bound(double widest) const { return (most + widest * (most_w - least_w) / 2) / least_w; }
};

place projected(const l3d_image_point& p) {
    return {p[0] / p[2], p[1] / p[2]};
}

place mix(const place& a, const place& b, double t) {
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

double distance(const place& a, const place& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// The range of pixels, among `count` in a row, whose centres are in [low, high]. Units: pixels.
struct pixel_range {
    int first, end;

    pixel_range(double low, double high, int count)
        : first(static_cast<int>(std::clamp(std::ceil(low - 0.5), 0.0, double(count)))),
          end(static_cast<int>(std::clamp(std::floor(high - 0.5) + 1, 0.0, double(count)))) {}
};

} // namespace

l3d_outline_search::l3d_outline_search(const l3d_dice_view& view, const l3d_outline_reach& reach,
                                       const l3d_two_layer_depths& depths, l3d_pixel_bits& mask)
    : whole_(view), view_(view), reach_(reach), allowed_(std::max(reach.places / 8, 1.0 / 64)),
      depths_(depths), mask_(mask) {}

/// Sets the errors and near planes for a patch whose points have this share of the view's errors.
/// No near plane is farther than these errors push it.
void l3d_outline_search::take_share(double share) {
    view_.take_share(whole_, share);
    radius_ = reach_.places + view_.error_xy / std::max(view_.near, 1e-300);
    fold_radius_ = radius_ + reach_.depth / 2;
    least_near_ = view_.camera_near > 0 ? std::min(view_.camera_near, view_.near) : view_.near;
    most_near_ = std::max(std::min(reach_.farthest_near, view_.near), least_near_);
    window_ = view_.window().grown(fold_radius_ + 1);
}

void l3d_outline_search::add(const l3d_bezier_patch<double, 3>& patch,
                             const l3d_normal_net& normals, const vector& eye,
                             const l3d_image_patch& net, unsigned sides, double share) {
    take_share(share);
    piece whole{};
    for (std::size_t i = 0; i < whole.patch.points.size(); ++i)
        whole.patch.points[i] = patch.points[i] - eye;
    whole.net = net;
    whole.normals = normals.polynomial();
    whole.sides = sides;
    search(whole);
}

/// Finds the Bernstein coefficients of n.(S - E) over the piece, for normals n at points S and the
/// eye E. With the middle C of the points, the product is n.(C - E) + n.(S - C). Along the normals'
/// common axis, S - C is nearly nothing.
l3d_outline_search::level_set<l3d_outline_search::order>
l3d_outline_search::facing_of(const piece& p) const {
    vector axis(0.0);
    for (const vector& n : p.normals.points)
        axis = axis + n;
    const double length = l3d_length(axis);
    axis = length > 0 ? axis * (1 / length) : vector(0.0);
    const auto [low, high] = p.patch.bounds();
    const vector middle = (low + high) * 0.5;
    double along = 0, reach = 0;
    for (const vector& s : p.patch.points) {
        along = std::max(along, std::abs(l3d_dot(axis, s - middle)));
        reach = std::max(reach, l3d_length(s - middle));
    }
    level_set<order> result;
    double largest = 0;
    for (std::size_t i = 0; i < result.at.size(); ++i) {
        const vector& n = p.normals.points[i];
        const double by_axis = l3d_dot(n, axis);
        result.at[i] = l3d_dot(n, middle);
        result.error = std::max(result.error,
                                std::abs(by_axis) * along + l3d_length(n - axis * by_axis) * reach);
        largest = std::max(largest, l3d_length(n));
    }
    result.error += rounding * largest * (l3d_length(middle) + reach);
    return result;
}

void l3d_outline_search::search(const piece& p) {
    ++pieces_;
    if (l3d_outside(p.net.points, window_, least_near_, view_.far))
        return;
    const l3d_depth_range& w = p.net.w();
    const bool is_cut = w.least < most_near_ || w.most > view_.far;
    piece next = p;
    level_set<order> facing;
    if (next.may_fold) {
        facing = facing_of(p);
        const auto [least, most] = std::minmax_element(facing.at.begin(), facing.at.end());
        next.may_fold = !(*least > facing.error || -*most > facing.error);
    }
    if (!next.may_fold && !is_cut && next.sides == 0)
        return;
    if (w.least < least_near_ / 2) {
        if (p.depth < most_levels)
            split(next);
        else
            add_box(view_.window());
        return;
    }
    const l3d_image_box& box = p.net.box();
    const double size = std::max(box.width(), box.height());
    if ((size >= least_asked || p.depth == 0) && hides(box, w))
        return;
    if (pieces_ > most_pieces) {
        add_box(box);
        return;
    }
    if (size <= longest_line || p.depth >= most_levels) {
        if (mark_small(next, facing))
            return;
        if (size <= allowed_ || p.depth >= most_levels) {
            add_box(box);
            return;
        }
    }
    split(next);
}

/// Marks the sides of a small piece. Also marks the lines at which the piece folds or is cut, if
/// they are nearly straight. Returns whether all outlines of the piece are marked. The members of
/// `p` tell which outlines are not marked yet.
bool l3d_outline_search::mark_small(piece& p, const level_set<order>& facing) {
    const l3d_image_curve sides[] = {p.net.row(0), p.net.column(3), p.net.row(3), p.net.column(0)};
    for (std::size_t k = 0; k < std::size(sides); ++k)
        if (p.sides >> k & 1)
            add_curve(sides[k], 0);
    p.sides = 0;
    p.may_fold = p.may_fold && !add_level_set(facing, p);
    const bool are_cuts_marked = mark_cuts(p);
    return !p.may_fold && are_cuts_marked;
}

/// Marks the lines at which the near and far planes cut a piece. Returns false if one of these
/// lines is not nearly straight.
bool l3d_outline_search::mark_cuts(const piece& p) {
    const l3d_depth_range& w = p.net.w();
    level_set<4> near, far;
    near.error = (most_near_ - least_near_) / 2 + view_.error_w;
    far.error = view_.error_w;
    for (std::size_t i = 0; i < p.net.points.size(); ++i) {
        near.at[i] = p.net.points[i][2] - mean(most_near_, least_near_);
        far.at[i] = p.net.points[i][2] - view_.far;
    }
    const bool is_near_marked = w.least >= most_near_ || add_level_set(near, p);
    const bool is_far_marked = w.most <= view_.far || add_level_set(far, p);
    return is_near_marked && is_far_marked;
}

/// Halves a piece along its longer direction in space.
void l3d_outline_search::split(const piece& p) {
    double along_u = 0, along_v = 0;
    for (int line = 0; line < 4; ++line)
        for (int i = 0; i < 3; ++i) {
            along_u += l3d_length(p.patch.at(line, i + 1) - p.patch.at(line, i));
            along_v += l3d_length(p.patch.at(i + 1, line) - p.patch.at(i, line));
        }
    const bool in_u = along_u >= along_v;
    // On the heap: the recursion is as deep as there are halvings.
    const auto halves = std::make_unique<std::array<piece, 2>>(l3d_halves(p, in_u));
    auto& [low, high] = *halves;
    std::tie(low.patch, high.patch) = in_u ? p.patch.split_u() : p.patch.split_v();
    constexpr unsigned low_v = 1, high_u = 2, high_v = 4, low_u = 8;
    low.sides = p.sides & ~(in_u ? high_u : high_v);
    high.sides = p.sides & ~(in_u ? low_u : low_v);
    search(low);
    search(high);
}

/// Whether everything drawn in and around a box hides a piece in the box with the range `w`. The
/// drawn surfaces must be nearer than the piece's nearest point by the piece's range of depth,
/// since the piece's surface goes on beside it.
bool l3d_outline_search::hides(const l3d_image_box& box, const l3d_depth_range& w) const {
    const bool is_parallel = view_.is_parallel();
    const auto depth = [&](double of_w) {
        return is_parallel ? double{view_.depth_at(of_w)} : view_.depth_scale / of_w;
    };
    const double nearest = depth(w.least), farthest = depth(w.most);
    const double limit = is_parallel
                             ? 2 * nearest - farthest + 4 * reach_.places * reach_.depth_by_pixel
                             : (2 * nearest - farthest) * (1 + 4 * reach_.places / reach_.focal);
    const double margin = fold_radius_ + 1.5;
    const auto pixel = [](double at, int count) {
        return static_cast<int>(std::clamp(std::floor(at), 0.0, double(count)));
    };
    const int left = pixel(box.left - margin + view_.size.width / 2.0, view_.size.width);
    const int right = pixel(box.right + margin + 1 + view_.size.width / 2.0, view_.size.width);
    const int top = pixel(box.top - margin + view_.size.height / 2.0, view_.size.height);
    const int bottom = pixel(box.bottom + margin + 1 + view_.size.height / 2.0, view_.size.height);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x)
            if (!(depths_.inv_w(x, y) > limit))
                return false;
    return true;
}

/// Marks the pixels whose centres are no farther than `radius` from the line between two places.
/// Units: pixels from the picture's centre.
void l3d_outline_search::add_line(place from, place to, double radius) {
    for (place* end : {&from, &to})
        *end = {end->x + view_.size.width / 2.0, end->y + view_.size.height / 2.0};
    const double dx = to.x - from.x, dy = to.y - from.y;
    const double square = dx * dx + dy * dy;
    const pixel_range rows(std::min(from.y, to.y) - radius, std::max(from.y, to.y) + radius,
                           view_.size.height);
    const pixel_range columns(std::min(from.x, to.x) - radius, std::max(from.x, to.x) + radius,
                              view_.size.width);
    for (int y = rows.first; y < rows.end; ++y)
        for (int x = columns.first; x < columns.end; ++x) {
            const double px = x + 0.5 - from.x, py = y + 0.5 - from.y;
            const double t = square > 0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0.0;
            const double qx = px - t * dx, qy = py - t * dy;
            if (qx * qx + qy * qy <= radius * radius)
                mask_.set(x, y);
        }
}

/// Marks the pixels that outlines in a box may reach. Expects: w > 0 in the box.
void l3d_outline_search::add_box(const l3d_image_box& box) {
    const place middle{mean(box.left, box.right), mean(box.top, box.bottom)};
    add_line(middle, middle, fold_radius_ + std::hypot(box.width(), box.height()) / 2);
}

/// Marks pixels around places that lie nearly on a line. The line is widened by the places'
/// distance from it. Returns false, with nothing marked, if the line would be too long or too wide.
bool l3d_outline_search::add_straight(const place* places, std::size_t count, double error,
                                      double radius) {
    place from = places[0], to = places[0];
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (distance(places[i], places[k]) > distance(from, to)) {
                from = places[i];
                to = places[k];
            }
    const double length = distance(from, to);
    double beside = 0;
    for (std::size_t i = 0; i < count && length > 0; ++i)
        beside = std::max(beside, std::abs((places[i].x - from.x) * (to.y - from.y) -
                                           (places[i].y - from.y) * (to.x - from.x)) /
                                      length);
    if (!(length <= longest_line && error + beside <= allowed_))
        return false;
    add_line(from, to, radius + error + beside);
    return true;
}

void l3d_outline_search::add_curve(const l3d_image_curve& curve, int level) {
    if (l3d_outside(curve.points, window_, least_near_, view_.far))
        return;
    const l3d_depth_range w = l3d_depth_range_of(curve.points);
    const place ends[2] = {projected(curve.points[0]), projected(curve.points[3])};
    linear_error error{0, w.least, w.most};
    for (std::size_t i = 0; i < curve.points.size(); ++i)
        error.add(curve.points[i], mix(ends[0], ends[1], static_cast<double>(i) / 3));
    if (add_straight(ends, 2, error.bound(distance(ends[0], ends[1])), radius_))
        return;
    if (level >= most_levels) {
        add_box(l3d_image_box_of(curve.points));
        return;
    }
    const auto [low, high] = curve.split();
    add_curve(low, level + 1);
    add_curve(high, level + 1);
}

/// Marks the places where a polynomial may be 0. These places form a strip of the piece, whose
/// width follows from the polynomial's distance from a linear one. The strip's picture is nearly a
/// line. Returns true if the strip is marked, or empty.
template <std::size_t N>
bool l3d_outline_search::add_level_set(const level_set<N>& of, const piece& p) {
    constexpr std::size_t end = N - 1;
    const double c00 = of.at[0], c01 = of.at[end], c10 = of.at[N * end], c11 = of.at[N * N - 1];
    const double middle = mean(mean(c00, c01), mean(c10, c11));
    const double in_s = mean(c01 - c00, c11 - c10), in_t = mean(c10 - c00, c11 - c01);
    const auto linear = [&](double s, double t) {
        return middle + in_s * (s - 0.5) + in_t * (t - 0.5);
    };
    double off = 0;
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j)
            off = std::max(off, std::abs(of.at[N * i + j] - linear(static_cast<double>(j) / end,
                                                                   static_cast<double>(i) / end)));
    off += of.error;
    if (std::abs(middle) - (std::abs(in_s) + std::abs(in_t)) / 2 > off)
        return true;

    // Finds the corners of the strip: the unit square's corners within it, and the points where the
    // strip's two lines cross the square's sides.
    constexpr std::size_t most_corners = 12;
    place corners[most_corners];
    std::size_t count = 0;
    constexpr double around[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto &a = around[k], &b = around[k + 1];
        const double at_a = linear(a[0], a[1]), at_b = linear(b[0], b[1]);
        if (std::abs(at_a) <= off)
            corners[count++] = {a[0], a[1]};
        for (const double level : {-off, off})
            if ((at_a - level) * (at_b - level) < 0) {
                const double t = (level - at_a) / (at_b - at_a);
                corners[count++] = {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
            }
    }
    if (count == 0)
        return true;

    const l3d_image_net& net = p.net;
    const place q00 = projected(net.at(0, 0)), q01 = projected(net.at(0, 3));
    const place q10 = projected(net.at(3, 0)), q11 = projected(net.at(3, 3));
    const place q = mix(mix(q00, q01, 0.5), mix(q10, q11, 0.5), 0.5);
    const place ds{mean(q01.x - q00.x, q11.x - q10.x), mean(q01.y - q00.y, q11.y - q10.y)};
    const place dt{mean(q10.x - q00.x, q11.x - q01.x), mean(q10.y - q00.y, q11.y - q01.y)};
    const auto seen = [&](double s, double t) -> place {
        return {q.x + ds.x * (s - 0.5) + dt.x * (t - 0.5),
                q.y + ds.y * (s - 0.5) + dt.y * (t - 0.5)};
    };
    linear_error error{0, net.w().least, net.w().most};
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            error.add(net.at(i, j), seen(j / 3.0, i / 3.0));
    for (std::size_t i = 0; i < count; ++i)
        corners[i] = seen(corners[i].x, corners[i].y);
    return add_straight(corners, count,
                        error.bound(std::hypot(ds.x, ds.y) + std::hypot(dt.x, dt.y)), fold_radius_);
}
