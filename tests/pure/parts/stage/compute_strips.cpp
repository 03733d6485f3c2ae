// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using filtered = effect<axes<>, layer_array<16>, hbao, bilateral<>, compute_strips<4, 2, 20>>;
using in_images = effect<axes<>, layer_array<16>, hbao, bilateral<>, compute<4, 2>>;
static_assert(stage_of(compute_strips_part::description) == stage_kind::compute);
static_assert(filtered::passes[2].group_width() == 4 && filtered::passes[2].group_height() == 2);

}

TEST_CASE("compute_strips keeps layers in shared memory in the main pass, and nothing in others") {
    REQUIRE(filtered::passes.size() == 5);
    CHECK(contains(filtered::source<2>(), "shared vec4 crease_strips_groups[crease_strips_texels];\n"));
    CHECK(contains(filtered::source<2>(), "const int crease_compute_strips_apron = 20;\n"));
    CHECK(!contains(filtered::source<1>(), "shared "));
    for (std::string_view filter : {filtered::source<3>(), filtered::source<4>()})
        CHECK(!contains(filter, "crease_strips"));
    CHECK(!contains(in_images::source<2>(), "crease_strips"));
}

TEST_CASE("what is kept is counted in bytes: a depth, or four, of each texel of a row and of a column") {
    const choice stage = choice_of<compute_strips<8, 6, 10>>();
    CHECK(strip_bytes(stage, choice_of<single_layer>(), 1) == 4 * (28 * 6 + 8 * 26));
    CHECK(strip_bytes(stage, choice_of<peeled_layers<>>(), 1) == 16 * (28 * 6 + 8 * 26));
    CHECK(strip_bytes(stage, choice_of<single_layer>(), 2) == 4 * (36 * 12 + 16 * 32));
    CHECK(strip_bytes(choice_of<compute_strips<1024, 1024, 1024>>(), choice_of<layer_array<>>(), 16) >
          most_shared_bytes);
    CHECK(recipe("axes/single_layer/hbao/compute_strips:16x16x56"));
    CHECK_FALSE(recipe("axes/single_layer/hbao/compute_strips:16x16x57"));
    CHECK(recipe("axes/layer_array/hbao/compute_strips:8x8x28"));
    CHECK_FALSE(recipe("axes/layer_array/hbao/compute_strips:8x8x29"));
    CHECK_FALSE(recipe("axes/single_layer/hbao/compute_strips:16x16x56/upsample:2"));
}
