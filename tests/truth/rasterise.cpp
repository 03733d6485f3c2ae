// SPDX-License-Identifier: MIT
#include "frame/frame.hpp"
#include "measure/compare.hpp"

#include "expect_error.hpp"
#include "placed_scene.hpp"
#include "rectangles.hpp"

#include "truth/truth.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace crease::tools;

namespace {

crease::vulkan::device& device() {
    static crease::vulkan::device one({.name = "", .validation = true});
    return one;
}

gbuffer rasterised(const placed_scene& scene) {
    return rasterise(device(), scene.triangles, scene.from);
}

image visibility_of(const gbuffer& inputs, std::string_view recipe, const frame_options& options = {}) {
    frame_options how = options;
    how.radius = inputs.from.ao_radius;
    return run_effect(device(), crease::recipe(recipe), inputs, how).visibility;
}

/// One recipe of each kind of estimator, and layers with the cameras that they are captured by.
constexpr const char* recipes[] = {
    "directions:4x4/single_layer/hbao/bilateral", "hemisphere_points:8/single_layer/ssao",
    "sphere_lines:8/single_layer/line_volume", "directions:4x4/stochastic_layers:4/hbao/atomic_minimum",
    "directions:4x4/stochastic_layers:4/hbao_plus/atomic_minimum/second_view"};

}

TEST_CASE("rasterise: the same picture wherever the scene is") {
    const gbuffer here = rasterised(placed_scene(1));
    for (const glm::dvec3 place : {glm::dvec3(1e5, 0, -1e5), glm::dvec3(-6.4e6, 6.4e6, 3)}) {
        const gbuffer there = rasterised(placed_scene(1, place));
        CHECK(there.depth.texels == here.depth.texels);
        CHECK(there.normals == here.normals);
        for (const char* recipe : recipes)
            CHECK(visibility_of(there, recipe).texels == visibility_of(here, recipe).texels);
    }
}

TEST_CASE("rasterise: a second camera is beside the first wherever both are") {
    const auto seen = [](const glm::dvec3& place) {
        const placed_scene scene(1, place);
        frame_options how;
        how.second = scene.from;
        how.second->eye += glm::dvec3(-3, 0.5, 0);
        return visibility_of(rasterised(scene), recipes[4], how).texels;
    };
    CHECK(seen({-6.4e6, 6.4e6, 3}) == seen({0, 0, 0}));
}

TEST_CASE("rasterise: the same picture of a scene of any size") {
    const gbuffer one = rasterised(placed_scene(1));
    for (const double size : {0x1p-80, 0x1p-40, 0x1p50, 0x1p80}) {
        CAPTURE(size);
        const gbuffer other = rasterised(placed_scene(size));
        CHECK(shrunk(other.depth, size).texels == one.depth.texels);
        CHECK(other.normals == one.normals);
        for (const char* recipe : recipes)
            CHECK(visibility_of(other, recipe).texels == visibility_of(one, recipe).texels);
    }
    for (const double size : {1e-12, 1e-6, 1e9, 1e15}) { // which round every position anew
        CAPTURE(size);
        const gbuffer other = rasterised(placed_scene(size));
        const double visibility =
            compare(visibility_of(other, recipes[0]), visibility_of(one, recipes[0])).mae;
        MESSAGE("size " << size << ": visibility differs by " << visibility);
        CHECK(visibility <= 9e-5); // measured: 2.4e-5
    }
}

TEST_CASE("rasterise: near and far of any size leave depth and occlusion right") {
    placed_scene scene(1);
    const truth traced =
        trace_truth(scene.triangles, scene.from,
                    {.width = scene.from.width, .height = scene.from.height, .radius = 0, .rays = 1});
    const gbuffer usual = rasterised(scene);
    const image expected = visibility_of(usual, recipes[0]);
    for (const auto& [near, far] : {std::pair{0.1f, 1e6f},
                                    {1e-3f, 1e3f},
                                    {1e-5f, 1e5f},
                                    {1e-7f, 1e7f},
                                    {1e-30f, 1e30f},
                                    {0.1f, 3e38f}}) {
        scene.from.near = near;
        scene.from.far = far;
        CAPTURE(scene.from.near);
        CAPTURE(scene.from.far);
        const gbuffer inputs = rasterised(scene);
        std::size_t apart = 0, background = 0;
        for (std::size_t i = 0; i < inputs.depth.texels.size(); ++i) {
            const float depth = inputs.depth.texels[i], right = traced.depth.texels[i];
            background += depth == far;
            if (depth < far && right < 100)
                apart += std::abs(depth - right) > 1e-5f * right;
        }
        MESSAGE("near " << near << ", far " << far << ": " << apart << " depths apart");
        CHECK(apart <= 20); // at silhouettes; measured: 5
        CHECK(background == static_cast<std::size_t>(std::ranges::count(usual.depth.texels, 100.0f)));
        const double visibility = compare(visibility_of(inputs, recipes[0]), expected).mae;
        MESSAGE("visibility differs by " << visibility);
        CHECK(visibility <= 6e-6); // measured: 1.5e-6
    }
    scene.from.near = 1e37f;
    scene.from.far = 3e38f;
    CHECK(std::ranges::all_of(visibility_of(rasterised(scene), recipes[0]).texels,
                              [](float texel) { return texel == 1; }));
}

TEST_CASE("rasterise: the rasteriser sees what the tracer sees, through each lens and depth") {
    placed_scene scene(1);
    for (const bool orthographic : {false, true})
        for (const glm::dvec2 shift : {glm::dvec2(0), glm::dvec2(0.3, -0.2)}) {
            scene.from.orthographic = orthographic;
            scene.from.shift = shift;
            const truth traced =
                trace_truth(scene.triangles, scene.from,
                            {.width = scene.from.width, .height = scene.from.height, .radius = 0, .rays = 1});
            image expected;
            for (const device_depth_kind kind :
                 {device_depth_kind::reversed, device_depth_kind::standard, device_depth_kind::infinite}) {
                if (orthographic && kind == device_depth_kind::infinite)
                    continue;
                CAPTURE(orthographic);
                CAPTURE(shift.x);
                CAPTURE(name_of(kind));
                const gbuffer inputs = rasterise(device(), scene.triangles, scene.from, 4, kind);
                std::size_t apart = 0;
                for (std::size_t i = 0; i < inputs.depth.texels.size(); ++i)
                    apart += std::abs(inputs.depth.texels[i] - traced.depth.texels[i]) >
                             1e-4f * traced.depth.texels[i];
                CHECK(apart <= 20); // at silhouettes
                const image seen = visibility_of(inputs, recipes[0]);
                if (expected.texels.empty())
                    expected = seen;
                CHECK(compare(seen, expected).mae <= 1e-3);
                CHECK(compare(visibility_of(inputs, std::string(recipes[0]) + "/linear_depth"), seen).mae <=
                      1e-3);
            }
        }
}

TEST_CASE("rasterise: near too small for a depth buffer is refused") {
    placed_scene scene(1);
    scene.from.near = 1e-36f;
    expect_error<scene_error>(
        "the camera 'overview': near is 1e-36, and a 32-bit depth buffer tells depths apart up "
        "to 1.3e+33 times as far, but the scene reaches",
        [&] { rasterised(scene); });
}

TEST_CASE("rasterise: an eye too far away is refused") {
    placed_scene scene(1);
    scene.from.eye = {1.9e18, 1.9e18, 1.9e18};
    expect_error<scene_error>("no triangle has an area; move the camera nearer", [&] { rasterised(scene); });
    scene.from.eye = {0, 0, 1e8};
    const gbuffer inputs = rasterised(scene);
    expect_error<scene_error>("the radius 1.2 is out of what 32-bit positions allow",
                              [&] { visibility_of(inputs, recipes[0]); });
}

TEST_CASE("rasterise: normals are unit, face the camera, and point along the axes of view space") {
    mesh room; // a floor, a ceiling, a left, a right and a back wall
    add_rectangle(room, {-2, -1, 1}, {4, 0, 0}, {0, 0, -7});
    add_rectangle(room, {-2, 1, 1}, {4, 0, 0}, {0, 0, -7});
    add_rectangle(room, {-2, -1, 1}, {0, 2, 0}, {0, 0, -7});
    add_rectangle(room, {2, -1, 1}, {0, 2, 0}, {0, 0, -7});
    add_rectangle(room, {-2, -1, -6}, {4, 0, 0}, {0, 2, 0});
    camera from;
    from.vfov_deg = 90;
    from.width = 64;
    from.height = 32;
    const image normal = rasterise(device(), room, from).normal;
    const auto at = [&](unsigned x, unsigned y) {
        return glm::vec3(normal.at(x, y, 0), normal.at(x, y, 1), normal.at(x, y, 2));
    };
    CHECK(at(32, 30) == glm::vec3(0, 1, 0));
    CHECK(at(32, 1) == glm::vec3(0, -1, 0));
    CHECK(at(1, 16) == glm::vec3(1, 0, 0));
    CHECK(at(62, 16) == glm::vec3(-1, 0, 0));
    CHECK(at(32, 16) == glm::vec3(0, 0, 1));
}
