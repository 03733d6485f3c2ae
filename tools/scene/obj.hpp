// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

#include <string_view>

namespace crease::tools {

/// The triangles of a Wavefront .obj file: vertices and faces, polygons in triangles. Every other line is
/// passed over; of "v x y z w" the weight w, which is for curves alone.
/// @throws scene_error, without the name of the file
mesh read_obj(std::string_view file);

}
