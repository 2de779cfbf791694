// SPDX-License-Identifier: MIT
// l3d_method_option: the command line's choice among the methods that are compared.
#ifndef L3D_COMPARE_METHOD_OPTION_H
#define L3D_COMPARE_METHOD_OPTION_H

#include "pipeline/pipeline_afd.h"
#include "system/afd_options.h"
#include "system/options.h"

#include <string>

/// Option --method, added to a program's own.
///
/// Lives:   borrowed by the l3d_options until parse() is done.
class l3d_method_option {
public:
    explicit l3d_method_option(l3d_options& options);
    l3d_method_option(const l3d_method_option&) = delete;
    l3d_method_option& operator=(const l3d_method_option&) = delete;

    /// The settings asked for, with the method.
    /// Errors: as l3d_afd_options::settings; l3d_error(usage) for an unknown method, or one that
    ///         has not what is to be shown.
    l3d_afd_settings settings(const l3d_afd_options& afd) const;

private:
    std::string name_ = "afd";
};

#endif
