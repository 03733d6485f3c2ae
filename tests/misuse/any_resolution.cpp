// crease::effect: the filter makes the picture larger, and the output blends colours, which have a pixel each
// (upsample, composite)
// directions/linked_lists/hbao/composite/upsample
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, linked_lists<>, hbao, composite<>, upsample<>>::passes.size();
