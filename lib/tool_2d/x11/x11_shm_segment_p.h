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

/// Memory that this process writes and the server reads.
///
/// If the server supports it (MIT-SHM 1.2), the memory is a file without a name, which is handed to
/// the server. Such memory cannot be mistaken for another's, has no limits of its own, and works
/// from within a container. Otherwise the memory is a segment of System V. Nobody else may open
/// this segment (mode 0600), and its name is removed at once. The kernel frees either kind with the
/// last process that has it, however that process ends.
/// Lives:   the connection outlives the segment.
class x11_shm_segment {
public:
    /// Makes a segment. For the first segment of a connection, it proves that sharing works: the
    /// server must answer that it has taken the file, or that it reads our pixels in the segment of
    /// System V. A server in another IPC namespace may find a stranger's memory under our number.
    ///
    /// Shape:   at least `size` bytes; the proof is a row of pixels of this layout.
    /// Errors: null, with one line in `why` that gives the reasons of kernel or server;
    ///         std::bad_alloc. A later segment that the server refuses fails at its first use.
    /// Cost:   the first time five round trips for a file, and five more if the file fails.
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

    /// Makes a file without a name, whose descriptor goes to the server.
    /// Errors:  null, with one line in `why`.
    static std::unique_ptr<x11_shm_segment> by_file(x11_connection& connection, std::size_t size,
                                                    std::string& why);
    /// Makes memory that the server finds by its number.
    /// Errors:  null, with one line in `why`.
    static std::unique_ptr<x11_shm_segment> by_system_v(x11_connection& connection, Visual* visual,
                                                        const l3d_pixel_layout& layout,
                                                        std::size_t size, std::string& why);

    /// Makes and maps the file, and hands it to the server. Errors: false, with one line in `why`.
    bool attach_file(std::size_t size, std::string& why);
    /// Makes and maps a segment of System V, and asks the server to attach it.
    /// Errors:  false, with one line in `why`.
    bool attach(std::size_t size, std::string& why);
    void forget_name();

    const x11_connection& connection_;
    XShmSegmentInfo info_{};
    std::size_t file_size_ = 0; ///< size of the shared file; 0 for a segment of System V
    bool is_named_ = false;
};

} // namespace l3d_detail

#endif
