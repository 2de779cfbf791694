// SPDX-License-Identifier: MIT
// l3d_pipeline_afd_viewer: patches that can be turned, zoomed and inspected with keys and mouse.
#ifndef L3D_PIPELINE_PIPELINE_AFD_VIEWER_H
#define L3D_PIPELINE_PIPELINE_AFD_VIEWER_H

#include "base/public.h"
#include "pipeline/part_switch.h"
#include "pipeline/pipeline_afd.h"
#include "pipeline/viewer_controls.h"

#include <string>
#include <vector>

/// l3d_pipeline_afd with the controls that its help overlay lists.
class L3D_PUBLIC l3d_pipeline_afd_viewer : public l3d_pipeline_afd {
public:
    using l3d_pipeline_afd::l3d_pipeline_afd;

    /// The viewer's keys, mouse and lines of text.
    l3d_viewer_controls& controls() { return controls_; }
    /// The same, read-only.
    const l3d_viewer_controls& controls() const { return controls_; }

    void any_event(const l3d_event& event) override { controls_.note(event); }
    void key_event(int key) override;
    void pointer_event(const l3d_event& event) override;
    void resize_event(l3d_size size) override;
    void update_event(double seconds) override;
    void draw_event() override;
    /// Time alone changes only what controls() change. A subclass that overrides update_event
    /// overrides this, too.
    bool is_at_rest() const override { return controls_.is_at_rest(); }
    double rest_left() const override { return controls_.rest_left(); }
    void rest_event(double seconds) override;

protected:
    /// The title of the scale of mode `error`. A subclass that shows more than bounds overrides it.
    virtual std::string error_scale_title() const { return "bound of the error, in pixels"; }

    /// A panel that a subclass has in every picture. The viewer's panels keep clear of it.
    virtual l3d_standing_panel standing_panel() { return {}; }

private:
    void draw_panels() override;
    std::vector<l3d_viewer_row> own_rows();
    l3d_viewed viewed();
    void scale_tolerance(double factor);
    void take_next_shade();
    void take_next_inspection();
    void add_inspection(l3d_panel& panel);
    void switch_wireframe();
    void switch_antialias();
    void tell_of_part(std::string line);
    l3d_panel legend();

    l3d_part_switch parts_{scene()};
    bool marks_part_ = false; ///< the picture marks a part until the next key
    l3d_viewer_controls controls_{
        *this, screen(), camera(), own_rows(), [this] { parts_.show_all(); }, viewed(), font()};
};

#endif
