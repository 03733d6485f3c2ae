// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

template <int Count>
using with =
    effect<directions<4, 4>, stochastic_layers<4>, hbao_plus, further_views<Count, 3>, atomic_minimum<>>;
static_assert(with<1>::view().views == 2 && with<2>::view().views == 3 && with<3>::view().views == 4);
static_assert(!recipe("directions/stochastic_layers/hbao/further_views"));
static_assert(!recipe("directions/stochastic_layers/hbao_plus/further_views:4"));
static_assert(!recipe("directions/stochastic_layers/hbao_plus/further_views/second_view"));

}

TEST_CASE("further_views captures and packs for each camera, and looks with all in one pass") {
    REQUIRE(with<3>::passes.size() == 9);
    constexpr std::string_view names[] = {"capture_layers",    "captured_layers_1", "captured_layers_2",
                                          "captured_layers_3", "pack_layers",       "pack_layers",
                                          "pack_layers",       "pack_layers",       "visibility"};
    for (unsigned i = 0; i < 8; ++i) {
        CAPTURE(i);
        CHECK(with<3>::passes[i].name == names[i]);
        CHECK(with<3>::passes[i].view == i % 4);
    }
    CHECK(with<3>::passes[3].size.divisor == 3);
    CHECK(contains(with<3>::source<8>(), "mat4 from_first[3];"));
}

TEST_CASE("one further view is a second view to the letter") {
    using second =
        effect<directions<4, 4>, stochastic_layers<4>, hbao_plus, second_view<3>, atomic_minimum<>>;
    for (std::size_t i = 0; i < second::passes.size(); ++i) {
        CAPTURE(i);
        const auto below_recipe = [](const pass& of) {
            const std::string text = joined(of.pieces);
            return text.substr(text.find('\n'));
        };
        CHECK(below_recipe(second::passes[i]) == below_recipe(with<1>::passes[i]));
    }
}
