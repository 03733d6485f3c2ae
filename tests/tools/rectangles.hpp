// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

inline crease::tools::camera look(const glm::dvec3& eye, const glm::dvec3& target,
                                  const glm::dvec3& up = {0, 1, 0}) {
    crease::tools::camera from;
    from.eye = eye;
    from.target = target;
    from.up = up;
    return from;
}

/// The parallelogram at `corner` with the sides `a` and `b`.
inline void add_rectangle(crease::tools::mesh& to, const glm::dvec3& corner, const glm::dvec3& a,
                          const glm::dvec3& b) {
    const auto first = static_cast<std::uint32_t>(to.positions.size());
    to.positions.insert(to.positions.end(), {corner, corner + a, corner + a + b, corner + b});
    for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u})
        to.indices.push_back(first + i);
}
