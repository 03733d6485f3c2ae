// SPDX-License-Identifier: MIT
// Taps that find their layers in shared memory give the picture of taps that read images, bit by bit; and
// they do find them there.
#include "abuffer.hpp"
#include "run.hpp"

#include "frame/frame.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace crease;
using oracle::lens;

/// The visibility of a picture in 32 bits.
std::vector<float> seen(const oracle::picture& p, const std::string& text, double radius = 0.5) {
    return oracle::run(p, text + "/r32f", radius);
}

inline constexpr glsl_file kept_alone_glsl{"test/kept_alone.glsl", R"glsl(
struct crease_layers {
    vec2 texel;
    float depth;
};

const int crease_most_layers = 1;

shared vec3 crease_kept_alone_texels[crease_strips_texels];

void crease_keep_in_strips(int place, vec2 texel) {
    crease_kept_alone_texels[place] = vec3(texel, crease_depth_at(texel));
}

crease_layers crease_fetch_layers(vec2 texel) {
    int place = crease_strips_place(texel);
    if (place < 0 || crease_kept_alone_texels[place].xy != texel)
        return crease_layers(texel, crease_background);
    return crease_layers(texel, crease_kept_alone_texels[place].z);
}

int crease_layer_count(crease_layers layers) { return 1; }

crease_layer crease_layer_at(crease_layers layers, int i) {
    return crease_layer_of(crease_view_position(layers.texel, layers.depth));
}
)glsl"};

/// A single layer that taps see where shared memory has the texel that they look for, and nowhere else.
struct kept_alone {
    static constexpr const glsl_file* files[] = {&kept_alone_glsl};
    static constexpr part description{
        .kind = role::depth_source,
        .name = "kept_alone",
        .summary = "what is in shared memory",
        .source = "",
        .files = files,
        .offers = traits<depth_layers, layers_in_strips>::list,
    };
};

/// The visibility of the middle of a picture, of which the rest is its guard band, by a recipe that may name
/// `kept_alone`.
std::vector<float> seen_in_middle(const oracle::picture& p, const std::string& text, double radius,
                                  unsigned guard) {
    static constexpr const part* known[] = {&axes_part::description,    &directions_part::description,
                                            &single_layer::description, &kept_alone::description,
                                            &hbao::description,         &upsample_part::description,
                                            &r32f::description,         &compute_strips_part::description};
    const auto composed = std::make_unique<composition>(recipe(std::string_view(text), known));
    REQUIRE_MESSAGE(*composed, composed->error());
    const unsigned width = static_cast<unsigned>(p.width) - 2 * guard,
                   height = static_cast<unsigned>(p.height) - 2 * guard;
    vulkan::runner runner(oracle::device(), *composed, width, height,
                          {.guard = guard, .constants = {}, .shaders = {}});
    oracle::upload(runner, *composed, p);
    parameters how = oracle::view_parameters(p, *composed, radius);
    const glm::mat4 projection(p.projection);
    REQUIRE(static_cast<bool>(set_projection(how.view, &projection[0][0], width, height, {}, guard)));
    runner.run(how);
    return runner.download("visibility");
}

std::size_t others(const std::vector<float>& a, const std::vector<float>& b) {
    REQUIRE(a.size() == b.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        count += a[i] == b[i] ? 0 : 1;
    return count;
}

}

TEST_CASE("strips in shared memory change no bit of a single layer's picture") {
    const auto check = [](const std::string& effect, const std::string& strips,
                          std::initializer_list<std::pair<int, int>> sizes) {
        for (const std::pair<int, int>& size : sizes) {
            const int width = size.first, height = size.second;
            CAPTURE(effect);
            CAPTURE(strips);
            CAPTURE(width);
            CAPTURE(height);
            const oracle::picture p = oracle::draw(oracle::still_life(), lens::off_centre, width, height);
            CHECK(others(seen(p, effect + "/compute_strips:" + strips), seen(p, effect + "/compute")) == 0);
        }
    };
    for (const char* strips : {"8x8x24", "16x4x20", "5x7x0", "1x1x24"})
        check("axes:8x24/single_layer/hbao", strips, {{97, 61}, {64, 40}, {1, 1}, {1, 9}, {7, 1}, {9, 8}});
    for (const char* effect :
         {"axes:8x40/single_layer/hbao_plus", "directions:5x6/single_layer/hbao",
          "half_directions:1x8/single_layer/cosine_bitmask",
          "poisson_disk:16/single_layer/hbao_plus/linear_depth/reconstructed_normals",
          "axes:8x24/single_layer/hbao/bilateral:2", "axes:8x24/single_layer/hbao/upsample:2",
          "axes:8x24/single_layer/hbao/upsample:3"})
        check(effect, "8x4x20", {{97, 61}, {7, 5}});
}

TEST_CASE("taps along the axes find every texel in shared memory that is within the apron, and no other") {
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, 97, 61);
    struct shape {
        std::string strips, upsampled, too_few; // texels in the apron
        unsigned guard = 0;
    };
    // The texel of a pixel is the middle one of those that it stands for, or the one before the middle.
    for (const shape& of : {shape{"8x8x", "", "17"},
                            {"16x4x", "", "17"},
                            {"3x5x", "", "17"},
                            {"8x8x", "", "17", 9},
                            {"8x4x", "/upsample:2", "17"},
                            {"3x2x", "/upsample:3", "16"},
                            {"3x2x", "/upsample:3", "16", 11}}) {
        CAPTURE(of.strips);
        CAPTURE(of.guard);
        const auto run = [&](const std::string& text) {
            return seen_in_middle(p, text + of.upsampled, 1.5, of.guard);
        };
        const auto kept = [&](const std::string& sampler, const std::string& apron) {
            return run(sampler + "/kept_alone/hbao/r32f/compute_strips:" + of.strips + apron);
        };
        const std::vector<float> expected = run("axes:6x18/single_layer/hbao/r32f");
        CHECK(*std::ranges::min_element(expected) < 0.7f);
        CHECK(others(kept("axes:6x18", "18"), expected) == 0);
        CHECK(others(kept("axes:6x18", of.too_few), expected) > 20); // at the ends of rows and columns
        // Of other directions those within the strips.
        const std::vector<float> spread = run("directions:8x4/single_layer/hbao/r32f");
        const std::size_t missed = others(kept("directions:8x4", "18"), spread);
        CHECK(missed > 100);
        CHECK(missed < spread.size());
    }
}

TEST_CASE("strips in shared memory change no bit of a picture of many layers") {
    constexpr unsigned width = 45, height = 27;
    const oracle::triangles drawn = oracle::soup(60, 4);
    const auto layered = [&](const std::string& text) {
        oracle::fragment_capture front("axes:1x1/layer_array:1/hbao", width, height);
        front.draw(drawn);
        std::vector<float> depth;
        for (const std::vector<oracle::fragment>& list : front.packed(1))
            depth.push_back(list.empty() ? 0 : static_cast<float>(list[0].depth));
        oracle::fragment_capture whole(text + "/r32f", width, height, lens::standard, "visibility");
        whole.runner().upload("depth", depth);
        whole.set("radius", 3);
        whole.draw(drawn);
        return whole.runner().download("visibility");
    };
    // The nearest four are in the strips, those behind them in the image.
    for (const std::string layers :
         {"layer_array:1/hbao", "layer_array:2/hbao", "layer_array:1/cosine_bitmask",
          "layer_array:2/cosine_bitmask", "layer_array:6/hbao", "linked_lists:6x16/hbao",
          "linear_lists:9x16/hbao"}) {
        CAPTURE(layers);
        const std::string effect = "axes:6x12/" + layers;
        const std::vector<float> expected = layered(effect);
        CHECK(*std::ranges::min_element(expected) < 0.7f);
        CHECK(others(layered(effect + "/compute_strips:4x8x12"), expected) == 0);
    }
    for (const std::string traversal : {"front_first", "deferred_layers"}) {
        CAPTURE(traversal);
        const std::string effect = "directions:4x4/peeled_layers:5/hbao/" + traversal;
        CHECK(others(layered(effect + "/compute_strips"), layered(effect)) == 0);
    }
}

TEST_CASE("strips hold the guard band, and the layers of the picture's camera alone") {
    using namespace tools;
    const mesh scene = built_in_scene();
    camera from = built_in_cameras().front();
    from.width = 150;
    from.height = 85;
    for (const unsigned guard : {0u, 23u}) {
        CAPTURE(guard);
        const gbuffer inputs = rasterise(oracle::device(), scene, from, guard);
        const auto run = [&](const std::string& text) {
            return run_effect(oracle::device(), recipe(std::string_view(text)), inputs,
                              {.radius = 1, .settings = {}})
                .visibility.texels;
        };
        for (const std::string effect :
             {"axes:8x24/single_layer/hbao/r32f", "axes:8x24/layer_array:6/hbao/r32f",
              "axes:8x24/stochastic_layers:8/hbao_plus/atomic_minimum/second_view:1/r32f",
              "axes:8x24/stochastic_layers:8/hbao_plus/atomic_minimum/further_views:2x2/r32f"}) {
            CAPTURE(effect);
            CHECK(others(run(effect + "/compute_strips"), run(effect + "/compute")) == 0);
        }
    }
}
