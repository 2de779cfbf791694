// SPDX-License-Identifier: MIT
// x11_shm_segment: memory that we write and the X server reads.
#ifndef L3D_TOOL_2D_X11_X11_SHM_SEGMENT_P_H
#define L3D_TOOL_2D_X11_X11_SHM_SEGMENT_P_H

#include "tool_2d/screen_info.h"
#include "tool_2d/x11/x11_connection_p.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

// Xlib.h first: the extension's header does not include it.
#include <X11/extensions/XShm.h>

namespace l3d_detail {

/// A System V segment, attached here and, read-only, by the server.
///
/// Nobody else may open it (mode 0600), and it has no name any more. The kernel frees it with the
/// last process that has it, however that ends.
/// Lives:   the connection outlives the segment.
class x11_shm_segment {
public:
    /// Makes a segment. The first segment of a connection proves that the server sees in it what we
    /// write there. A server in another IPC namespace may find a stranger's memory under our
    /// number.
    ///
    /// Shape:   at least `size` bytes; the proof is a row of pixels of this layout.
    /// Errors:  null, with one line in `why` that gives the reason of kernel or server;
    ///          std::bad_alloc. If the server refuses a later one, this shows when it is used.
    /// Cost:    the first time four round trips, three of which ask for the extension.
    static std::unique_ptr<x11_shm_segment> make(x11_connection& connection, Visual* visual,
                                                 const l3d_pixel_layout& layout, std::size_t size,
                                                 std::string& why);

    x11_shm_segment(const x11_shm_segment&) = delete;
    x11_shm_segment& operator=(const x11_shm_segment&) = delete;
    ~x11_shm_segment();

    std::uint8_t* bytes() const { return reinterpret_cast<std::uint8_t*>(info_.shmaddr); }
    XShmSegmentInfo& info() { return info_; }

private:
    explicit x11_shm_segment(const x11_connection& connection) : connection_(connection) {}

    /// Errors:  false, with one line in `why`.
    bool attach(std::size_t size, std::string& why);
    void forget_name();

    const x11_connection& connection_;
    XShmSegmentInfo info_{};
    bool is_named_ = false;
};

} // namespace l3d_detail

#endif
