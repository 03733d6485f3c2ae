// SPDX-License-Identifier: MIT
// What the inputs of an effect hold, as hosts have them.
#pragma once

#include "frame/frame.hpp"

#include <vector>

namespace crease::tools {

/// Distance of the far plane in the unit of what is drawn.
float far_plane(const gbuffer& inputs);

/// The texels of an input: depth or normals, as its `content` says.
std::vector<float> content_of(const resource& wanted, const gbuffer& inputs);

}
