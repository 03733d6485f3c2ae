// crease::effect: none of the parts has a setting of that name
// (directions, hbao)
// no recipe says this
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

using ao = effect<directions<>, single_layer, hbao>;

bool sharpen(parameters& p) {
    return ao::set<"sharpness">(p, 1);
}
