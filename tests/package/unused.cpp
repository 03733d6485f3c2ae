// SPDX-License-Identifier: MIT
// Names an effect and what a renderer must know to make its images, but no program.
#include <crease/crease.hpp>

using ao = crease::effect<crease::directions<8, 4>, crease::single_layer, crease::hbao, crease::bilateral<>>;

unsigned resource_count() {
    return static_cast<unsigned>(ao::resources.size());
}

float bias() {
    return crease::get(ao::defaults, ao::settings, "hbao.bias");
}
