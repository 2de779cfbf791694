// SPDX-License-Identifier: MIT
// l3d_camera: where the eye is, and the way from world to image; l3d_framed, a camera that shows
// the whole of a model, whatever its size and place.
#ifndef L3D_SCENE_CAMERA_H
#define L3D_SCENE_CAMERA_H

#include "base/public.h"
#include "geom/matrix.h"
#include "geom/vector.h"
#include "tool_2d/pixels.h"

#include <functional>
#include <string>

class l3d_patch_scene;

/// The smallest valid near_z, and the smallest valid distance of a camera's target from its eye.
/// Pictures store depths as 1 / distance in floats, which go up to 3e38.
inline constexpr double l3d_least_distance = 1e-32;

/// The largest valid magnitude of the coordinates of a camera's eye. The largest models reach to
/// 1e12. An eye within this limit sees all of them, also with a narrow field of view.
inline constexpr double l3d_farthest_eye = 1e15;

/// The least valid sine of the angle between a camera's `up` and its line of sight. With a smaller
/// sine, rounding alone would turn the picture by a part in 10^9 and more.
inline constexpr double l3d_least_up_sine = 1e-6;

/// The directions right, up and front of a model, made of its upward direction. Views such as "from
/// the front" are named by these directions. Front is the z axis, or -y if z is up, as in many
/// files.
///
/// Shape:   three perpendicular unit vectors; right x up = front.
struct L3D_PUBLIC l3d_upright {
    /// A direction in the world.
    using vector = l3d_vector<double, 3>;
    vector right, ///< the direction to the right of a person who looks at the model's front
        up,       ///< above the model
        front;    ///< the direction from the model to this person

    /// Makes the directions from the model's upward one, `upwards`.
    /// Expects: a finite vector of any length but zero.
    explicit l3d_upright(const vector& upwards);

    /// The vector that is the sum of these lengths along right, up and front.
    vector at(double rightwards, double upwards, double forwards) const {
        return right * rightwards + up * upwards + front * forwards;
    }
};

/// The kind of projection.
enum class L3D_PUBLIC l3d_projection {
    perspective, ///< things twice as far away look half as large
    /// Things look as large as in perspective at the target; nothing is behind the eye.
    parallel,
};

/// A camera in a right-handed world, which looks from its eye to its target. A new camera stands at
/// (0, 0, 1), looks at the origin, and has y up.
///
/// Units:   world units; fov in degrees, vertical, over the whole picture height.
/// Expects: eye != target, up not parallel to target - eye, 0 < fov < 180, 0 < near_z < far_z.
struct L3D_PUBLIC l3d_camera {
    /// A place or a direction in the world.
    using vector = l3d_vector<double, 3>;
    vector eye{0.0, 0.0, 1.0};    ///< the eye's place
    vector target{0.0, 0.0, 0.0}; ///< the place in the middle of the picture
    vector up{0.0, 1.0, 0.0};     ///< the direction that points up in the picture, of any length
    double fov = 38;              ///< full vertical angle of view, in degrees
    double near_z = 0.1; ///< least distance along the view axis that is drawn, in world units
    /// Farthest distance along the view axis that is drawn, in world units. The default hides
    /// nothing: no point is farther from any eye than sqrt(3) 1.001e15.
    double far_z = 1e16;
    /// The kind of projection. In a parallel projection, near_z and far_z cut nothing.
    l3d_projection projection = l3d_projection::perspective;

    friend bool operator==(const l3d_camera&, const l3d_camera&) = default;

    /// Unit vectors to the right, up and forward in the picture.
    struct frame {
        /// Three perpendicular unit vectors in world space.
        vector right, up, forward;
    };
    /// The axes of the picture in the world. Expects: is_valid().
    frame axes() const;

    /// Sine of the angle between `up` and the line of sight.
    double up_sine() const;

    /// The error message for an invalid camera, naming the value at fault; "" if it is valid. A
    /// valid camera has finite numbers, the eye within l3d_farthest_eye, the target within 1e12 and
    /// not at the eye, and up_sine() at least l3d_least_up_sine. Such a camera also has 0 < fov <
    /// 180 and l3d_least_distance <= near_z < far_z.
    std::string complaint() const;

    /// Whether complaint() is empty.
    bool is_valid() const { return complaint().empty(); }

    /// Whether the projection is parallel: far things do not look smaller.
    bool is_parallel() const { return projection == l3d_projection::parallel; }

    /// Pixels per world unit at distance 1 from the eye, in perspective, in a picture of this size.
    double focal_length(l3d_size size) const;

    /// Pixels per world unit at the target. In a parallel projection this scale is the same
    /// everywhere.
    double scale_at_target(l3d_size size) const;

    /// The matrix that takes a place (x, y, z, 1) of the world to (x, y, 0, w) in the picture. The
    /// place is then seen (x / w, y / w) pixels from the picture's centre, y down. w is the
    /// distance along the view axis, or 1 in a parallel projection.
    l3d_matrix<double> image_matrix(l3d_size size) const;

    /// Turns the eye about the target: first around `up`, then around the axis to the right. The
    /// eye stays where it is if the line of sight would then run nearly along `up`.
    /// Units: degrees.
    void orbit(double around_up, double around_right);

    /// Multiplies the eye's distance from the target by `factor`. Expects: factor > 0.
    void approach(double factor) { approach(factor, target); }

    /// Multiplies the distances of eye and target from a place by `factor`. The place stays where
    /// it is in the picture.
    /// Expects: factor > 0.
    void approach(double factor, const vector& place);

    /// Moves eye and target by the same vector. Units: world.
    void move(const vector& by) {
        eye += by;
        target += by;
    }

    /// The distance of a place from the eye, measured along the view axis.
    double depth_of(const vector& place) const;

    /// The place that is seen at the position (x, y) of a picture at this distance along the view
    /// axis.
    /// Units: pixels from the picture's left upper corner, where a pixel's middle is at 1/2.
    vector place_at(double x, double y, double depth, l3d_size size) const;
};

/// A function that tells how far a thing reaches along a direction: the largest dot product of the
/// direction with any point of the thing. For a thing without points it returns minus infinity.
using l3d_reach = std::function<double(const l3d_vector<double, 3>& direction)>;

/// A function that returns the reach of a scene's surfaces, not of their control points. The reach
/// is too large by at most 1/10000 of the span of the control points.
/// Lives:   borrows the scene.
/// Cost:    a call takes 16 products for each patch, and more for the few patches that reach
///          farthest.
L3D_PUBLIC l3d_reach l3d_reach_of(const l3d_patch_scene& scene);

/// The part of a picture's width or height that a model fills after l3d_framed. The rest is room to
/// turn the model.
inline constexpr double l3d_framed_share = 0.85;

/// The camera that shows all of a model in a picture of this size. The result keeps the line of
/// sight's direction, `up` and `fov`. The model fills l3d_framed_share of the picture's width or of
/// its height, and at most this share of the other side. The target is in the middle of the model's
/// depth. `near_z` becomes smaller if it would cut the model.
///
/// In a parallel projection, the eye's distance from the target sets the scale.
/// Expects: a valid camera.
/// Errors:  none. The camera stays as it is if there is nothing to show. An eye that would be
///          farther than l3d_farthest_eye from the origin stays within.
L3D_PUBLIC l3d_camera l3d_framed(const l3d_camera& camera, l3d_size size, const l3d_reach& reach);

/// Whether a picture of this size shows all of a model well. It does if the model takes 60 % or
/// more of the picture's width or height, and is not near one border with much room opposite. For a
/// parallel projection the answer is always no.
/// Expects: a valid camera.
L3D_PUBLIC bool l3d_shows_well(const l3d_camera& camera, l3d_size size, const l3d_reach& reach);

/// The reason why a picture shows nothing of a model, such as "behind the eye"; "" if it may show
/// something. A model whose picture is less than one pixel wide and high is "smaller than a pixel".
/// Expects: a valid camera. In parallel projection nothing is behind the eye.
L3D_PUBLIC std::string l3d_why_unseen(const l3d_camera& camera, l3d_size size,
                                      const l3d_reach& reach);

/// The answer of l3d_why_unseen for a model smaller than a pixel. Such a model may still cover a
/// pixel's middle.
inline constexpr const char* l3d_smaller_than_a_pixel = "smaller than a pixel";

/// The answer of l3d_why_unseen for a model so small that no valid eye is near enough to show it.
inline constexpr const char* l3d_too_small =
    "too small for any view, whose eye is 1e-32 away at least";

/// The reason that pipelines give for an empty picture if all faces or patches of a model are
/// points or lines.
inline constexpr const char* l3d_without_area = "without any area";

/// The camera itself if l3d_shows_well, else the camera that l3d_framed makes of it. Expects,
/// Errors: as these two functions.
L3D_PUBLIC l3d_camera l3d_framed_unless_well(const l3d_camera& camera, l3d_size size,
                                             const l3d_reach& reach);

#endif
