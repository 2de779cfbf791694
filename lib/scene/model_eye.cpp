// SPDX-License-Identifier: MIT
// l3d_eye_of, l3d_least_w_of: find the eye in a model's coordinates, and its box's least w.
#include "scene/model_eye.h"

#include <cmath>

namespace {

using vector = l3d_vector<double, 3>;

/// The first three numbers of a matrix' row, without the constant.
vector linear(const l3d_matrix<double>& m, int row) {
    return {m(row, 0), m(row, 1), m(row, 2)};
}

constexpr int x = 0, y = 1, w = 3; ///< rows of to_image

} // namespace

/// Source: Cramer's rule.
std::optional<vector> l3d_eye_of(const l3d_matrix<double>& to_image) {
    const vector of_x = linear(to_image, x), of_y = linear(to_image, y), of_w = linear(to_image, w);
    const vector yw = l3d_cross<double>(of_y, of_w);
    const double determinant = l3d_dot(of_x, yw);
    const vector eye = (yw * to_image(x, 3) + l3d_cross<double>(of_w, of_x) * to_image(y, 3) +
                        l3d_cross<double>(of_x, of_y) * to_image(w, 3)) *
                       (-1 / determinant);
    if (!std::isfinite(l3d_dot(eye, eye)))
        return std::nullopt;
    return eye;
}

double l3d_least_w_of(const l3d_patch_model& model, const l3d_matrix<double>& to_image) {
    double least = to_image(w, 3);
    for (int k = 0; k < 3; ++k)
        least += to_image(w, k) * (to_image(w, k) > 0 ? model.least()[k] : model.most()[k]);
    return least;
}
