// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using four = effect<tap_grid<6>, single_layer, hbao_plus, multi_resolution<4, 5>>;
using six = effect<tap_grid<6>, single_layer, hbao_plus, multi_resolution<6, 5>>;

static_assert(four::passes.size() == 7); // three halvings, three that gather, the main pass
static_assert(six::passes.size() == 11);
static_assert(effect<tap_grid<>, single_layer, hbao_plus, multi_resolution<2>>::passes.size() == 3);

template <class... Parts>
using layered = effect<tap_grid<6>, linked_lists<12>, hbao_plus, multi_resolution<3, 5>, Parts...>;

/// How many layers an image of an effect has.
template <class Effect>
unsigned layers_of(std::string_view image) {
    for (const resource& each : Effect::resources)
        if (each.name == image)
            return each.layers;
    return 0;
}

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

TEST_CASE("the smaller pictures are all that is kept of them, a level for each resolution") {
    for (const resource& each : six::resources)
        if (each.name == "resolutions") {
            CHECK(each.levels == 5);
            CHECK(each.size.level == 1);
            CHECK(each.size.width_of(97, 8) == 56);
        }
    for (std::size_t i = 3; i < 6;
         ++i) // what gathers in the picture that is halved once writes the first level
        for (const binding& b : four::passes[i].bindings)
            if (writes(b.how))
                CHECK(b.level == four::passes[i].size.level - 1);
}

TEST_CASE(
    "the smaller pictures have as many layers as receivers may find, which hand on a word for each side") {
    CHECK(layers_of<four>("resolutions") == 1);
    CHECK(layers_of<four>("odd_occlusion") == 1);
    CHECK(layers_of<layered<>>("resolutions") == 12);
    CHECK(layers_of<layered<>>("odd_occlusion") == 1);
    CHECK(layers_of<layered<every_layer>>("odd_occlusion") == 12);
    CHECK(layers_of<layered<thin_layers>>("odd_occlusion") == 24);
    CHECK(layers_of<layered<every_layer, compressed<4>>>("resolutions") == 4);
    CHECK(layers_of<layered<thin_layers, compressed<4>>>("odd_occlusion") == 8);
    CHECK(layers_of<layered<every_layer, compressed_occluders<4>>>("resolutions") == 12);
    using two = effect<tap_grid<>, static_and_dynamic_layers<>, hbao_plus, multi_resolution<>>;
    CHECK(layers_of<two>("resolutions") == 2);
}

TEST_CASE("multi_resolution takes taps on the screen, of any sampler and for any estimator of such") {
    CHECK(recipe("poisson_disk:9/single_layer/hbao_plus/multi_resolution"));
    CHECK(recipe("directions:8x4/layer_array/hbao/multi_resolution:3x8"));
    CHECK_FALSE(recipe("hemisphere_points:9/single_layer/ssao/multi_resolution"));
    CHECK_FALSE(recipe("tap_grid:6/single_layer/hbao_plus/multi_resolution:1"));
    CHECK_FALSE(recipe("tap_grid:6/single_layer/hbao_plus/multi_resolution:7"));
}

TEST_CASE("what finds layers in the depth image or in shared memory finds them in one resolution") {
    for (const std::string own : {"front_first", "deferred_layers", "compute_strips"}) {
        CAPTURE(own);
        const std::string parts = "axes/linked_lists/hbao_plus/" + own;
        CHECK(recipe(parts));
        CHECK_FALSE(recipe(parts + "/multi_resolution"));
    }
}
