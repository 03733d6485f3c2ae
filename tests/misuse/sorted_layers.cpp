// crease::effect: the resolutions take layers in order from the eye, and the depth source keeps them in none
// (multi_resolution, stochastic_layers)
// tap_grid/stochastic_layers/hbao_plus/multi_resolution
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<tap_grid<>, stochastic_layers<>, hbao_plus, multi_resolution<>>::passes.size();
