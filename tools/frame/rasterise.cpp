// SPDX-License-Identifier: MIT
#include "frame/frame.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <span>

namespace crease::tools {

namespace {

constexpr const char* vertex_glsl = R"glsl(#version 450
layout(push_constant) uniform transforms {
    mat4 view_from_eye;
    mat4 clip_from_view;
};
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec3 view_position;
layout(location = 1) flat out vec3 view_normal;

void main() {
    vec4 seen = view_from_eye * vec4(position, 1.0);
    view_position = seen.xyz;
    view_normal = mat3(view_from_eye) * normal;
    gl_Position = clip_from_view * seen;
}
)glsl";

constexpr const char* fragment_glsl = R"glsl(#version 450
layout(location = 0) in vec3 view_position;
layout(location = 1) flat in vec3 view_normal;
layout(location = 0) out vec4 facing_normal;

void main() { facing_normal = vec4(dot(view_normal, view_position) > 0.0 ? -view_normal : view_normal, 0.0); }
)glsl";

/// The pictures within the guard band.
void crop(gbuffer& made) {
    const camera& from = made.from;
    const std::size_t pitch = from.width + 2 * std::size_t{made.guard};
    for (std::size_t y = 0; y < from.height; ++y)
        for (std::size_t x = 0; x < from.width; ++x) {
            const std::size_t inside = y * from.width + x, whole = (y + made.guard) * pitch + x + made.guard;
            const float device = made.device[whole];
            made.depth.texels[inside] =
                device == background_of(made.depth_kind)
                    ? from.far
                    : static_cast<float>(made.drawn.scale.unit * double{linear_depth_of(made, device)});
            for (std::size_t c = 0; c < 3; ++c)
                made.normal.texels[3 * inside + c] = made.normals[4 * whole + c];
        }
}

}

float linear_depth_of(const gbuffer& inputs, float device) {
    const float unpacked = device * inputs.view.depth_unpack[0] + inputs.view.depth_unpack[1];
    return inputs.from.orthographic ? unpacked : 1 / unpacked;
}

gbuffer rasterise(vulkan::device& device, const mesh& scene, const camera& from, unsigned guard,
                  device_depth_kind depth) {
    const eye_mesh seen = seen_from(from.eye, scene);
    const glm::mat4 projection = projection_matrix(from, seen.scale, depth);
    glm::mat4 wide = projection;
    float matrix[16];
    std::copy_n(glm::value_ptr(projection), 16, matrix);
    widen_projection(matrix, from.width, from.height, guard);
    std::copy_n(matrix, 16, glm::value_ptr(wide));

    const piece vertex[] = {{"gbuffer.vert", vertex_glsl}}, fragment[] = {{"gbuffer.frag", fragment_glsl}};
    const format colours[] = {format::rgba16_float};
    vulkan::rasteriser rasteriser(device,
                                  {.vertex = vertex,
                                   .fragment = fragment,
                                   .colours = colours,
                                   .push_constant_bytes = sizeof(transforms),
                                   .reversed_depth = depth != device_depth_kind::standard},
                                  from.width + 2 * guard, from.height + 2 * guard);
    gbuffer made{.from = from,
                 .view = view_of(projection, from.width, from.height, guard),
                 .guard = guard,
                 .drawn = upload_geometry(device, seen, {glm::mat4(glm::mat3(view_rotation(from))), wide}),
                 .depth_kind = depth,
                 .device = {},
                 .normals = {},
                 .depth = image(from.width, from.height),
                 .normal = image(from.width, from.height, 3)};
    rasteriser.draw(*made.drawn.triangles, std::as_bytes(std::span(&made.drawn.how, 1)));
    made.device = vulkan::download(device, rasteriser.depth());
    made.normals = vulkan::download(device, rasteriser.colour(0));
    crop(made);
    return made;
}

}
