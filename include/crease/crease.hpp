// SPDX-License-Identifier: MIT
#pragma once

/// @namespace crease
/// Ambient-occlusion shaders, composed from parts. Whatever these headers define needs no library.

#include <crease/compose/composition.hpp>
#include <crease/compose/effect.hpp>
#include <crease/parts/all_parts.hpp>
