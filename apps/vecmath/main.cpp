// SPDX-License-Identifier: MIT
// vecmath: prints sums and products of points and vectors.
#include <l3d/transform.h>
#include <l3d/options.h>

#include <iostream>

namespace {

using point = l3d_point<l3d_real>;
using vector = point::vector;

double number(l3d_real x) {
    return l3d_to_double(x);
}

/// Prints a place with w = 1 or a direction with w = 0. The library tells them apart by types, not
/// by w.
std::ostream& print(std::ostream& out, const vector& v, int w) {
    return out << '(' << number(v[0]) << ", " << number(v[1]) << ", " << number(v[2]) << ", " << w
               << ')';
}
std::ostream& operator<<(std::ostream& out, const point& p) {
    return print(out, p.from_origin, 1);
}
std::ostream& operator<<(std::ostream& out, const vector& v) {
    return print(out, v, 0);
}

void print() {
    const auto p1 = point::of(5, 5, 5), p2 = point::of(2, 7, 3);
    const auto v1 = point::of(1, 0, 0).from_origin, v2 = point::of(0, 1, 0).from_origin;
    const auto v3 = point::of(1, 1, 0).from_origin, zero = point::of(0, 0, 0).from_origin;
    std::cout << "points            P1 = " << p1 << "  P2 = " << p2 << '\n'
              << "vectors           v1 = " << v1 << "  v2 = " << v2 << "  v3 = " << v3 << '\n'
              << "P2 - P1              = " << (p2 - p1) << "  a vector\n"
              << "P1 + (P2 - P1)       = " << (p1 + (p2 - p1)) << "  a point\n"
              << "v1 + v2              = " << (v1 + v2) << '\n'
              << "v3 * 2.5             = " << (v3 * l3d_from_double<l3d_real>(2.5)) << '\n'
              << "v1 . v3              = " << number(l3d_dot(v1, v3)) << '\n'
              << "v1 x v2              = " << l3d_cross(v1, v2) << '\n'
              << "v2 x v1              = " << l3d_cross(v2, v1) << '\n'
              << "|P2 - P1|            = " << number(l3d_length(p2 - p1)) << '\n'
              << "v3 / |v3|            = " << l3d_normalized(v3) << '\n'
              << "0 / |0|              = " << l3d_normalized(zero) << "  as it is\n";
}

} // namespace

int main(int argc, char** argv) try {
    l3d_options options("vecmath", "Sums and products of points and vectors, as text.", {320, 200});
    bool is_classic = false;
    options.add("--classic", is_classic, "the numbers alone, as in the book");
    if (options.parse(argc, argv)) {
        if (!is_classic)
            std::cout << "The difference of two points is a vector; a point and a vector make a "
                         "point; two points have no sum.\n\n";
        print();
    }
    return static_cast<int>(std::cout.flush() ? l3d_exit::success : l3d_exit::failure);
} catch (const std::exception& error) {
    return l3d_report("vecmath", error);
}
