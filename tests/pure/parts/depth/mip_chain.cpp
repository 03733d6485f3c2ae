// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace crease;

using half = effect<sample_box, mip_chain<5, 2>, mean_height<>>;

static_assert(offers<mip_chain<>, layers_of_areas>);
static_assert(half::passes.size() == 8); // two of the range, five levels, the main pass

}

TEST_CASE("mip_chain makes each level of the one before, which is in the other image") {
    const auto even = std::ranges::find(half::resources, "even_levels", &resource::name);
    const auto odd = std::ranges::find(half::resources, "odd_levels", &resource::name);
    REQUIRE((even != half::resources.end() && odd != half::resources.end()));
    CHECK(even->layers == 3);
    CHECK(odd->layers == 2);
    CHECK((even->size.divisor == 2 && odd->size.divisor == 2));
    CHECK(half::passes[6].name == "level_4");
    CHECK(contains(half::passes[6].pieces[0].text, "const int crease_areas_level = 4;"));
    CHECK(has_part_of(half::passes[6], "depth/mip_chain_level.glsl"));
}

TEST_CASE("mip_chain needs no scan") {
    CHECK_FALSE(recipe("sample_box/mip_chain/mean_height/work_efficient_scan"));
    CHECK(recipe("box_area/mip_chain:4/unsharp_mask"));
}
