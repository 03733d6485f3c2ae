// SPDX-License-Identifier: MIT
#pragma once

#include "emission.hpp"

namespace crease::tools {

/// A C++ header with the effect as `crease::effect` gives it, but for the text of passes that have SPIR-V:
/// passes, resources, settings, features, `view()`, and whether a C++ type is this effect. Adds its shaders
/// to those of the passes.
std::string header(emission& of);

}
