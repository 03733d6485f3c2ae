// crease::effect: the estimator needs single layers of depth, which the depth source does not hold
// (hbao, summed_area)
// directions/summed_area/hbao
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, summed_area<>, hbao>::passes.size();
