// crease::effect: a template argument is not a part: it has no `description` of type crease::part
// (int)
// no recipe says this
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, hbao, int>::passes.size();
