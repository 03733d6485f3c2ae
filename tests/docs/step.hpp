// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan.hpp>

#include <bit>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

/// A wall that steps towards the camera in the left half of the picture, and what runs effects on it.
namespace step {

inline constexpr unsigned width = 48, height = 32;
inline constexpr float near_wall = 4, far_wall = 5, radius = 1.5f;

/// Column-major, depth reversed: perspective without a far plane, and orthographic from 0 to 10.
inline constexpr float perspective[16] = {1, 0, 0, 0, 0, -1.5f, 0, 0, 0, 0, 0, -1, 0, 0, 0.1f, 0};
inline constexpr float orthographic[16] = {1 / 4.5f, 0, 0, 0, 0, -1 / 3.f, 0, 0, 0, 0, 0.1f, 0, 0, 0, 1, 1};

inline crease::vulkan::device& device() {
    static crease::vulkan::device device({.name = {}, .validation = true});
    return device;
}

inline std::string joined(crease::array_view<const crease::piece> pieces) {
    std::string all;
    for (const crease::piece& each : pieces)
        all += each.text;
    return all;
}

inline constexpr crease::piece vertex[] = {{"step.vert", R"(#version 450
layout(push_constant) uniform camera { mat4 projection; };
layout(location = 0) in vec3 position;
layout(location = 0) out vec3 anchor;
void main() {
    anchor = position;
    gl_Position = projection * vec4(position, 1.0);
}
)"}};
inline constexpr crease::piece fragment[] = {{"step.frag", R"(
layout(location = 0) in vec3 anchor;
void main() { crease_capture(anchor); }
)"}};
inline constexpr crease::piece surface_fragment[] = {{"step.frag", R"(
layout(location = 0) in vec3 anchor;
void main() { crease_capture(anchor, vec3(0.0, 0.0, 1.0), vec4(1.0)); }
)"}};

/// The host's part of the fragment shader of a geometry pass.
inline crease::array_view<const crease::piece> fragment_of(const crease::pass& geometry) {
    return geometry.takes_surfaces ? surface_fragment : fragment;
}

/// The far wall whole, also where the near one hides it.
inline std::vector<float> triangles() {
    std::vector<float> all;
    const auto add = [&all](float right, float depth) {
        const float left = -20, high = 20;
        const float corners[][2] = {{left, -high}, {right, -high}, {right, high},
                                    {left, -high}, {right, high},  {left, high}};
        for (const auto& [x, y] : corners)
            all.insert(all.end(), {x, y, -depth, 0, 0, 1});
    };
    add(20, far_wall);
    add(0, near_wall);
    return all;
}

inline crease::parameters parameters_for(const crease::effect_view& effect, bool is_orthographic) {
    crease::parameters p = effect.defaults;
    if (const auto fit =
            crease::set_projection(p.view, is_orthographic ? orthographic : perspective, width, height);
        !fit)
        throw std::runtime_error(std::string(fit.error));
    p.further_views[0].view = p.view;
    p.radius = radius;
    return p;
}

/// The image of a resource after a few frames.
inline std::vector<float> run(const crease::effect_view& effect, const std::string& image,
                              bool is_orthographic = false) {
    crease::vulkan::runner runner(device(), effect, width, height);
    for (const crease::resource& r : effect.resources) {
        if (r.life != crease::lifetime::input || r.kind != crease::resource_kind::image)
            continue;
        std::vector<float> numbers;
        std::vector<std::uint32_t> millimetres;
        for (unsigned i = 0; i < width * height; ++i) {
            const float depth = i % width < width / 2 ? near_wall : far_wall;
            if (r.name == "normal")
                numbers.insert(numbers.end(), {0, 0, 1, 0});
            else
                numbers.push_back(is_orthographic ? 1 - depth / 10 : 0.1f / depth);
            millimetres.push_back(static_cast<std::uint32_t>(1000 * depth));
        }
        if (r.texels == crease::format::r32_uint)
            runner.upload(r.name, std::span<const std::uint32_t>(millimetres));
        else
            runner.upload(r.name, std::span<const float>(numbers));
    }
    const crease::vulkan::mesh walls(device(), triangles());
    const std::span<const std::byte> camera = std::as_bytes(std::span(perspective));
    for (const crease::pass& each : effect.passes)
        if (each.stage == crease::stage_kind::geometry)
            runner.set_geometry(each.name,
                                {.vertex = vertex,
                                 .fragment = fragment_of(each),
                                 .push_constant_bytes = sizeof perspective,
                                 .reversed_depth = true},
                                walls, camera);
    crease::parameters p = parameters_for(effect, is_orthographic);
    for (; p.frame < 2; ++p.frame)
        runner.run(p);
    return runner.download(image);
}

}
