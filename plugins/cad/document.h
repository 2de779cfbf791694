// SPDX-License-Identifier: MIT
// Reads a STEP or IGES file, and visits its assembly: parts, places, colours.
#ifndef L3D_PLUGINS_CAD_DOCUMENT_H
#define L3D_PLUGINS_CAD_DOCUMENT_H

#include "geom/files/cad_plugin_p.h"

#include <atomic>
#include <functional>
#include <string>
#include <string_view>

namespace cad {

/// Reads a STEP or IGES file's text, and writes all its faces as records. Calls `flush` after each
/// face, so that the records need not be stored all at once. `share` is set to the share of the
/// work that is done, from 0 to 1.
/// Errors: returns the reason why no faces can be written; "" if they were written.
std::string write_document(std::string_view text, bool is_iges, l3d_detail::cad_writer& to,
                           const std::function<void()>& flush, std::atomic<double>& share);

} // namespace cad

#endif
