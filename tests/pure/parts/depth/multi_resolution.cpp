// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using four = effect<tap_grid<6>, multi_resolution<4, 5>, hbao_plus>;
using six = effect<tap_grid<6>, multi_resolution<6, 5>, hbao_plus>;

static_assert(offers<multi_resolution<>, depth_layers>);
static_assert(!offers<multi_resolution<>, layers_behind_front>);
static_assert(four::passes.size() == 7); // three halvings, three that gather, the main pass
static_assert(six::passes.size() == 11);
static_assert(effect<tap_grid<>, multi_resolution<2>, hbao_plus>::passes.size() == 3);

}

TEST_CASE("pictures are halved from fine to coarse, and gather from coarse to fine") {
    for (unsigned i = 0; i < 3; ++i) {
        CAPTURE(i);
        CHECK(four::passes[i].name == (i == 0 ? "halve_picture" : "halve_again"));
        CHECK(four::passes[i].size.level == i + 1);
        CHECK(four::passes[3 + i].size.level == 3 - i);
        CHECK(four::passes[3 + i].name.starts_with("gather_"));
    }
    CHECK(four::passes[3].name == "gather_3");
    CHECK(six::passes[5].name == "gather_5");
}

TEST_CASE("a pass that gathers reads what the one before it wrote, and not what it writes") {
    for (std::size_t i = 3; i < 7; ++i) {
        CAPTURE(i);
        const bool odd = four::passes[i].size.level % 2 == 1;
        for (const binding& b : four::passes[i].bindings) {
            CHECK((b.name != "odd_occlusion" || b.how == (odd ? access::store : access::sample)));
            CHECK((b.name != "even_occlusion" || b.how == (odd ? access::sample : access::store)));
        }
    }
}

TEST_CASE("multi_resolution takes taps on the screen, of any sampler and for any estimator of such") {
    CHECK(recipe("poisson_disk:9/multi_resolution/hbao_plus"));
    CHECK(recipe("directions:8x4/multi_resolution:3x8/hbao"));
    CHECK_FALSE(recipe("hemisphere_points:9/multi_resolution/ssao"));
    CHECK_FALSE(recipe("tap_grid:6/multi_resolution:1/hbao_plus"));
    CHECK_FALSE(recipe("tap_grid:6/multi_resolution:7/hbao_plus"));
}
