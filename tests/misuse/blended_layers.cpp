// crease::effect: the output blends the colours of layers, and the receivers are surfaces of which no colour is known
// (composite, first_surface)
// directions/linked_lists/hbao/composite/first_surface
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, linked_lists<>, hbao, composite<>, first_surface>::passes.size();
