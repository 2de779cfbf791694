// SPDX-License-Identifier: MIT
// l3d_method_option: the command line's choice among the methods that are compared.
#ifndef L3D_COMPARE_METHOD_OPTION_H
#define L3D_COMPARE_METHOD_OPTION_H

#include "compare/method_choice.h"
#include "pipeline/pipeline_afd.h"
#include "system/options/afd_options.h"
#include "system/options/options.h"

#include <optional>
#include <string>

/// An option that names a method, added to a program's own.
///
/// Lives:   borrowed by the l3d_options until parse() is done.
class l3d_method_option {
public:
    /// Declares the option. It has a name, a usual method ("" for none), and the text of --help
    /// before the methods' names.
    l3d_method_option(l3d_options& options, std::string option, std::string usual,
                      const std::string& help);
    l3d_method_option(const l3d_method_option&) = delete;
    l3d_method_option& operator=(const l3d_method_option&) = delete;

    /// The settings that the options ask for, with the method.
    /// Expects: a usual method.
    /// Errors:  as l3d_afd_options::settings; l3d_error(usage) for an unknown method, or for one
    ///          that lacks a wanted feature.
    l3d_afd_settings settings(const l3d_afd_options& afd) const;

    /// The method that the user asked for, else the usual one, if there is any.
    /// Errors:  l3d_error(usage) for an unknown method.
    std::optional<l3d_method_choice> choice() const;

private:
    std::string option_, name_;
};

#endif
