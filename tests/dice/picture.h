// SPDX-License-Identifier: MIT
// A picture that pieces are drawn into.
#ifndef L3D_TESTS_DICE_PICTURE_H
#define L3D_TESTS_DICE_PICTURE_H

#include "scene/camera_shading.h"
#include "dice/diced_piece.h"
#include "raster/surfaces/surface_rasterizer_sw.h"
#include "reference/views.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace dice_tests {

/// Draws what it is given. Cleared when made and by `clear`.
class picture {
public:
    explicit picture(l3d_size size, const l3d_camera& camera = {})
        : size_(size),
          shading_(l3d_camera_shading(camera, size, l3d_shade::lambert,
                                      {reference::project_light.x, reference::project_light.y,
                                       reference::project_light.z})) {
        words_.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
        depth_.resize(size);
        clear();
    }

    void clear() {
        rasterizer_.begin({words_.data(), size_.width, size_.height, size_.width}, &depth_,
                          shading_);
        rasterizer_.draw({});
    }

    void draw(std::span<const l3d_diced_piece> pieces, double) {
        parts_.clear();
        for (const l3d_diced_piece& piece : pieces)
            parts_.push_back(&piece.part);
        rasterizer_.draw(parts_);
    }

    l3d_size size() const { return size_; }
    const std::vector<std::uint32_t>& words() const { return words_; }

    float inv_w(int x, int y) const { return depth_.row(y)[static_cast<std::size_t>(x)]; }
    bool covered(int x, int y) const { return inv_w(x, y) > 0; }

    std::int64_t uncovered() const {
        std::int64_t result = 0;
        for (int y = 0; y < size_.height; ++y)
            for (const float inv_w : depth_.row(y))
                result += inv_w <= 0;
        return result;
    }

    /// Distances along the view axis, infinite where nothing is.
    std::vector<float> distances() const {
        std::vector<float> result;
        for (int y = 0; y < size_.height; ++y)
            for (const float inv_w : depth_.row(y))
                result.push_back(inv_w > 0 ? 1 / inv_w : std::numeric_limits<float>::infinity());
        return result;
    }

    std::vector<unsigned char> greys() const {
        std::vector<unsigned char> result;
        for (const std::uint32_t word : words_)
            result.push_back(static_cast<unsigned char>(word & 0xff));
        return result;
    }

private:
    l3d_size size_;
    l3d_shading shading_;
    std::vector<std::uint32_t> words_;
    l3d_depth_buffer depth_;
    std::vector<const l3d_surface_part*> parts_;
    l3d_workers workers_{1};
    l3d_surface_rasterizer_sw rasterizer_{workers_};
};

} // namespace dice_tests

#endif
