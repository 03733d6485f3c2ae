// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/glsl_file.hpp>

namespace crease {

inline constexpr glsl_file encoding_octahedron_glsl{
    "encoding/octahedron.glsl",
#include <crease/encoding/octahedron.glsl>
};

}
