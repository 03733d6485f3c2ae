// SPDX-License-Identifier: MIT
#include "scene/polygon.hpp"

#include "expect_error.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

using namespace crease::tools;

namespace {

mesh cut(const std::vector<glm::dvec3>& polygon) {
    mesh made{.positions = polygon, .indices = {}};
    std::vector<std::uint32_t> corners(polygon.size());
    std::iota(corners.begin(), corners.end(), 0u);
    triangulator(made).add(corners);
    return made;
}

/// Twice the area's normal of a triangle.
glm::dvec3 area(const mesh& of, std::size_t triangle) {
    const auto corner = [&](std::size_t k) { return of.positions[of.indices[3 * triangle + k]]; };
    return glm::cross(corner(1) - corner(0), corner(2) - corner(0));
}

/// Checks that the triangles are as many as `triangles`, turn as the polygon does and have its area.
void check_cut(const std::vector<glm::dvec3>& polygon, std::size_t triangles) {
    const mesh made = cut(polygon);
    CHECK(made.triangles() == triangles);
    glm::dvec3 whole(0);
    for (std::size_t i = 0; i < polygon.size(); ++i)
        whole += glm::cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    double sum = 0;
    for (std::size_t i = 0; i < made.triangles(); ++i) {
        CHECK(glm::dot(area(made, i), whole) > 0);
        sum += glm::length(area(made, i));
    }
    CHECK(sum == doctest::Approx(glm::length(whole)).epsilon(1e-12));
}

const std::vector<glm::dvec3> arrow{{0, 0, 0}, {2, -1, 0}, {0.5, 0, 0}, {2, 1, 0}},
    letter_u{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};

}

TEST_CASE("polygon: convex and not, each way around") {
    for (std::vector<glm::dvec3> polygon :
         {std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, arrow, letter_u}) {
        check_cut(polygon, polygon.size() - 2);
        std::reverse(polygon.begin(), polygon.end());
        check_cut(polygon, polygon.size() - 2);
        for (glm::dvec3& p : polygon) // another plane, of any size
            p = glm::dvec3(p.y, p.x + p.y, p.x) * 1e-9;
        check_cut(polygon, polygon.size() - 2);
        std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
        check_cut(polygon, polygon.size() - 2);
    }
}

TEST_CASE("polygon: a star of many corners") {
    std::vector<glm::dvec3> star;
    for (int i = 0; i < 400; ++i) {
        const double angle = std::numbers::pi * i / 200, radius = i % 2 ? 1 : 0.25;
        star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 7);
    }
    check_cut(star, 398);
}

TEST_CASE("polygon: corners on an edge, and a seam that leads to a hole") {
    check_cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, 3);
    check_cut({{0, 0, 0},
               {4, 0, 0},
               {4, 4, 0},
               {0, 4, 0},
               {0, 0, 0},
               {1, 1, 0},
               {1, 3, 0},
               {3, 3, 0},
               {3, 1, 0},
               {1, 1, 0}},
              8);
}

TEST_CASE("polygon: what is none ends too") {
    CHECK(cut({}).triangles() == 0);
    CHECK(cut({{0, 0, 0}, {1, 0, 0}}).triangles() == 0);
    CHECK(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).triangles() == 0);
    CHECK(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).triangles() > 0); // crosses itself
    const double nan = std::nan("");
    CHECK_NOTHROW(cut({{0, 0, 0}, {nan, 1, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST_CASE("polygon: more work than a polygon is worth is refused") {
    std::vector<glm::dvec3> comb;
    for (int i = 0; i < 100'000; ++i)
        comb.emplace_back(i, i % 2 ? 1 : 1000, 0);
    for (int i = 100'000; i-- > 0;)
        comb.emplace_back(i, i % 2 ? 0 : 999, 0);
    expect_error<scene_error>("has polygons that are too involved to cut into triangles", [&] { cut(comb); });
}
