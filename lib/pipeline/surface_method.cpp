// SPDX-License-Identifier: MIT
// l3d_method_factory: makes the default method, or calls a program's own function.
#include "pipeline/surface_method.h"

#include "pipeline/method_afd.h"

#include <utility>

l3d_method_factory::l3d_method_factory()
    : name_("afd"), create_([](const l3d_rasterizer_factory& rasterizers, l3d_workers& workers) {
          return std::make_unique<l3d_method_afd<l3d_real>>(rasterizers, workers);
      }),
      has_bound_(true), draws_parallel_(true), is_default_(true) {}

l3d_method_factory::l3d_method_factory(std::string name, create_call create, bool has_bound,
                                       bool draws_parallel)
    : name_(std::move(name)), create_(std::move(create)), has_bound_(has_bound),
      draws_parallel_(draws_parallel), is_default_(false) {}

std::unique_ptr<l3d_surface_method>
l3d_method_factory::create(const l3d_rasterizer_factory& rasterizers, l3d_workers& workers) const {
    return create_(rasterizers, workers);
}
