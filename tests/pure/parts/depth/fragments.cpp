// SPDX-License-Identifier: MIT
#include <crease/parts/depth/fragments.hpp>

#include <doctest/doctest.h>

using namespace crease;

static_assert(fragments_beyond_layers.life == lifetime::report && fragments_beyond_layers.cleared &&
              fragments_beyond_layers.clear == 0);
static_assert(fragments_beyond_layers.kind == resource_kind::buffer &&
              fragments_beyond_layers.element == "uint");
static_assert(fragment_layers_number.least == 1 && fragment_layers_number.most == 32);

TEST_CASE("a counter of lost fragments is one number, and says what to do") {
    CHECK(fragments_beyond_layers.size.width_of(640) == 1);
    CHECK(fragments_beyond_layers.size.height_of(360) == 1);
    CHECK(fragments_beyond_layers.meaning.find(": more layers keep them") != std::string_view::npos);
}
