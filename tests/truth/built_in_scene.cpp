// SPDX-License-Identifier: MIT
// The error of the recipes against ray tracing, on the built-in scene: bounds are 8 % above what was
// measured.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "frame/frame.hpp"
#include "measure/compare.hpp"
#include "truth/truth.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace crease::tools;

namespace {

struct bound {
    const char* recipe;
    double most; ///< RMSE, or degrees
};

}

TEST_CASE("error to the linear truth") {
    const mesh scene = built_in_scene();
    camera from = built_in_cameras().front();
    from.width = 480;
    from.height = 270;
    const truth traced =
        trace_truth(scene, from, {.width = 480, .height = 270, .radius = from.ao_radius, .rays = 128});
    crease::vulkan::device device({.name = "", .validation = true});
    const gbuffer inputs = rasterise(device, scene, from);
    for (const bound& expected : {bound{"hemisphere_points:16/single_layer/ssao/bilateral", 0.125},
                                  {"directions:8x4/single_layer/hbao/bilateral", 0.093},
                                  {"directions:8x4/single_layer/hbao_plus/bilateral", 0.111},
                                  {"poisson_disk:16/single_layer/hbao_plus/bilateral", 0.136},
                                  {"directions:4x4/single_layer/hbao/bilateral", 0.093},
                                  {"directions:4x4/single_layer/hbao/bilateral:2/upsample:2", 0.105}}) {
        CAPTURE(std::string(expected.recipe));
        const frame made = run_effect(device, crease::recipe(std::string_view(expected.recipe)), inputs,
                                      {.radius = from.ao_radius, .settings = {}});
        const comparison error =
            compare(made.visibility, traced.ao_linear, {.depth = &inputs.depth, .far = from.far});
        MESSAGE(std::string(expected.recipe) << ": " << error.rmse);
        CHECK(error.nonfinite == 0);
        CHECK(error.rmse < expected.most);
    }
}

TEST_CASE("a radius larger than the scene still finds what is in the picture") {
    const mesh scene = built_in_scene();
    camera from = built_in_cameras().front();
    from.width = 240;
    from.height = 135;
    constexpr float radius = 50;
    const truth traced =
        trace_truth(scene, from, {.width = 240, .height = 135, .radius = radius, .rays = 64});
    crease::vulkan::device device({.name = "", .validation = true});
    const gbuffer inputs = rasterise(device, scene, from);
    const frame made = run_effect(device, crease::recipe("directions:4x8/single_layer/hbao/bilateral"),
                                  inputs, {.radius = radius, .settings = {}});
    const comparison error =
        compare(made.visibility, traced.ao_linear, {.depth = &inputs.depth, .far = from.far});
    MESSAGE("radius " << radius << ": RMSE " << error.rmse << ", bias " << error.bias);
    CHECK(error.rmse < 0.165);
    CHECK(std::abs(error.bias) < 0.06);
}

TEST_CASE("stochastic layers give back what hidden geometry takes, and bent normals are near the truth's") {
    const mesh scene = built_in_scene();
    camera from = built_in_cameras().front();
    from.width = 480;
    from.height = 270;
    const truth traced = trace_truth(
        scene, from,
        {.width = 480, .height = 270, .radius = from.ao_radius, .rays = 128, .first_layer = true});
    const image mask = hidden_mask(traced);
    crease::vulkan::device device({.name = "", .validation = true});
    const gbuffer inputs = rasterise(device, scene, from);
    image depth = inputs.depth;
    for (std::size_t i = 0; i < depth.texels.size(); ++i)
        if (mask.texels[i] == 0)
            depth.texels[i] = from.far;
    const auto run = [&](const char* recipe) {
        return run_effect(device, crease::recipe(std::string_view(recipe)), inputs,
                          {.radius = from.ao_radius, .settings = {}});
    };
    const auto hidden_bias = [&](const char* recipe) {
        const comparison error =
            compare(run(recipe).visibility, traced.ao_linear, {.depth = &depth, .far = from.far});
        MESSAGE(std::string(recipe) << " where geometry is hidden: RMSE " << error.rmse << ", bias "
                                    << error.bias << ", of " << error.pixels << " pixels");
        return error.bias;
    };
    const double layered = hidden_bias("directions:8x4/stochastic_layers:16/hbao/bilateral"),
                 single = hidden_bias("directions:8x4/single_layer/hbao/bilateral");
    CHECK(layered < 0.55 * single); // measured: 0.51
    // The paper turns the normal by the whole horizon, however far that is, which the truth's falloff does
    // not.
    for (const bound& expected : {bound{"directions:8x4/single_layer/hbao/bent_cone/bilateral", 5.65},
                                  {"directions:8x4/single_layer/hbao_plus/bent_cone/bilateral", 5.65},
                                  {"hemisphere_points:32/single_layer/ssao/bent_cone/bilateral", 7.25}}) {
        const double degrees = mean_angle(*run(expected.recipe).bent, traced.bent);
        MESSAGE(std::string(expected.recipe)
                << ": " << degrees << " degrees to the truth's bent normal; the normals "
                << mean_angle(inputs.normal, traced.bent));
        CHECK(degrees < expected.most);
    }
}

TEST_CASE("the rasteriser sees what the tracer sees") {
    const mesh scene = built_in_scene();
    camera from = built_in_cameras().front();
    from.width = 240;
    from.height = 135;
    const truth traced = trace_truth(scene, from, {.width = 240, .height = 135, .radius = 0, .rays = 1});
    crease::vulkan::device device;
    const gbuffer inputs = rasterise(device, scene, from);
    std::size_t apart = 0;
    for (std::size_t i = 0; i < inputs.depth.texels.size(); ++i)
        apart += std::abs(inputs.depth.texels[i] - traced.depth.texels[i]) > 1e-4f * traced.depth.texels[i];
    CHECK(apart <= 32); // pixels on a silhouette go either way; measured: 8
}
