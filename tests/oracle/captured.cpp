// SPDX-License-Identifier: MIT
#include "captured.hpp"

#include <doctest/doctest.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace oracle {

namespace {

constexpr const char* vertex_glsl = R"glsl(#version 450
layout(push_constant) uniform transforms {
    mat4 clip_from_view;
    vec3 moved;
};
layout(location = 0) in vec3 position;
layout(location = 0) out vec3 anchor;
void main() {
    anchor = position + moved;
    gl_Position = clip_from_view * vec4(position, 1.0);
}
)glsl";

constexpr const char* fragment_glsl = R"glsl(
layout(location = 0) in vec3 anchor;
void main() { crease_capture(anchor); }
)glsl";

constexpr crease::piece vertex[] = {{"vertex", vertex_glsl}}, fragment[] = {{"fragment", fragment_glsl}};

struct transforms {
    glm::mat4 clip_from_view;
    glm::vec4 moved;
};

/// The effect without the passes after one: a driver takes longer to compile them than to draw.
crease::effect_view up_to(std::string_view last, crease::effect_view effect) {
    for (std::size_t i = 0; i < effect.passes.size(); ++i)
        if (effect.passes[i].name == last)
            effect.passes = {effect.passes.data(), i + 1};
    return effect;
}

bool is_reversed(lens kind) {
    return kind == lens::reversed || kind == lens::infinite;
}

}

std::vector<std::uint32_t> share_out(const picture& p, unsigned samples) {
    std::vector<std::uint32_t> image;
    for (unsigned s = 0; s < samples; ++s)
        for (int y = 0; y < p.height; ++y)
            for (int x = 0; x < p.width; ++x) {
                const std::vector<glm::dvec3> all = p.positions(x, y);
                const glm::dvec3 kept = all[(s + static_cast<unsigned>(x)) % all.size()];
                image.push_back(p.background(x, y)
                                    ? kept_nothing
                                    : std::bit_cast<std::uint32_t>(static_cast<float>(-kept.z)));
            }
    return image;
}

std::vector<surface> balls() {
    std::vector<surface> scene;
    for (int i = 0; i < 48; ++i) {
        // Steps by the golden ratio and others that no whole numbers relate.
        const auto spread = [i](double by) { return std::fmod((i + 0.5) * by, 1.0); };
        scene.push_back(
            {surface::kind::sphere,
             {4 * spread(0.618034) - 2, 3 * spread(0.7548777) - 1.5, -2.4 - 2.4 * spread(0.5698403)},
             {0, 0, 1},
             0.15 + 0.3 * spread(0.4142136)});
    }
    return scene;
}

picture many_layers(lens kind, int width, int height, std::size_t most) {
    std::vector<surface> scene = balls();
    scene.push_back({surface::kind::plane, {0, 0, -5}, glm::normalize(glm::dvec3(0.2, 0.3, 1))});
    picture p = draw_all(scene, kind, width, height);
    for (std::vector<float>& behind : p.hidden)
        behind.resize(std::min(behind.size(), most - 1));
    return p;
}

void add_quad(triangles& to, glm::vec3 at, glm::vec3 across, glm::vec3 up) {
    to.insert(to.end(), {at, at + across, at + across + up, at, at + across + up, at + up});
}

triangles wall(float depth) {
    triangles all;
    const float reach = 4 * std::max(depth, 1.0f);
    add_quad(all, {-reach, -reach, -depth}, {2 * reach, 0, 0}, {0, 2 * reach, 0});
    return all;
}

glm::mat4 clip_from_view(lens kind, double aspect) {
    return glm::mat4(make_projection(kind, aspect));
}

layer_capture::layer_capture(const std::string& parts, unsigned samples, unsigned width, unsigned height,
                             lens seen_by, std::string_view last)
    : projection_(clip_from_view(seen_by, static_cast<double>(width) / height)),
      composed_(compose("directions:1x1/stochastic_layers:" + std::to_string(samples) + "/hbao/" + parts +
                        (seen_by == lens::orthographic ? "/orthographic" : ""))),
      runner_(device(), up_to(last, *composed_), width, height),
      how_(composed_->view().defaults), host_{.vertex = vertex,
                                              .fragment = fragment,
                                              .push_constant_bytes = sizeof(transforms),
                                              .reversed_depth = is_reversed(seen_by)} {
    float matrix[16];
    std::copy_n(glm::value_ptr(projection_), 16, matrix);
    REQUIRE(crease::set_projection(how_.view, matrix, width, height));
    const std::size_t texels = std::size_t{width} * height;
    runner_.upload("depth", std::vector<float>(texels, host_.reversed_depth ? 1.0f : 0.0f));
    runner_.upload("normal", std::vector<float>(4 * texels, 1.0f));
}

void layer_capture::draw(const triangles& scene, const capture_settings& how) {
    std::vector<float> numbers; // with a normal, which no shader here reads
    for (const glm::vec3& p : scene)
        numbers.insert(numbers.end(), {p.x, p.y, p.z, 0, 0, 1});
    set(how_, *composed_, "opacity", how.opacity);
    how_.frame = how.frame;
    const transforms pushed{projection_, glm::vec4(how.moved, 0)};
    const crease::vulkan::mesh drawn(device(), numbers);
    runner_.set_geometry("capture_layers", host_, drawn, std::as_bytes(std::span(&pushed, 1)));
    runner_.run(how_);
}

}
