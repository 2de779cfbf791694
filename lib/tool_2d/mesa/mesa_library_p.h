// SPDX-License-Identifier: MIT
// mesa_library: a shared library found at run time.
#ifndef L3D_TOOL_2D_MESA_MESA_LIBRARY_P_H
#define L3D_TOOL_2D_MESA_MESA_LIBRARY_P_H

#include <initializer_list>
#include <string>

namespace l3d_detail {

/// A shared library that the program can do without.
///
/// Lives:   stays loaded until the program ends: Mesa has threads and destructors of its own,
///          which must not lose their code.
class mesa_library {
public:
    /// Loads the first of the names that can be loaded; its symbols stay local.
    explicit mesa_library(std::initializer_list<const char*> names);

    /// The reason why no library was loaded, in one line; empty if one was.
    const std::string& problem() const { return problem_; }

    /// The address of a symbol. Errors: null if there is no such symbol, or no library.
    void* find(const char* name) const;

    /// Sets `function` to the function of this name. Errors: false if there is none.
    template <class Function> bool find(Function*& function, const char* name) const {
        function = reinterpret_cast<Function*>(find(name));
        return function != nullptr;
    }

private:
    void* handle_ = nullptr;
    std::string problem_;
};

} // namespace l3d_detail

#endif
