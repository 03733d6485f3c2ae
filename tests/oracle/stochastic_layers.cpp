// SPDX-License-Identifier: MIT
// Layers behind the first: the estimators against the oracle that knows them all, and what a capture keeps.
#include "run.hpp"

#include "frame/frame.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>

namespace {

using oracle::lens;

constexpr std::uint32_t nothing = ~0u;

std::unique_ptr<crease::composition> compose(const std::string& text) {
    const crease::recipe chosen{std::string_view(text)};
    REQUIRE_MESSAGE(static_cast<bool>(chosen), chosen.error());
    return std::make_unique<crease::composition>(chosen);
}

/// What atomic_minimum would hold where the samples share out all layers of a texel in turn.
std::vector<std::uint32_t> share_out(const oracle::picture& p, unsigned samples) {
    std::vector<std::uint32_t> image;
    for (unsigned s = 0; s < samples; ++s)
        for (int y = 0; y < p.height; ++y)
            for (int x = 0; x < p.width; ++x) {
                if (p.background(x, y)) {
                    image.push_back(nothing);
                    continue;
                }
                const std::vector<glm::dvec3> all = p.positions(x, y);
                const glm::dvec3 kept = all[(s + static_cast<unsigned>(x)) % all.size()];
                image.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(-kept.z)));
            }
    return image;
}

std::vector<float> run_with_all(const oracle::picture& p, const crease::effect_view& effect,
                                const crease::parameters& how, unsigned samples) {
    crease::vulkan::runner runner(oracle::device(), effect, static_cast<unsigned>(p.width),
                                  static_cast<unsigned>(p.height));
    oracle::upload(runner, effect, p);
    crease::vulkan::upload(oracle::device(), runner.image_of("captured_layers"), share_out(p, samples));
    runner.run(how);
    return runner.download("visibility");
}

struct technique {
    std::string sampler, estimator;
    std::function<double(const oracle::picture&, const oracle::receiver&, const oracle::settings&)> occlusion;
};

const std::vector<technique>& techniques() {
    static const std::vector<technique> all{
        {"hemisphere_points:12", "ssao",
         [](const auto& p, const auto& r, const auto& s) {
             return oracle::ssao(p, r, s, oracle::hemisphere_points(p, r, s, 12));
         }},
        {"directions:6x3", "hbao",
         [](const auto& p, const auto& r, const auto& s) {
             return oracle::hbao(p, r, s, oracle::directions(p, r, s, 6, 3));
         }},
        {"directions:6x5", "hbao_plus",
         [](const auto& p, const auto& r, const auto& s) {
             return oracle::hbao_plus(p, r, s, oracle::directions(p, r, s, 6, 5));
         }},
    };
    return all;
}

/// How a technique's effect over six samples that share out all layers differs from the oracle's.
/// @param reach  front_reach, radii
oracle::difference differ(const technique& t, const std::string& parts, lens kind,
                          std::optional<float> reach = {}) {
    const oracle::picture p = oracle::draw_all(oracle::still_life(), kind, 97, 61);
    const auto composed =
        compose(t.sampler + "/stochastic_layers:6/" + t.estimator + "/atomic_minimum" + parts);
    crease::parameters how = oracle::view_parameters(p, composed->view(), 0.8);
    how.front_reach = reach.value_or(how.front_reach);
    const oracle::settings s = oracle::settings_of(how);
    const auto expected =
        oracle::main_pass(p, s, 1, false, [&](const oracle::receiver& r) { return t.occlusion(p, r, s); });
    return oracle::compare(run_with_all(p, composed->view(), how, 6), expected.visibility);
}

/// Rectangles that fill the picture at these depths, as triangles in view space.
std::vector<float> stack_of_quads(const std::vector<float>& depths) {
    std::vector<float> numbers;
    for (float d : depths)
        for (const glm::vec2 corner : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}})
            numbers.insert(numbers.end(), {4 * d * corner.x, 4 * d * corner.y, -d, 0, 0, 1});
    return numbers;
}

constexpr const char* vertex_glsl = R"glsl(#version 450
layout(push_constant) uniform transforms { mat4 clip_from_view; };
layout(location = 0) in vec3 position;
layout(location = 0) out vec3 anchor;
void main() {
    anchor = position;
    gl_Position = clip_from_view * vec4(position, 1.0);
}
)glsl";

constexpr const char* fragment_glsl = R"glsl(
layout(location = 0) in vec3 anchor;
void main() { crease_capture(anchor); }
)glsl";

/// How many samples of all texels keep each of some stacked quads, nearest first.
struct census {
    std::vector<double> kept;     ///< by layer
    double trials = 0;            ///< samples of all texels
    double variance_of_front = 0; ///< over the texels, of the number of samples that keep the front layer
};

census count_layers(const std::string& parts, float opacity, unsigned samples) {
    constexpr unsigned side = 160;
    const std::vector<float> depths{4, 2, 5, 3}; // drawn in this order
    const auto composed = compose("directions:4x4/stochastic_layers:" + std::to_string(samples) +
                                  "/hbao/atomic_minimum/" + parts);
    const crease::effect_view effect = composed->view();
    crease::vulkan::runner runner(oracle::device(), effect, side, side);
    crease::parameters how = effect.defaults;
    const glm::dmat4 projection = oracle::make_projection(lens::standard, 1);
    float matrix[16];
    for (int i = 0; i < 16; ++i)
        matrix[i] = static_cast<float>(projection[i / 4][i % 4]);
    crease::set_projection(how.view, matrix, side, side);
    how.opacity = opacity;
    const crease::piece vertex[] = {{"vertex", vertex_glsl}}, fragment[] = {{"fragment", fragment_glsl}};
    crease::vulkan::capturer capturer(oracle::device(), effect, 0, runner,
                                      {.vertex = vertex, .fragment = fragment, .push_constant_bytes = 64});
    const crease::vulkan::mesh mesh(oracle::device(), stack_of_quads(depths));
    capturer.draw(mesh, how, std::as_bytes(std::span(matrix)));
    const std::vector<std::uint32_t> bits = runner.download_uint("captured_layers");

    census found{.kept = std::vector<double>(4), .trials = static_cast<double>(bits.size())};
    std::vector<double> front(side * side);
    for (std::size_t i = 0; i < bits.size(); ++i) {
        if (bits[i] == nothing)
            continue;
        const int layer = static_cast<int>(std::lround(std::bit_cast<float>(bits[i]))) - 2;
        REQUIRE(layer >= 0);
        REQUIRE(layer < 4);
        ++found.kept[static_cast<std::size_t>(layer)];
        front[i % front.size()] += layer == 0;
    }
    const double mean = found.kept[0] / static_cast<double>(front.size());
    for (double n : front)
        found.variance_of_front += (n - mean) * (n - mean) / static_cast<double>(front.size());
    return found;
}

}

TEST_CASE("every estimator folds all layers of a tap by the greatest") {
    for (const technique& t : techniques())
        for (lens kind : {lens::standard, lens::reversed, lens::orthographic}) {
            CAPTURE(t.estimator);
            CAPTURE(static_cast<int>(kind));
            const oracle::difference d = differ(t, kind == lens::orthographic ? "/orthographic" : "", kind);
            CHECK(d.typical < 0.02);
            CHECK(d.mean < 0.6 / 255);
        }
}

TEST_CASE(
    "looking at the front first and skipping nothing gives the same; skipping what cannot matter almost") {
    for (const technique& t : techniques()) {
        CAPTURE(t.estimator);
        for (const std::string fold : {"front_first:0", "front_first:1"}) {
            CAPTURE(fold);
            CHECK(differ(t, "/" + fold, lens::standard, 0.0f).mean < 0.7 / 255);
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
                const std::string fold =
                    "/deferred_layers:" + std::to_string(skip) + "x" + std::to_string(looks);
                const oracle::difference d = differ(t, fold, lens::standard, 0.0f);
                CHECK(d.typical < 0.02);
                // Of horizons: forgetting how high a tap behind raised its direction is 0.14.
                CHECK(d.mean < (of.horizons ? 0.13 : 0.2) / 255);
            }
}

TEST_CASE("a sample keeps layer j with probability alpha (1 - alpha)^(j - 1)") {
    for (const char* sampling : {"stratified", "simple_hash", "hash_4d"})
        for (float alpha : {0.2f, 0.5f})
            for (unsigned samples : {1u, 4u, 8u, 16u, 32u}) {
                CAPTURE(std::string(sampling));
                CAPTURE(alpha);
                CAPTURE(samples);
                const census found = count_layers(sampling, alpha, samples);
                for (std::size_t j = 0; j < 4; ++j) {
                    const double p = alpha * std::pow(1.0 - alpha, static_cast<double>(j));
                    // Five standard deviations of independent coins.
                    const double error = 5 * std::sqrt(p * (1 - p) / found.trials);
                    CAPTURE(j);
                    CHECK(found.kept[j] / found.trials == doctest::Approx(p).epsilon(error / p));
                }
            }
}

TEST_CASE("the thresholds that stay on the surface keep the front layer as often, over many of their cells") {
    for (const char* sampling : {"isotropic_threshold", "anisotropic_threshold"})
        for (float alpha : {0.2f, 0.5f}) {
            CAPTURE(std::string(sampling));
            CAPTURE(alpha);
            const census found = count_layers(sampling, alpha, 8);
            CHECK(found.kept[0] / found.trials == doctest::Approx(alpha).epsilon(0.05));
        }
}

TEST_CASE("strata vary less than coins") {
    const double strata = count_layers("stratified", 0.2f, 8).variance_of_front,
                 coins = count_layers("simple_hash", 0.2f, 8).variance_of_front;
    MESSAGE("variance of the number of 8 samples that keep the front layer: strata " << strata << ", coins "
                                                                                     << coins);
    CHECK(coins == doctest::Approx(8 * 0.2 * 0.8).epsilon(0.05));
    CHECK(strata < 0.3); // of floor(1.6 + xi): 0.6 * 0.4
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
        for (const char* fold : {"", "/front_first", "/deferred_layers"}) {
            if (t.estimator == "ssao" && std::string(fold) == "/deferred_layers")
                continue; // it cannot resume at a tap
            CAPTURE(t.estimator);
            CAPTURE(std::string(fold));
            CHECK(others(of_courtyard, t, std::string("atomic_minimum") + fold) == 0);
            // Samples beside the centre of a texel see past an edge that the centre does not, so not the
            // courtyard; and of the two planes of a corner the one that is beside the centre is seen too.
            if (has_samples)
                CHECK(others(of_corner, t, std::string("multisampled") + fold) <= 240 * 135 / 100);
            if (places_samples)
                CHECK(others(of_courtyard, t, std::string("centred_samples") + fold) == 0);
        }
}

TEST_CASE("the carriers agree, as far as chance lets them") {
    using namespace crease::tools;
    if ((oracle::device().features().depth_samples & 4) == 0) {
        MESSAGE("the device lacks depth images of 4 samples: the carriers are not compared on it");
        return;
    }
    const mesh scene = built_in_scene();
    camera from = built_in_cameras().front();
    from.width = 320;
    from.height = 180;
    const gbuffer inputs = rasterise(oracle::device(), scene, from);
    const auto mean_of = [&](const char* carrier) {
        const std::string text = std::string("directions:8x4/stochastic_layers:4/hbao/") + carrier;
        const frame made = run_effect(oracle::device(), crease::recipe(std::string_view(text)), inputs,
                                      {.radius = from.ao_radius, .settings = {}});
        double sum = 0;
        for (float v : made.visibility.texels)
            sum += double{v};
        return sum / static_cast<double>(made.visibility.texels.size());
    };
    const double of_layers = mean_of("atomic_minimum");
    CHECK(mean_of("multisampled") == doctest::Approx(of_layers).epsilon(0.005));
    if (oracle::device().features().centred_depth_samples & 4)
        CHECK(mean_of("centred_samples") == doctest::Approx(of_layers).epsilon(0.005));
    else
        MESSAGE("the device lacks VK_EXT_sample_locations for 4 samples: centred_samples is not compared");
}

TEST_CASE("nothing drawn for a capture is an error, not an empty picture") {
    const auto composed = compose("directions:4x4/stochastic_layers:4/hbao/atomic_minimum");
    crease::vulkan::runner runner(oracle::device(), composed->view(), 8, 8);
    runner.upload("depth", std::vector<float>(64, 1.0f));
    runner.upload("normal", std::vector<float>(256, 0.0f));
    CHECK_THROWS_WITH_AS(runner.run(composed->view().defaults), "nothing was drawn for the capture 'layers'",
                         crease::vulkan::error);
}
