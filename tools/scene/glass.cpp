// SPDX-License-Identifier: MIT
#include "scene/solids.hpp"

#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

// The showroom: x to the right, z towards the first camera, the floor at y = 0. The back wall stands at z =
// -4. A car of glass stands in the middle, shells of glass to its left, a solid block and panes to its right.

namespace crease::tools {
namespace {

constexpr glm::vec4 stone{0.78f, 0.76f, 0.72f, 1}, plaster{0.86f, 0.83f, 0.78f, 1},
    rubber{0.16f, 0.16f, 0.18f, 1}, metal{0.62f, 0.64f, 0.68f, 1}, leather{0.62f, 0.3f, 0.18f, 1},
    paint_of_car{0.16f, 0.5f, 0.68f, 0.3f}, window{0.66f, 0.84f, 0.9f, 0.2f}, amber{0.9f, 0.6f, 0.2f, 0.25f},
    rose{0.85f, 0.4f, 0.5f, 0.5f}, green_glass{0.3f, 0.68f, 0.46f, 0.45f}, pane{0.45f, 0.62f, 0.8f, 1};

glm::mat4 at(float x, float y, float z) {
    return glm::translate(glm::mat4(1), {x, y, z});
}

glm::mat4 turned(const glm::mat4& place, float degrees, const glm::vec3& axis = {0, 1, 0}) {
    return glm::rotate(place, glm::radians(degrees), axis);
}

void add_room(mesh& to) {
    add_box(to, {-7, -0.3f, -4}, {7, 0, 6});
    add_box(to, {-4.2f, 0, -2.1f}, {2.4f, 0.1f, 1.9f}); // the platform of the car
    paint(to, {stone});
    add_box(to, {-7, -0.3f, -4.3f}, {7, 3.4f, -4});
    add_box(to, {-7.3f, -0.3f, -4.3f}, {-7, 3.4f, 6});
    for (int i = 0; i < 6; ++i) { // pilasters
        const float x = -6.6f + 2.6f * static_cast<float>(i);
        add_box(to, {x - 0.2f, 0, -4}, {x + 0.2f, 3.2f, -3.85f});
    }
    add_box(to, {-7, 3.2f, -4}, {7, 3.4f, -3.75f});
    add_box(to, {-7, 0, -4}, {7, 0.18f, -3.93f});
    paint(to, {plaster});
}

std::vector<glm::vec2> circle(float radius, unsigned parts) {
    std::vector<glm::vec2> profile;
    for (unsigned i = 0; i <= parts; ++i) {
        const float angle = std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(parts);
        profile.emplace_back(i == 0 || i == parts ? 0 : radius * std::sin(angle), -radius * std::cos(angle));
    }
    return profile;
}

/// A ring around +Y.
std::vector<glm::vec2> ring(float radius, float thickness, unsigned parts) {
    std::vector<glm::vec2> profile;
    for (unsigned i = 0; i <= parts; ++i) {
        const float angle =
            2 * std::numbers::pi_v<float> * static_cast<float>(i % parts) / static_cast<float>(parts);
        profile.emplace_back(radius + thickness * std::sin(angle), -thickness * std::cos(angle));
    }
    return profile;
}

void add_wheel(mesh& to, const glm::mat4& place) {
    const std::array<glm::vec2, 8> tyre{{{0.2f, -0.1f},
                                         {0.3f, -0.11f},
                                         {0.345f, -0.07f},
                                         {0.35f, 0},
                                         {0.345f, 0.07f},
                                         {0.3f, 0.11f},
                                         {0.2f, 0.1f},
                                         {0.2f, -0.1f}}};
    add_lathe(to, tyre, 36, place);
    paint(to, {rubber});
    const std::array<glm::vec2, 5> hub{
        {{0, -0.05f}, {0.2f, -0.04f}, {0.2f, 0.04f}, {0.06f, 0.07f}, {0, 0.07f}}};
    add_lathe(to, hub, 24, place);
    paint(to, {metal});
}

/// A skin over closed cross-sections across x.
/// @param point  of a place along x and one around it, both 0 to 1
void add_skin(mesh& to, const glm::mat4& place, unsigned along, unsigned around,
              const std::function<glm::vec3(float, float)>& point) {
    const auto first = static_cast<std::uint32_t>(to.positions.size());
    for (unsigned i = 0; i <= along; ++i)
        for (unsigned k = 0; k < around; ++k)
            to.positions.emplace_back(place *
                                      glm::vec4(point(static_cast<float>(i) / static_cast<float>(along),
                                                      static_cast<float>(k) / static_cast<float>(around)),
                                                1));
    for (unsigned i = 0; i < along; ++i)
        for (unsigned k = 0; k < around; ++k) {
            const auto corner = [&](unsigned a, unsigned b) { return first + a * around + b % around; };
            add_triangle(to, corner(i, k), corner(i + 1, k + 1), corner(i + 1, k));
            add_triangle(to, corner(i, k), corner(i, k + 1), corner(i + 1, k + 1));
        }
}

/// Goes smoothly from 0 to 1 where x goes from begin to end.
float ramp(float begin, float end, float x) {
    const float t = std::clamp((x - begin) / (end - begin), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

/// A number's power that keeps its sign.
float bent(float x, float exponent) {
    return std::copysign(std::pow(std::abs(x), exponent), x);
}

/// The shell below the windows, from bumper to bumper.
void add_body(mesh& to, const glm::mat4& place) {
    constexpr float length = 4.2f, floor = 0.24f;
    add_skin(to, place, 44, 40, [](float t, float u) {
        const float x = length * (t - 0.5f), nose = ramp(0, 0.1f, t), tail = ramp(1, 0.93f, t);
        const float end = std::sqrt(std::max(0.0f, nose * tail));
        const float top = 0.72f + 0.2f * ramp(0.02f, 0.35f, t) - 0.06f * ramp(0.85f, 1, t),
                    middle = (floor + top) / 2;
        const float angle = 2 * std::numbers::pi_v<float> * u;
        return glm::vec3(x, middle + end * (top - floor) / 2 * bent(std::sin(angle), 0.45f),
                         end * 0.86f * bent(std::cos(angle), 0.4f));
    });
    paint(to, {paint_of_car});
}

/// Windows and roof.
void add_cabin(mesh& to, const glm::mat4& place) {
    add_skin(to, place, 28, 32, [](float t, float u) {
        const float x = -0.75f + 2.5f * t, high = 0.68f * std::sqrt(ramp(0, 0.38f, t) * ramp(1, 0.7f, t));
        const float angle = 2 * std::numbers::pi_v<float> * u,
                    up = std::max(0.0f, bent(std::sin(angle), 0.5f));
        const float wide = 0.76f - 0.16f * up;
        return glm::vec3(x, 0.88f + high * up,
                         std::min(1.0f, 2.5f * high) * wide * bent(std::cos(angle), 0.45f));
    });
    paint(to, {window});
}

void add_seat(mesh& to, const glm::mat4& place, float width) {
    add_box(to, {-0.26f, 0.4f, -width / 2}, {0.28f, 0.56f, width / 2}, place);
    add_box(to, {-0.06f, 0, -width / 2}, {0.08f, 0.62f, width / 2},
            turned(place * at(0.26f, 0.5f, 0), -12, {0, 0, 1}));
    add_box(to, {-0.04f, 0.66f, -width / 5}, {0.05f, 0.82f, width / 5},
            turned(place * at(0.26f, 0.5f, 0), -12, {0, 0, 1}));
}

/// What stands inside of the car.
void add_interior(mesh& to, const glm::mat4& place) {
    for (const float z : {-0.38f, 0.38f})
        add_seat(to, place * at(0.1f, 0, z), 0.5f);
    add_seat(to, place * at(1.05f, 0.02f, 0), 1.2f);
    paint(to, {leather});
    add_box(to, {-1.0f, 0.3f, -0.66f}, {1.5f, 0.36f, 0.66f}, place);
    add_box(to, {-0.72f, 0.36f, -0.68f}, {-0.5f, 0.86f, 0.68f}, place);
    add_lathe(to, ring(0.17f, 0.018f, 10), 28, turned(place * at(-0.3f, 0.86f, 0.36f), 62, {0, 0, 1}));
    paint(to, {rubber});
    add_box(to, {-1.6f, 0.36f, -0.36f}, {-0.95f, 0.66f, 0.36f}, place); // the engine
    for (int i = 0; i < 4; ++i) {
        const float x = -1.5f + 0.14f * static_cast<float>(i);
        add_box(to, {x, 0.66f, -0.26f}, {x + 0.08f, 0.72f, 0.26f}, place);
    }
    for (const float x : {-1.32f, 1.3f}) // axles
        add_box(to, {x - 0.03f, 0.32f, -0.78f}, {x + 0.03f, 0.38f, 0.78f}, place);
    paint(to, {metal});
}

void add_car(mesh& to, const glm::mat4& place) {
    for (const float x : {-1.32f, 1.3f})
        for (const float side : {-1.0f, 1.0f})
            add_wheel(to, turned(place * at(x, 0.35f, 0.78f * side), 90 * side, {1, 0, 0}));
    add_interior(to, place);
    add_body(to, place);
    add_cabin(to, place);
}

/// Balls of glass on plinths, one with something in it.
void add_shells(mesh& to) {
    add_box(to, {-6.3f, 0, 0.9f}, {-5.1f, 0.5f, 2.1f});
    add_box(to, {-6.1f, 0, -1.9f}, {-5.1f, 0.8f, -0.9f});
    paint(to, {stone});
    add_lathe(to, circle(0.28f, 16), 32, at(-5.7f, 0.78f, 1.5f));
    add_box(to, {-0.2f, 0, -0.2f}, {0.2f, 0.4f, 0.2f}, turned(at(-5.6f, 0.9f, -1.4f), 30));
    paint(to, {leather});
    add_lathe(to, circle(0.62f, 24), 48, at(-5.7f, 1.12f, 1.5f));
    paint(to, {amber});
    const std::array<glm::vec2, 9> bell{{{0.46f, 0},
                                         {0.46f, 0.5f},
                                         {0.44f, 0.66f},
                                         {0.38f, 0.8f},
                                         {0.28f, 0.92f},
                                         {0.14f, 0.99f},
                                         {0.05f, 1},
                                         {0.05f, 1.08f},
                                         {0, 1.08f}}};
    add_lathe(to, bell, 40, at(-5.6f, 0.8f, -1.4f));
    paint(to, {rose});
}

/// A solid block, and panes of more and more opacity before a bar.
void add_block_and_panes(mesh& to) {
    add_box(to, {2.8f, 0, 1.5f}, {4.2f, 0.3f, 2.9f});
    paint(to, {stone});
    add_box(to, {-0.42f, 0, -0.42f}, {0.42f, 1.0f, 0.42f}, turned(at(3.5f, 0.29f, 2.2f), 24));
    paint(to, {green_glass});
    add_box(to, {3.0f, 0.5f, -3.2f}, {6.4f, 0.7f, -3.0f});
    add_box(to, {3.4f, 0, -3.2f}, {3.6f, 1.9f, -3.0f});
    add_box(to, {5.8f, 0, -3.2f}, {6.0f, 1.9f, -3.0f});
    paint(to, {leather});
    for (int i = 0; i < 5; ++i) {
        const float x = 2.9f + 0.72f * static_cast<float>(i), z = -2.75f + 0.16f * static_cast<float>(i);
        add_box(to, {x, -0.01f, z}, {x + 0.95f, 1.6f, z + 0.03f});
        paint(to, {glm::vec4(glm::vec3(pane), 0.1f + 0.2f * static_cast<float>(i))});
    }
}

}

mesh glass_scene() {
    mesh scene;
    add_room(scene);
    add_car(scene, turned(at(-0.9f, 0.1f, -0.1f), 24));
    add_shells(scene);
    add_block_and_panes(scene);
    return scene;
}

std::vector<camera> glass_cameras() {
    camera showroom{
        .name = "showroom", .eye = {2.2f, 3.0f, 8.6f}, .target = {-0.8f, 0.6f, -0.6f}, .vfov_deg = 41};
    showroom.ao_radius = 0.8f;
    camera car{.name = "car", .eye = {-2.6f, 2.0f, 3.4f}, .target = {-0.7f, 0.7f, -0.1f}, .vfov_deg = 42};
    car.ao_radius = 0.6f;
    camera panes{.name = "panes", .eye = {5.8f, 2.2f, 5.0f}, .target = {3.6f, 0.5f, -1.4f}, .vfov_deg = 50};
    panes.ao_radius = 0.8f;
    return {showroom, car, panes};
}

}
