// SPDX-License-Identifier: MIT
// l3d_moveable: moves along and about its own axes, with damping.
#include "pipeline/worlds/camera_left_handed.h"

#include <algorithm>
#include <cmath>

namespace {

/// Damping leaves these shares of velocity and of spin after one update of the book.
constexpr double kept_velocity = 0.95;
constexpr double kept_spin = 0.85;

/// A step of motion is at most half an update of the book. The fastest flight is over after ln(5400
/// / 0.01) / -ln 0.95 = 257 updates, which are 4.3 s. So a time of more than 10 s takes no more
/// steps than 10 s.
constexpr double steps_per_second = 2 * l3d_book_rate;
constexpr double longest_flight = 10;

constexpr double twist_step = 5 * l3d_book_rate;
constexpr double largest_velocity = 90 * l3d_book_rate;
constexpr double largest_spin = 95 * l3d_book_rate;

/// Motion slower than this counts as rest. The motion that is left out is shorter than 0.01 / 60 *
/// 19 = 0.0032 units, or 0.05 / 60 * 5.7 = 0.0048 degrees.
constexpr double slowest_velocity = 0.01;
constexpr double slowest_spin = 0.05;

/// The least sine of the angle between the two directions of set_axes. With a smaller sine, a
/// float's rounding of 2^-24 would decide the third axis.
constexpr double least_sine = 0x1p-20;

void add_up_to(double& velocity, double step, double limit) {
    if (std::abs(velocity) < limit || velocity * step < 0)
        velocity += step;
}

/// The time in which an undamped body goes as far as a damped body goes in `seconds`. Each update
/// keeps the part k of the velocity, then moves. So n updates move it by v (k + k^2 + ... + k^n) =
/// v k (1 - k^n) / (1 - k).
double effective_time(double kept, double seconds) {
    return kept * (1 - std::pow(kept, seconds * l3d_book_rate)) / (1 - kept) / l3d_book_rate;
}

void slow_down(double& velocity, double factor, double slowest) {
    velocity *= factor;
    if (std::abs(velocity) < slowest)
        velocity = 0;
}

template <class T>
l3d_vector<T, 3> turned(const l3d_vector<T, 3>& v, const l3d_vector<T, 3>& axis, double degrees) {
    const auto about = l3d_converted<double, T, 3>(axis);
    return l3d_transformed(l3d_rotation<T>(about, degrees), v);
}

} // namespace

template <class T> void l3d_moveable<T>::push(const by_axis& times) {
    add_up_to(velocity.right, times.right * thrust.right, largest_velocity);
    add_up_to(velocity.up, times.up * thrust.up, largest_velocity);
    add_up_to(velocity.forward, times.forward * thrust.forward, largest_velocity);
}

template <class T> void l3d_moveable<T>::twist(const by_axis& times) {
    add_up_to(spin.right, times.right * twist_step, largest_spin);
    add_up_to(spin.up, times.up * twist_step, largest_spin);
    add_up_to(spin.forward, times.forward * twist_step, largest_spin);
}

template <class T> void l3d_moveable<T>::turn_about_right(double degrees) {
    forward_ = turned(forward_, right_, degrees);
    up_ = l3d_cross(forward_, right_);
    straighten();
}

template <class T> void l3d_moveable<T>::turn_about_up(double degrees) {
    forward_ = turned(forward_, up_, degrees);
    straighten();
}

template <class T> void l3d_moveable<T>::turn_about_forward(double degrees) {
    up_ = turned(up_, forward_, degrees);
    straighten();
}

template <class T> bool l3d_moveable<T>::set_axes(const vector& forward, const vector& up) {
    // In double: the products of small vectors would be lost in fixed point.
    using wide = l3d_vector<double, 3>;
    const auto direction = [](const wide& v) {
        const double largest =
            std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); // squares may overflow
        return largest > 0 && std::isfinite(largest) ? l3d_normalized(v / largest) : wide(0.0);
    };
    const wide along = direction(l3d_converted<double, T, 3>(forward));
    const wide side = l3d_cross(direction(l3d_converted<double, T, 3>(up)), along);
    if (!(l3d_length(side) > least_sine))
        return false;
    const wide right = l3d_normalized(side);
    forward_ = l3d_converted<T, double, 3>(along);
    right_ = l3d_converted<T, double, 3>(right);
    up_ = l3d_converted<T, double, 3>(l3d_cross(along, right));
    return true;
}

template <class T> bool l3d_moveable<T>::transform(const l3d_matrix<T>& m) {
    if (!set_axes(l3d_transformed(m, forward_), l3d_transformed(m, up_)))
        return false;
    place = l3d_transformed(m, place);
    return true;
}

/// Makes the axes perpendicular again, and of length 1, by two cross products and two divisions.
/// The axis to the right follows from the two other axes.
template <class T> void l3d_moveable<T>::straighten() {
    forward_ = l3d_normalized(forward_);
    right_ = l3d_normalized(l3d_cross(up_, forward_));
    up_ = l3d_cross(forward_, right_);
}

template <class T> void l3d_moveable<T>::spin_by(double share) {
    if (spin.up != 0)
        turn_about_up(spin.up * share);
    if (spin.right != 0)
        turn_about_right(spin.right * share);
    if (spin.forward != 0)
        turn_about_forward(spin.forward * share);
}

template <class T> void l3d_moveable<T>::update(double seconds) {
    const int steps = std::max(
        1, static_cast<int>(std::ceil(std::min(seconds, longest_flight) * steps_per_second)));
    for (int i = 0; i < steps && moves(); ++i)
        fly(seconds / steps);
}

template <class T> bool l3d_moveable<T>::moves() const {
    const auto any = [](const by_axis& v) { return v.right != 0 || v.up != 0 || v.forward != 0; };
    return any(velocity) || any(spin);
}

template <class T> void l3d_moveable<T>::fly(double seconds) {
    // Turns by half of the angle, moves, and turns by the other half. So the error of a step falls
    // with the step's square.
    const double half_turn = effective_time(kept_spin, seconds) / 2;
    const double way = effective_time(kept_velocity, seconds);
    spin_by(half_turn);
    place += right_ * l3d_from_double<T>(velocity.right * way) +
             up_ * l3d_from_double<T>(velocity.up * way) +
             forward_ * l3d_from_double<T>(velocity.forward * way);
    spin_by(half_turn);

    const double turning = std::pow(kept_spin, seconds * l3d_book_rate);
    const double moving = std::pow(kept_velocity, seconds * l3d_book_rate);
    for (double* s : {&spin.right, &spin.up, &spin.forward})
        slow_down(*s, turning, slowest_spin);
    for (double* v : {&velocity.right, &velocity.up, &velocity.forward})
        slow_down(*v, moving, slowest_velocity);
}

template <class T> l3d_matrix<T> l3d_moveable<T>::viewing_transform() const {
    l3d_matrix<T> m = l3d_identity<T>();
    for (int i = 0; i < 3; ++i) {
        m(0, i) = right_[i];
        m(1, i) = up_[i];
        m(2, i) = forward_[i];
    }
    m(0, 3) = -l3d_dot(right_, place.from_origin);
    m(1, 3) = -l3d_dot(up_, place.from_origin);
    m(2, 3) = -l3d_dot(forward_, place.from_origin);
    return m;
}

template <class T> l3d_matrix<T> l3d_moveable<T>::inverse_viewing_transform() const {
    return l3d_from_axes(right_, up_, forward_, place);
}

template class l3d_moveable<float>;
template class l3d_moveable<double>;
template class l3d_moveable<l3d_fixed<std::int64_t, 32>>;
