// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

#include <filesystem>
#include <string_view>

namespace crease::tools {

/// The triangles of a Wavefront .obj file: vertices and faces, polygons in triangles, and their materials as
/// `read_mtl` reads them. A library or a material that is not there makes white and opaque. Every other line
/// is passed over; of "v x y z w" the weight w, which is for curves alone.
/// @param folder  where the libraries of materials are; null where none may be read
/// @throws scene_error, without the name of the file; file_error
mesh read_obj(std::string_view file, const std::filesystem::path* folder = nullptr);

}
