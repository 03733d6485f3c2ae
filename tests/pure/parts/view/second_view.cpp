// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using two = effect<directions<4, 4>, stochastic_layers<4>, hbao_plus, second_view<3>, atomic_minimum<>>;
using one = effect<directions<4, 4>, stochastic_layers<4>, hbao_plus, atomic_minimum<>>;
static_assert(two::view().views == 2 && one::view().views == 1);
static_assert(two::view().block_size() > one::view().block_size());
static_assert(!recipe("directions/stochastic_layers/hbao/second_view")); // needs an estimator of any eye
static_assert(!recipe("directions/single_layer/hbao_plus/second_view")); // needs layers of two cameras
static_assert(!recipe("directions/stochastic_layers/hbao_plus/second_view:5"));
static_assert(recipe("directions/stochastic_layers/hbao_plus/second_view/all_layers"));

}

TEST_CASE("second_view captures and packs for each camera, and looks with both in one pass") {
    REQUIRE(two::passes.size() == 5);
    constexpr unsigned cameras[] = {0, 1, 0, 1, 0};
    constexpr std::string_view names[] = {"capture_layers", "captured_layers_1", "pack_layers", "pack_layers",
                                          "visibility"};
    for (std::size_t i = 0; i < 5; ++i) {
        CAPTURE(i);
        CHECK(two::passes[i].view == cameras[i]);
        CHECK(two::passes[i].name == names[i]);
    }
    CHECK(two::passes[1].size.divisor == 3);
    CHECK(contains(two::source<3>(), "const int crease_view_index = 1;"));
    CHECK(contains(two::source<4>(), "mat4 from_first[1];"));
    CHECK(contains(two::source<4>(), "int crease_view_index = 0;")); // which it changes
    CHECK_FALSE(contains(two::source<4>(), "const int crease_view_index"));
    CHECK_FALSE(contains(one::source<2>(), "from_first"));
}

TEST_CASE("what is packed for the second camera is what that captured") {
    const auto reads = [](const pass& by, std::string_view name) {
        for (const binding& b : by.bindings)
            if (!writes(b.how) && two::resources[b.resource].name == name)
                return true;
        return false;
    };
    CHECK(reads(two::passes[2], "captured_layers"));
    CHECK_FALSE(reads(two::passes[2], "captured_layers_1"));
    CHECK(reads(two::passes[3], "captured_layers_1"));
    CHECK_FALSE(reads(two::passes[3], "captured_layers"));
}
