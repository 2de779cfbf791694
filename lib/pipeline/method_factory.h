// SPDX-License-Identifier: MIT
// l3d_method_factory: makes the method that a pipeline fills surfaces with.
#ifndef L3D_PIPELINE_METHOD_FACTORY_H
#define L3D_PIPELINE_METHOD_FACTORY_H

#include "base/public.h"

#include <functional>
#include <memory>
#include <string>

class l3d_rasterizer_factory;
class l3d_surface_method;
class l3d_workers;

/// Makes a surface method, and tells what a pipeline must know of it beforehand.
///
/// A default one makes the library's own method: adaptive forward differencing in l3d_real.
class L3D_PUBLIC l3d_method_factory {
public:
    /// Makes a method that fills with surfaces of these rasterizers, by these workers.
    /// Expects: never returns null.
    /// Errors:  exceptions of the call leave the pipeline's constructor.
    /// Lives:   the method may borrow the workers, but not the rasterizers.
    using create_call = std::function<std::unique_ptr<l3d_surface_method>(
        const l3d_rasterizer_factory& rasterizers, l3d_workers& workers)>;

    /// The factory of the library's own method.
    l3d_method_factory();

    /// A factory of methods that `create` makes, called by this name in reports and messages. Only
    /// a method whose counts bound the error can draw mode `error`.
    l3d_method_factory(std::string name, create_call create, bool has_bound = false);

    /// The name that reports and messages give the method.
    const std::string& name() const { return name_; }
    /// Whether the method's counts bound the error of each frame.
    bool has_bound() const { return has_bound_; }

    /// Whether it makes the library's own method, whose steps the wireframe shows.
    bool is_default() const { return is_default_; }

    /// Makes a method; never null.
    /// Errors: exceptions of the call.
    /// Lives:  the method borrows the workers.
    std::unique_ptr<l3d_surface_method> create(const l3d_rasterizer_factory& rasterizers,
                                               l3d_workers& workers) const;

private:
    std::string name_;
    create_call create_;
    bool has_bound_, is_default_;
};

#endif
