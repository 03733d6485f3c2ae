// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>
#include <crease/parts/traversal/all_layers.hpp>

namespace crease {

inline constexpr glsl_file surfaces_glsl{
    "receivers/surfaces.glsl",
#include <crease/receivers/surfaces.glsl>
};

/// Blends layers, of which crease_blend is told the colours.
CREASE_TRAIT(blended_layers, receivers,
             "the output blends the colours of layers, and the receivers are surfaces of which no colour is "
             "known");

}
