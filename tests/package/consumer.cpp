// SPDX-License-Identifier: MIT
// What a host writes first: it prints a shader, and holds the type to the SPIR-V that its build made, if it
// did.
#include <crease/crease.hpp>

#include <cstdio>

using ao = crease::effect<crease::directions<8, 4>, crease::single_layer, crease::hbao>;

#if __has_include(<embedded.hpp>)
#include <embedded.hpp>
static_assert(embedded::matches<ao>);
#elif defined(REQUIRE_EMBEDDED)
#error "crease_add_shader made no header"
#endif

int main() {
    std::puts(ao::source<0>().data());
}
