// SPDX-License-Identifier: MIT
#include "frame/geometry.hpp"

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <vector>

namespace crease::tools {

namespace {

/// Three vertices of position and face normal for each triangle.
std::vector<float> flat_vertices(const mesh& scene) {
    std::vector<float> numbers;
    numbers.reserve(scene.indices.size() * vulkan::mesh::numbers_per_vertex);
    for (std::size_t i = 0; i + 2 < scene.indices.size(); i += 3) {
        const glm::vec3 corners[] = {scene.positions[scene.indices[i]], scene.positions[scene.indices[i + 1]],
                                     scene.positions[scene.indices[i + 2]]};
        const glm::vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        for (const glm::vec3& p : corners)
            numbers.insert(numbers.end(), {p.x, p.y, p.z, normal.x, normal.y, normal.z});
    }
    return numbers;
}

}

std::shared_ptr<vulkan::mesh> upload_geometry(vulkan::device& device, const mesh& scene) {
    return std::make_shared<vulkan::mesh>(device, flat_vertices(scene));
}

glm::mat4 projection_matrix(const camera& from) {
    glm::mat4 matrix = glm::perspectiveRH_ZO(glm::radians(from.vfov_deg),
                                             static_cast<float>(from.width) / static_cast<float>(from.height),
                                             from.near, from.far);
    matrix[1][1] = -matrix[1][1];
    return matrix;
}

view_parameters view_of(const glm::mat4& projection, unsigned width, unsigned height, unsigned guard) {
    view_parameters view;
    float matrix[16];
    std::copy_n(glm::value_ptr(projection), 16, matrix);
    set_projection(view, matrix, width, height, {}, guard);
    return view;
}

}
