// crease::effect: layers are looked for in the depth image or in shared memory, which have one resolution, and there are several
// (deferred_layers, multi_resolution)
// tap_grid/linked_lists/hbao_plus/multi_resolution/deferred_layers
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count =
    effect<tap_grid<>, linked_lists<>, hbao_plus, multi_resolution<>, deferred_layers<>>::passes.size();
