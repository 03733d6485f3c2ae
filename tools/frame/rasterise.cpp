// SPDX-License-Identifier: MIT
#include "frame/frame.hpp"

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace crease::tools {

namespace {

constexpr const char* vertex_glsl = R"glsl(#version 450
layout(push_constant) uniform transforms {
    mat4 view_from_world;
    mat4 clip_from_view;
};
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec3 view_position;
layout(location = 1) flat out vec3 view_normal;

void main() {
    vec4 seen = view_from_world * vec4(position, 1.0);
    view_position = seen.xyz;
    view_normal = mat3(view_from_world) * normal;
    gl_Position = clip_from_view * seen;
}
)glsl";

constexpr const char* fragment_glsl = R"glsl(#version 450
layout(location = 0) in vec3 view_position;
layout(location = 1) flat in vec3 view_normal;
layout(location = 0) out vec4 facing_normal;

void main() { facing_normal = vec4(dot(view_normal, view_position) > 0.0 ? -view_normal : view_normal, 0.0); }
)glsl";

struct transforms {
    glm::mat4 view_from_world, clip_from_view;
};

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

glm::mat4 projection_matrix(const camera& from) {
    glm::mat4 matrix = glm::perspectiveRH_ZO(glm::radians(from.vfov_deg),
                                             static_cast<float>(from.width) / static_cast<float>(from.height),
                                             from.near, from.far);
    matrix[1][1] = -matrix[1][1]; // Vulkan's clip space points down
    return matrix;
}

view_parameters view_of(const camera& from, const glm::mat4& projection) {
    view_parameters view;
    float matrix[16];
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            matrix[column * 4 + row] = projection[column][row];
    set_projection(view, matrix, from.width, from.height);
    return view;
}

}

gbuffer rasterise(vulkan::device& device, const mesh& scene, const camera& from) {
    const piece vertex[] = {{"gbuffer.vert", vertex_glsl}}, fragment[] = {{"gbuffer.frag", fragment_glsl}};
    const format colours[] = {format::rgba16_float};
    vulkan::rasteriser rasteriser(device,
                                  {.vertex = vertex,
                                   .fragment = fragment,
                                   .colours = colours,
                                   .push_constant_bytes = sizeof(transforms)},
                                  from.width, from.height);
    const vulkan::mesh triangles(device, flat_vertices(scene));
    const transforms how{view_matrix(from), projection_matrix(from)};
    rasteriser.draw(triangles, std::as_bytes(std::span(&how, 1)));

    gbuffer made{.view = view_of(from, how.clip_from_view),
                 .device = vulkan::download(device, rasteriser.depth()),
                 .depth = image(from.width, from.height),
                 .normal = image(from.width, from.height, 3)};
    const std::vector<float> normals = vulkan::download(device, rasteriser.colour(0));
    for (std::size_t i = 0; i < made.device.size(); ++i) {
        const float inverse = made.device[i] * made.view.depth_unpack[0] + made.view.depth_unpack[1];
        made.depth.texels[i] = made.device[i] == 1.0f ? from.far : 1 / inverse;
        for (std::size_t c = 0; c < 3; ++c)
            made.normal.texels[3 * i + c] = normals[4 * i + c];
    }
    return made;
}

}
