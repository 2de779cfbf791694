// SPDX-License-Identifier: MIT
// Counts and errors of a product's picture against the exact one.
#include "reference/measure.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>

namespace reference {
namespace {

/// A neighbour this far from the tangent plane, in pixels, lies on another layer or on a bend that
/// the tangent plane of one pixel does not describe.
constexpr double jump_px = 1;

double dot(const long double (&a)[3], const vec3& b) {
    return static_cast<double>(a[0] * b.x + a[1] * b.y + a[2] * b.z);
}

double dot(const vec3& a, const vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// How a plane lies to the line of sight d through a pixel's centre, d scaled to 1 along the axis.
struct slant {
    double toward;           ///< n.d
    double along_x, along_y; ///< n.right, n.up
};
slant slant_of(const vec3& n, const camera_frame& frame, int x, int y) {
    const double along_x = dot(frame.right, n), along_y = dot(frame.up, n);
    if (frame.parallel)
        return {dot(frame.forward, n), along_x, along_y};
    const double focal = static_cast<double>(frame.focal);
    return {dot(frame.forward, n) +
                (x + 0.5 - static_cast<double>(frame.center_x)) / focal * along_x +
                (static_cast<double>(frame.center_y) - y - 0.5) / focal * along_y,
            along_x, along_y};
}

/// The picture, and what the comparison needs to know of a pixel's neighbourhood.
class comparison {
public:
    comparison(std::span<const float> depth, const exact_image& exact)
        : depth_(depth), exact_(exact), frame_(exact.view(), exact.size()) {
        assert(depth.size() == static_cast<std::size_t>(exact.size().width) *
                                   static_cast<std::size_t>(exact.size().height));
    }

    double depth(int x, int y) const {
        return depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(exact_.size().width) +
                      static_cast<std::size_t>(x)];
    }
    bool product_covers(int x, int y) const {
        return std::isfinite(depth(x, y)) && depth(x, y) > 0;
    }

    double error_px(int x, int y) const {
        return depth_error_px(exact_.at(x, y), frame_, x, y, depth(x, y));
    }

    /// All nine pixels exist and satisfy the predicate.
    template <class Predicate> bool around(int x, int y, Predicate predicate) const {
        if (x < 1 || y < 1 || x + 1 >= exact_.size().width || y + 1 >= exact_.size().height)
            return false;
        for (int j = y - 1; j <= y + 1; ++j)
            for (int i = x - 1; i <= x + 1; ++i)
                if (!predicate(i, j))
                    return false;
        return true;
    }

    bool surrounded(int x, int y) const {
        return around(x, y, [&](int i, int j) { return exact_.covered(i, j); });
    }

    /// Most of the neighbours are covered: where an outline has moved inwards, they are not.
    bool is_hole(int x, int y) const {
        constexpr int most = 6; // of eight
        int covered = 0;
        around(x, y, [&](int i, int j) {
            covered += product_covers(i, j);
            return true;
        });
        return covered >= most;
    }

    /// The pixel and its neighbours show one surface without a jump, whatever the product shows
    /// there: each of them lies in the middle's tangent plane, and the middle in each of theirs.
    ///
    /// One of both is not enough. Where the middle is seen nearly edge on, its tangent plane holds
    /// the line of sight, and with it everything that is far behind. But at a jump, the surface
    /// behind has another tangent plane.
    bool is_smooth(int x, int y) const {
        const exact_sample& middle = exact_.at(x, y);
        return around(x, y, [&](int i, int j) {
            const exact_sample& other = exact_.at(i, j);
            return other.covered() &&
                   tangent_distance_px(middle, x, y, frame_, other, i, j) <= jump_px &&
                   tangent_distance_px(other, i, j, frame_, middle, x, y) <= jump_px;
        });
    }

    /// Both cover the pixel, so that depth and grey level can be compared there.
    bool is_judged(int x, int y) const {
        return product_covers(x, y) && exact_.covered(x, y) && is_smooth(x, y);
    }

private:
    std::span<const float> depth_;
    const exact_image& exact_;
    camera_frame frame_;
};

} // namespace

/// The plane through w_p d_p with the normal n is away from the point w_q d_q by n.(w_q d_q - w_p
/// d_p), and a pixel is w_q / focal wide there. Where d_q meets the plane, at w_p (n.d_p) /
/// (n.d_q), this is 0, however slanted the plane.
double tangent_distance_px(const exact_sample& plane, int x, int y, const camera_frame& frame,
                           const exact_sample& other, int i, int j) {
    if (frame.parallel) {
        const slant s = slant_of(plane.normal, frame, i, j);
        const double off = (other.w - plane.w) * s.toward * static_cast<double>(frame.focal) +
                           (i - x) * s.along_x - (j - y) * s.along_y;
        return dot(plane.normal, plane.normal) > 0 ? std::abs(off)
                                                   : std::numeric_limits<double>::infinity();
    }
    const double off = other.w * slant_of(plane.normal, frame, i, j).toward -
                       plane.w * slant_of(plane.normal, frame, x, y).toward;
    const bool has_normal = dot(plane.normal, plane.normal) > 0;
    return has_normal ? std::abs(off) * static_cast<double>(frame.focal) / other.w
                      : std::numeric_limits<double>::infinity();
}

/// The tangent plane's w = w_p (n.d_p) / (n.d): one pixel sideways changes w focal / w by
/// -(n.right) / (n.d), and down by (n.up) / (n.d).
double depth_error_px(const exact_sample& exact, const camera_frame& frame, int x, int y,
                      double w) {
    const slant s = slant_of(exact.normal, frame, x, y);
    const double distance = frame.parallel ? 1 : exact.w; // at which `focal` pixels make a unit
    return std::abs((w - exact.w) / distance * static_cast<double>(frame.focal) * s.toward) /
           std::sqrt(s.toward * s.toward + s.along_x * s.along_x + s.along_y * s.along_y);
}

measurement measure(std::span<const float> product_depth, const exact_image& exact,
                    const exact_region& region, int most_distances) {
    const comparison pictures(product_depth, exact);
    measurement result;
    const auto next_distance = [&] { return result.distances_complete = most_distances-- > 0; };
    for (int y = 0; y < exact.size().height; ++y)
        for (int x = 0; x < exact.size().width; ++x) {
            const bool is = pictures.product_covers(x, y), should = exact.covered(x, y);
            result.covered_product += is;
            result.covered_exact += should;
            if (is && !should) {
                ++result.extra;
                if (next_distance())
                    result.max_extra_distance =
                        std::max(result.max_extra_distance,
                                 region.distance_to_exact_surface(x + 0.5, y + 0.5));
            } else if (should && !is) {
                ++result.missing;
                result.holes += pictures.surrounded(x, y);
                if (next_distance())
                    result.max_missing_distance =
                        std::max(result.max_missing_distance,
                                 region.distance_to_uncovered(x + 0.5, y + 0.5).upper);
            } else if (pictures.is_judged(x, y)) {
                ++result.depth_compared;
                const double w = exact.at(x, y).w;
                const double relative = std::abs(pictures.depth(x, y) - w) / w;
                const double px = pictures.error_px(x, y);
                result.max_depth_relative = std::max(result.max_depth_relative, relative);
                result.mean_depth_relative += relative;
                result.mean_depth_px += px;
                if (px > result.max_depth_px) {
                    result.max_depth_px = px;
                    result.worst_depth_x = x;
                    result.worst_depth_y = y;
                }
            }
        }
    if (result.depth_compared > 0) {
        result.mean_depth_relative /= static_cast<double>(result.depth_compared);
        result.mean_depth_px /= static_cast<double>(result.depth_compared);
    }
    return result;
}

error_map map_errors(std::span<const float> product_depth, const exact_image& exact,
                     const exact_region& region, int most_distances, const std::stop_token& stop) {
    constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
    constexpr double farthest = 16; // pixels: no method's outline is worse but by a hole
    const comparison pictures(product_depth, exact);
    const picture_size size = exact.size();
    const std::size_t pixels = product_depth.size();
    error_map result{std::vector<float>(pixels, nothing), std::vector<float>(pixels, nothing),
                     std::vector<bool>(pixels)};
    const auto for_pixels = [&](auto visit) {
        std::size_t k = 0;
        for (int y = 0; y < size.height; ++y) {
            end_if_told(stop);
            for (int x = 0; x < size.width; ++x, ++k)
                visit(k, x, y, pictures.product_covers(x, y), exact.covered(x, y));
        }
    };
    std::int64_t wrong = 0;
    for_pixels([&](std::size_t k, int x, int y, bool is, bool should) {
        result.holes[k] = !is && should && pictures.surrounded(x, y) && pictures.is_hole(x, y);
        wrong += is != should && !result.holes[k];
    });
    const std::int64_t every = wrong / most_distances + 1;
    std::int64_t count = 0;
    for_pixels([&](std::size_t k, int x, int y, bool is, bool should) {
        result.covered += should;
        if (pictures.is_judged(x, y)) {
            result.depth[k] = static_cast<float>(pictures.error_px(x, y));
            ++result.compared;
        }
        if (is == should || result.holes[k] || count++ % every != 0)
            return;
        result.outline[k] = static_cast<float>(
            is ? region.distance_to_exact_surface(x + 0.5, y + 0.5)
               : std::min(farthest,
                          region.distance_to_uncovered(x + 0.5, y + 0.5, farthest).upper));
    });
    return result;
}

shade_difference measure_lambert(std::span<const unsigned char> product_grey,
                                 std::span<const float> product_depth, const exact_image& exact,
                                 vec3 light) {
    const comparison pictures(product_depth, exact);
    const std::vector<unsigned char> wanted = exact.lambert(light);
    assert(product_grey.size() == wanted.size());
    shade_difference result;
    for (int y = 0; y < exact.size().height; ++y)
        for (int x = 0; x < exact.size().width; ++x) {
            result.covered += exact.covered(x, y);
            if (!pictures.is_judged(x, y))
                continue;
            const std::size_t k =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(exact.size().width) +
                static_cast<std::size_t>(x);
            const int difference = std::abs(int(product_grey[k]) - int(wanted[k]));
            ++result.compared;
            result.max = std::max(result.max, difference);
            result.mean += difference;
            result.rms += difference * difference;
        }
    if (result.compared > 0) {
        result.mean /= static_cast<double>(result.compared);
        result.rms = std::sqrt(result.rms / static_cast<double>(result.compared));
    }
    return result;
}

} // namespace reference
