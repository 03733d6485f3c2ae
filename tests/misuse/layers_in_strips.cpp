// crease::effect: the stage keeps layers in shared memory, where the depth source does not look for them
// (compute_strips, depth_pyramid)
// axes/depth_pyramid/hbao_plus/compute_strips
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<axes<>, depth_pyramid<>, hbao_plus, compute_strips<>>::passes.size();
