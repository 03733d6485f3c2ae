// crease::effect: a part is of use only beside a part that requires its role, and none does
// (stratified, single_layer)
// directions/single_layer/hbao/stratified
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, hbao, stratified>::passes.size();
