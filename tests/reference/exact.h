// SPDX-License-Identifier: MIT
// The exact picture of bicubic patches: the judge of every approximate one.
#ifndef L3D_REFERENCE_EXACT_H
#define L3D_REFERENCE_EXACT_H

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <vector>

/// Shares nothing with the library but the conventions: no header of lib/ is included here, so that
/// a mistake of the library cannot excuse itself.
namespace reference {

/// Errors: std::runtime_error if nobody wants the result any more.
inline void end_if_told(const std::stop_token& stop) {
    if (stop.stop_requested())
        throw std::runtime_error("exact picture: told to stop");
}

struct vec3 {
    double x = 0, y = 0, z = 0;
};

/// Shape: points[4 * row + column]; rows run along v, columns along u.
struct patch {
    std::array<vec3, 16> points;
};

/// Units:   world, right-handed; fov_degrees vertical; near along the view axis.
/// Expects: eye != target, up not parallel to the view axis, 0 < fov < 180, near > 0.
struct camera {
    vec3 eye, target, up{0, 1, 0};
    double fov_degrees = 45;
    double near = 0.1;
    /// In a parallel projection, pixels are as large everywhere as at the target, and nothing is
    /// cut.
    bool parallel = false;

    /// The least homogeneous w that is drawn.
    double least_w() const { return parallel ? 0.5 : near; }
};

struct picture_size {
    int width = 0, height = 0;
};

/// A point before the division: the pixel position is (x / w, y / w), w the distance along the
/// axis, or 1 in a parallel projection.
struct homogeneous_point {
    long double x = 0, y = 0, w = 0;
};

/// Units: x, y pixels (y down, centre of the first pixel at 1/2); w along the view axis;
///        normal: unit dS/du x dS/dv in the world, not turned to the eye, zero where none exists.
struct surface_point {
    long double x = 0, y = 0, w = 0;
    vec3 world, normal;
};

/// The camera as three unit vectors and a focal length in pixels.
struct camera_frame {
    long double eye[3], right[3], up[3], forward[3];
    long double focal = 0, center_x = 0, center_y = 0;
    bool parallel = false; ///< then `focal` is the number of pixels in a unit

    camera_frame(const camera& view, picture_size size);
    homogeneous_point project(const long double (&world)[3]) const;
    /// The distance along the axis.
    long double distance(const long double (&world)[3]) const;
    /// The world point that is seen at pixel position (x, y) at the distance w along the axis.
    vec3 unproject(double x, double y, double w) const;
};

homogeneous_point exact_homogeneous(const patch& surface, const camera_frame& frame, long double u,
                                    long double v);
surface_point exact_point(const patch& surface, const camera_frame& frame, long double u,
                          long double v);
surface_point exact_point(const patch& surface, const camera& view, picture_size size,
                          long double u, long double v);

/// The nearest surface behind one pixel centre; w is infinite and patch -1 where nothing is.
struct exact_sample {
    double w = std::numeric_limits<double>::infinity();
    double u = 0, v = 0;
    vec3 normal;
    int patch = -1;

    bool covered() const { return patch >= 0; }
};

/// The exact picture: at every pixel centre, the nearest of all surface points with w >= near. In a
/// parallel projection, w of a sample is the distance along the axis all the same.
///
/// Every intersection is found. A patch is split until a piece either has no pixel centre in its
/// hull or is proved to map one to one onto the picture. There the only root is iterated to 1e-11
/// px. Pixel centres within 1e-9 px of an outline may go either way.
///
/// Errors: std::runtime_error if a patch needs more than 20 million pieces, and if told to stop.
/// Cost:   about 1 us per pixel and layer of depth.
class exact_image {
public:
    exact_image(std::span<const patch> patches, const camera& view, picture_size size,
                const std::stop_token& stop = {});

    picture_size size() const { return size_; }
    const camera& view() const { return view_; }
    const exact_sample& at(int x, int y) const { return samples_[index(x, y)]; }
    bool covered(int x, int y) const { return at(x, y).covered(); }
    /// How many surface points lie behind the pixel centre, in all layers (a point on a seam that
    /// two pieces share counts more than once).
    int layers(int x, int y) const { return layers_[index(x, y)]; }

    /// Lambert grey level: round(255 (0.1 + 0.9 max(0, n.l))), n turned to the eye; 0 where nothing
    /// is. Expects: light of any length but zero, towards the light, world space.
    std::vector<unsigned char> lambert(vec3 light) const;

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
               static_cast<std::size_t>(x);
    }

    picture_size size_;
    camera view_;
    std::vector<exact_sample> samples_;
    std::vector<int> layers_;
};

} // namespace reference

#endif
