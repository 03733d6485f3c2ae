// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace crease;

using by_default = effect<directions<4, 4>, stochastic_layers<4>, hbao>;
using named = effect<directions<4, 4>, stochastic_layers<4>, hbao, stratified>;
static_assert(!recipe("directions/single_layer/hbao/stratified"));

}

TEST_CASE("stratified is the default, and looks its subsets up in a table that is filled once") {
    CHECK(contains(by_default::source<0>(), "crease_stratified_subset"));
    const auto r = std::ranges::find(named::resources, "subsets", &resource::name);
    REQUIRE(r != named::resources.end());
    CHECK(r->life == lifetime::constant);
    CHECK(r->texels == format::r32_uint);
    CHECK(r->size.width_of(9999) == 256); // whatever the picture
    CHECK(r->size.height_of(9999) == 257);
    CHECK((r->fill == &fill_subsets<4>));
}

TEST_CASE("more than 16 samples are drawn in two halves by the table of 16") {
    using many = effect<directions<4, 4>, stochastic_layers<32>, hbao>;
    const auto r = std::ranges::find(many::resources, "subsets", &resource::name);
    REQUIRE(r != many::resources.end());
    CHECK((r->fill == &fill_subsets<16>));
    CHECK(contains(many::source<0>(), "crease_stratified_half(16, 1u) << 16u"));
}
