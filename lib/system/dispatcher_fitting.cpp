// SPDX-License-Identifier: MIT
// l3d_dispatcher_fitting: chooses a window's dispatcher, or a script's.
#include "system/dispatcher.h"

#include "system/dispatcher_window.h"
#include "system/frame_writer.h"

l3d_dispatcher_fitting::l3d_dispatcher_fitting(const l3d_frame_settings& settings)
    : settings_(settings) {
    l3d_frame_writer{settings.output}; // tells faults early, before there is a window
}

l3d_exit l3d_dispatcher_fitting::do_start(l3d_pipeline& pipeline, l3d_screen& screen) {
    if (screen.is_window())
        fitting_ = std::make_unique<l3d_dispatcher_window>(settings_);
    else
        fitting_ = std::make_unique<l3d_dispatcher_script>(settings_);
    fitting_->plug(pipeline, screen);
    return fitting_->start();
}

std::unique_ptr<l3d_dispatcher>
l3d_dispatcher_factory_fitting::do_create(const l3d_frame_settings& settings) const {
    return std::make_unique<l3d_dispatcher_fitting>(settings);
}
