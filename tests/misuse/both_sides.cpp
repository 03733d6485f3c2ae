// crease::effect: the receivers have two sides, and the estimator sees that side alone which faces the camera
// (thin_layers, unsharp_mask)
// box_window/linked_lists/unsharp_mask/thin_layers
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<box_window<>, linked_lists<>, unsharp_mask, thin_layers>::passes.size();
