// SPDX-License-Identifier: MIT
// visit_curve_pixels: draws curves one pixel wide, by adaptive forward differences.
#ifndef L3D_RASTER_PATHS_CURVE_PIXELS_P_H
#define L3D_RASTER_PATHS_CURVE_PIXELS_P_H

#include "geom/forward_difference.h"
#include "raster/paths/flat_curve_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace l3d_detail {

/// Lights pixels as a thin, eight-connected run: the pixel in the corner of a right angle is left
/// out.
template <class Light> class thin_run {
public:
    explicit thin_run(const Light& light) : light_(light) {}
    ~thin_run() { end(); }
    thin_run(const thin_run&) = delete;
    thin_run& operator=(const thin_run&) = delete;

    /// Adds a pixel to the run.
    /// Expects: the first pixel of a run, or one whose x and y differ by at most 1 from the last
    ///          pixel's.
    void add(std::int64_t x, std::int64_t y) {
        if (count_ > 0 && x == last_.x && y == last_.y)
            return;
        if (count_ > 1) {
            const bool corner = std::abs(x - before_.x) == 1 && std::abs(y - before_.y) == 1 &&
                                (last_.x == before_.x || last_.y == before_.y) &&
                                (last_.x == x || last_.y == y);
            if (!corner) {
                light_(before_.x, before_.y);
                before_ = last_;
            }
        } else if (count_ == 1) {
            before_ = last_;
        }
        count_ = std::min(count_ + 1, 2);
        last_ = {x, y};
    }

    void end() {
        if (count_ > 1)
            light_(before_.x, before_.y);
        if (count_ > 0)
            light_(last_.x, last_.y);
        count_ = 0;
    }

private:
    struct place {
        std::int64_t x = 0, y = 0;
    };
    const Light& light_;
    place before_, last_;
    int count_ = 0;
};

/// Walks along a curve by forward differences that halve and double their step.
///
/// In a step with differences d1, d2, d3, a coordinate changes at most by |d1| + |d2| / 2 + |d3| /
/// 3, which is a bound of its derivative. The step is halved until this change is at most one
/// pixel. It is doubled as soon as the change in a double step is at most one pixel, too.
/// Units:   pixels from `origin`, which keeps numbers, and so rounding errors, small.
/// Expects: a curve that 512 or fewer equal steps divide into changes of at most one pixel. Then at
///          most 1024 steps are made, and rounding errors are below 2^-20 pixel; NUMERICS.md,
///          section 20.
class adaptive_walk {
public:
    explicit adaptive_walk(const l3d_curve_2d& curve)
        : origin_{std::round(projected(curve.points[0]).x),
                  std::round(projected(curve.points[0]).y)},
          plain_(is_plain(curve)) {
        for (std::size_t k = 0; k < 3; ++k) {
            std::array<double, 4> b;
            for (std::size_t i = 0; i < 4; ++i) {
                const auto& p = curve.points[i];
                b[i] = k == 2 ? p[2]
                              : p[static_cast<int>(k)] - (k == 0 ? origin_.x : origin_.y) * p[2];
            }
            d_[k] = l3d_forward_difference<double, 3>::build(b, 1);
        }
        for (const auto& p : curve.points) {
            const l3d_point_2d at = projected(p);
            reach_ = std::max({reach_, std::abs(at.x - origin_.x), std::abs(at.y - origin_.y)});
        }
    }

    /// The place that the walk has reached.
    l3d_point_2d at() const {
        const double w = plain_ ? 1 : d_[2].value();
        return {origin_.x + d_[0].value() / w, origin_.y + d_[1].value() / w};
    }

    /// The curve's parameter at the place reached, exactly.
    double parameter() const { return 1 - static_cast<double>(left_) / whole; }

    bool done() const { return left_ == 0; }

    /// Moves on by less than a pixel in each coordinate.
    void step() {
        while (change() > 1 && step_ > 1) {
            for (auto& d : d_)
                d.halve();
            step_ /= 2;
        }
        for (auto& d : d_)
            d.step();
        left_ -= step_;
        // With less than half of a pixel a step, one of twice the length may do.
        if (left_ % (2 * step_) == 0 && left_ > 0 && change() < 0.5) {
            for (auto& d : d_)
                d.double_step();
            step_ *= 2;
        }
    }

private:
    /// The number of steps in a curve if all are as short as possible.
    static constexpr std::int64_t whole = 1 << 20;

    double change() const {
        const auto most = [](const l3d_forward_difference<double, 3>& d) {
            return std::abs(d.d[1]) + std::abs(d.d[2]) / 2 + std::abs(d.d[3]) / 3;
        };
        const double place = std::max(most(d_[0]), most(d_[1]));
        if (plain_)
            return place;
        // The change of the quotient place / weight. At a place at most `reach` away, it is at most
        // the change of the place plus `reach` times that of the weight, over the least weight.
        const double weight = most(d_[2]), least = d_[2].value() - weight;
        return least > 0 ? (place + reach_ * weight) / least : 2;
    }

    l3d_point_2d origin_;
    bool plain_;
    double reach_ = 0;
    std::array<l3d_forward_difference<double, 3>, 3> d_;
    std::int64_t step_ = whole, left_ = whole;
};

/// The number of equal steps of a curve's parameter that move its point by at most a pixel each.
inline double pixel_steps(const l3d_curve_2d& curve) {
    const auto& p = curve.points;
    const l3d_point_2d origin = projected(p[0]);
    double place = 0, weight = 0, reach = 0, least = p[0][2];
    for (std::size_t i = 1; i < 4; ++i) {
        const double w = p[i][2] - p[i - 1][2];
        place = std::max({place, std::abs(p[i][0] - p[i - 1][0] - origin.x * w),
                          std::abs(p[i][1] - p[i - 1][1] - origin.y * w)});
        weight = std::max(weight, std::abs(w));
        const l3d_point_2d at = projected(p[i]);
        reach = std::max({reach, std::abs(at.x - origin.x), std::abs(at.y - origin.y)});
        least = std::min(least, p[i][2]);
    }
    return 3 * (place + reach * weight) / least;
}

/// Adds the pixels nearest to the points of a curve to a run. The run ends where the curve is
/// outside of the box `seen`.
template <class Run> void walk_curve(const l3d_curve_2d& curve, const seen_box& seen, Run& run) {
    if (seen.misses(curve))
        return run.end();
    constexpr double most_steps = 512;
    if (pixel_steps(curve) > most_steps) {
        const auto [first, second] = curve.split();
        walk_curve(first, seen, run);
        return walk_curve(second, seen, run);
    }
    const auto add = [&run](l3d_point_2d p) {
        run.add(static_cast<std::int64_t>(std::floor(p.x + 0.5)),
                static_cast<std::int64_t>(std::floor(p.y + 0.5)));
    };
    adaptive_walk walk(curve);
    add(projected(curve.points[0]));
    while (!walk.done()) {
        walk.step();
        add(walk.done() ? projected(curve.points[3]) : walk.at());
    }
}

/// Calls light(x, y) for the pixels of a path's lines and curves that lie in a picture.
template <class Light>
void visit_curve_pixels(const l3d_path& path, l3d_size size, const Light& light) {
    const auto in_picture = [&](std::int64_t x, std::int64_t y) {
        if (x >= 0 && x < size.width && y >= 0 && y < size.height)
            light(static_cast<int>(x), static_cast<int>(y));
    };
    // Pixels up to two beside the picture are found, too, since the neighbours of a pixel tell
    // whether it is a corner.
    constexpr double beside = 2;
    struct {
        seen_box seen;
        thin_run<decltype(in_picture)> run;
        l3d_point_2d begin{}, last{};

        void move(l3d_point_2d to) {
            run.end();
            begin = last = to;
        }
        void line(l3d_point_2d to) {
            const auto at = [&](double t) {
                return l3d_curve_2d::point(std::lerp(last.x, to.x, t), std::lerp(last.y, to.y, t),
                                           1.0);
            };
            walk_curve(l3d_curve_2d{{at(0), at(1.0 / 3), at(2.0 / 3), at(1)}}, seen, run);
            last = to;
        }
        void curve(const l3d_curve_2d& c) {
            walk_curve(c, seen, run);
            last = projected(c.points[3]);
        }
        void close() {
            line(begin);
            run.end();
        }
    } visitor{{-beside, -beside, size.width + beside, size.height + beside},
              thin_run<decltype(in_picture)>(in_picture)};
    if (path.is_number())
        path.visit(visitor);
}

} // namespace l3d_detail

#endif
