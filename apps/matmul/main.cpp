// SPDX-License-Identifier: MIT
// matmul: prints products of matrices, to show that their order matters.
#include <l3d/transform.h>
#include <l3d/options.h>

#include <iostream>

namespace {

using matrix = l3d_matrix<l3d_real>;
using vector = l3d_vector<l3d_real, 4>;

std::ostream& operator<<(std::ostream& out, const vector& v) {
    for (int i = 0; i < 4; ++i)
        out << (i == 0 ? "(" : ", ") << l3d_to_double(v[i]);
    return out << ')';
}

std::ostream& operator<<(std::ostream& out, const matrix& m) {
    for (int i = 0; i < 4; ++i)
        out << "\n    " << m.row(i);
    return out;
}

void print() {
    const auto a = l3d_scaling<l3d_real>(2, 2, 2);
    constexpr double numbers[16] = {1.1, 2.2,   3.3,   4.4,   5.5,   6.6,   7.7,   8.8,
                                    9.9, 10.10, 11.11, 12.12, 13.13, 14.14, 15.15, 16.16};
    matrix b;
    for (int i = 0; i < 16; ++i)
        b(i / 4, i % 4) = l3d_from_double<l3d_real>(numbers[i]);
    const auto real = [](double number) { return l3d_from_double<l3d_real>(number); };
    const vector p(real(5), real(6), real(7), real(1));
    std::cout << "a =" << a << "\nb =" << b << "\np = " << p << '\n'
              << "a b =" << a * b << "\nb a =" << b * a << '\n'
              << "a p = " << a * p << '\n'
              << "b p = " << b * p << '\n'
              << "(a b) p = " << (a * b) * p << '\n'
              << "(b a) p = " << (b * a) * p << '\n';
}

} // namespace

int main(int argc, char** argv) try {
    l3d_options options("matmul", "Products of matrices, as text.", {320, 200});
    bool is_classic = false;
    options.add("--classic", is_classic, "the numbers alone, as in the book");
    if (options.parse(argc, argv)) {
        if (!is_classic)
            std::cout << "Matrices change points from the right to the left: (a b) p does b first, "
                         "so a b is not b a.\n\n";
        print();
    }
    return static_cast<int>(std::cout.flush() ? l3d_exit::success : l3d_exit::failure);
} catch (const std::exception& error) {
    return l3d_report("matmul", error);
}
