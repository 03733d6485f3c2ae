// SPDX-License-Identifier: MIT
#include "scene/eye_mesh.hpp"

#include "expect_error.hpp"

#include <glm/geometric.hpp>

#include <cmath>

using namespace crease::tools;

namespace {

/// A triangle with legs of `size`, its right angle at `corner`.
void add_triangle(mesh& to, const glm::dvec3& corner, double size) {
    for (const glm::dvec3& p : {corner, corner + glm::dvec3(size, 0, 0), corner + glm::dvec3(0, size, 0)}) {
        to.indices.push_back(static_cast<std::uint32_t>(to.positions.size()));
        to.positions.push_back(p);
    }
}

mesh triangle(const glm::dvec3& corner, double size) {
    mesh scene;
    add_triangle(scene, corner, size);
    return scene;
}

}

TEST_CASE("eye mesh: positions are rounded relative to the eye, wherever both are") {
    const glm::dvec3 corner(1.5, -0.25, -3), eye(0.5, 0.125, 1);
    const eye_mesh at_origin = seen_from(eye, triangle(corner, 1));
    for (const glm::dvec3 place : {glm::dvec3(1e5, 0, -1e5), glm::dvec3(6.4e6, 3, -6.4e6)}) {
        const eye_mesh moved = seen_from(eye + place, triangle(corner + place, 1));
        CHECK(moved.positions == at_origin.positions);
        CHECK(moved.scale.unit == at_origin.scale.unit);
    }
    CHECK(at_origin.scale.unit == 4); // of a farthest coordinate of 4
    CHECK(at_origin.scale.farthest == 4);
    CHECK(at_origin.positions[0] == glm::vec3(0.25f, -0.09375f, -1));
    CHECK(std::abs(at_origin.scale.nearest - std::hypot(1, 4)) <= 1e-15);
}

TEST_CASE("eye mesh: a scene of any size has the same numbers") {
    const eye_mesh one = seen_from(glm::dvec3(0), triangle({1.5, -0.25, -3}, 1));
    for (const double size : {0x1p-90, 0x1p-40, 0x1p50, 0x1p90}) {
        const eye_mesh other = seen_from(glm::dvec3(0), triangle(glm::dvec3(1.5, -0.25, -3) * size, size));
        CHECK(other.positions == one.positions);
        CHECK(other.scale.unit == size * one.scale.unit);
        CHECK(other.scale.radius(static_cast<float>(size)) == one.scale.radius(1));
    }
}

TEST_CASE("eye mesh: triangles that rounding leaves no area are left out, and all others have a normal") {
    mesh scene = triangle({1000, 1000, -1000}, 1);
    add_triangle(scene, {1000.5, 1000.5, -1000}, 1e-6); // 32-bit positions are 6e-5 apart there
    add_triangle(scene, {0, 0, -1e-3}, 1e-6);
    const eye_mesh seen = seen_from(glm::dvec3(0), scene);
    CHECK(seen.indices == std::vector<std::uint32_t>{0, 1, 2, 6, 7, 8});
    for (std::size_t i = 0; i < seen.indices.size(); i += 3)
        CHECK(normal_of(seen.positions[seen.indices[i]], seen.positions[seen.indices[i + 1]],
                        seen.positions[seen.indices[i + 2]]) == glm::dvec3(0, 0, 1));
    expect_error<scene_error>(
        "the scene is 2.15e+18 from the eye, where 32-bit positions are 2.56e+11 apart and no "
        "triangle has an area; move the camera nearer",
        [] {
            seen_from({0, 1.9e18, 1e18}, triangle({0, 0, 0}, 1));
        });
}

TEST_CASE("eye mesh: a normal of the smallest corners there are") {
    CHECK(normal_of({0, 0, 0}, {1e-38, 0, 0}, {0, 0, 1e-38}) == glm::dvec3(0, -1, 0));
}

TEST_CASE("eye mesh: a radius that 32 bits cannot hold beside the distance or the size of the scene") {
    const eye_scale near{.unit = 8, .nearest = 0, .farthest = 10},
        away{.unit = 1e6, .nearest = 1e6, .farthest = 1e6};
    CHECK(near.radius(0) == 0);
    CHECK(near.radius(2) == 0.25f);
    CHECK(near.radius(10 * 0x1p-50f) == 10 * 0x1p-53f);
    CHECK(near.radius(10 * 0x1p50f) == 10 * 0x1p47f);
    expect_error<scene_error>(
        "the radius 8e-15 is out of what 32-bit positions allow from this eye, which the scene "
        "begins 0 and ends 10 away from; it must be 0 or 8.88e-15 to 1.13e+16",
        [&] { near.radius(8e-15f); });
    expect_error<scene_error>("the radius 1.2e+16 is out of", [&] { near.radius(1.2e16f); });
    CHECK(away.radius(1) == 1e-6f);
    expect_error<scene_error>("must be 0 or 0.954 to", [&] { away.radius(0.9f); });
}

TEST_CASE("eye mesh: what has opacity 0 is left out, and the others keep their materials") {
    mesh scene = triangle({0, 0, -3}, 1);
    paint(scene, {{1, 0, 0, 0.5f}});
    add_triangle(scene, {0, 0, -4}, 1);
    paint(scene, {{0, 1, 0, 0}});
    add_triangle(scene, {0, 0, -5}, 1);
    paint(scene, {{0, 0, 1, 1}});
    add_triangle(scene, {0, 0, -6}, 1);
    const eye_mesh seen = seen_from(glm::dvec3(0), scene);
    CHECK(seen.indices == std::vector<std::uint32_t>{0, 1, 2, 6, 7, 8, 9, 10, 11});
    CHECK(seen.material_of(0) == material{{1, 0, 0, 0.5f}});
    CHECK(seen.material_of(1) == material{{0, 0, 1, 1}});
    CHECK(seen.material_of(2) == material{});
    mesh clear = triangle({0, 0, -3}, 1);
    paint(clear, {{1, 1, 1, 0}});
    expect_error<scene_error>("every triangle of the scene has opacity 0, so that nothing is seen",
                              [&] { seen_from(glm::dvec3(0), clear); });
}

TEST_CASE("eye mesh: what is dynamic stays so where other triangles are left out") {
    mesh scene{.positions = {{0, 0, -2}, {1, 0, -2}, {0, 1, -2}},
               .indices = {0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2}};
    scene.materials = {{{1, 1, 1, 1}}, {{1, 1, 1, 0}}};
    scene.material_ids = {0, 1, 0};
    scene.dynamic = {false, true, true};
    CHECK(seen_from({0, 0, 0}, scene).dynamic == std::vector<bool>{false, true, false});
}
