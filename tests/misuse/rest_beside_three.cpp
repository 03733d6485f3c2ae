// crease::effect: a fourth or later part must not be a sampler, a depth source or an estimator
// (ssao)
// directions/single_layer/hbao/ssao
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, hbao, ssao>::passes.size();
