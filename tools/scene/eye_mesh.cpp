// SPDX-License-Identifier: MIT
#include "scene/eye_mesh.hpp"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace crease::tools {
namespace {

struct box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high = -low;
};

/// Around all triangles, relative to the eye.
box bounds(const glm::dvec3& eye, const mesh& scene) {
    box all;
    for (const std::uint32_t i : scene.indices) {
        all.low = glm::min(all.low, scene.positions[i] - eye);
        all.high = glm::max(all.high, scene.positions[i] - eye);
    }
    return all;
}

double greatest(const glm::dvec3& v) {
    return std::max({v.x, v.y, v.z});
}

/// Normals and lengths within a radius are products of two lengths, of which none may reach the ends of what
/// 32 bits hold.
constexpr double most_unlike = 0x1p50;

/// A position is off by half of its last bit, of which a radius must hold some.
constexpr double least_radius_of_distance = 0x1p-20;

}

eye_mesh seen_from(const glm::dvec3& eye, const mesh& scene) {
    const box all = bounds(eye, scene);
    eye_mesh made;
    made.scale.nearest = glm::length(glm::max(glm::max(all.low, -all.high), glm::dvec3(0)));
    made.scale.farthest = greatest(glm::max(glm::abs(all.low), glm::abs(all.high)));
    if (made.scale.farthest > 0)
        made.scale.unit = std::exp2(std::ilogb(made.scale.farthest));
    made.positions.reserve(scene.positions.size());
    for (const glm::dvec3& p : scene.positions)
        made.positions.emplace_back((p - eye) / made.scale.unit);
    made.materials = scene.materials;
    const auto white = static_cast<std::uint32_t>(made.materials.size());
    made.materials.emplace_back();
    bool is_seen = false;
    for (std::size_t i = 0; i + 2 < scene.indices.size(); i += 3) {
        const std::size_t triangle = i / 3;
        const std::uint32_t of = triangle < scene.material_ids.size() ? scene.material_ids[triangle] : white;
        if (made.materials[of].colour.a == 0)
            continue;
        is_seen = true;
        const glm::dvec3 a = made.positions[scene.indices[i]], b = made.positions[scene.indices[i + 1]],
                         c = made.positions[scene.indices[i + 2]];
        if (glm::cross(b - a, c - a) == glm::dvec3(0))
            continue;
        made.indices.insert(made.indices.end(), &scene.indices[i], &scene.indices[i] + 3);
        made.material_ids.push_back(of);
        made.dynamic.push_back(triangle < scene.dynamic.size() && scene.dynamic[triangle]);
    }
    if (!is_seen)
        throw scene_error("every triangle of the scene has opacity 0, so that nothing is seen");
    if (made.indices.empty())
        throw scene_error(
            fmt::format("the scene is {:.3g} from the eye, where 32-bit positions are {:.3g} apart "
                        "and no triangle has an area; move the camera nearer",
                        made.scale.nearest, made.scale.nearest * std::numeric_limits<float>::epsilon()));
    return made;
}

float eye_scale::radius(float in_world) const {
    const double least = std::max(nearest * least_radius_of_distance, farthest / most_unlike),
                 most = farthest * most_unlike;
    if (in_world != 0 && !(in_world >= least && in_world <= most))
        throw scene_error(
            fmt::format("the radius {:.3g} is out of what 32-bit positions allow from this eye, which "
                        "the scene begins {:.3g} and ends {:.3g} away from; it must be 0 or {:.3g} to "
                        "{:.3g}",
                        in_world, nearest, farthest, least, most));
    return static_cast<float>(in_world / unit);
}

glm::dvec3 normal_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::normalize(glm::cross(b - a, c - a));
}

}
