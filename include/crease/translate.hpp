// SPDX-License-Identifier: MIT
#pragma once

/// @namespace crease::translate
/// Optional: from the SPIR-V of an effect's passes to HLSL, MSL and the GLSL of OpenGL and OpenGL ES, with
/// the host's numbers. Needs SPIRV-Cross beside what crease::spirv needs; the CMake target is
/// crease::translate.

#include <crease/translate/check.hpp>
#include <crease/translate/shader.hpp>
