// SPDX-License-Identifier: MIT
// frame_measure: the cost and the errors of a method's frames.
#ifndef L3D_APPS_TEAPOT_AFD_FRAME_MEASURE_H
#define L3D_APPS_TEAPOT_AFD_FRAME_MEASURE_H

#include "compare/method_choice.h"
#include <l3d/pipeline_afd.h>
#include "reference/exact.h"
#include "reference/measure.h"
#include "reference/region.h"

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

/// A view of a model, with its exact picture, to measure errors of other pictures of this view.
class measured_view {
public:
    /// Makes a view, and draws its exact picture.
    /// Cost:    some us for each pixel that the model covers.
    /// Errors:  std::runtime_error if the exact renderer gives up, or if `stop` is requested.
    measured_view(std::string name, const l3d_patch_model& model, const l3d_camera& camera,
                  l3d_size size, std::stop_token stop = {});

    const std::string& name() const { return name_; }
    const l3d_patch_model& model() const { return model_; }
    const l3d_camera& camera() const { return camera_; }
    l3d_size size() const { return size_; }

    /// The grey levels of the exact picture in the usual light, row by row; 0 where no surface is.
    const std::vector<unsigned char>& levels() const { return levels_; }
    const reference::exact_image& exact() const { return exact_; }

    /// The error of each pixel of another picture of the view. `distances` are that picture's, row
    /// by row. At most some `most_distances` pixels of outlines are measured.
    /// Errors: as the constructor.
    reference::error_map errors(const std::vector<float>& distances, int most_distances) const {
        return reference::map_errors(distances, exact_, region_, most_distances, stop_);
    }

private:
    std::string name_;
    const l3d_patch_model& model_;
    l3d_camera camera_;
    l3d_size size_;
    std::stop_token stop_;
    std::vector<reference::patch> patches_;
    reference::exact_image exact_;
    reference::exact_region region_;
    std::vector<unsigned char> levels_;
};

/// The way to draw a picture: by a method for patches, or as polygons, sorted by depth or with a
/// depth buffer.
enum class drawn_as { patches, zsort, zbuffer };

/// The subject of a measurement: a method and its tolerance, or a pipeline of polygons. For
/// polygons, the method's resolution is the number of quads along each side of a patch.
struct measured_setting {
    l3d_method_choice method;
    double tolerance = 0.25;
    drawn_as as = drawn_as::patches;
    bool places_only = false; ///< whether the tolerance is for places in the picture alone

    /// Name of the setting's line in a diagram; all points of the line share it.
    std::string series() const;
    std::string label() const; ///< name of the setting's point in the line
};

/// A row of the report: time and errors of one setting in one view. Unknown values are NaN.
struct frame_result {
    std::string model, view, series, label;
    /// The number of the model's patches.
    std::int64_t patches = 0;
    /// The shortest and the median time of a frame.
    double least_ms = 0, median_ms = 0;
    /// The time of the very first frame.
    double first_ms = 0;
    int frames = 0;
    std::int64_t samples = 0, quads = 0, failures = 0;
    /// The certified bound of places; infinite if there is none.
    double bound_px = 0;
    /// The largest measured error of an outline.
    double outline_px = 0;
    /// The largest and the mean error of depth.
    double largest_px = 0, mean_px = 0;
    /// The error of depth that 999 of 1000 errors do not exceed.
    double percentile_px = 0;
    /// The share of covered pixels in which depths could be compared.
    double judged = 0;
    /// The root mean square error of greys, over the pixels that either picture covers.
    double rms_levels = 0;
    std::int64_t holes = 0;
};

/// The results of measure_frames: a row of the report, and the error of each pixel.
struct measured_frames {
    frame_result row;
    reference::error_map errors;
};

/// Measures the time and the errors of a setting in a view. For about `seconds`, it draws the model
/// on one thread, each time from a slightly different place. Then it draws the view itself, and
/// compares this picture with the exact one. At most some `most_distances` pixels of outlines are
/// measured.
measured_frames measure_frames(const measured_view& view, const measured_setting& setting,
                               double seconds, int most_distances);

#endif
