// SPDX-License-Identifier: MIT
// The truth of scenes far from the origin or the eye, of any size, near and far.
#include "truth/truth.hpp"

#include "expect_error.hpp"
#include "measure/compare.hpp"
#include "placed_scene.hpp"
#include "rectangles.hpp"
#include "scene/solids.hpp"

#include <algorithm>
#include <cmath>

using namespace crease::tools;

namespace {

truth truth_of(const placed_scene& scene) {
    return trace_truth(scene.triangles, scene.from,
                       {.width = scene.from.width,
                        .height = scene.from.height,
                        .radius = scene.from.ao_radius,
                        .rays = 16,
                        .first_layer = true});
}

/// How the visibility of an image differs in the mean.
double mean_difference(const image& a, const image& b) {
    return compare(a, b).mae;
}

}

TEST_CASE("truth: the same wherever the scene is") {
    const truth here = truth_of(placed_scene(1));
    for (const glm::dvec3 place : {glm::dvec3(1e5, 0, -1e5), glm::dvec3(-6.4e6, 6.4e6, 3)}) {
        const truth there = truth_of(placed_scene(1, place));
        CHECK(there.depth.texels == here.depth.texels);
        CHECK(there.normal.texels == here.normal.texels);
        CHECK(there.bent.texels == here.bent.texels);
        CHECK(there.ao_hard.texels == here.ao_hard.texels);
        CHECK(there.ao_linear.texels == here.ao_linear.texels);
        CHECK(there.ao_quad.texels == here.ao_quad.texels);
        CHECK(there.ao_first_layer.texels == here.ao_first_layer.texels);
    }
}

TEST_CASE("truth: the same for a scene of any size") {
    const truth one = truth_of(placed_scene(1));
    for (const double size : {0x1p-80, 0x1p-40, 0x1p50, 0x1p80}) {
        CAPTURE(size);
        const truth other = truth_of(placed_scene(size));
        CHECK(shrunk(other.depth, size).texels == one.depth.texels);
        CHECK(other.normal.texels == one.normal.texels);
        CHECK(other.bent.texels == one.bent.texels);
        CHECK(other.ao_linear.texels == one.ao_linear.texels);
        CHECK(other.ao_first_layer.texels == one.ao_first_layer.texels);
    }
    for (const double size : {1e-12, 1e-6, 1e9, 1e15}) { // which round every position anew
        CAPTURE(size);
        const truth other = truth_of(placed_scene(size));
        const double visibility = mean_difference(other.ao_linear, one.ao_linear),
                     depth = mean_difference(shrunk(other.depth, size), one.depth);
        MESSAGE("size " << size << ": visibility differs by " << visibility << ", depth by " << depth);
        CHECK(visibility <= 5e-7); // measured: 1.4e-7
        CHECK(depth <= 2.5e-6);    // measured: 6.5e-7
    }
}

TEST_CASE("truth: an eye too far away is refused") {
    camera from = look({0, 0, 1.9e18}, {0, 0, 0});
    mesh box;
    add_box(box, {-1, -1, -1}, {1, 1, 1});
    const truth_settings settings{.width = 4, .height = 4, .radius = 1, .rays = 1};
    const auto refused = [&](const std::string& part) {
        expect_error<scene_error>(part, [&] { trace_truth(box, from, settings); });
    };
    refused(
        "the radius 1 is out of what 32-bit positions allow from this eye, which the scene begins 1.9e+18 ");
    from.eye = {1e8, 0, 0};
    from.far = 2e8f;
    refused(
        "the radius 1 is out of what 32-bit positions allow from this eye, which the scene begins 1e+08 ");
    from.eye = {1.9e18, 1.9e18, 1.9e18};
    refused("no triangle has an area; move the camera nearer");
}

TEST_CASE("truth: near and far of any size") {
    placed_scene scene(1);
    const truth expected = truth_of(scene);
    for (const auto& [near, far] : {std::pair{1e-30f, 1e30f}, {1e-7f, 1e7f}, {1e-38f, 3e38f}}) {
        scene.from.near = near;
        scene.from.far = far;
        const truth seen = truth_of(scene);
        CHECK(seen.ao_linear.texels == expected.ao_linear.texels);
        CHECK(*std::ranges::max_element(seen.depth.texels) == far);
    }
    scene.from.near = 1e37f;
    CHECK(std::ranges::all_of(truth_of(scene).ao_linear.texels, [](float v) { return v == 1; }));
}

TEST_CASE("truth: no corner that rounding folds up makes a number that is none") {
    mesh scene;
    add_rectangle(scene, {-500, 0, -900}, {1000, 0, 0}, {0, 0, 1000});
    for (unsigned i = 0; i < 64; ++i) // 32-bit positions are 3e-5 apart there
        add_rectangle(scene, {300 + 0.1 * i, 0.5, -400}, {1e-5, 0, 0}, {0, 1e-5, 1e-5});
    const camera from = look({0, 3, 0}, {0, 0, -100});
    const truth seen = trace_truth(scene, from, {.width = 32, .height = 18, .radius = 2, .rays = 16});
    for (const image* pixels : {&seen.depth, &seen.normal, &seen.bent, &seen.ao_linear})
        CHECK(std::ranges::all_of(pixels->texels, [](float texel) { return std::isfinite(texel); }));
}
