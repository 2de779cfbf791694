// SPDX-License-Identifier: MIT
// The standard headers that most sources include, compiled once for all of them. A source still
// includes what it uses.
#ifndef L3D_BASE_PRECOMPILED_H
#define L3D_BASE_PRECOMPILED_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#endif
