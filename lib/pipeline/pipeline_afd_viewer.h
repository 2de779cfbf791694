// SPDX-License-Identifier: MIT
// l3d_pipeline_afd_viewer: patches that can be turned, zoomed and inspected with keys and mouse.
#ifndef L3D_PIPELINE_PIPELINE_AFD_VIEWER_H
#define L3D_PIPELINE_PIPELINE_AFD_VIEWER_H

#include "pipeline/pipeline_afd.h"

#include <functional>
#include <string>
#include <utility>

/// l3d_pipeline_afd with the controls that its help overlay lists.
class l3d_pipeline_afd_viewer : public l3d_pipeline_afd {
public:
    using l3d_pipeline_afd::l3d_pipeline_afd;

    /// The eye circles the target by this angle from frame to frame (per 1 / fps of a second
    /// where time is measured); the first frame is not turned. Units: degrees; frames a second.
    void set_turntable(double degrees_per_frame, double fps);

    /// What the key s does with the picture; without one it does nothing.
    /// The function returns a line to show, such as the file's name.
    void set_screenshot(std::function<std::string(const l3d_pixels&)> save) {
        save_ = std::move(save);
    }

    void key_event(int key) override;
    void pointer_event(const l3d_event& event) override;
    void update_event(double seconds) override;

protected:
    void draw_overlay() override;

private:
    bool view_key(int key);
    bool look_key(int key);
    void set_tolerance(double pixels);
    void say(std::string line);

    double turntable_degrees_ = 0; ///< per second
    bool first_frame_ = true;
    bool paused_ = false;
    bool status_shown_ = false;
    bool help_shown_ = false;
    std::string message_;
    double smoothed_seconds_ = 0; ///< between frames
    int pointer_x_ = 0, pointer_y_ = 0;
    std::function<std::string(const l3d_pixels&)> save_;
};

#endif
