// SPDX-License-Identifier: MIT
// Parts that crease does not know compose with those that it does.
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

constexpr crease::glsl_file nearness_glsl{"host/nearness.glsl", R"(
struct crease_estimate { float occlusion; };
struct crease_contribution { float occlusion; };
crease_estimate crease_estimate_begin(crease_receiver receiver) { return crease_estimate(0.0); }
void crease_estimate_turn(inout crease_estimate estimate, vec2 direction) {}
crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    bool near = tap.inside && distance(position, receiver.position) < crease_radius;
    return crease_contribution(near ? 1.0 : 0.0);
}
void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution) {
    estimate.occlusion += contribution.occlusion;
}
float crease_estimate_occlusion(crease_estimate estimate) { return estimate.occlusion / float(crease_nearness_most); }
)"};

struct nearness_part {
    using needs = crease::traits<crease::screen_taps, crease::depth_layers>;
    static constexpr crease::number takes[] = {{"most", 1, 99, 10, "taps that darken fully"}};
    static constexpr crease::part description{
        .kind = crease::role::estimator,
        .name = "nearness",
        .summary = "counts what is near",
        .source = "the host",
        .glsl = &nearness_glsl,
        .numbers = takes,
        .needs = needs::list,
        .fold = &crease::fold_max_glsl,
    };
};

template <int Most>
struct nearness : nearness_part {
    static constexpr int numbers[] = {Most};
};

using fixed = crease::effect<crease::poisson_disk<>, crease::single_layer, nearness<20>, crease::bilateral<>>;
static_assert(contains(fixed::passes[0].pieces[0].text,
                       "layout(constant_id = 3) const int crease_nearness_most = 20;"));

}

TEST_CASE("a host's own estimator composes at compile time and from a recipe alike") {
    static constexpr const crease::part* known[] = {
        &crease::poisson_disk_part::description, &crease::single_layer::description,
        &nearness_part::description, &crease::bilateral_part::description};
    const crease::recipe chosen("poisson_disk/single_layer/nearness:20/bilateral", known);
    REQUIRE(chosen);
    const crease::composition composed(chosen);
    CHECK(joined(composed.view().passes[0].pieces) == fixed::source<0>);
    CHECK(piece_of(composed.view().passes[0], "host/nearness.glsl") == nearness_glsl.text);
}

TEST_CASE("a host's own estimator is refused beside a sampler that does not fit") {
    static constexpr const crease::part* known[] = {&crease::hemisphere_points_part::description,
                                                    &crease::single_layer::description,
                                                    &nearness_part::description};
    CHECK(crease::recipe("hemisphere_points/single_layer/nearness", known).error() ==
          "crease::effect: the estimator needs taps on the screen, which the sampler does not propose "
          "(nearness, hemisphere_points)");
}
