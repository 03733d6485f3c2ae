// SPDX-License-Identifier: MIT
#include "frame/geometry.hpp"

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace crease::tools {

namespace {

/// Device depth is near / depth, which must not fall to where 32-bit numbers lose bits.
constexpr double least_depth = 0x1p-110;

/// Three vertices for each triangle.
struct flat_vertices {
    std::vector<float> positions_and_normals, colours;

    void add(const eye_mesh& scene, std::size_t triangle) {
        const std::uint32_t* corner = &scene.indices[3 * triangle];
        const glm::vec3 corners[] = {scene.positions[corner[0]], scene.positions[corner[1]],
                                     scene.positions[corner[2]]};
        const glm::vec3 normal = normal_of(corners[0], corners[1], corners[2]);
        const glm::vec4& c = scene.material_of(triangle).colour;
        for (const glm::vec3& p : corners) {
            positions_and_normals.insert(positions_and_normals.end(),
                                         {p.x, p.y, p.z, normal.x, normal.y, normal.z});
            colours.insert(colours.end(), {c.r, c.g, c.b, c.a});
        }
    }
};

/// The triangles of a scene that a choice has; where it has none, one without area, as a mesh has at least
/// one.
template <typename Choice>
std::shared_ptr<vulkan::mesh> upload(vulkan::device& device, const eye_mesh& scene, Choice has) {
    flat_vertices all;
    for (std::size_t i = 0; i < scene.triangles(); ++i)
        if (has(i))
            all.add(scene, i);
    if (all.colours.empty()) {
        all.positions_and_normals.resize(3 * vulkan::mesh::numbers_per_vertex);
        all.colours.resize(3 * vulkan::mesh::numbers_per_colour);
    }
    return std::make_shared<vulkan::mesh>(device, all.positions_and_normals, all.colours);
}

}

geometry upload_geometry(vulkan::device& device, const eye_mesh& scene, const transforms& how) {
    geometry made{.triangles = upload(device, scene, [](std::size_t) { return true; }),
                  .of_static = nullptr,
                  .of_dynamic = nullptr,
                  .how = how,
                  .scale = scene.scale};
    if (std::ranges::count(scene.dynamic, true) > 0) {
        made.of_static = upload(device, scene, [&](std::size_t i) { return !scene.dynamic[i]; });
        made.of_dynamic = upload(device, scene, [&](std::size_t i) { return bool{scene.dynamic[i]}; });
    }
    return made;
}

glm::mat4 projection_matrix(const camera& from, const eye_scale& scene, device_depth_kind depth) {
    if (!from.orthographic && from.near < scene.farthest * least_depth)
        throw scene_error(fmt::format(
            "the camera '{}': near is {:.3g}, and a 32-bit depth buffer tells depths apart up to {:.3g} "
            "times as far, but the scene reaches {:.3g}; near must be at least {:.3g}",
            from.name, from.near, 1 / least_depth, scene.farthest, scene.farthest * least_depth));
    if (from.orthographic && depth == device_depth_kind::infinite)
        throw scene_error("an orthographic camera has no infinite depth; use reversed or standard");
    // Beyond the scene, at 1 or 2, they may lie anywhere.
    const double near = std::min(from.near / scene.unit, 0x1p60),
                 far = std::min(from.far / scene.unit, 0x1p100);
    const view_window window = window_of(from, static_cast<double>(from.width) / from.height);
    const glm::dvec2 scale = glm::dvec2(1, -1) / window.half, middle = window.middle * scale;
    glm::dmat4 matrix(0);
    matrix[0][0] = scale.x;
    matrix[1][1] = scale.y;
    if (from.orthographic) {
        const double length = scene.unit, sign = depth == device_depth_kind::standard ? -1 : 1;
        matrix[0][0] *= length;
        matrix[1][1] *= length;
        matrix[2][2] = sign / (far - near);
        matrix[3] = {-middle.x, -middle.y, (sign < 0 ? -near : far) / (far - near), 1};
        return matrix;
    }
    matrix[2] = {middle.x, middle.y, 0, -1};
    switch (depth) {
    case device_depth_kind::reversed:
        matrix[2][2] = near / (far - near);
        matrix[3][2] = near * far / (far - near);
        break;
    case device_depth_kind::standard:
        matrix[2][2] = -far / (far - near);
        matrix[3][2] = -near * far / (far - near);
        break;
    case device_depth_kind::infinite:
        matrix[3][2] = near;
    }
    return matrix;
}

view_parameters view_of(const glm::mat4& projection, unsigned width, unsigned height, unsigned guard) {
    view_parameters view;
    float matrix[16];
    std::copy_n(glm::value_ptr(projection), 16, matrix);
    if (const auto fit = set_projection(view, matrix, width, height, {}, guard); !fit)
        throw std::runtime_error(std::string(fit.error));
    return view;
}

}
