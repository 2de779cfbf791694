// SPDX-License-Identifier: MIT
// l3d_method_option: declares the option, and checks that the method can serve the settings.
#include "compare/method_option.h"

#include "base/error.h"

#include <utility>

l3d_method_option::l3d_method_option(l3d_options& options, std::string option, std::string usual,
                                     const std::string& help)
    : option_(std::move(option)), name_(std::move(usual)) {
    options.add(option_, name_, help + l3d_method_choice::all_names(), "NAME");
}

std::optional<l3d_method_choice> l3d_method_option::choice() const {
    if (name_.empty())
        return std::nullopt;
    std::string why;
    const auto method = l3d_method_choice::from_name(name_, why);
    if (!method)
        throw l3d_error(l3d_exit::usage, option_ + ": " + why);
    return method;
}

l3d_afd_settings l3d_method_option::settings(const l3d_afd_options& afd) const {
    const l3d_method_choice method = *choice();
    l3d_afd_settings result = afd.settings();
    result.method = method.factory();
    if (result.wireframe && method.method != l3d_method::afd)
        throw l3d_error(l3d_exit::usage,
                        "--wireframe: shows the steps of afd, not of --method " + method.name());
    if (result.fog.is_on() && method.method != l3d_method::afd)
        throw l3d_error(l3d_exit::usage,
                        "--fog: --method " + method.name() + " draws without; afd has it");
    if (afd.camera().is_parallel() && !method.draws_parallel())
        throw l3d_error(l3d_exit::usage,
                        "--parallel: --method " + method.name() + " draws perspective alone; " +
                            l3d_method_choice::names_with_parallel() + " have both");
    if (result.shade == l3d_shade::error && !method.has_bound())
        throw l3d_error(l3d_exit::usage,
                        "--shade: error shows a bound of the error, and --method " + method.name() +
                            " has none; " + l3d_method_choice::names_with_bound() + " have one");
    if (l3d_is_inspection(result.shade) && method.method != l3d_method::afd)
        throw l3d_error(l3d_exit::usage,
                        "--shade: zebra, isophotes, gaussian, mean and draft look at exact "
                        "patches, and --method " +
                            method.name() + " does not; afd does");
    if (afd.gives_tolerance() && !method.keeps_tolerance() && result.shade != l3d_shade::error)
        throw l3d_error(l3d_exit::usage, "--tolerance: --method " + method.name() +
                                             " has steps of its own and keeps none; " +
                                             l3d_method_choice::names_with_tolerance() + " do");
    return result;
}
