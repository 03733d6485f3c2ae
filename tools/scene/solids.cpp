// SPDX-License-Identifier: MIT
#include "scene/solids.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace crease::tools {
namespace {

using quad = std::array<glm::vec3, 4>;

void add_triangle(mesh& to, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    if (a == b || b == c || c == a)
        return; // at the axis of a lathe
    for (const glm::vec3& corner : {a, b, c}) {
        to.indices.push_back(static_cast<std::uint32_t>(to.positions.size()));
        to.positions.push_back(corner);
    }
}

void add_quad(mesh& to, const quad& corners, const glm::mat4& place) {
    quad world;
    for (unsigned i = 0; i < 4; ++i)
        world[i] = place * glm::vec4(corners[i], 1);
    add_triangle(to, world[0], world[1], world[2]);
    add_triangle(to, world[0], world[2], world[3]);
}

}

void add_box(mesh& to, const glm::vec3& low, const glm::vec3& high, const glm::mat4& place) {
    const glm::vec3 a = low, b = high;
    add_quad(to, {{{a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}}}, place);
    add_quad(to, {{{b.x, a.y, a.z}, {a.x, a.y, a.z}, {a.x, b.y, a.z}, {b.x, b.y, a.z}}}, place);
    add_quad(to, {{{b.x, a.y, b.z}, {b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}}}, place);
    add_quad(to, {{{a.x, a.y, a.z}, {a.x, a.y, b.z}, {a.x, b.y, b.z}, {a.x, b.y, a.z}}}, place);
    add_quad(to, {{{a.x, b.y, b.z}, {b.x, b.y, b.z}, {b.x, b.y, a.z}, {a.x, b.y, a.z}}}, place);
    add_quad(to, {{{a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, a.y, b.z}, {a.x, a.y, b.z}}}, place);
}

void add_lathe(mesh& to, std::span<const glm::vec2> profile, unsigned segments, const glm::mat4& place) {
    const auto point = [&](const glm::vec2& p, unsigned segment) {
        // The last segment ends exactly where the first begins.
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(segment % segments) /
                            static_cast<float>(segments);
        return p.x == 0 ? glm::vec3(0, p.y, 0) : glm::vec3(p.x * std::sin(angle), p.y, p.x * std::cos(angle));
    };
    for (std::size_t i = 0; i + 1 < profile.size(); ++i)
        for (unsigned s = 0; s < segments; ++s)
            add_quad(to,
                     {{point(profile[i], s), point(profile[i], s + 1), point(profile[i + 1], s + 1),
                       point(profile[i + 1], s)}},
                     place);
}

void add_arch(mesh& to, const arch& shape, const glm::mat4& place) {
    const float side = shape.width / 2, top = shape.height, depth = shape.thickness;
    // Inner and outer outline from right to left; the outer one goes up, along the top, and down.
    std::vector<glm::vec2> inner, outer;
    for (unsigned i = 0; i <= shape.segments; ++i) {
        const float angle =
            std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(shape.segments);
        inner.emplace_back(shape.radius * std::cos(angle), shape.radius * std::sin(angle));
        const float x = inner.back().x / shape.radius * side;
        outer.emplace_back(x, i == 0 || i == shape.segments ? 0 : top);
    }
    outer.insert(outer.begin() + 1, glm::vec2(side, top));
    inner.insert(inner.begin() + 1, inner.front());
    outer.insert(outer.end() - 1, glm::vec2(-side, top));
    inner.insert(inner.end() - 1, inner.back());
    const auto at = [](const glm::vec2& p, float z) { return glm::vec3(p, z); };
    for (std::size_t i = 0; i + 1 < inner.size(); ++i) {
        const glm::vec2 a = inner[i], b = inner[i + 1], c = outer[i + 1], d = outer[i];
        add_quad(to, {{at(a, depth), at(d, depth), at(c, depth), at(b, depth)}}, place);
        add_quad(to, {{at(a, 0), at(b, 0), at(c, 0), at(d, 0)}}, place);
        add_quad(to, {{at(a, 0), at(a, depth), at(b, depth), at(b, 0)}}, place);
        if (c.y == top && d.y == top)
            add_quad(to, {{at(d, depth), at(d, 0), at(c, 0), at(c, depth)}}, place);
    }
    for (const float sign : {-1.0f, 1.0f}) // the feet, from the opening to the end
        add_quad(to,
                 {{{sign * shape.radius, 0, 0},
                   {sign * side, 0, 0},
                   {sign * side, 0, depth},
                   {sign * shape.radius, 0, depth}}},
                 place);
}

}
