// SPDX-License-Identifier: MIT
// x11_shm_segment: shares files or System V memory, and proves that two programs see the same
// memory.
#include "tool_2d/x11/x11_shm_segment_p.h"

#include "tool_2d/x11/x11_image_p.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <unistd.h>

#include <X11/Xlib-xcb.h>
#include <xcb/shm.h>

namespace l3d_detail {
namespace {

// Whether a segment can be attached by its number after its name was removed. Linux allows that,
// and other systems may not.
#ifdef __linux__
constexpr bool attaches_nameless = true;
#else
constexpr bool attaches_nameless = false;
#endif

// The proof that the server sees our memory is a row of this many random pixels. At 8 bits each,
// other memory looks the same by chance once in 2^512.
constexpr int proof_width = 64;
// The bytes of such a row, at 32 bits a pixel.
constexpr std::size_t proof_size = std::size_t{4} * proof_width;

/// Frees an image that Xlib made, and its pixels.
struct copy_freer {
    void operator()(XImage* image) const { XDestroyImage(image); }
};
using unique_copy = std::unique_ptr<XImage, copy_freer>;

std::string kernel_reason(const char* call) {
    return std::string(call) + ": " + std::generic_category().message(errno);
}

/// Whether sharing certainly fails, so that there is no need to try.
bool is_hopeless(const x11_connection& connection, std::string& why) {
    const char* const refusal = std::getenv("L3D_NO_SHM");
    if (refusal != nullptr && *refusal != '\0')
        why = "L3D_NO_SHM is set";
    else if (!connection.is_local())
        why = "the X server is reached over a network";
    else if (!connection.has(XShmQueryExtension))
        why = connection.lost() ? x11_server_went_away : "the X server does not have MIT-SHM";
    else
        return false;
    return true;
}

/// Lets the server copy pixels from the segment, and reads them back over the connection. Null if
/// the server refuses.
unique_copy copy_by_server(const x11_connection& connection, XImage& row) {
    auto* const display = connection.display();
    const auto pixmap =
        XCreatePixmap(display, connection.root(), proof_width, 1, static_cast<unsigned>(row.depth));
    // Each display comes with a graphics context for its usual depth.
    GC graphics = DefaultGC(display, connection.screen());
    const bool is_usual = row.depth == DefaultDepth(display, connection.screen());
    if (!is_usual)
        graphics = XCreateGC(display, pixmap, 0, nullptr);
    XShmPutImage(display, pixmap, graphics, &row, 0, 0, 0, 0, proof_width, 1, False);
    unique_copy copy(XGetImage(display, pixmap, 0, 0, proof_width, 1, AllPlanes, ZPixmap));
    if (!is_usual)
        XFreeGC(display, graphics);
    XFreePixmap(display, pixmap);
    return copy;
}

bool have_same_pixels(XImage& one, XImage& other) {
    for (int x = 0; x < proof_width; ++x) {
        if (XGetPixel(&one, x, 0) != XGetPixel(&other, x, 0))
            return false;
    }
    return true;
}

/// Whether the server sees the pixels that this program writes.
/// Expects: `trap` was set before the server was told of the segment.
bool server_sees(x11_shm_segment& segment, XImage& row, const x11_connection& connection,
                 const x11_error_trap& trap, std::string& why) {
    std::random_device random;
    std::generate_n(segment.bytes(), ximage_size(row),
                    [&] { return static_cast<std::uint8_t>(random()); });
    row.data = reinterpret_cast<char*>(segment.bytes());
    row.obdata = reinterpret_cast<char*>(&segment.info());
    const auto copy = copy_by_server(connection, row);
    if (connection.lost())
        why = x11_server_went_away;
    else if (trap.error() != 0 || !copy)
        why = "the X server refuses shared memory: " + x11_error_text(connection, trap.error());
    else if (!have_same_pixels(row, *copy))
        why = "the X server sees other memory than ours (it is in another IPC namespace)";
    else
        return true;
    return false;
}

} // namespace

std::unique_ptr<x11_shm_segment> x11_shm_segment::make(x11_connection& connection, Visual* visual,
                                                       const l3d_pixel_layout& layout,
                                                       std::size_t size, std::string& why) {
    if (is_hopeless(connection, why))
        return nullptr;
    std::string why_no_file;
    if (connection.sharing() != x11_sharing::segments) {
        auto segment = by_file(connection, size, why_no_file);
        if (segment)
            return segment;
        if (connection.sharing() == x11_sharing::files || connection.lost()) {
            why = connection.lost() ? x11_server_went_away : why_no_file;
            return nullptr;
        }
    }
    auto segment = by_system_v(connection, visual, layout, size, why);
    if (!segment && !connection.lost() && !why_no_file.empty())
        why = why_no_file + "; " + why;
    return segment;
}

/// Makes a segment of a shared file.
/// Errors:  null, with a reason in `why` unless the server is just too old.
std::unique_ptr<x11_shm_segment> x11_shm_segment::by_file(x11_connection& connection,
                                                          std::size_t size, std::string& why) {
    std::unique_ptr<x11_shm_segment> segment(new x11_shm_segment(connection));
    if (connection.sharing() == x11_sharing::files)
        return segment->attach_file(size, why) ? std::move(segment) : nullptr;
    x11_error_trap trap(connection);
    if (!segment->attach_file(size, why))
        return nullptr;
    const int error = trap.sync();
    if (error == 0 && !connection.lost()) {
        connection.set_sharing(x11_sharing::files);
        return segment;
    }
    if (connection.lost())
        why = x11_server_went_away;
    else if (error != BadRequest) // A server before MIT-SHM 1.2 does not know the request.
        why = "the X server refuses shared files: " + x11_error_text(connection, error);
    return nullptr;
}

std::unique_ptr<x11_shm_segment> x11_shm_segment::by_system_v(x11_connection& connection,
                                                              Visual* visual,
                                                              const l3d_pixel_layout& layout,
                                                              std::size_t size, std::string& why) {
    const auto row = make_ximage(connection.display(), visual, layout, {proof_width, 1});
    std::unique_ptr<x11_shm_segment> segment(new x11_shm_segment(connection));
    if (attaches_nameless && connection.sharing() == x11_sharing::segments)
        return segment->attach(size, why) ? std::move(segment) : nullptr;
    x11_error_trap trap(connection);
    if (!segment->attach(std::max(size, proof_size), why) ||
        !server_sees(*segment, *row, connection, trap, why))
        return nullptr;
    segment->forget_name();
    connection.set_sharing(x11_sharing::segments);
    return segment;
}

bool x11_shm_segment::attach_file(std::size_t size, std::string& why) {
    rlimit largest{};
    if (getrlimit(RLIMIT_FSIZE, &largest) == 0 && largest.rlim_cur < size) {
        // Above the limit, the kernel would send a signal, which ends programs.
        why = "the limit of file sizes (ulimit -f) is too small";
        return false;
    }
    const int file = memfd_create("l3d", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    if (file < 0) {
        why = kernel_reason("memfd_create");
        return false;
    }
    // A sealed file cannot shrink while the server reads it.
    void* address = MAP_FAILED;
    if (ftruncate(file, static_cast<off_t>(size)) == 0 &&
        fcntl(file, F_ADD_SEALS, F_SEAL_SHRINK) == 0)
        address = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (address == MAP_FAILED) {
        why = kernel_reason("shared file");
        close(file);
        return false;
    }
    file_size_ = size;
    info_.shmid = -1;
    info_.shmaddr = static_cast<char*>(address);
    info_.readOnly = True;
    auto* const xcb = XGetXCBConnection(connection_.display());
    info_.shmseg = xcb_generate_id(xcb);
    xcb_shm_attach_fd(xcb, static_cast<xcb_shm_seg_t>(info_.shmseg), file, 1); // closes the file
    return true;
}

bool x11_shm_segment::attach(std::size_t size, std::string& why) {
    info_.shmid = shmget(IPC_PRIVATE, size, IPC_CREAT | 0600);
    if (info_.shmid < 0) {
        why = kernel_reason("shmget");
        return false;
    }
    is_named_ = true;
    void* const address = shmat(info_.shmid, nullptr, 0);
    if (reinterpret_cast<std::intptr_t>(address) == -1) {
        why = kernel_reason("shmat");
        forget_name();
        return false;
    }
    // The name goes at once, so that a killed process leaves nothing behind.
    if (attaches_nameless)
        forget_name();
    info_.shmaddr = static_cast<char*>(address);
    info_.readOnly = True;
    XShmAttach(connection_.display(), &info_);
    return true;
}

/// Removes the segment's name, by which others could find it, and which would outlive the program.
void x11_shm_segment::forget_name() {
    if (std::exchange(is_named_, false))
        shmctl(info_.shmid, IPC_RMID, nullptr);
}

x11_shm_segment::~x11_shm_segment() {
    if (info_.shmaddr == nullptr)
        return;
    if (!connection_.lost())
        XShmDetach(connection_.display(), &info_);
    forget_name();
    if (file_size_ != 0)
        munmap(info_.shmaddr, file_size_);
    else
        shmdt(info_.shmaddr);
}

} // namespace l3d_detail
