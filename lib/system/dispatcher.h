// SPDX-License-Identifier: MIT
// l3d_dispatcher: turns outside events into pipeline calls; its kinds, and the factories that make
// them.
#ifndef L3D_SYSTEM_DISPATCHER_H
#define L3D_SYSTEM_DISPATCHER_H

#include "base/error.h"
#include "base/public.h"
#include "pipeline/pipeline.h"
#include "system/frame_writer.h"
#include "tool_2d/event.h"
#include "tool_2d/screen.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

/// The event loop of a program: turns outside events into calls of the pipeline. The program plugs
/// in its pipeline and its screen, and starts the loop.
///
/// Lives:   borrows pipeline and screen. The dispatcher is made before both (step 3 of 5), and so
///          is destroyed after both. If a signal ended the loop, the dispatcher's destructor raises
///          the signal again, when everything is closed.
class L3D_PUBLIC l3d_dispatcher {
public:
    l3d_dispatcher() = default;
    l3d_dispatcher(const l3d_dispatcher&) = delete;
    l3d_dispatcher& operator=(const l3d_dispatcher&) = delete;
    virtual ~l3d_dispatcher() = default;

    /// Sets the pipeline to drive, and the screen that the pipeline draws into. The screen is also
    /// the source of events.
    void plug(l3d_pipeline& pipeline, l3d_screen& screen);

    /// Sets the caption that windows show on top of their pictures: for some seconds, and when the
    /// user asks for help.
    void set_caption(l3d_caption caption) { caption_ = std::move(caption); }

    /// Runs the loop until the pipeline is done, all frames are made, a signal asks for the end, or
    /// the display is lost.
    ///
    /// Errors: returns display_lost if the display is lost. Throws l3d_error(failure) if a picture
    ///         cannot be written, or if plug() was not called.
    l3d_exit start();

protected:
    /// Calls the pipeline's functions for an event; a close event sets `done`. The caller itself
    /// handles the events expose and display_lost, and updates its own state for resize.
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
    /// Errors: l3d_error(usage) if no file can have the settings' output name.
    std::unique_ptr<l3d_dispatcher> create(const l3d_frame_settings& settings) const {
        return do_create(settings);
    }

private:
    virtual std::unique_ptr<l3d_dispatcher> do_create(const l3d_frame_settings& settings) const = 0;
};

/// A dispatcher for back-ends that open a window only where there is a display. If its screen is a
/// window, it works as the dispatcher for windows, else as l3d_dispatcher_script without a script.
class L3D_PUBLIC l3d_dispatcher_fitting final : public l3d_dispatcher {
public:
    /// Errors:  as the constructor of l3d_frame_writer.
    explicit l3d_dispatcher_fitting(const l3d_frame_settings& settings);

private:
    l3d_exit do_start(l3d_pipeline& pipeline, l3d_screen& screen) override;

    l3d_frame_settings settings_;
    /// The dispatcher that does the work, kept until the screen is closed.
    std::unique_ptr<l3d_dispatcher> fitting_;
};

/// Makes dispatchers for a back-end whose screens are windows only where there is a display.
class L3D_PUBLIC l3d_dispatcher_factory_fitting final : public l3d_dispatcher_factory {
private:
    /// Errors:  as the constructor of l3d_frame_writer.
    std::unique_ptr<l3d_dispatcher> do_create(const l3d_frame_settings& settings) const override;
};

/// An event of a script, and the frame before which the event happens.
struct L3D_PUBLIC l3d_script_event {
    int frame = 0;   ///< the number of the frame, from 0
    l3d_event event; ///< the event
};

/// A dispatcher without a window, which replays a script of events. It makes frames as fast as it
/// can. In the pipeline's world, a fixed step of time lies between two frames. If the settings give
/// no number of frames, it makes one frame. The same script gives the same pictures every time.
class L3D_PUBLIC l3d_dispatcher_script final : public l3d_dispatcher {
public:
    /// Takes a script of events to replay.
    /// Expects: the script is sorted by its frames.
    /// Errors:  as the constructor of l3d_frame_writer.
    explicit l3d_dispatcher_script(const l3d_frame_settings& settings,
                                   std::vector<l3d_script_event> script = {});

private:
    l3d_exit do_start(l3d_pipeline& pipeline, l3d_screen& screen) override;

    l3d_frame_settings settings_;
    std::vector<l3d_script_event> script_;
    l3d_frame_writer writer_;
};

/// Makes dispatchers that have no script to replay.
class L3D_PUBLIC l3d_dispatcher_factory_script final : public l3d_dispatcher_factory {
private:
    /// Errors:  as the constructor of l3d_frame_writer.
    std::unique_ptr<l3d_dispatcher> do_create(const l3d_frame_settings& settings) const override;
};

#endif
