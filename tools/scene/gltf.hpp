// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

#include <filesystem>
#include <string_view>

namespace crease::tools {

/// The triangles of the scene that a .glb or .gltf file (glTF 2.0) shows: nodes placed, quantised and sparse
/// positions expanded, morph targets by their default weights, skins in the pose of their joints, instances
/// of EXT_mesh_gpu_instancing; of materials what `read_gltf_material` says. Animations are not read.
/// @param folder  where further files are; null where none may be read
/// @throws scene_error, without the name of the file, for a required extension that changes triangles in
/// another way too; file_error
mesh read_gltf(std::string_view file, const std::filesystem::path* folder);

}
