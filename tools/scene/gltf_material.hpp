// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf_json.hpp"
#include "scene/scene.hpp"

#include <optional>

namespace crease::tools {

/// A material of a glTF file by its factors, without textures and the colours of vertices: of alpha mode
/// BLEND the opacity is the base colour's alpha; OPAQUE ones are opaque, and so are those of MASK whose alpha
/// reaches the cutoff. All show both sides, as all triangles here do.
/// @param of  an element of "materials"
/// @return none where nothing of it is seen: of MASK below the cutoff
/// @throws scene_error
std::optional<material> read_gltf_material(const gltf_value& of);

}
