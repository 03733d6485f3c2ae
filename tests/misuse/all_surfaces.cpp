// crease::effect: the output blends the colours of all layers, and the compression keeps them of none
// (composite, compressed)
// directions/linked_lists/hbao/composite/compressed
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, linked_lists<>, hbao, composite<>, compressed<>>::passes.size();
