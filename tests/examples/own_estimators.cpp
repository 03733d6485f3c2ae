// SPDX-License-Identifier: MIT
// The estimator of a host's own composes with the parts of crease as its own do; and those by half slices are
// near the truth, over one layer and over several.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "frame/frame.hpp"
#include "measure/compare.hpp"
#include "openness.hpp"
#include "truth/truth.hpp"

#include <crease/spirv.hpp>

#include <doctest/doctest.h>

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

using namespace crease::tools;

namespace {

constexpr const char* estimators[] = {"openness", "gtao", "visibility_bitmask", "cosine_bitmask"};

crease::recipe recipe_of(const std::string& text) {
    std::vector<const crease::part*> known(std::begin(crease::all_parts), std::end(crease::all_parts));
    known.push_back(&engine::openness::description);
    const crease::recipe made(std::string_view(text), known);
    REQUIRE_MESSAGE(made, std::string(made.error()));
    return made;
}

void check_compiles(const std::string& text) {
    CAPTURE(text);
    const auto composed = std::make_unique<crease::composition>(recipe_of(text));
    REQUIRE_MESSAGE(*composed, std::string(composed->error()));
    const crease::effect_view effect = composed->view();
    for (const crease::pass& pass : effect.passes) {
        if (pass.stage == crease::stage_kind::geometry)
            continue;
        const crease::spirv::words module = crease::spirv::compile(pass);
        crease::spirv::validate(module);
        CHECK(crease::spirv::mismatches(effect, pass, crease::spirv::reflect(module)) ==
              std::vector<std::string>{});
    }
}

crease::vulkan::device& validated_device() {
    static crease::vulkan::device device({.name = "", .validation = true});
    return device;
}

frame run(const std::string& text, const gbuffer& inputs, const std::map<std::string, float>& settings = {}) {
    return run_effect(validated_device(), recipe_of(text), inputs,
                      {.radius = inputs.from.ao_radius, .settings = settings});
}

/// A rectangle before the camera, turned about two axes.
mesh slanted(float degrees, float roll) {
    glm::dmat4 turn = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -5));
    turn = glm::rotate(turn, glm::radians(double{roll}), glm::dvec3(0, 0, 1));
    turn = glm::rotate(turn, glm::radians(double{degrees}), glm::dvec3(1, 0, 0));
    mesh made{.positions = {}, .indices = {0, 1, 2, 2, 1, 3}};
    for (double y : {-4, 4})
        for (double x : {-4, 4})
            made.positions.emplace_back(turn * glm::dvec4(x, y, 0, 1));
    return made;
}

/// What the built-in scene looks like, and the truth of it.
struct scene_and_truth {
    gbuffer inputs;
    truth traced;
};

const scene_and_truth& built_in() {
    static const scene_and_truth made = [] {
        const mesh scene = built_in_scene();
        camera from = built_in_cameras().front();
        from.width = 320;
        from.height = 180;
        return scene_and_truth{
            rasterise(validated_device(), scene, from),
            trace_truth(scene, from,
                        {.width = from.width, .height = from.height, .radius = from.ao_radius, .rays = 128})};
    }();
    return made;
}

double error_of(const frame& made, const image& truth) {
    const gbuffer& inputs = built_in().inputs;
    const comparison error =
        compare(made.visibility, truth, {.depth = &inputs.depth, .far = inputs.from.far});
    CHECK(error.nonfinite == 0);
    MESSAGE("RMSE " << error.rmse << ", bias " << error.bias);
    return error.rmse;
}

}

TEST_CASE("they compose with every depth source of layers, traversal and output that fit") {
    for (const std::string estimator : estimators)
        for (const char* output : {"visibility_only", "bent_cone", "packed_bent_cone", "shade"}) {
            check_compiles("directions:4x4/single_layer/" + estimator + "/" + output);
            for (const char* traversal : {"all_layers", "front_first", "deferred_layers"})
                check_compiles("directions:4x4/stochastic_layers:8/" + estimator + "/" + traversal + "/" +
                               output);
        }
}

TEST_CASE("they compose with other views, a stage and filters") {
    for (const std::string estimator : estimators)
        for (const char* rest : {"orthographic/linear_depth/reconstructed_normals", "fragment",
                                 "tiled_noise/bilateral:2/upsample:2"})
            check_compiles("directions:5x3/single_layer/" + estimator + "/" + rest);
}

TEST_CASE("what they need of a sampler and of a depth source is asked for") {
    std::vector<const crease::part*> known(std::begin(crease::all_parts), std::end(crease::all_parts));
    known.push_back(&engine::openness::description);
    const crease::recipe points("hemisphere_points:16/single_layer/openness", known);
    CHECK_FALSE(points);
    CHECK(points.error().find("taps in order along directions") != std::string_view::npos);
}

TEST_CASE("a plane is open at every slant, by an even and an odd number of directions") {
    for (float degrees : {0.f, 30.f, 60.f, 80.f, 87.f})
        for (float roll : {0.f, 40.f}) {
            const camera from{.name = "front", .width = 160, .height = 90, .ao_radius = 0.5f};
            const gbuffer inputs = rasterise(validated_device(), slanted(degrees, roll), from);
            for (const std::string estimator : estimators)
                for (const char* directions : {"directions:1x8", "directions:4x8", "directions:5x8"}) {
                    const std::string text = directions + ("/single_layer/" + estimator) + "/bent_cone";
                    CAPTURE(text);
                    CAPTURE(degrees);
                    CAPTURE(roll);
                    const frame made = run(text, inputs);
                    CHECK(std::ranges::min(made.visibility.texels) > 0.99f);
                    CHECK(mean_angle(*made.bent, inputs.normal) < 0.1);
                }
        }
}

TEST_CASE("they are near the truth, and nearer with the layers behind the first") {
    const auto& [inputs, traced] = built_in();
    const std::string single = "directions:12x12/single_layer/",
                      layered = "directions:12x12/stochastic_layers:8/";
    const double gtao = error_of(run(single + "gtao", inputs), traced.ao_linear);
    CHECK(gtao < 0.072);                                                     // measured: 0.066
    CHECK(error_of(run(layered + "gtao", inputs), traced.ao_linear) < gtao); // 0.064
    const double bitmask = error_of(run(single + "visibility_bitmask", inputs), traced.ao_hard);
    CHECK(bitmask < 0.089); // 0.082
    // What lies behind is known, and a layer may be thinner.
    const frame known = run(layered + "visibility_bitmask", inputs, {{"thickness", 0.2f}});
    CHECK(error_of(known, traced.ao_hard) < 0.8 * bitmask); // 0.059
}

TEST_CASE("front_first finds what all layers do") {
    const gbuffer& inputs = built_in().inputs;
    for (const std::string estimator : estimators) {
        // Whose taps all lie ahead: one beside the receiver would hide what rounding decides.
        const std::string layered = "slices:2x4/stochastic_layers:8/" + estimator;
        const image all = run(layered + "/all_layers", inputs).visibility,
                    first = run(layered + "/front_first", inputs, {{"front_first.reach", 0}}).visibility;
        const comparison between = compare(first, all);
        CAPTURE(estimator);
        // Where rounding puts a point into the sector beside.
        CHECK(between.rmse < 0.001);
    }
}

TEST_CASE("bent normals are near the truth's") {
    const auto& [inputs, traced] = built_in();
    const double normals = mean_angle(inputs.normal, traced.bent);
    for (const std::string estimator : estimators) {
        const frame made = run("directions:8x8/single_layer/" + estimator + "/bent_cone", inputs);
        const double degrees = mean_angle(*made.bent, traced.bent);
        MESSAGE(estimator << ": " << degrees << " degrees to the truth's bent normal; the normals "
                          << normals);
        // Measured: 2.9, 2.5, 3.0 and 3.4 of 5.1. The last has no bound of its own:
        // tests/oracle/slice_closed_forms.cpp says by a wall how far it must bend.
        CHECK(degrees < (estimator == "cosine_bitmask" ? 1 : 0.65) * normals);
    }
}

TEST_CASE("the thicker layers are the more they hide") {
    const gbuffer& inputs = built_in().inputs;
    const auto seen = [&inputs](float thickness) {
        const std::vector<float> texels =
            run("directions:4x4/single_layer/visibility_bitmask", inputs, {{"thickness", thickness}})
                .visibility.texels;
        return std::accumulate(texels.begin(), texels.end(), 0.0) / static_cast<double>(texels.size());
    };
    CHECK(seen(0) == 1);
    CHECK(seen(0.1f) < 1);
    CHECK(seen(0.4f) < seen(0.1f));
    CHECK(seen(3) < seen(0.4f));
}
