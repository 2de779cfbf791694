// SPDX-License-Identifier: MIT
// load_window: shows how far a file is read where no terminal does, and lets users stop it.
#ifndef L3D_SYSTEM_LOAD_WINDOW_P_H
#define L3D_SYSTEM_LOAD_WINDOW_P_H

#include "system/factory_manager.h"
#include "system/options/options.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace l3d_detail {

/// A small window that shows the name of the file that is being read, and the share that is done.
/// The window opens after half a second of reading. It opens only if the program will show a
/// window, and if the program's messages do not go to a terminal. At a terminal, long_work shows
/// the share, and stop_key stops reading.
///
/// Lives: borrows the factories and the options.
class load_window {
public:
    load_window(const l3d_factory_manager& factories, const l3d_options& options)
        : factories_(factories), options_(options) {}

    /// Shows the share of the file that is read, from 0 to 1. At 1 the window closes. Returns
    /// false, to stop reading, once the user has closed the window, or has pressed Escape or q in
    /// it.
    bool goes_on(const std::string& file, double share);

private:
    using clock = std::chrono::steady_clock;

    bool is_wanted() const;
    void open(const std::string& file);
    bool is_ended();
    void draw(const std::string& file, double share);

    const l3d_factory_manager& factories_;
    const l3d_options& options_;
    clock::time_point begin_ = clock::now();
    bool is_tried_ = false, is_stopped_ = false;
    /// The time and share that the window shows; empty if the window must be drawn again.
    std::string shown_;
    std::unique_ptr<l3d_screen> screen_;
    l3d_font font_;
};

} // namespace l3d_detail

#endif
