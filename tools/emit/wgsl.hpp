// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/module.hpp>

#include <string>
#include <vector>

namespace crease::tools {

/// WGSL of modules in the dialect webgpu, by npm's naga-wasm, which node runs.
/// @throws std::runtime_error  where one of these is missing, or naga refuses a module
std::vector<std::string> wgsl_of(const std::vector<const spirv::words*>& modules);

}
