// SPDX-License-Identifier: MIT
// l3d_dispatcher: turns outside events into pipeline calls; and the factory that makes one.
#ifndef L3D_SYSTEM_DISPATCHER_H
#define L3D_SYSTEM_DISPATCHER_H

#include "base/public.h"
#include "base/error.h"
#include "tool_2d/event.h"
#include "tool_2d/screen.h"
#include "pipeline/caption.h"
#include "pipeline/pipeline.h"
#include "system/frame_settings.h"

#include <memory>
#include <string>
#include <utility>

/// The event loop of a program, which plugs in its pipeline and its screen and starts it.
///
/// Lives:   borrows pipeline and screen. Made before them (step 3 of 5), so it dies after them;
///          a signal that ended the loop is delivered then, when everything is closed.
class L3D_PUBLIC l3d_dispatcher {
public:
    l3d_dispatcher() = default;
    l3d_dispatcher(const l3d_dispatcher&) = delete;
    l3d_dispatcher& operator=(const l3d_dispatcher&) = delete;
    virtual ~l3d_dispatcher() = default;

    /// Names the application and the screen it draws into, which is also the source of events.
    void plug(l3d_pipeline& pipeline, l3d_screen& screen);

    /// Sets the caption that windows show on their pictures, for some seconds and when help is
    /// asked for.
    void set_caption(l3d_caption caption) { caption_ = std::move(caption); }

    /// Runs until the pipeline is done, the frames are made, or the display is lost.
    ///
    /// Expects: plug() was called.
    /// Errors: returns display_lost if the display is lost; throws l3d_error(failure) if a picture
    ///         cannot be written.
    l3d_exit start();

protected:
    /// Calls the pipeline as the event asks; a close event sets `done`. The caller looks after
    /// expose, resize (of its own state) and display_lost.
    static void deliver(const l3d_event& event, l3d_pipeline& pipeline);

private:
    virtual l3d_exit do_start(l3d_pipeline& pipeline, l3d_screen& screen) = 0;

    l3d_exit start_with_caption();

    l3d_pipeline* pipeline_ = nullptr;
    l3d_screen* screen_ = nullptr;
    l3d_caption caption_;
};

/// Makes dispatchers of one kind.
class L3D_PUBLIC l3d_dispatcher_factory {
public:
    l3d_dispatcher_factory() = default;
    l3d_dispatcher_factory(const l3d_dispatcher_factory&) = delete;
    l3d_dispatcher_factory& operator=(const l3d_dispatcher_factory&) = delete;
    virtual ~l3d_dispatcher_factory() = default;

    /// Makes a dispatcher with these settings.
    /// Errors: l3d_error(usage) if the settings name an impossible output.
    std::unique_ptr<l3d_dispatcher> create(const l3d_frame_settings& settings) const {
        return do_create(settings);
    }

private:
    virtual std::unique_ptr<l3d_dispatcher> do_create(const l3d_frame_settings& settings) const = 0;
};

#endif
