// SPDX-License-Identifier: MIT
#include "frame/content.hpp"

#include "scene/scene.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

namespace crease::tools {

namespace {

std::vector<float> depth_of(std::string_view content, const gbuffer& inputs) {
    if (content == "device_depth")
        return inputs.device;
    const float whole = std::log2(1 + far_plane(inputs));
    std::vector<float> depth;
    for (const float z : inputs.device) {
        const bool is_background = z == background_of(inputs.depth_kind);
        const float linear = is_background ? 0 : linear_depth_of(inputs, z);
        depth.push_back(content == "linear_depth" ? linear
                        : is_background           ? 1
                                                  : std::log2(1 + linear) / whole);
    }
    return depth;
}

/// The point of the octahedron that stands for a direction.
glm::vec2 octahedron_of(glm::vec3 direction) {
    const float sum = std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
    const glm::vec2 point = glm::vec2(direction) / (sum > 0 ? sum : 1);
    return direction.z >= 0 ? point
                            : glm::vec2(std::copysign(1 - std::abs(point.y), point.x),
                                        std::copysign(1 - std::abs(point.x), point.y));
}

std::vector<float> normals_of(std::string_view content, const gbuffer& inputs) {
    const glm::mat3 to_world(glm::transpose(view_rotation(inputs.from)));
    const bool is_octahedral = content.starts_with("octahedral"), is_packed = content.starts_with("packed");
    std::vector<float> texels;
    for (std::size_t i = 0; i < inputs.normals.size(); i += 4) {
        glm::vec3 normal = glm::make_vec3(&inputs.normals[i]);
        if (content.ends_with("world_normals"))
            normal = to_world * normal;
        if (is_octahedral) {
            const glm::vec2 point = octahedron_of(normal) * 0.5f + 0.5f;
            texels.insert(texels.end(), {point.x, point.y});
            continue;
        }
        normal = is_packed ? normal * 0.5f + 0.5f : normal;
        texels.insert(texels.end(), {normal.x, normal.y, normal.z, 0});
    }
    return texels;
}

}

float far_plane(const gbuffer& inputs) {
    return static_cast<float>(double{inputs.from.far} / inputs.drawn.scale.unit);
}

std::vector<float> content_of(const resource& wanted, const gbuffer& inputs) {
    if (wanted.content.ends_with("_depth"))
        return depth_of(wanted.content, inputs);
    if (wanted.content.ends_with("_normals"))
        return normals_of(wanted.content, inputs);
    throw std::runtime_error("the input '" + std::string(wanted.name) + "' holds '" +
                             std::string(wanted.content) + "', which the command does not draw");
}

}
