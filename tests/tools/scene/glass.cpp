// SPDX-License-Identifier: MIT
#include "scene/scene.hpp"
#include "truth/truth.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace crease::tools;

TEST_CASE("glass scene: sound, of several opacities, and most of it opaque") {
    const mesh scene = glass_scene();
    CHECK_NOTHROW(check_mesh(scene, "glass"));
    CHECK(scene.triangles() > 5000);
    CHECK(scene.triangles() < 40000);
    REQUIRE(scene.material_ids.size() == scene.triangles());
    std::set<float> opacities;
    for (const std::uint32_t id : scene.material_ids)
        opacities.insert(scene.materials[id].colour.a);
    CHECK(opacities.size() > 6);
    CHECK(opacities.contains(1));
    CHECK(*opacities.begin() > 0);
    CHECK(is_transparent(scene));
}

TEST_CASE("glass cameras: each sees through glass, and open and closed places") {
    const mesh scene = glass_scene(), whole = [&] {
        mesh opaque = scene;
        for (material& each : opaque.materials)
            each.colour.a = 1;
        return opaque;
    }();
    for (const camera& from : glass_cameras()) {
        CAPTURE(from.name);
        const truth_settings settings{.width = 80, .height = 45, .radius = from.ao_radius, .rays = 32};
        const truth seen = trace_truth(scene, from, settings), opaque = trace_truth(whole, from, settings);
        CHECK(seen.depth.texels == opaque.depth.texels);
        std::size_t changed = 0;
        for (std::size_t i = 0; i < seen.ao_linear.texels.size(); ++i)
            changed += std::abs(seen.ao_linear.texels[i] - opaque.ao_linear.texels[i]) > 0.1f;
        CHECK(changed > 80 * 45 / 20);
        CHECK(std::ranges::count_if(seen.ao_hard.texels, [](float v) { return v < 0.5f; }) > 20);
        CHECK(std::ranges::count_if(seen.ao_hard.texels, [](float v) { return v > 0.95f; }) > 300);
    }
}
