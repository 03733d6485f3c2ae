// SPDX-License-Identifier: MIT
#include "scene/scene.hpp"
#include "truth/truth.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <algorithm>

using namespace crease::tools;

TEST_CASE("built-in scene: sound, with a triangle count as documented") {
    const mesh scene = built_in_scene();
    CHECK_NOTHROW(check_mesh(scene, "built-in"));
    CHECK(scene.triangles() > 5000);
    CHECK(scene.triangles() < 20000);
    for (std::size_t i = 0; i < scene.indices.size(); i += 3) {
        const glm::dvec3 a = scene.positions[scene.indices[i]], b = scene.positions[scene.indices[i + 1]],
                         c = scene.positions[scene.indices[i + 2]];
        REQUIRE(glm::length(glm::cross(b - a, c - a)) > 1e-7);
    }
}

TEST_CASE("built-in cameras: each sees surfaces, open sky, and both open and closed places") {
    const mesh scene = built_in_scene();
    const std::vector<camera> cameras = built_in_cameras();
    REQUIRE(cameras.size() >= 2);
    CHECK(cameras[0].name == "overview");
    for (const camera& from : cameras) {
        CAPTURE(from.name);
        const truth seen =
            trace_truth(scene, from, {.width = 160, .height = 90, .radius = from.ao_radius, .rays = 32});
        const auto sky = std::ranges::count(seen.depth.texels, from.far);
        CHECK(sky > 160 * 90 / 50);
        CHECK(sky < 160 * 90 / 3);
        CHECK(std::ranges::count_if(seen.ao_hard.texels, [](float v) { return v < 0.5f; }) > 100);
        CHECK(std::ranges::count_if(seen.ao_hard.texels, [](float v) { return v > 0.95f; }) > 1000);
    }
}
