// crease::effect: the receivers have two sides, and the estimator sees that side alone which faces the camera
// (thin_layers, ssao)
// hemisphere_points/linked_lists/ssao/thin_layers
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<hemisphere_points<>, linked_lists<>, ssao, thin_layers>::passes.size();
