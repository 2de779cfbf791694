// SPDX-License-Identifier: MIT
// image_sampler: the colours that pixels of a picture get from an image.
#ifndef L3D_RASTER_IMAGES_IMAGE_SAMPLER_P_H
#define L3D_RASTER_IMAGES_IMAGE_SAMPLER_P_H

#include "raster/placement_2d.h"
#include "raster/paths/path.h"
#include "raster/color/color_mixer_p.h"

#include <cstdint>
#include <vector>

namespace l3d_detail {

/// Finds the colours of a picture's pixels in a placed image, by the inverse of its placement.
///
/// In the image, pixel (i, j) is the square [i, i + 1) x [j, j + 1).
/// Lives:   borrows the image and the mixer.
class image_sampler {
public:
    image_sampler(const l3d_placed_image& image, const color_mixer& mixer);

    /// The part of the picture that the image may reach. This part is the image's outline, or for
    /// l3d_image_filter::nearest an axis-aligned box of whole pixels around this outline. The path
    /// is empty if nothing is to be drawn.
    l3d_path reach() const;

    /// Whether the image is only moved by whole pixels. If so, moved_x() and moved_y() tell how far
    /// the image is moved to the right and down.
    bool is_moved_only() const { return moved_only_; }
    std::int32_t moved_x() const { return moved_x_; }
    std::int32_t moved_y() const { return moved_y_; }

    /// The colour that the image's filter gives to the picture's pixel (x, y). The filter `area`
    /// takes the mean over the part of the pixel's square that lies in the image.
    mixed_color at(std::int32_t x, std::int32_t y);

private:
    l3d_point_2d back(double x, double y) const;
    double opacity(std::uint32_t word) const {
        return image_.transparent ? (255 - (word >> 24)) / 255.0 : 1;
    }
    mixed_color color(int column, int row) const;
    mixed_color nearest(l3d_point_2d at) const;
    mixed_color linear(l3d_point_2d at) const;
    mixed_color box_mean(l3d_point_2d from, l3d_point_2d to) const;
    mixed_color area_mean(std::int32_t x, std::int32_t y);
    void add_edge(l3d_point_2d from, l3d_point_2d to);
    void add_in_row(int row, double from, double to, double height);
    void add_in_cell(int row, int column, double from, double to, double height);

    const l3d_placed_image& image_;
    const color_mixer& mixer_;
    double determinant_;
    bool upright_, moved_only_;
    std::int32_t moved_x_ = 0, moved_y_ = 0;
    // for area_mean: the columns and rows of the image that a pixel reaches
    int first_column_ = 0, first_row_ = 0, columns_ = 0, rows_ = 0;
    /// For each row of the image, differences of the covered area from column to column.
    std::vector<double> areas_;
};

} // namespace l3d_detail

#endif
