// SPDX-License-Identifier: MIT
// l3d_factory_manager: the table of back-ends, and the choice among them.
#ifndef L3D_SYSTEM_FACTORY_MANAGER_H
#define L3D_SYSTEM_FACTORY_MANAGER_H

#include "base/public.h"
#include "tool_2d/screen.h"
#include "raster/rasterizer_factory.h"
#include "system/dispatcher.h"

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

class l3d_options;

/// A back-end: a way to show pictures. Back-ends are the rows of the table of l3d_factory_manager.
struct L3D_PUBLIC l3d_backend {
    std::string name;    ///< the back-end's name, as --backend takes it
    std::string purpose; ///< the back-end's use, in a few words
    /// Whether the back-end is chosen without a question if it is the first row that can serve.
    bool automatic = false;
    bool on_display = false;   ///< whether the back-end needs a display
    bool unseen = false;       ///< whether nobody sees its pictures unless --output names a file
    bool writes_files = false; ///< whether it writes its pictures to files itself
    /// Whether this row is a variant of another row, as mesa:egl is a variant of mesa.
    /// --list-backends lists variants; the prompt does not.
    bool variant = false;
    std::unique_ptr<l3d_screen_factory> screen_factory; ///< makes the back-end's screens
    /// Makes the back-end's rasterizers; canvases share the factory.
    std::shared_ptr<const l3d_rasterizer_factory> rasterizer_factory;
    std::unique_ptr<l3d_dispatcher_factory>
        dispatcher_factory; ///< Makes the event loops of programs on this back-end.
};

/// Knows all back-ends, as the rows of a table. It asks each back-end whether it can serve here,
/// and chooses one of them.
///
/// No other place in the library names concrete kinds of back-ends. The manager is no global
/// object: each program has one in main.
class L3D_PUBLIC l3d_factory_manager {
public:
    /// Makes the rows of the library: xshm, ximage, mesa and its variants mesa:egl and mesa:osmesa,
    /// memory.
    l3d_factory_manager();
    l3d_factory_manager(const l3d_factory_manager&) = delete;
    l3d_factory_manager& operator=(const l3d_factory_manager&) = delete;
    ~l3d_factory_manager();

    /// Adds a row at the end of the table.
    /// Expects: choose() was not called yet.
    /// Errors:  throws l3d_error if the row lacks a factory, or another row has its name.
    void add(l3d_backend row);

    /// Chooses the back-end that --backend names, else the variable L3D_BACKEND, else the program
    /// itself. If none of these names a back-end, choose() asks the user at a terminal. Without a
    /// terminal it takes the first automatic row that can serve. If nobody would see the pictures,
    /// stderr gets a line that says so. In this case --output becomes `program`.png, unless the
    /// user named a back-end that shows nothing.
    ///
    /// Returns: false if the program has nothing more to do: --list-backends or --diagnose was
    ///          answered, or the user answered q at the prompt.
    ///
    /// Errors:  l3d_error: usage for an unknown name; no_display, with DISPLAY's value, if no
    ///          display can be opened; otherwise no_backend, with all reasons.
    bool choose(l3d_options& options);

    /// As choose(options), with the streams of the prompt. `may_ask` says whether the user may be
    /// asked, since both streams are a terminal.
    bool choose(l3d_options& options, std::istream& in, std::ostream& out, bool may_ask);

    /// The row that choose() took.
    /// Errors: throws l3d_error if choose() was not called, or took none.
    const l3d_backend& chosen() const;

    /// Makes a screen of the chosen back-end.
    /// Errors:  l3d_error with the reason: display_lost or no_backend; also as chosen().
    std::unique_ptr<l3d_screen> create_screen(const l3d_screen_request& request) const;

    /// Makes a window for a notice that is shown before choose(), such as on a long reading. The
    /// first automatic back-end that can open a window makes it.
    /// Errors:  null if the options or the environment name a back-end that has no windows, or if
    ///          no window opens.
    std::unique_ptr<l3d_screen> create_notice(const l3d_options& options,
                                              const l3d_screen_request& request) const;

    /// Makes a dispatcher of the chosen back-end.
    /// Errors:  as l3d_dispatcher_factory::create and chosen().
    std::unique_ptr<l3d_dispatcher> create_dispatcher(const l3d_frame_settings& settings) const;

private:
    std::vector<l3d_backend> rows_;
    const l3d_backend* chosen_ = nullptr;
    bool verbose_ = false;
};

#endif
