// SPDX-License-Identifier: MIT
// x11_reply: the owner of a reply that xcb read.
#ifndef L3D_TOOL_2D_X11_X11_REPLY_P_H
#define L3D_TOOL_2D_X11_X11_REPLY_P_H

#include <cstdlib>
#include <memory>

namespace l3d_detail {

/// xcb's replies come from malloc.
struct x11_reply_freer {
    void operator()(void* reply) const { std::free(reply); }
};
template <class Reply> using unique_reply = std::unique_ptr<Reply, x11_reply_freer>;

} // namespace l3d_detail

#endif
