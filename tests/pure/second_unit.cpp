// SPDX-License-Identifier: MIT
// A second translation unit of the whole library: what is not inline would be defined twice.
#include <crease/crease.hpp>

#include "second_unit.hpp"

const void* parts_of_second_unit() {
    return crease::all_parts;
}

std::string_view source_of_second_unit() {
    return crease::effect<crease::directions<>, crease::single_layer, crease::hbao>::source<0>();
}
