// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using both = effect<directions<>, stochastic_layers<>, hbao_plus, second_view<3>>;
static_assert(both::view().views == 2);
static_assert(both::view().block_size() == block_size(2, both::settings.size()));
static_assert(effect<directions<>, stochastic_layers<>, hbao_plus>::view().views == 1);

}

TEST_CASE("the second camera's picture is as much smaller as the number says") {
    for (const pass& each : both::passes)
        CHECK(each.size.divisor == (each.view == 1 ? 3 : 1));
    for (const resource& r : both::resources)
        if (r.name == "captured_layers_1")
            CHECK(r.size == extent{.divisor = 3});
    CHECK(has_part_of(both::passes.back(), "view/further_view.glsl"));
}

TEST_CASE("the result in the second camera's view turns back where it has a direction") {
    using bent = effect<directions<>, stochastic_layers<>, hbao_plus, second_view<>, bent_cone>;
    CHECK(contains(part_of(bent::passes.back(), "output/bent_cone.glsl"), "crease_turned_back("));
    CHECK(has_part_of(both::passes.back(), "core/result.glsl"));
}
