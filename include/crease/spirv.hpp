// SPDX-License-Identifier: MIT
#pragma once

/// @namespace crease::spirv
/// Optional: from an effect's passes to SPIR-V. Needs glslang and SPIRV-Tools; the CMake target is
/// crease::spirv.

#include <crease/spirv/check.hpp>
#include <crease/spirv/compile.hpp>
#include <crease/spirv/disassemble.hpp>
#include <crease/spirv/optimise.hpp>
#include <crease/spirv/reflect.hpp>
#include <crease/spirv/validate.hpp>
