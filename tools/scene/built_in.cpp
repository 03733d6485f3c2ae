// SPDX-License-Identifier: MIT
#include "scene/solids.hpp"

#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <array>
#include <cmath>
#include <numbers>

// The courtyard: x to the right, z towards the first camera, the floor at y = 0. The back wall stands at z =
// -5, the arcade at x = -6; stairs climb along the back wall to a roofed gallery on the right.

namespace crease::tools {
namespace {

glm::mat4 at(float x, float y, float z) {
    return glm::translate(glm::mat4(1), {x, y, z});
}

glm::mat4 turned(const glm::mat4& place, float degrees, const glm::vec3& axis = {0, 1, 0}) {
    return glm::rotate(place, glm::radians(degrees), axis);
}

void add_floor(mesh& to) {
    constexpr float tile = 1.5f, gap = 0.016f;
    add_box(to, {-9, -0.4f, -5.4f}, {6.6f, -0.06f, 7.6f});
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < 8; ++k) {
            const glm::vec3 corner(-6 + tile * static_cast<float>(i), 0, -5 + tile * static_cast<float>(k));
            add_box(to, corner + glm::vec3(gap / 2, -0.06f, gap / 2),
                    corner + glm::vec3(tile - gap / 2, 0, tile - gap / 2));
        }
}

void add_back_wall(mesh& to) {
    add_box(to, {-9, -0.06f, -5.4f}, {6.4f, 5.2f, -5});
    add_box(to, {-9, 5.2f, -5.5f}, {6.5f, 5.4f, -4.85f});
    add_box(to, {-6, 0, -5}, {-0.2f, 0.3f, -4.94f});
    for (int i = 0; i < 20; ++i) { // brackets below the coping
        const float x = -5.7f + 0.4f * static_cast<float>(i);
        add_box(to, {x - 0.09f, 4.92f, -5}, {x + 0.09f, 5.2f, -4.88f});
    }
    for (const float x : {-4.4f, -2.2f}) { // blind windows with a sill
        add_box(to, {x - 0.62f, 1.5f, -5}, {x - 0.5f, 3.5f, -4.9f});
        add_box(to, {x + 0.5f, 1.5f, -5}, {x + 0.62f, 3.5f, -4.9f});
        add_box(to, {x - 0.62f, 3.5f, -5}, {x + 0.62f, 3.62f, -4.9f});
        add_box(to, {x - 0.75f, 1.38f, -5}, {x + 0.75f, 1.5f, -4.78f});
    }
}

void add_column(mesh& to, const glm::mat4& place, float radius, float height) {
    const std::array<glm::vec2, 14> shaft{{{radius * 1.45f, 0.14f},
                                           {radius * 1.45f, 0.2f},
                                           {radius * 1.3f, 0.26f},
                                           {radius * 1.1f, 0.28f},
                                           {radius, 0.36f},
                                           {radius, height * 0.4f},
                                           {radius * 0.88f, height - 0.42f},
                                           {radius * 1.05f, height - 0.4f},
                                           {radius * 1.05f, height - 0.34f},
                                           {radius * 0.9f, height - 0.32f},
                                           {radius * 0.95f, height - 0.26f},
                                           {radius * 1.15f, height - 0.18f},
                                           {radius * 1.4f, height - 0.14f},
                                           {radius * 1.4f, height - 0.12f}}};
    add_lathe(to, shaft, 20, place);
    const float half = radius * 1.55f;
    add_box(to, {-half, 0, -half}, {half, 0.14f, half}, place);
    add_box(to, {-half, height - 0.12f, -half}, {half, height, half}, place);
}

void add_arcade(mesh& to) {
    constexpr float bay = 3, spring = 2.3f, top = 5.2f;
    for (int i = 0; i < 4; ++i) {
        const float z = -3.5f + bay * static_cast<float>(i);
        add_arch(to, {bay, top - spring, 0.44f, 1.2f, 16}, turned(at(-6.22f, spring, z), 90));
        add_column(to, at(-6, 0, z + bay / 2), 0.19f, spring);
    }
    for (int i = 0; i < 29; ++i) { // brackets below the coping
        const float z = -4.6f + 0.4f * static_cast<float>(i);
        add_box(to, {-5.78f, 4.92f, z - 0.09f}, {-5.66f, top, z + 0.09f});
    }
    add_box(to, {-5.78f, 3.85f, -5}, {-5.72f, 4, 7});
    add_box(to, {-6.3f, 0, -5}, {-5.7f, spring, -4.7f});
    add_box(to, {-6.32f, top, -5}, {-5.6f, top + 0.2f, 7});
    add_box(to, {-9, -0.06f, -5}, {-8.6f, top, 7});       // the wall of the walk behind
    add_box(to, {-8.6f, 4.2f, -5}, {-6.22f, 4.4f, 7});    // its ceiling
    add_box(to, {-8.6f, -0.06f, -5}, {-6, 0, 7});         // its floor
    add_box(to, {-8.6f, 0, -4.6f}, {-8.2f, 0.45f, 6.6f}); // its bench
}

constexpr float gallery_height = 2, stairs_begin = -0.2f, stairs_end = 2.8f, stairs_front = -3.4f,
                gallery_front = -2.7f, gallery_end = 6.2f;

/// A handrail from `begin` to `end` with thin bars that reach down to the two points.
void add_railing(mesh& to, const glm::vec3& begin, const glm::vec3& end, int bars) {
    constexpr float height = 0.95f, half = 0.014f;
    const glm::vec3 along = end - begin;
    const float length = std::hypot(along.x, along.y, along.z);
    const float pitch = glm::degrees(std::asin(along.y / length)),
                yaw = -glm::degrees(std::atan2(along.z, along.x));
    const glm::mat4 place =
        turned(turned(glm::translate(glm::mat4(1), begin + glm::vec3(0, height, 0)), yaw), pitch, {0, 0, 1});
    add_box(to, {-0.04f, -0.035f, -0.035f}, {length + 0.04f, 0.035f, 0.035f}, place);
    for (int i = 0; i <= bars; ++i) {
        const glm::vec3 foot = begin + along * (static_cast<float>(i) / static_cast<float>(bars));
        add_box(to, foot + glm::vec3(-half, -0.08f, -half), foot + glm::vec3(half, height - 0.02f, half));
    }
}

void add_stairs(mesh& to) {
    constexpr int steps = 10;
    constexpr float run = (stairs_end - stairs_begin) / steps, rise = gallery_height / steps;
    for (int i = 0; i < steps; ++i) {
        const float x = stairs_begin + run * static_cast<float>(i), y = rise * static_cast<float>(i);
        add_box(to, {x, 0, -5}, {x + run, y + rise - 0.05f, stairs_front});
        add_box(to, {x - 0.04f, y + rise - 0.05f, -5}, {x + run, y + rise, stairs_front + 0.05f});
    }
    add_railing(to, {stairs_begin + run / 2, rise, stairs_front - 0.06f},
                {stairs_end - run / 2, gallery_height, stairs_front - 0.06f}, 18);
    add_box(to, {stairs_begin - 0.1f, 0, stairs_front - 0.16f},
            {stairs_begin + 0.1f, 1.35f, stairs_front + 0.04f}); // the newel
}

void add_gallery(mesh& to) {
    add_box(to, {stairs_end, gallery_height - 0.22f, -5}, {gallery_end, gallery_height, gallery_front});
    add_railing(to, {stairs_end + 0.12f, gallery_height, gallery_front - 0.08f},
                {gallery_end - 0.12f, gallery_height, gallery_front - 0.08f}, 26);
    add_railing(to, {stairs_end + 0.06f, gallery_height, stairs_front - 0.06f},
                {stairs_end + 0.06f, gallery_height, gallery_front - 0.08f}, 5);
    for (const float x : {stairs_end + 0.1f, gallery_end - 0.1f}) {
        add_box(to, {x - 0.1f, 0, gallery_front - 0.2f}, {x + 0.1f, gallery_height - 0.22f, gallery_front});
        add_box(to, {x - 0.07f, gallery_height, gallery_front - 0.17f},
                {x + 0.07f, 4.02f, gallery_front - 0.03f});
    }
    for (int i = 0; i < 7; ++i) { // joists below the floor
        const float x = stairs_end + 0.3f + 0.47f * static_cast<float>(i);
        add_box(to, {x - 0.05f, gallery_height - 0.38f, -5},
                {x + 0.05f, gallery_height - 0.22f, gallery_front - 0.2f});
    }
    add_box(to, {4.1f, gallery_height, -5}, {5.1f, gallery_height + 1.9f, -4.93f}); // a door
    add_box(to, {4.9f, gallery_height + 0.85f, -4.93f}, {4.98f, gallery_height + 0.93f, -4.85f});
}

void add_roof(mesh& to) {
    const glm::mat4 slope = turned(at(0, 4.75f, -5), 14, {1, 0, 0});
    constexpr float length = 2.75f;
    add_box(to, {stairs_end - 0.3f, 0, 0}, {6.5f, 0.06f, length}, slope);
    for (int i = 0; i < 8; ++i) { // rafters
        const float x = stairs_end - 0.1f + 0.5f * static_cast<float>(i);
        add_box(to, {x - 0.04f, -0.14f, 0}, {x + 0.04f, 0, length - 0.08f}, slope);
    }
    for (int i = 0; i < 9; ++i) { // courses of shingles
        const float z = 0.3f * static_cast<float>(i);
        add_box(to, {-0.32f, 0, 0}, {3.72f, 0.05f, 0.36f},
                turned(slope * at(stairs_end, 0.07f, z), -6, {1, 0, 0}));
    }
    add_box(to, {stairs_end - 0.1f, 3.98f, gallery_front - 0.17f}, {6.3f, 4.1f, gallery_front - 0.03f});
}

void add_sphere(mesh& to, const glm::vec3& centre, float radius) {
    std::array<glm::vec2, 21> profile;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const float angle = std::numbers::pi_v<float> * static_cast<float>(i) / 20;
        profile[i] = {i == 0 || i == 20 ? 0 : radius * std::sin(angle), -radius * std::cos(angle)};
    }
    add_lathe(to, profile, 40, at(centre.x, centre.y, centre.z));
}

void add_fountain(mesh& to, const glm::mat4& place) {
    const std::array<glm::vec2, 24> profile{
        {{1.5f, 0},      {1.5f, 0.12f},  {1.38f, 0.16f}, {1.34f, 0.42f}, {1.42f, 0.5f},  {1.42f, 0.58f},
         {1.14f, 0.58f}, {1.12f, 0.24f}, {0.34f, 0.24f}, {0.3f, 0.34f},  {0.14f, 0.46f}, {0.11f, 0.8f},
         {0.2f, 0.9f},   {0.14f, 0.98f}, {0.3f, 1.06f},  {0.58f, 1.16f}, {0.72f, 1.3f},  {0.72f, 1.35f},
         {0.64f, 1.35f}, {0.5f, 1.22f},  {0.24f, 1.14f}, {0.1f, 1.13f},  {0.08f, 1.3f},  {0, 1.3f}}};
    add_lathe(to, profile, 32, place);
}

void add_crates(mesh& to) {
    const auto crate = [&](const glm::mat4& place, float size) {
        const float half = size / 2, slat = size * 0.09f, depth = size * 0.05f;
        add_box(to, {-half + depth, 0, -half + depth}, {half - depth, size - depth, half - depth}, place);
        for (const float sx : {-1.0f, 1.0f})
            for (const float sz : {-1.0f, 1.0f})
                add_box(to, {sx > 0 ? half - slat : -half, 0, sz > 0 ? half - slat : -half},
                        {sx > 0 ? half : -half + slat, size, sz > 0 ? half : -half + slat}, place);
        for (const float y : {0.0f, size - slat})
            for (const float s : {-1.0f, 1.0f}) {
                const float outer = s * half, inner = s * (half - depth);
                const float low = std::min(outer, inner), high = std::max(outer, inner);
                add_box(to, {-half + slat, y, low}, {half - slat, y + slat, high}, place);
                add_box(to, {low, y, -half + slat}, {high, y + slat, half - slat}, place);
            }
    };
    crate(turned(at(-5.0f, 0, -4.3f), 8), 0.9f);
    crate(turned(at(-3.9f, 0, -4.45f), -6), 0.75f);
    crate(turned(at(-4.95f, 0.9f, -4.35f), 27), 0.6f);
    crate(turned(at(3.7f, 0, -4.4f), 5), 0.8f);
    crate(turned(at(5.2f, 0, -4.2f), -14), 1.0f);
}

/// The pillar that stands in the first camera's way, and the cupboard that it hides.
void add_foreground(mesh& to) {
    add_column(to, at(0.2f, 0, 4.4f), 0.34f, 4.4f);
    add_box(to, {-0.42f, 0, -0.25f}, {0.42f, 1.8f, 0.25f}, turned(at(-2.6f, 0, 1.98f), 49));
}

/// Planks that lean against the back wall.
void add_planks(mesh& to) {
    add_box(to, {0, 0, 0}, {0.3f, 2.6f, 0.04f},
            turned(turned(at(-1.6f, 0, -4.45f), -11, {1, 0, 0}), 4, {0, 0, 1}));
    add_box(to, {0, 0, 0}, {0.3f, 2.4f, 0.04f},
            turned(turned(at(-1.0f, 0, -4.5f), -11, {1, 0, 0}), -5, {0, 0, 1}));
}

}

mesh built_in_scene() {
    mesh scene;
    add_floor(scene);
    add_back_wall(scene);
    add_arcade(scene);
    add_stairs(scene);
    add_gallery(scene);
    add_roof(scene);
    add_fountain(scene, at(-1.7f, 0, 0.2f));
    add_sphere(scene, {-1.7f, 1.58f, 0.2f}, 0.28f);
    add_sphere(scene, {0.9f, 0.5f, -1.6f}, 0.5f);
    add_crates(scene);
    add_planks(scene);
    add_foreground(scene);
    return scene;
}

std::vector<camera> built_in_cameras() {
    camera overview{.name = "overview", .eye = {6, 3.4f, 9.4f}, .target = {-0.7f, 1.9f, -2}, .vfov_deg = 40};
    overview.ao_radius = 1.2f;
    camera stairs{
        .name = "stairs", .eye = {-0.9f, 1.9f, 1.2f}, .target = {3.0f, 1.75f, -4.2f}, .vfov_deg = 52};
    stairs.ao_radius = 0.8f;
    camera arcade{
        .name = "arcade", .eye = {-3.2f, 1.7f, 2.9f}, .target = {-6.3f, 2.1f, -1.8f}, .vfov_deg = 55};
    arcade.ao_radius = 1.2f;
    return {overview, stairs, arcade};
}

}
