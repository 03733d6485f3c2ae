// crease::effect: what the stage keeps takes more than the 16384 bytes of shared memory that every device has
// (compute_strips, layer_array)
// axes/layer_array/hbao/compute_strips:8x8x29
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<axes<>, layer_array<>, hbao, compute_strips<8, 8, 29>>::passes.size();
