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

/// One row of the table: a way to show pictures.
struct L3D_PUBLIC l3d_backend {
    std::string name;          ///< the word that --backend takes
    std::string purpose;       ///< its use, in a few words
    bool automatic = false;    ///< taken without a question if it is the first that can serve
    bool on_display = false;   ///< it needs a display
    bool unseen = false;       ///< nobody sees its pictures unless --output names a file
    bool writes_files = false; ///< it writes its pictures to files itself
    /// Whether the row only adds a wish to another row, as mesa:egl does to mesa. Lists show such a
    /// row, and the prompt does not.
    bool variant = false;
    std::unique_ptr<l3d_screen_factory> screen_factory;               ///< makes its screens
    std::shared_ptr<const l3d_rasterizer_factory> rasterizer_factory; ///< canvases share it
    std::unique_ptr<l3d_dispatcher_factory>
        dispatcher_factory; ///< makes the loop that drives programs on it
};

/// Knows every back-end, asks each whether it can serve here, and takes one.
///
/// No other place names concrete kinds of back-ends. The manager is not a global: each program has
/// one in main.
class L3D_PUBLIC l3d_factory_manager {
public:
    /// Makes the rows of the library: xshm, ximage, mesa and its variants mesa:egl and mesa:osmesa,
    /// memory.
    l3d_factory_manager();
    l3d_factory_manager(const l3d_factory_manager&) = delete;
    l3d_factory_manager& operator=(const l3d_factory_manager&) = delete;
    ~l3d_factory_manager();

    /// Adds a row at the end. Expects: all three factories; a name that no row has.
    void add(l3d_backend row);

    /// Takes the back-end named by --backend, else by the environment's L3D_BACKEND, else by the
    /// program itself. If none is named, it asks at a terminal, and elsewhere takes the first
    /// automatic row that can serve. If nobody would see the pictures, stderr gets a line about it.
    /// Then the output becomes `program`.png, unless the back-end was named and shows nothing.
    ///
    /// Returns: false if the program ends well without pictures: --list-backends or --diagnose was
    ///          answered, or the answer at the prompt was q.
    ///
    /// Errors:  l3d_error: usage for an unknown name; no_display if no display can be opened
    ///          (naming DISPLAY and its value); no_backend, with all reasons, otherwise.
    bool choose(l3d_options& options);

    /// As above, with the prompt's streams given; `may_ask` says whether both are a terminal.
    bool choose(l3d_options& options, std::istream& in, std::ostream& out, bool may_ask);

    /// The row that choose() took. Expects: choose() was true.
    const l3d_backend& chosen() const;

    /// Makes a screen of the chosen back-end.
    /// Expects: choose() was true.
    /// Errors:  l3d_error with the reason: display_lost or no_backend.
    std::unique_ptr<l3d_screen> create_screen(const l3d_screen_request& request) const;

    /// Makes a window for a notice that is shown before choose(). It is of the first automatic kind
    /// that can serve.
    /// Errors:  null if the options or the environment name a back-end without a window, or if no
    ///          window opens.
    std::unique_ptr<l3d_screen> create_notice(const l3d_options& options,
                                              const l3d_screen_request& request) const;

    /// Makes a dispatcher of the chosen back-end.
    /// Expects: choose() was true.
    /// Errors:  as l3d_dispatcher_factory::create.
    std::unique_ptr<l3d_dispatcher> create_dispatcher(const l3d_frame_settings& settings) const;

private:
    std::vector<l3d_backend> rows_;
    const l3d_backend* chosen_ = nullptr;
    bool verbose_ = false;
};

#endif
