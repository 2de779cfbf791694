// SPDX-License-Identifier: MIT
// l3d_image_transform: scaling and error bound of the transform.
#include "pipeline/image_transform.h"

#include <algorithm>
#include <cmath>

namespace {

/// The largest power of two not above value; 1 for 0.
double power_below(double value) {
    return value > 0 ? std::exp2(std::floor(std::log2(value))) : 1;
}

} // namespace

template <class Wide>
l3d_image_transform<Wide>::l3d_image_transform(const l3d_camera& camera, l3d_size size,
                                               const l3d_patch_model& model)
    : size_(size), near_(camera.near), far_(camera.far) {
    const double focal = camera.focal_length(size);
    double largest = 0;  // of the model's coordinates
    double farthest = 0; // bound of the distance of any control point from the eye
    for (int i = 0; i < 3; ++i) {
        largest = std::max({largest, std::abs(model.least()[i]), std::abs(model.most()[i])});
        farthest += std::max(std::abs(model.least()[i] - camera.eye[i]),
                             std::abs(model.most()[i] - camera.eye[i]));
    }
    if constexpr (l3d_is_fixed<Wide>) {
        model_scale_ = power_below(0x1p10 / std::max(largest, 1e-30));
        depth_scale_ = power_below(std::min(0x1p8, 0x1p28 / focal) / std::max(farthest, 1e-30));
    }
    const l3d_matrix<double> exact = camera.image_matrix(size);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix_(row, column) = l3d_from_double<Wide>(exact(row, column) * depth_scale_ /
                                                         (column < 3 ? model_scale_ : 1.0));

    // Doubles: the matrix (axes, products) is good to some 16 ulps of |direction| (|p| + |eye|),
    // four products and three sums add at most 8 more; a patch cut in 50 halvings is rounded at
    // its own size first, not at that of its pieces, at 3 midpoints each. Fixed: matrix entries
    // and model points are off by half an ulp each, as is the one rounding of the sum.
    using traits = l3d_real_traits<Wide>;
    double eye = 0;
    for (int i = 0; i < 3; ++i)
        eye += std::abs(camera.eye[i]);
    const double terms = 3 * largest + eye;
    double slope_xy = 0, slope_w = 0;
    for (int column = 0; column < 3; ++column) {
        slope_xy += std::max(std::abs(exact(0, column)), std::abs(exact(1, column)));
        slope_w += std::abs(exact(3, column));
    }
    const double rounding = (3 * largest * model_scale_ + 2) * traits::half_ulp;
    const double to_entries = depth_scale_ / model_scale_ * traits::half_ulp;
    const double roundings = (l3d_is_fixed<Wide> ? 24 : 24 + 3 * 50) * 0x1p-53;
    error_xy_ = roundings * focal * terms * depth_scale_ + rounding + slope_xy * to_entries;
    error_w_ = roundings * terms * depth_scale_ + rounding + slope_w * to_entries;
}

template <class Wide> l3d_dice_view l3d_image_transform<Wide>::view(double tolerance) const {
    l3d_dice_view view;
    view.size = size_;
    view.near = near_ * depth_scale_;
    view.far = far_ * depth_scale_;
    view.tolerance = tolerance;
    view.depth_scale = depth_scale_;
    view.error_xy = error_xy_;
    view.error_w = error_w_;
    return view;
}

template <class Wide>
l3d_bezier_patch<Wide, 3>
l3d_image_transform<Wide>::operator()(const l3d_patch_model::patch& patch) const {
    l3d_bezier_patch<Wide, 3> result;
    for (std::size_t i = 0; i < 16; ++i) {
        l3d_vector<Wide, 4> p;
        for (int k = 0; k < 3; ++k)
            p[k] = l3d_from_double<Wide>(patch.points[i][k] * model_scale_);
        p[3] = Wide(1);
        const l3d_vector<Wide, 4> h = matrix_ * p;
        result.points[i][0] = h[0];
        result.points[i][1] = h[1];
        result.points[i][2] = h[3];
    }
    return result;
}

template class l3d_image_transform<double>;
template class l3d_image_transform<l3d_fixed<std::int64_t, 32>>;
