// crease::effect: the second part must be a depth source
// (hbao)
// directions/hbao/hbao
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, hbao, hbao>::passes.size();
