// SPDX-License-Identifier: MIT
// captioned: a pipeline with its caption on top of the pictures.
#ifndef L3D_PIPELINE_CAPTIONED_P_H
#define L3D_PIPELINE_CAPTIONED_P_H

#include "pipeline/pipeline.h"
#include "raster/text/panel.h"
#include "raster/shapes/rasterizer_2d_sw.h"
#include "tool_2d/screen.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace l3d_detail {

/// Draws a program's caption on the finished pictures of a pipeline, and hands every call on to
/// that pipeline. Before the pipeline draws again, the pixels that the caption covered are
/// restored, since some programs draw on top of the last picture.
///
/// For some seconds after the start, a panel tells the subject, the lesson, and some keys. If this
/// panel would hide much of the picture, it tells less: at least the key that lists all keys, or
/// else it is left out. The help keys show all keys, page after page, and then hide the help.
/// Another panel shows the pipeline's message.
///
/// Lives: borrows pipeline and screen.
class captioned final : public l3d_pipeline {
public:
    /// Units: `hint_seconds`: seconds for which the first panel stays.
    captioned(l3d_pipeline& shown, l3d_screen& screen, l3d_caption caption, l3d_font font,
              double hint_seconds);

    void any_event(const l3d_event& event) override;
    void key_event(int key) override;
    void pointer_event(const l3d_event& event) override;
    void resize_event(l3d_size size) override;
    void update_event(double seconds) override;
    void draw_event() override;
    void interrupt_when(std::function<bool()> wanted) override {
        shown_.interrupt_when(std::move(wanted));
    }
    l3d_pixel_box changed() const override { return changed_; }
    void frame_event(const l3d_frame_times& times) override;
    bool skip_event() override;
    bool is_at_rest() const override { return shown_.is_at_rest(); }
    double rest_left() const override;
    void rest_event(double seconds) override;
    bool needs_redraw() const override { return is_old_ || shown_.needs_redraw(); }
    std::string take_remark() override { return shown_.take_remark(); }

private:
    bool hint_is_shown() const { return hint_seconds_ > 0; }
    void pass_hint(double seconds);
    void follow() { done |= shown_.done; }
    void uncover();
    void cover();
    l3d_panel_style style() const;
    std::vector<l3d_panel> help_pages() const;
    void draw(l3d_rasterizer_2d& rasterizer, const l3d_panel& panel, l3d_corner corner);
    bool draws_a_hint(l3d_rasterizer_2d& rasterizer);
    std::vector<l3d_panel> hints() const;

    l3d_pipeline& shown_;
    l3d_screen& screen_;
    l3d_caption caption_;
    l3d_font font_;
    double hint_seconds_;       ///< seconds for which the panel of the start still stays
    std::size_t help_page_ = 0; ///< number of the page of help that is shown, from 1; 0 if none is
    bool is_old_ = false;       ///< the panels in the picture are out of date
    std::vector<std::uint32_t> picture_;
    l3d_pixel_box covered_, changed_;
    std::vector<l3d_pixel_box> texts_; ///< the boxes of the panels in the picture
};

} // namespace l3d_detail

#endif
