// SPDX-License-Identifier: MIT
#include "scene/polygon.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <utility>
#include <vector>

namespace crease::tools {
namespace {

/// More would take seconds; a convex polygon of 10'000 corners needs this many.
constexpr std::size_t most_tests = 50'000'000;

/// Twice the signed area of a triangle.
double area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The corners in the plane of two axes in which the polygon has the greatest area, counterclockwise.
std::vector<glm::dvec2> flattened(const std::vector<glm::dvec3>& positions,
                                  std::span<const std::uint32_t> corners) {
    glm::dvec3 normal(0); // of twice the area's length (Newell)
    const glm::dvec3& origin = positions[corners[0]];
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        normal += glm::cross(positions[corners[i]] - origin, positions[corners[i + 1]] - origin);
    const glm::dvec3 size = glm::abs(normal);
    const int across = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    int x = (across + 1) % 3, y = (across + 2) % 3;
    if (normal[across] < 0)
        std::swap(x, y);
    std::vector<glm::dvec2> flat;
    for (const std::uint32_t corner : corners)
        flat.emplace_back(positions[corner][x] - origin[x], positions[corner][y] - origin[y]);
    return flat;
}

}

void triangulator::add(std::span<const std::uint32_t> corners) {
    if (corners.size() == 3)
        add_triangle(to_, corners[0], corners[1], corners[2]);
    else if (corners.size() > 3)
        clip_ears(corners);
}

void triangulator::count_test() {
    if (++tests_ > most_tests)
        throw scene_error("has polygons that are too involved to cut into triangles; export triangles");
}

void triangulator::clip_ears(std::span<const std::uint32_t> corners) {
    const std::vector<glm::dvec2> flat = flattened(to_.positions, corners);
    const std::size_t size = corners.size();
    std::vector<std::size_t> before(size), after(size);
    for (std::size_t i = 0; i < size; ++i) {
        before[i] = (i + size - 1) % size;
        after[i] = (i + 1) % size;
    }
    const auto turn = [&](std::size_t i) { return area(flat[before[i]], flat[i], flat[after[i]]); };
    const auto is_ear = [&](std::size_t i) {
        const std::size_t a = before[i], c = after[i];
        count_test();
        if (!(turn(i) > 0))
            return false;
        for (std::size_t k = after[c]; k != a; k = after[k]) {
            count_test();
            const glm::dvec2 p = flat[k];
            const bool is_inside = area(flat[a], flat[i], p) >= 0 && area(flat[i], flat[c], p) >= 0 &&
                                   area(flat[c], flat[a], p) >= 0;
            if (is_inside && p != flat[a] && p != flat[i] && p != flat[c])
                return false;
        }
        return true;
    };
    std::size_t at = 1, left = size, refused = 0;
    while (left > 3) {
        // A polygon that crosses itself may have no ear: it is cut anywhere.
        if (!is_ear(at) && refused < left) {
            ++refused;
            at = after[at];
            continue;
        }
        add_triangle(to_, corners[before[at]], corners[at], corners[after[at]]);
        after[before[at]] = after[at];
        before[after[at]] = before[at];
        at = after[at];
        --left;
        refused = 0;
    }
    add_triangle(to_, corners[before[at]], corners[at], corners[after[at]]);
}

}
