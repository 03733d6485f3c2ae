// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using pyramid = effect<directions<8, 4>, depth_pyramid<4>, hbao>;

static_assert(offers<depth_pyramid<>, depth_layers>);
static_assert(!offers<depth_pyramid<>, layers_behind_front>);
static_assert(pyramid::passes.size() == 5); // four levels, the main pass
static_assert(effect<directions<8, 4>, depth_pyramid<2>, hbao>::passes.size() == 3);

}

TEST_CASE("depth_pyramid makes each level of the one before, and the main pass sees them all") {
    CHECK(pyramid::passes[0].name == "depth_pyramid_base");
    for (unsigned level = 0; level < 4; ++level) {
        CAPTURE(level);
        const pass& each = pyramid::passes[level];
        CHECK(each.size.level == level);
        CHECK(each.size.guarded);
        CHECK(each.bindings.back().level == level);
        CHECK(each.bindings.back().how == access::store);
        if (level == 0)
            continue;
        CHECK(each.name == "depth_pyramid_level");
        CHECK(each.bindings[0].name == "input");
        CHECK(each.bindings[0].level == level - 1);
        CHECK(each.bindings[0].how == access::sample);
        CHECK(each.bindings[0].resource == each.bindings.back().resource);
    }
    for (const binding& b : pyramid::passes[4].bindings)
        CHECK(b.level == binding::all_levels);
    CHECK(contains(pyramid::passes[4].pieces[0].text,
                   "vec4 crease_load_depth_pyramid(ivec2 texel, int level) { return "
                   "texelFetch(crease_depth_pyramid, texel, level); }"));
}

TEST_CASE("depth_pyramid is fetched also where others are loaded, as a storage image shows one level") {
    using loading = effect<directions<8, 4>, depth_pyramid<4>, hbao, image_load>;
    for (const pass& each : loading::passes)
        for (const binding& b : each.bindings)
            CHECK(b.how != access::load);
}

TEST_CASE("depth_pyramid takes taps on the screen") {
    CHECK(recipe("poisson_disk:9/depth_pyramid/hbao_plus"));
    CHECK(recipe("half_directions/depth_pyramid/cosine_bitmask"));
    CHECK_FALSE(recipe("hemisphere_points:9/depth_pyramid/ssao"));
    CHECK_FALSE(recipe("directions:8x4/depth_pyramid:1/hbao"));
    CHECK_FALSE(recipe("directions:8x4/depth_pyramid:4x2/hbao"));
}
