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
        CHECK(p.passes[i].size.divisor == divisors[i]);
        CHECK(p.passes[i].input_divisor == input_divisors[i]);
        CHECK(p.resources[p.passes[i].outputs[0]].size.divisor == divisors[i]);
    }
}

TEST_CASE("two upsamplings multiply") {
    const plan p = planned("directions/single_layer/hbao/upsample:2/upsample:3");
    REQUIRE(p.passes.size() == 3);
    CHECK(p.passes[0].size.divisor == 6);
    CHECK(p.passes[1].size.divisor == 3);
    CHECK(p.passes[2].size.divisor == 1);
}

TEST_CASE("each pass reads what the one before it writes, in the encoding between passes") {
    const plan p = planned("directions/single_layer/hbao/bilateral/upsample");
    CHECK(p.passes[0].input == -1);
    for (std::size_t i = 1; i < p.passes.size(); ++i) {
        CHECK(p.passes[i].input == static_cast<int>(p.passes[i - 1].outputs[0]));
        CHECK(p.resources[p.passes[i - 1].outputs[0]].texels == visibility_depth_encoding.texels);
        CHECK(p.passes[i].last == (i + 1 == p.passes.size()));
    }
    CHECK(p.resources[p.passes[p.passes.size() - 1].outputs[0]].texels == visibility_encoding.texels);
    CHECK(p.resources[p.resources.size() - 1].life == lifetime::output);
}
