// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using by_default = effect<directions<4, 4>, stochastic_layers<4>, hbao>;
static_assert(offers<all_layers, any_view>);
static_assert(recipe("sample_box/summed_area/mean_height")); // whose default is another
static_assert(!recipe("sample_box/summed_area/mean_height/all_layers"));

}

TEST_CASE("all_layers is the default, and keeps what lies at the depth image too") {
    CHECK(contains(by_default::source<2>(), "crease_combine_first_layers"));
    CHECK(contains(by_default::source<1>(), "return depth >= front - 1e-4 * front;"));
    CHECK(by_default::passes.size() == 3); // captured, packed, looked at
}
