// SPDX-License-Identifier: MIT
// Layers behind the first: the estimators against the oracle that knows them all, and what a capture keeps.
#include "captured.hpp"
#include "techniques.hpp"

#include "frame/frame.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <optional>

namespace {

using oracle::compose;
using oracle::lens;
using oracle::technique;
using oracle::techniques;

std::vector<float> run_with_all(const oracle::picture& p, const crease::effect_view& effect,
                                const crease::parameters& how, unsigned samples) {
    const given_layers given(effect);
    crease::vulkan::runner runner(oracle::device(), given, static_cast<unsigned>(p.width),
                                  static_cast<unsigned>(p.height));
    oracle::upload(runner, given, p);
    runner.upload("captured_layers", oracle::share_out(p, samples));
    runner.run(how);
    return runner.download("visibility");
}

/// How a technique's effect over six samples that share out all layers differs from the oracle's.
/// @param reach  within which a front surface settles its tap, radii; else the default
/// @param turn  added to the normals
oracle::difference differ(const technique& t, const std::string& parts, lens kind,
                          std::optional<float> reach = {}, glm::vec3 turn = {}) {
    oracle::picture p = oracle::many_layers(kind, 97, 61, 6);
    for (glm::vec3& normal : p.normals)
        normal = glm::normalize(normal + turn);
    const auto composed =
        compose(t.sampler + "/stochastic_layers:6/" + t.estimator + "/atomic_minimum" + parts);
    crease::parameters how = oracle::view_parameters(p, composed->view(), 0.8);
    if (reach)
        oracle::set(how, *composed, "reach", *reach);
    const oracle::settings s = oracle::settings_of(how, *composed);
    const auto expected =
        oracle::main_pass(p, s, 1, false, [&](const oracle::receiver& r) { return t.occlusion(p, r, s); });
    return oracle::compare(run_with_all(p, composed->view(), how, 6), expected);
}

// A front surface in the tangent plane itself settles its tap or not, by rounding, and then leaves the look
// to another.
constexpr oracle::difference of_ties{
    .typical = 0.03, .mean = 0.0024, .border = 0.0012, .most = 0.6, .bias = 0.0012};

/// How many samples of all texels keep each of some stacked quads, nearest first.
struct census {
    std::vector<double> kept; ///< by layer
    double trials = 0;        ///< samples of all texels
};

census count_layers(const std::string& coverage, float opacity, unsigned samples) {
    constexpr unsigned side = 160;
    oracle::triangles stack;
    for (float depth : {4.0f, 2.0f, 5.0f, 3.0f}) // drawn in this order
        for (glm::vec3 corner : oracle::wall(depth))
            stack.push_back(corner);
    oracle::layer_capture capture("atomic_minimum/" + coverage, samples, side, side);
    capture.draw(stack, {.opacity = opacity});
    const std::vector<std::uint32_t> bits = capture.runner().download_uint("captured_layers");

    std::size_t others = 0; // at depths where nothing was drawn
    census found{.kept = std::vector<double>(4), .trials = static_cast<double>(bits.size())};
    for (std::uint32_t each : bits) {
        if (each == oracle::kept_nothing)
            continue;
        const long layer = std::lround(std::bit_cast<float>(each)) - 2;
        if (layer >= 0 && layer < 4)
            ++found.kept[static_cast<std::size_t>(layer)];
        else
            ++others;
    }
    CHECK(others == 0);
    return found;
}

}

TEST_CASE("every estimator combines all layers of a tap by the greatest") {
    for (const technique& t : techniques())
        for (lens kind : {lens::standard, lens::reversed, lens::orthographic}) {
            CAPTURE(t.estimator);
            CAPTURE(static_cast<int>(kind));
            oracle::check_within(differ(t, kind == lens::orthographic ? "/orthographic" : "", kind),
                                 oracle::of_rounding);
        }
}

TEST_CASE("layers after the eighth and beyond the sixteenth count too, to the last sample") {
    for (const unsigned count : {12u, 20u}) {
        CAPTURE(count);
        // Half planes that stand behind one another, each a step further to the left than the one before it.
        std::vector<oracle::surface> stairs;
        for (unsigned i = 0; i < count; ++i)
            stairs.push_back({oracle::surface::kind::half_plane,
                              {1.2 - 3.0 / count * i, 0, -2.5 - 3.0 / count * i},
                              {0, 0, 1}});
        const oracle::picture p = oracle::draw_all(stairs, lens::standard, 97, 61);
        for (const technique& t : techniques())
            for (const std::string traversal : {"", "/front_first:0"}) {
                CAPTURE(t.estimator);
                CAPTURE(traversal);
                const auto composed = compose(t.sampler + "/stochastic_layers:" + std::to_string(count) +
                                              "/" + t.estimator + "/atomic_minimum" + traversal);
                crease::parameters how = oracle::view_parameters(p, composed->view(), 0.8);
                if (!traversal.empty())
                    oracle::set(how, *composed, "reach", 0);
                const oracle::settings s = oracle::settings_of(how, *composed);
                const auto expected = oracle::main_pass(
                    p, s, 1, false, [&](const oracle::receiver& r) { return t.occlusion(p, r, s); });
                oracle::check_within(oracle::compare(run_with_all(p, composed->view(), how, count), expected),
                                     oracle::of_rounding);
            }
    }
}

TEST_CASE(
    "looking at the front first and skipping nothing gives the same; skipping what cannot matter almost") {
    for (const technique& t : techniques()) {
        CAPTURE(t.estimator);
        for (const std::string traversal : {"front_first:0", "front_first:1"}) {
            CAPTURE(traversal);
            oracle::check_within(differ(t, "/" + traversal, lens::standard, 0.0f), oracle::of_rounding);
        }
    }
}

TEST_CASE("layers behind come after all fronts of their direction, of the first of each four taps") {
    struct shape {
        std::string sampler;
        int directions, steps; ///< 0 directions: of the disk
        bool horizons;
    };
    // Of the last four the directions are not taken together: too many groups, too many batches, too many
    // taps.
    const shape shapes[] = {{"directions:6x5", 6, 5, true},    {"directions:4x8", 4, 8, false},
                            {"poisson_disk:14", 0, 14, false}, {"directions:9x7", 9, 7, true},
                            {"directions:2x35", 2, 35, false}, {"directions:2x64", 2, 64, true},
                            {"poisson_disk:70", 0, 70, false}};
    for (const shape& of : shapes)
        for (bool skip : {false, true})
            for (unsigned looks : {1u, 3u}) {
                CAPTURE(of.sampler);
                CAPTURE(skip);
                CAPTURE(looks);
                const technique t{of.sampler, of.horizons ? "hbao" : "hbao_plus",
                                  [&](const auto& p, const auto& r, const auto& s) {
                                      const auto taps =
                                          of.directions == 0
                                              ? oracle::poisson_disk(p, r, s, of.steps)
                                              : oracle::directions(p, r, s, of.directions, of.steps);
                                      const oracle::deferral how{.looks = looks, .skip = skip};
                                      return of.horizons ? oracle::hbao(p, r, s, taps, how)
                                                         : oracle::hbao_plus(p, r, s, taps, how);
                                  }};
                const std::string traversal =
                    "/deferred_layers:" + std::to_string(skip) + "x" + std::to_string(looks);
                oracle::check_within(differ(t, traversal, lens::standard, 0.0f),
                                     skip && !of.horizons ? of_ties : oracle::of_rounding);
            }
}

TEST_CASE("a front surface settles nothing where the normal looks away from the eye") {
    const technique t{"directions:6x5", "hbao_plus", [&](const auto& p, const auto& r, const auto& s) {
                          return oracle::hbao_plus(p, r, s, oracle::directions(p, r, s, 6, 5),
                                                   {.looks = 3, .skip = true});
                      }};
    oracle::check_within(differ(t, "/deferred_layers:1x3", lens::standard, 0.0f, {1.2f, 0.4f, -1.5f}),
                         of_ties);
}

TEST_CASE("a sample keeps layer j with probability alpha (1 - alpha)^(j - 1)") {
    for (const char* coverage : {"stratified", "simple_hash", "hash_4d"})
        for (float alpha : {0.2f, 0.5f})
            for (unsigned samples : {1u, 4u, 8u, 16u, 32u}) {
                CAPTURE(std::string(coverage));
                CAPTURE(alpha);
                CAPTURE(samples);
                const census found = count_layers(coverage, alpha, samples);
                for (std::size_t j = 0; j < 4; ++j) {
                    const double p = alpha * std::pow(1.0 - alpha, static_cast<double>(j));
                    // Five standard deviations of independent coins, which hash_4d throws fewer of: see
                    // coverages.cpp.
                    const double coins = found.trials / (std::string(coverage) == "hash_4d" ? 12 : 1);
                    const double error = 5 * std::sqrt(p * (1 - p) / coins);
                    CAPTURE(j);
                    CHECK(std::abs(found.kept[j] / found.trials - p) < error);
                }
            }
}

TEST_CASE("with opacity 1 a stochastic effect is its single-layer one") {
    using namespace crease::tools;
    const mesh courtyard = built_in_scene();
    mesh corner; // a floor and a wall: no edge has anything behind it
    corner.positions = {{-9, -1, 1}, {9, -1, 1}, {9, -1, -5}, {-9, -1, -5}, {9, 8, -5}, {-9, 8, -5}};
    corner.indices = {0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5};
    camera from = built_in_cameras().front();
    from.width = 240;
    from.height = 135;
    camera at_corner = from;
    at_corner.eye = {0, 0.5f, 0};
    at_corner.target = {0.3f, -0.6f, -4};
    at_corner.ao_radius = 1;
    const gbuffer of_courtyard = rasterise(oracle::device(), courtyard, from),
                  of_corner = rasterise(oracle::device(), corner, at_corner);
    const auto others = [&](const gbuffer& inputs, const technique& t, const std::string& parts) {
        const auto run = [&](const std::string& text, const std::map<std::string, float>& settings) {
            return run_effect(oracle::device(), crease::recipe(std::string_view(text)), inputs,
                              {.radius = 1, .settings = settings})
                .visibility.texels;
        };
        const std::vector<float> single = run(t.sampler + "/single_layer/" + t.estimator, {});
        const std::vector<float> layered =
            run(t.sampler + "/stochastic_layers:4/" + t.estimator + "/" + parts, {{"opacity", 1.0f}});
        std::size_t count = 0;
        for (std::size_t i = 0; i < single.size(); ++i)
            count += std::abs(single[i] - layered[i]) > 1.5f / 255;
        return count;
    };
    const bool has_samples = (oracle::device().features().depth_samples & 4) != 0;
    if (!has_samples)
        MESSAGE("the device lacks depth images of 4 samples: multisampled is not tested on it");
    const bool places_samples = (oracle::device().features().centred_depth_samples & 4) != 0;
    if (!places_samples)
        MESSAGE(
            "the device lacks VK_EXT_sample_locations for 4 samples: centred_samples is not tested on it");
    for (const technique& t : techniques())
        for (const char* traversal : {"", "/front_first", "/deferred_layers"}) {
            if (t.estimator == "ssao" && std::string(traversal) == "/deferred_layers")
                continue; // it cannot resume at a tap
            CAPTURE(t.estimator);
            CAPTURE(std::string(traversal));
            CHECK(others(of_courtyard, t, std::string("atomic_minimum") + traversal) == 0);
            // Samples beside the centre of a texel see past an edge that the centre does not, so not the
            // courtyard; and of the two planes of a corner the one that is beside the centre is seen too.
            if (has_samples)
                CHECK(others(of_corner, t, std::string("multisampled") + traversal) <= 240 * 135 / 100);
            if (places_samples)
                CHECK(others(of_courtyard, t, std::string("centred_samples") + traversal) == 0);
        }
}

TEST_CASE("the layer storages agree, as far as chance lets them") {
    using namespace crease::tools;
    if ((oracle::device().features().depth_samples & 4) == 0) {
        MESSAGE("the device lacks depth images of 4 samples: the layer storages are not compared on it");
        return;
    }
    const mesh scene = built_in_scene();
    camera from = built_in_cameras().front();
    from.width = 320;
    from.height = 180;
    const gbuffer inputs = rasterise(oracle::device(), scene, from);
    const auto mean_of = [&](const char* storage) {
        const std::string text = std::string("directions:8x4/stochastic_layers:4/hbao/") + storage;
        const frame made = run_effect(oracle::device(), crease::recipe(std::string_view(text)), inputs,
                                      {.radius = from.ao_radius, .settings = {}});
        double sum = 0;
        for (float v : made.visibility.texels)
            sum += double{v};
        return sum / static_cast<double>(made.visibility.texels.size());
    };
    const double of_layers = mean_of("atomic_minimum");
    CHECK(std::abs(mean_of("multisampled") - of_layers) < 0.005);
    if (oracle::device().features().centred_depth_samples & 4)
        CHECK(std::abs(mean_of("centred_samples") - of_layers) < 0.005);
    else
        MESSAGE("the device lacks VK_EXT_sample_locations for 4 samples: centred_samples is not compared");
}

TEST_CASE("nothing drawn in a geometry pass is an error, not an empty picture") {
    const auto composed = compose("directions:4x4/stochastic_layers:4/hbao/atomic_minimum");
    crease::vulkan::runner runner(oracle::device(), composed->view(), 8, 8);
    runner.upload("depth", std::vector<float>(64, 1.0f));
    runner.upload("normal", std::vector<float>(256, 0.0f));
    CHECK_THROWS_WITH_AS(runner.run(composed->view().defaults),
                         "nothing is drawn in the geometry pass 'capture_layers'; set_geometry says what is",
                         crease::vulkan::error);
}
