// SPDX-License-Identifier: MIT
// l3d_probe: one thing looked at to find out what can serve here.
#ifndef L3D_TOOL_2D_PROBE_H
#define L3D_TOOL_2D_PROBE_H

#include "base/public.h"

#include <string>
#include <vector>

/// A thing that --diagnose prints a line about.
struct L3D_PUBLIC l3d_probe {
    /// How far it serves.
    enum class verdict {
        good,    ///< nothing is missing
        limited, ///< it serves, but not as well as it could
        bad      ///< it does not serve
    };

    std::string what;                ///< "MIT-SHM", "visual"
    std::string result;              ///< the finding, or the reason why there is none
    verdict outcome = verdict::good; ///< how far it serves
    std::string remedy; ///< the thing to install, set or leave out; empty if nothing is wrong
};

/// The name of the display's own probe: if that is bad, no window can open.
inline constexpr auto l3d_display_probe = "display";

/// All that was found, in the order in which it is printed.
using l3d_probes = std::vector<l3d_probe>;

#endif
