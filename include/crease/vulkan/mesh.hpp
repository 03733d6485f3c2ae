// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/reflect.hpp>
#include <crease/vulkan/buffer.hpp>
#include <crease/vulkan/pipeline.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace crease::vulkan {

/// Triangles on the device: three vertices each, without an index, a vertex being position xyz, normal xyz
/// and, where the mesh has them, a colour rgba.
class mesh {
public:
    /// Position xyz and normal xyz.
    static constexpr std::size_t numbers_per_vertex = 6;
    /// Colour rgba.
    static constexpr std::size_t numbers_per_colour = 4;

    /// @param vertices  18 numbers a triangle, at least one triangle
    /// @param colours    none, or 12 numbers a triangle
    /// @throws error  where the counts are others, or there is not enough memory
    mesh(const device& on, std::span<const float> vertices, std::span<const float> colours = {})
        : vertices_(on, expect_triangles(vertices).size_bytes(), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT,
                    transfer::to_device, "vertices"),
          count_(static_cast<std::uint32_t>(vertices.size() / numbers_per_vertex)) {
        std::ranges::copy(std::as_bytes(vertices), vertices_.bytes().begin());
        if (colours.empty())
            return;
        if (colours.size() != numbers_per_colour * count_)
            throw error("a mesh takes " + std::to_string(3 * numbers_per_colour) +
                        " numbers of colour a triangle, " + std::to_string(numbers_per_colour * count_) +
                        " in all and not " + std::to_string(colours.size()));
        colours_.emplace(on, colours.size_bytes(), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, transfer::to_device,
                         "colours");
        std::ranges::copy(std::as_bytes(colours), colours_->bytes().begin());
    }

    /// The vertex buffer.
    VkBuffer buffer_handle() const { return vertices_.handle(); }
    /// Whether the vertices have colours.
    bool has_colours() const { return colours_.has_value(); }
    /// The buffer of colours, of a mesh that has them.
    VkBuffer colour_handle() const { return colours_->handle(); }
    /// Three for each triangle.
    std::uint32_t vertex_count() const { return count_; }

private:
    buffer vertices_;
    std::optional<buffer> colours_;
    std::uint32_t count_;

    static std::span<const float> expect_triangles(std::span<const float> vertices) {
        if (vertices.empty() || vertices.size() % (3 * numbers_per_vertex) != 0)
            throw error("a mesh takes " + std::to_string(3 * numbers_per_vertex) +
                        " numbers a triangle, not " + std::to_string(vertices.size()) + " in all");
        return vertices;
    }
};

}

namespace crease::vulkan::detail {

inline constexpr VkShaderStageFlags geometry_stages =
    VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

inline constexpr VkVertexInputBindingDescription mesh_buffers[] = {
    {0, mesh::numbers_per_vertex * sizeof(float), VK_VERTEX_INPUT_RATE_VERTEX},
    {1, mesh::numbers_per_colour * sizeof(float), VK_VERTEX_INPUT_RATE_VERTEX}};
/// Normal, position, colour: whatever a shader takes beside the position, it is one piece of this.
inline constexpr VkVertexInputAttributeDescription mesh_attributes[] = {
    {1, 0, VK_FORMAT_R32G32B32_SFLOAT, 3 * sizeof(float)},
    {0, 0, VK_FORMAT_R32G32B32_SFLOAT, 0},
    {2, 1, VK_FORMAT_R32G32B32A32_SFLOAT, 0}};

/// How a graphics pipeline reads a mesh: the position, and the normal and the colour where the vertex shader
/// takes them.
inline VkPipelineVertexInputStateCreateInfo mesh_input(std::span<const std::uint32_t> vertex_shader) {
    const std::vector<std::uint32_t> taken = spirv::reflect(vertex_shader).attributes;
    const bool normal = std::ranges::count(taken, 1u) > 0, colour = std::ranges::count(taken, 2u) > 0;
    auto input = blank<VkPipelineVertexInputStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO);
    input.vertexBindingDescriptionCount = colour ? 2 : 1;
    input.pVertexBindingDescriptions = mesh_buffers;
    input.vertexAttributeDescriptionCount = 1u + normal + colour;
    input.pVertexAttributeDescriptions = mesh_attributes + !normal;
    return input;
}

/// @throws error  where the pipeline reads colours and the mesh has none
inline void expect_colours(const mesh& triangles, const VkPipelineVertexInputStateCreateInfo& input) {
    if (input.vertexBindingDescriptionCount == 2 && !triangles.has_colours())
        throw error("the vertex shader takes a colour at location 2, and the mesh has none");
}

/// Draws a mesh with a pipeline that is made for it.
inline void draw_mesh(VkCommandBuffer commands, VkPipeline pipeline, VkPipelineLayout layout,
                      const mesh& triangles, std::span<const std::byte> push_constants) {
    const VkBuffer buffers[] = {triangles.buffer_handle(),
                                triangles.has_colours() ? triangles.colour_handle() : VK_NULL_HANDLE};
    constexpr VkDeviceSize starts[] = {0, 0};
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
    vkCmdBindVertexBuffers(commands, 0, triangles.has_colours() ? 2 : 1, buffers, starts);
    if (!push_constants.empty())
        vkCmdPushConstants(commands, layout, geometry_stages, 0,
                           static_cast<std::uint32_t>(push_constants.size()), push_constants.data());
    vkCmdDraw(commands, triangles.vertex_count(), 1, 0, 0);
}

/// @throws error  where the bytes are not as many as `wanted`
inline void expect_push_constants(std::span<const std::byte> given, std::uint32_t wanted) {
    if (given.size() != wanted)
        throw error("the geometry's shaders take " + std::to_string(wanted) +
                    " bytes of push constants, not " + std::to_string(given.size()));
}

/// @throws error  where the device has not as many
inline void expect_push_size(const device& on, std::uint32_t bytes) {
    if (bytes > on.limits().maxPushConstantsSize)
        throw error("the device '" + on.name() + "' has no " + std::to_string(bytes) +
                    " bytes of push constants");
}

}
