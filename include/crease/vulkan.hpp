// SPDX-License-Identifier: MIT
#pragma once

/// @namespace crease::vulkan
/// Optional: a small headless runner that executes any effect as data. Needs Vulkan 1.1 and crease/spirv.hpp;
/// the CMake target is crease::vulkan.

#include <crease/vulkan/device.hpp>
#include <crease/vulkan/geometry.hpp>
#include <crease/vulkan/rasteriser.hpp>
#include <crease/vulkan/runner.hpp>
