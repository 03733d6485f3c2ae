// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

namespace {

using namespace crease;

constexpr plan planned(std::string_view text) {
    return make_plan(recipe(text).choices());
}

static_assert(planned("directions/single_layer/hbao").passes.size() == 1);
static_assert(planned("directions/single_layer/hbao/bilateral").passes.size() == 3);
static_assert(planned("directions/single_layer/hbao/reconstructed_normals").resources.size() == 3);

}

TEST_CASE("what stands before upsample runs at its fraction of the resolution, what stands after in full") {
    const plan p = planned("directions/single_layer/hbao/bilateral/upsample:4/bilateral");
    REQUIRE(p.passes.size() == 6);
    const unsigned divisors[] = {4, 4, 4, 1, 1, 1};
    const unsigned input_divisors[] = {4, 4, 4, 4, 1, 1};
    for (std::size_t i = 0; i < 6; ++i) {
        CHECK(p.passes[i].divisor == divisors[i]);
        CHECK(p.passes[i].input_divisor == input_divisors[i]);
        CHECK(p.resources[p.passes[i].output].size.divisor == divisors[i]);
    }
}

TEST_CASE("two upsamplings multiply") {
    const plan p = planned("directions/single_layer/hbao/upsample:2/upsample:3");
    REQUIRE(p.passes.size() == 3);
    CHECK(p.passes[0].divisor == 6);
    CHECK(p.passes[1].divisor == 3);
    CHECK(p.passes[2].divisor == 1);
}

TEST_CASE("each pass reads what the one before it writes, in the encoding that it takes") {
    const plan p = planned("directions/single_layer/hbao/bilateral/upsample");
    CHECK(p.passes[0].input == -1);
    for (std::size_t i = 1; i < p.passes.size(); ++i) {
        CHECK(p.passes[i].input == static_cast<int>(p.passes[i - 1].output));
        CHECK(p.passes[i].what->input == p.passes[i - 1].result);
    }
    CHECK(p.passes[p.passes.size() - 1].result == &visibility_encoding);
    CHECK(p.resources[p.resources.size() - 1].life == lifetime::output);
}
