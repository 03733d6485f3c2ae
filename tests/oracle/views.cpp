// SPDX-License-Identifier: MIT
// What a second camera and a guard band add to the picture.
#include "run.hpp"

#include "frame/frame.hpp"

#include <crease/second_camera.hpp>

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace crease::tools;

/// A box with these corners, as twelve triangles.
void add_box(mesh& to, glm::vec3 low, glm::vec3 high) {
    const auto first = static_cast<std::uint32_t>(to.positions.size());
    for (unsigned i = 0; i < 8; ++i)
        to.positions.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    constexpr std::uint32_t corners[] = {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                                         2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3};
    for (std::uint32_t i : corners)
        to.indices.push_back(first + i);
}

/// A wall that faces the camera, and a thin bar that stands out from it, of which the camera sees the end
/// alone.
mesh bar_on_wall() {
    mesh scene;
    add_box(scene, {-6, -4, -6.2f}, {6, 4, -6});
    add_box(scene, {-0.1f, -1, -6}, {0.1f, 1, -4.5f});
    return scene;
}

camera in_front() {
    camera c;
    c.name = "in front";
    c.eye = {0, 0, 0};
    c.target = {0, 0, -1};
    c.vfov_deg = 50;
    c.near = 0.1f;
    c.far = 50;
    c.width = 200;
    c.height = 120;
    c.ao_radius = 1;
    return c;
}

/// A camera to the right of the bar, turned to its foot.
camera aside_of(camera from) {
    from.eye = {3, 0, -2};
    from.target = {0, 0, -6};
    return from;
}

/// A box on a floor, just beside what the camera sees.
mesh floor_and_box_beside(const camera& from) {
    mesh scene;
    add_box(scene, {-20, -1.2f, -20}, {20, -1, 20});
    const float edge = 6 * std::tan(glm::radians(from.vfov_deg) / 2) * static_cast<float>(from.width) /
                       static_cast<float>(from.height); // where the picture ends at depth 6
    add_box(scene, {edge + 0.02f, -1, -8}, {edge + 0.5f, 2, -4});
    return scene;
}

frame render(const mesh& scene, const camera& from, const std::string& text, unsigned guard, float opacity,
             const std::optional<camera>& second = {}) {
    const gbuffer inputs = rasterise(oracle::device(), scene, from, guard);
    frame_options how{.radius = from.ao_radius, .settings = {}, .second = second};
    if (text.find("stochastic") != std::string::npos)
        how.settings["opacity"] = opacity;
    return run_effect(oracle::device(), crease::recipe(std::string_view(text)), inputs, how);
}

}

TEST_CASE("a second camera in the first one's place changes nothing") {
    const mesh scene = bar_on_wall();
    const camera from = in_front();
    const std::string one = "directions:8x4/stochastic_layers:4/hbao_plus/atomic_minimum";
    const frame single = render(scene, from, one, 0, 1);
    const frame both = render(scene, from, one + "/second_view:1", 0, 1, from);
    std::size_t other = 0;
    for (std::size_t i = 0; i < single.visibility.texels.size(); ++i)
        other += std::abs(single.visibility.texels[i] - both.visibility.texels[i]) > 1.5f / 255;
    CHECK(other < single.visibility.texels.size() /
                      100); // where the way there and back rounds a tap to the next texel
}

TEST_CASE("a second camera sees the side of a bar that the first sees from its end") {
    const mesh scene = bar_on_wall();
    const camera from = in_front();
    const camera aside = aside_of(from);
    const std::string one = "directions:8x6/stochastic_layers:4/hbao_plus/atomic_minimum";
    const frame single = render(scene, from, one, 0, 1);
    for (const char* second : {"/second_view:1", "/second_view:2"}) {
        CAPTURE(std::string(second));
        const frame both = render(scene, from, one + second, 0, 0.5f, aside);
        double gained = 0;
        int count = 0;
        for (unsigned x = 106; x < 112; ++x) // the wall to the right of the bar
            for (unsigned y = 55; y < 65; ++y, ++count)
                gained += double{single.visibility.at(x, y)} - double{both.visibility.at(x, y)};
        CHECK(gained / count > 0.1);
        for (std::size_t i = 0; i < single.visibility.texels.size(); ++i) // the greater occlusion counts
            CHECK(both.visibility.texels[i] <= 1);
    }
}

TEST_CASE("a bent normal that the second camera finds stands in the first one's space") {
    const mesh scene = bar_on_wall();
    const camera from = in_front();
    const camera aside = aside_of(from);
    const frame both = render(
        scene, from, "directions:8x6/stochastic_layers:4/hbao_plus/atomic_minimum/second_view:1/bent_cone", 0,
        0.5f, aside);
    glm::vec3 mean(0);
    for (unsigned x = 106; x < 112; ++x) // the wall to the right of the bar
        for (unsigned y = 55; y < 65; ++y)
            mean += glm::vec3(both.bent->at(x, y, 0), both.bent->at(x, y, 1), both.bent->at(x, y, 2)) / 60.0f;
    CHECK(mean.x > 0.15f);
    CHECK(std::abs(mean.y) < 0.1f);
    CHECK(mean.z > 0.7f);
}

TEST_CASE("the second camera is placed to the right and in front, turned to the middle") {
    crease::parameters p;
    crease::place_second_camera(p, 1, 2, 10);
    const auto turned = [&p](float x, float y, float z) {
        const float* m = p.further_views[0].from_first;
        return glm::vec3(m[0] * x + m[4] * y + m[8] * z + m[12], m[1] * x + m[5] * y + m[9] * z + m[13],
                         m[2] * x + m[6] * y + m[10] * z + m[14]);
    };
    CHECK(glm::length(turned(1, 0, -2)) < 1e-6f);
    const glm::vec3 focus = turned(0, 0, -10);
    CHECK(std::abs(focus.x) < 1e-5f);
    CHECK(std::abs(focus.z + std::sqrt(65.0f)) < 1e-5f);
    CHECK(std::abs(turned(1, 3, -2).y - 3) < 1e-5f);
}

TEST_CASE("a guard band lets what stands beside the picture darken it") {
    const camera from = in_front();
    const mesh scene = floor_and_box_beside(from);
    for (const char* text :
         {"directions:8x6/single_layer/hbao", "directions:8x6/single_layer/hbao/linearised_depth",
          "directions:8x6/stochastic_layers:4/hbao/atomic_minimum"}) {
        CAPTURE(std::string(text));
        const frame bare = render(scene, from, text, 0, 1), guarded = render(scene, from, text, 48, 1);
        double bare_edge = 0, guarded_edge = 0;
        const unsigned row =
            60 + static_cast<unsigned>(60 * (1 / 6.0) / std::tan(0.4363)); // the floor at depth 6
        for (unsigned x = 188; x < 200; ++x) {
            bare_edge += double{bare.visibility.at(x, row)} / 12;
            guarded_edge += double{guarded.visibility.at(x, row)} / 12;
        }
        CHECK(guarded_edge < bare_edge - 0.05);
        for (unsigned x = 60; x < 100; ++x) // and what is far from the edge is the same
            CHECK(std::abs(bare.visibility.at(x, row) - guarded.visibility.at(x, row)) < 0.02f);
    }
}

TEST_CASE("areas with a guard band are those of the greater picture") {
    const camera from = in_front();
    const mesh scene = floor_and_box_beside(from);
    constexpr unsigned guard = 24;
    camera greater = from;
    greater.width += 2 * guard;
    greater.height += 2 * guard;
    greater.vfov_deg =
        glm::degrees(2 * std::atan(std::tan(glm::radians(from.vfov_deg) / 2) *
                                   static_cast<float>(greater.height) / static_cast<float>(from.height)));
    for (const char* source : {"summed_area", "summed_area:2", "summed_area_adaptive:4",
                               "summed_area_adaptive:4x2", "n_buffer", "n_buffer:8x2", "mip_chain"}) {
        CAPTURE(std::string(source));
        const std::string text = "sample_box/" + std::string(source) + "/mean_height";
        const frame guarded = render(scene, from, text, guard, 1), bare = render(scene, from, text, 0, 1),
                    whole = render(scene, greater, text, 0, 1);
        std::size_t other = 0, bare_other = 0;
        for (unsigned y = 0; y < from.height; ++y)
            for (unsigned x = 0; x < from.width; ++x) {
                const float expected = whole.visibility.at(x + guard, y + guard);
                other += std::abs(guarded.visibility.at(x, y) - expected) > 2.5f / 255;
                bare_other += std::abs(bare.visibility.at(x, y) - expected) > 2.5f / 255;
            }
        CHECK(other < std::size_t{from.width} * from.height / 200);
        CHECK(bare_other > 20 + other);
    }
}
