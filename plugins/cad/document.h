// SPDX-License-Identifier: MIT
// Reads a STEP or IGES file, and walks over its assembly: parts, places, colours.
#ifndef L3D_PLUGINS_CAD_DOCUMENT_H
#define L3D_PLUGINS_CAD_DOCUMENT_H

#include "geom/files/cad_plugin_p.h"

#include <atomic>
#include <functional>
#include <string>

namespace cad {

/// Writes all faces of a file as records. Calls `flush` after each face, so that nobody has to keep
/// all records. `share` becomes the share of the work that is done, from 0 to 1.
/// Errors: returns why there are no faces to write; "" if it went well.
std::string write_document(const char* path, bool is_iges, l3d_detail::cad_writer& to,
                           const std::function<void()>& flush, std::atomic<double>& share);

} // namespace cad

#endif
