// SPDX-License-Identifier: MIT
#include <crease/vulkan/rasteriser.hpp>
#include <crease/vulkan/runner.hpp>

#include "little_effect.hpp"
#include "sentence.hpp"
#include "sized.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <span>

using namespace crease;

namespace {

constexpr piece vertex_text{"test.vert", R"(
layout(push_constant) uniform shift_block { vec4 shift; };
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec3 normal_out;
void main() {
    normal_out = normal;
    gl_Position = vec4(position + shift.xyz, 1.0);
}
)"};
constexpr piece fragment_text{"test.frag", R"(
layout(location = 0) in vec3 normal;
layout(location = 0) out vec4 colour;
layout(location = 1) out float z;
void main() {
    colour = vec4(normal, 1.0);
    z = gl_FragCoord.z;
}
)"};
constexpr piece vertex[] = {little::version, vertex_text}, fragment[] = {little::version, fragment_text};
constexpr format colours[] = {format::rgba16_float, format::r32_float};
constexpr vulkan::rasteriser_options options{
    .vertex = vertex, .fragment = fragment, .colours = colours, .push_constant_bytes = 16};
constexpr float no_shift[4] = {0, 0, 0, 0};

/// A triangle that covers the left half of the image, and a nearer or farther one, wound the other way, that
/// covers the upper half.
std::vector<float> two_triangles(float left_depth, float upper_depth) {
    const auto vertex_at = [](float x, float y, float z, float normal_x) {
        return std::vector<float>{x, y, z, normal_x, 0, 1};
    };
    std::vector<float> all;
    for (const auto& v : {vertex_at(0, -9, left_depth, -1), vertex_at(0, 9, left_depth, -1),
                          vertex_at(-9, 0, left_depth, -1), vertex_at(-9, 0, upper_depth, 1),
                          vertex_at(9, 0, upper_depth, 1), vertex_at(0, -9, upper_depth, 1)})
        all.insert(all.end(), v.begin(), v.end());
    return all;
}

}

TEST_CASE("the nearer triangle is seen, whichever way depth runs") {
    vulkan::device& device = validated_device();
    for (const bool reversed : {false, true}) {
        vulkan::rasteriser_options chosen = options;
        chosen.reversed_depth = reversed;
        vulkan::rasteriser rasteriser(device, chosen, 8, 6);
        const float near_depth = reversed ? 0.75f : 0.25f, far_depth = 0.5f,
                    background = reversed ? 0.0f : 1.0f;
        const vulkan::mesh mesh(device, two_triangles(near_depth, far_depth));
        rasteriser.draw(mesh, std::as_bytes(std::span(no_shift)));
        const std::vector<float> depth = vulkan::download(device, rasteriser.depth());
        const std::vector<float> normals = vulkan::download(device, rasteriser.colour(0));
        const std::vector<float> z = vulkan::download(device, rasteriser.colour(1));
        for (std::size_t y = 0; y < 6; ++y)
            for (std::size_t x = 0; x < 8; ++x) {
                const bool left = x < 4, upper = y < 3;
                CHECK(depth[y * 8 + x] == (left ? near_depth : upper ? far_depth : background));
                CHECK(normals[(y * 8 + x) * 4] == (left ? -1.0f : upper ? 1.0f : 0.0f));
                CHECK(z[y * 8 + x] == (left ? near_depth : upper ? far_depth : 0.0f));
            }
    }
}

TEST_CASE("what is drawn feeds a runner without a round trip") {
    vulkan::device& device = validated_device();
    vulkan::rasteriser rasteriser(device, options, 641, 359);
    const vulkan::mesh mesh(device, two_triangles(0.25f, 0.5f));
    vulkan::runner runner(device, little::effect, 641, 359,
                          {.constants = {{"scale.gain", 1}}, .shaders = {}});
    runner.bind("depth", rasteriser.depth());
    for (int frame = 0; frame < 2; ++frame) {
        rasteriser.draw(mesh, std::as_bytes(std::span(no_shift)));
        runner.run(sized(641, 359));
    }
    const std::vector<float> visibility = runner.download("visibility");
    constexpr float half_a_step = 0.501f / 255; // of r8_unorm
    CHECK(std::abs(visibility[0] - 0.25f) <= half_a_step);
    CHECK(std::abs(visibility[640] - 0.5f) <= half_a_step);
    CHECK(visibility[358 * 641 + 640] == 1);
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("colours of the vertices") {
    vulkan::device& device = validated_device();
    constexpr piece vertex_of_colour = {"colour.vert", R"glsl(#version 450
layout(location = 0) in vec3 position;
layout(location = 2) in vec4 colour;
layout(location = 0) out vec4 shown;
void main() {
    shown = colour;
    gl_Position = vec4(position, 1.0);
}
)glsl"};
    constexpr piece fragment_of_colour = {"colour.frag", R"glsl(#version 450
layout(location = 0) in vec4 shown;
layout(location = 0) out vec4 drawn;
void main() { drawn = shown; }
)glsl"};
    constexpr format whole[] = {format::rgba32_float};
    vulkan::rasteriser rasteriser(device,
                                  {.vertex = {&vertex_of_colour, 1},
                                   .fragment = {&fragment_of_colour, 1},
                                   .colours = whole,
                                   .push_constant_bytes = 0},
                                  8, 6);
    const std::vector<float> triangles = two_triangles(0.25f, 0.5f);
    std::vector<float> rgba;
    for (const float of_triangle : {0.25f, 0.75f})
        for (int corner = 0; corner < 3; ++corner)
            rgba.insert(rgba.end(), {of_triangle, 0.5f, 1, 0.125f});
    rasteriser.draw(vulkan::mesh(device, triangles, rgba));
    const std::vector<float> drawn = vulkan::download(device, rasteriser.colour(0));
    CHECK(std::vector<float>(drawn.begin(), drawn.begin() + 4) == std::vector<float>{0.25f, 0.5f, 1, 0.125f});
    CHECK(drawn[7 * 4] == 0.75f);
    CHECK(sentence_of([&] { rasteriser.draw(vulkan::mesh(device, triangles)); }) ==
          "the vertex shader takes a colour at location 2, and the mesh has none");
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("what a rasteriser refuses") {
    vulkan::device& device = validated_device();
    const auto said = [&](const vulkan::rasteriser_options& o, std::uint32_t width) {
        return sentence_of([&] { vulkan::rasteriser(device, o, width, 4); });
    };
    CHECK(contains(said(options, 0), "has no texels"));
    vulkan::rasteriser_options wrong = options;
    wrong.colours = {};
    CHECK(said(wrong, 4) == "a rasteriser draws to one colour image at least");
    wrong = options;
    wrong.push_constant_bytes = 1u << 20;
    CHECK(contains(said(wrong, 4), "bytes of push constants"));
    wrong = options;
    wrong.fragment = vertex;
    CHECK(contains(said(wrong, 4), "the fragment shader does not compile:\ntest.vert:"));

    vulkan::rasteriser rasteriser(device, options, 4, 4);
    const vulkan::mesh mesh(device, two_triangles(0.25f, 0.5f));
    CHECK(sentence_of([&] { rasteriser.draw(mesh); }) ==
          "the geometry's shaders take 16 bytes of push constants, not 0");
}
