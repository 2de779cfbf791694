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

/// Writes all faces of a file's text as records. Calls `flush` after each face, so that nobody
/// needs to store all records. `share` is set to the share of the work done, from 0 to 1. Errors:
/// returns the reason why there are no faces to write; "" if there is none.
std::string write_document(std::string_view text, bool is_iges, l3d_detail::cad_writer& to,
                           const std::function<void()>& flush, std::atomic<double>& share);

} // namespace cad

#endif
