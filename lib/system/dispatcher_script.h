// SPDX-License-Identifier: MIT
// l3d_dispatcher_script: the dispatcher without a display; replays a list of events.
#ifndef L3D_SYSTEM_DISPATCHER_SCRIPT_H
#define L3D_SYSTEM_DISPATCHER_SCRIPT_H

#include "base/public.h"
#include "system/dispatcher.h"
#include "system/frame_writer.h"

#include <vector>

/// An event and the frame (from 0) before which it happens.
struct L3D_PUBLIC l3d_script_event {
    int frame = 0;   ///< the number of the frame, from 0
    l3d_event event; ///< the event
};

/// Makes frames as fast as it can, each a fixed step of time after the one before; one frame if
/// the settings say none. The same script gives the same pictures every time.
class L3D_PUBLIC l3d_dispatcher_script final : public l3d_dispatcher {
public:
    /// Expects: the script in the order of its frames.
    /// Errors:  as l3d_frame_writer.
    explicit l3d_dispatcher_script(const l3d_frame_settings& settings,
                                   std::vector<l3d_script_event> script = {});

private:
    l3d_exit do_start(l3d_pipeline& pipeline, l3d_screen& screen) override;

    l3d_frame_settings settings_;
    std::vector<l3d_script_event> script_;
    l3d_frame_writer writer_;
};

/// Makes dispatchers that have no events to replay.
class L3D_PUBLIC l3d_dispatcher_factory_script final : public l3d_dispatcher_factory {
private:
    /// Errors:  as l3d_frame_writer.
    std::unique_ptr<l3d_dispatcher> do_create(const l3d_frame_settings& settings) const override;
};

#endif
