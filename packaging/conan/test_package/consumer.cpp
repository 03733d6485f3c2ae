// SPDX-License-Identifier: MIT
// What a host writes first: it prints a shader.
#include <crease/crease.hpp>

#include <cstdio>

int main() {
    using ao = crease::effect<crease::directions<8, 4>, crease::single_layer, crease::hbao>;
    return std::puts(ao::source<0>().data()) < 0;
}
