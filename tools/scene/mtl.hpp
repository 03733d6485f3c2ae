// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace crease::tools {

/// Materials by name.
using mtl_materials = std::map<std::string, material, std::less<>>;

/// The materials of a Wavefront .mtl file: the diffuse colour "Kd", taken as linear, and the opacity "d", or
/// without it 1 - "Tr". Lines of other words, maps among them, are passed over, and so is whatever is before
/// the first material.
/// @throws scene_error, without the name of the file, where one of these is not of numbers from 0 to 1
mtl_materials read_mtl(std::string_view file);

}
