// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/stage/stages.hpp>

namespace crease {

inline constexpr glsl_file view_set_in_main_glsl{
    "dialect/view_set_in_main.glsl",
#include <crease/dialect/view_set_in_main.glsl>
};

}
