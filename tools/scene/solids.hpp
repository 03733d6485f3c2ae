// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

#include <glm/vec2.hpp>

#include <span>

namespace crease::tools {

// Each adds one closed solid to a mesh, its corners moved by `place`.

/// An axis-aligned box between two opposite corners.
void add_box(mesh& to, const glm::vec3& low, const glm::vec3& high, const glm::mat4& place = glm::mat4(1));

/// A surface of revolution around +Y.
/// @param profile (distance from the axis, y), from bottom to top; ends at distance 0 close it
void add_lathe(mesh& to, std::span<const glm::vec2> profile, unsigned segments, const glm::mat4& place);

/// A wall piece with a round arch: z in [0, thickness], x in [-width / 2, width / 2], y in [0, height], with
/// a half-disk of `radius` around the origin left open. The ends at x = +-width / 2 are open, so that pieces
/// join.
struct arch {
    float width, height, thickness, radius;
    unsigned segments;
};
void add_arch(mesh& to, const arch& shape, const glm::mat4& place);

}
