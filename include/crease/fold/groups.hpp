// SPDX-License-Identifier: MIT
#pragma once

#include <crease/part.hpp>

namespace crease {

/// The layer that occludes the most, of layers that a depth source holds in groups of four.
inline constexpr glsl_file fold_groups_glsl{
    "fold/groups.glsl",
#include <crease/fold/groups.glsl>
};

}
