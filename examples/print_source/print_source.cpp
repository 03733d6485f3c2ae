// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <iostream>

using ao = crease::effect<crease::directions<4, 4>, crease::single_layer, crease::hbao>;

int main() {
    std::cout << ao::source<0>();
    return std::cout.flush() ? 0 : 1;
}
