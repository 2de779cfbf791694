// SPDX-License-Identifier: MIT
// l3d_dispatcher_window: the dispatcher of programs with a window.
#ifndef L3D_SYSTEM_DISPATCHER_WINDOW_H
#define L3D_SYSTEM_DISPATCHER_WINDOW_H

#include "system/dispatcher.h"
#include "system/frame_writer.h"
#include "system/signal_watch.h"

#include <optional>

/// The event loop of programs with a window. It handles all pending events, makes a frame when a
/// frame is due, and sleeps in between. A frame is drawn and shown only if the pipeline needs a new
/// picture or the window has a new size. A hidden window gets no frames, unless frames are counted
/// or written. A window that was uncovered shows its last picture again. If the window fills the
/// display, Escape gives the window its old place and size; only a second Escape reaches the
/// program. The signals of l3d_signal_watch end the loop within 0.2 s.
class l3d_dispatcher_window final : public l3d_dispatcher {
public:
    /// Errors:  as the constructor of l3d_frame_writer.
    explicit l3d_dispatcher_window(const l3d_frame_settings& settings);

private:
    class loop;

    l3d_exit do_start(l3d_pipeline& pipeline, l3d_screen& screen) override;

    l3d_frame_settings settings_;
    l3d_frame_writer writer_;
    /// Watches for signals while the loop runs. It is kept until the screen is closed.
    std::optional<l3d_signal_watch> signals_;
};

/// Makes dispatchers for programs with a window.
class l3d_dispatcher_factory_window final : public l3d_dispatcher_factory {
private:
    /// Errors:  as the constructor of l3d_frame_writer.
    std::unique_ptr<l3d_dispatcher> do_create(const l3d_frame_settings& settings) const override;
};

#endif
