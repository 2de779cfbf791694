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

/// The judge of the library's pictures. It shares nothing with the library but the conventions, and
/// includes no header of lib/, so that a mistake of the library cannot excuse itself.
namespace reference {

/// Ends a computation that nobody wants any more. Errors: std::runtime_error if told to stop.
inline void end_if_told(const std::stop_token& stop) {
    if (stop.stop_requested())
        throw std::runtime_error("exact picture: told to stop");
}

struct vec3 {
    double x = 0, y = 0, z = 0;
};

/// A bicubic Bezier patch. Shape: points[4 * row + column]; rows run along v, columns along u.
struct patch {
    std::array<vec3, 16> points;
};

/// The camera of a picture.
/// Units:   world, right-handed; fov_degrees vertical; near along the view axis.
/// Expects: eye != target, up not parallel to the view axis, 0 < fov < 180, near > 0.
struct camera {
    vec3 eye, target, up{0, 1, 0};
    double fov_degrees = 45;
    double near = 0.1;
    /// In a parallel projection, pixels are everywhere as large as at the target, and nothing is
    /// cut.
    bool parallel = false;

    /// The least homogeneous w that is drawn.
    double least_w() const { return parallel ? 0.5 : near; }
};

struct picture_size {
    int width = 0, height = 0;
};

/// A point before the division. The pixel position is (x / w, y / w). w is the distance along the
/// view axis, or 1 in a parallel projection.
struct homogeneous_point {
    long double x = 0, y = 0, w = 0;
};

/// A point of a surface in the picture and in the world.
/// Units:   x, y pixels (y down, centre of the first pixel at 1/2); w along the view axis; normal:
///          unit dS/du x dS/dv in the world, not turned to the eye, zero where none exists.
struct surface_point {
    long double x = 0, y = 0, w = 0;
    vec3 world, normal;
};

/// The camera as three unit vectors and a focal length in pixels.
struct camera_frame {
    long double eye[3], right[3], up[3], forward[3];
    long double focal = 0, center_x = 0, center_y = 0;
    bool parallel = false; ///< in this case `focal` is the number of pixels in a unit

    camera_frame(const camera& view, picture_size size);
    homogeneous_point project(const long double (&world)[3]) const;
    /// The distance along the view axis.
    long double distance(const long double (&world)[3]) const;
    /// The world point that is seen at pixel position (x, y), at the distance w along the view
    /// axis.
    vec3 unproject(double x, double y, double w) const;
};

homogeneous_point exact_homogeneous(const patch& surface, const camera_frame& frame, long double u,
                                    long double v);
surface_point exact_point(const patch& surface, const camera_frame& frame, long double u,
                          long double v);
surface_point exact_point(const patch& surface, const camera& view, picture_size size,
                          long double u, long double v);

/// The nearest surface behind one pixel centre. Where nothing is, w is infinite and patch is -1.
struct exact_sample {
    double w = std::numeric_limits<double>::infinity();
    double u = 0, v = 0;
    vec3 normal;
    int patch = -1;

    bool covered() const { return patch >= 0; }
};

/// The exact picture. Each pixel centre has the nearest of all surface points with w >= near. In a
/// parallel projection, too, w of a sample is the distance along the view axis.
///
/// Every intersection is found. A patch is split until each piece has no pixel centre in its hull,
/// or is proved to map one to one onto the picture. Then the only root is iterated to 1e-11 px.
/// Pixel centres within 1e-9 px of an outline may go either way.
///
/// Errors:  std::runtime_error if a patch needs more than 20 million pieces, or if told to stop.
/// Cost:   about 1 us per pixel and layer of depth.
class exact_image {
public:
    exact_image(std::span<const patch> patches, const camera& view, picture_size size,
                const std::stop_token& stop = {});

    picture_size size() const { return size_; }
    const camera& view() const { return view_; }
    const exact_sample& at(int x, int y) const { return samples_[index(x, y)]; }
    bool covered(int x, int y) const { return at(x, y).covered(); }
    /// The number of surface points behind the pixel centre, in all layers. A point on a seam that
    /// two pieces share counts more than once.
    int layers(int x, int y) const { return layers_[index(x, y)]; }

    /// Lambert's grey levels: round(255 (0.1 + 0.9 max(0, n.l))), where n is turned to the eye; 0
    /// where nothing is.
    /// Expects: light of any length but zero, towards the light, world space.
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
