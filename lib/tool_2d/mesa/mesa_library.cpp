// SPDX-License-Identifier: MIT
// mesa_library: opens a library, and keeps the reason if it cannot.
#include "tool_2d/mesa/mesa_library_p.h"

#include <dlfcn.h>

namespace l3d_detail {

mesa_library::mesa_library(std::initializer_list<const char*> names) {
    for (const char* name : names) {
        handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (handle_) {
            problem_.clear();
            return;
        }
        if (problem_.empty()) // users should install the library of the first name
            problem_ = dlerror();
    }
}

void* mesa_library::find(const char* name) const {
    return handle_ ? dlsym(handle_, name) : nullptr;
}

} // namespace l3d_detail
