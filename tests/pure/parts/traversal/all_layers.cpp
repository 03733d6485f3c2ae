// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

static_assert(offers<all_layers, any_view>);
static_assert(!recipe("sample_box/summed_area/mean_height/all_layers"));

}

TEST_CASE("all_layers is the traversal where none is named, and combines by the greatest where nothing else is said") {
    using named = effect<directions<>, stochastic_layers<>, hbao_plus, all_layers>;
    using unnamed = effect<directions<>, stochastic_layers<>, hbao_plus>;
    CHECK(without_recipe(named::source<2>) == without_recipe(unnamed::source<2>));
    CHECK(has_part_of(unnamed::passes.back(), "traversal/all_layers.glsl"));
    CHECK(has_part_of(unnamed::passes.back(), "core/combine.glsl"));
}
