// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/compile.hpp>
#include <crease/vulkan/buffer.hpp>
#include <crease/vulkan/pipeline.hpp>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace crease::vulkan {

/// Triangles on the device: three vertices each, without an index, a vertex being position xyz and normal
/// xyz.
class mesh {
public:
    static constexpr std::size_t numbers_per_vertex = 6;

    /// @param vertices  18 numbers a triangle, at least one triangle
    /// @throws error  where the count is no multiple of 18 or is 0, or there is not enough memory
    mesh(const device& on, std::span<const float> vertices)
        : vertices_(on, expect_triangles(vertices).size_bytes(), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT,
                    transfer::to_device, "vertices"),
          count_(static_cast<std::uint32_t>(vertices.size() / numbers_per_vertex)) {
        std::ranges::copy(std::as_bytes(vertices), vertices_.bytes().begin());
    }

    VkBuffer buffer_handle() const { return vertices_.handle(); }
    std::uint32_t vertex_count() const { return count_; }

private:
    buffer vertices_;
    std::uint32_t count_;

    static std::span<const float> expect_triangles(std::span<const float> vertices) {
        if (vertices.empty() || vertices.size() % (3 * numbers_per_vertex) != 0)
            throw error("a mesh takes " + std::to_string(3 * numbers_per_vertex) +
                        " numbers a triangle, not " + std::to_string(vertices.size()) + " in all");
        return vertices;
    }
};

/// What a rasteriser draws with and to.
struct rasteriser_options {
    std::span<const piece> vertex;   ///< GLSL; `layout(location = 0) in vec3` is the position, 1 the normal
    std::span<const piece> fragment; ///< GLSL; writes each of the colours
    std::span<const format> colours; ///< of locations 0, 1, ...; at least one
    std::uint32_t push_constant_bytes = 0; ///< that both shaders may read; a multiple of 4, at most 128
    bool reversed_depth =
        false; ///< false: the least depth is seen and the background is 1; true: the greatest, and 0
};

/// Draws triangles with depth test, both sides of each: into images that a runner can take as inputs.
class rasteriser {
public:
    /// @param width,height  of the images in texels, > 0
    /// @throws error         where a size is 0, or the device lacks a format, limit or memory
    /// @throws spirv::error  where a shader does not compile
    rasteriser(device& on, const rasteriser_options& options, std::uint32_t width, std::uint32_t height)
        : device_(on), push_bytes_(options.push_constant_bytes),
          clear_depth_(options.reversed_depth ? 0.0f : 1.0f) {
        if (options.colours.empty())
            throw error("a rasteriser draws to one colour image at least");
        if (push_bytes_ > on.limits().maxPushConstantsSize)
            throw error("the device '" + on.name() + "' has no " + std::to_string(push_bytes_) +
                        " bytes of push constants");
        image_description d{.name = "depth", .texels = format::d32_float, .width = width, .height = height};
        constexpr VkImageUsageFlags read_later = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
        d.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | read_later;
        depth_ = std::make_unique<image>(on, d);
        d.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | read_later;
        std::vector<image*> colours;
        for (format each : options.colours) {
            d.name = "colour " + std::to_string(colours_.size());
            d.texels = each;
            colours_.push_back(std::make_unique<image>(on, d));
            colours.push_back(colours_.back().get());
        }
        target_ = std::make_unique<detail::render_target>(on, colours, depth_.get(),
                                                          detail::earlier_content::cleared);
        make_pipeline(options);
        on.check_messages();
    }

    /// Clears the images and draws: depth to the background, colours to 0.
    /// @param push_constants  as many bytes as the options say
    /// @throws error  where they are not as many
    void draw(const mesh& triangles, std::span<const std::byte> push_constants = {}) {
        if (push_constants.size() != push_bytes_)
            throw error("the rasteriser takes " + std::to_string(push_bytes_) +
                        " bytes of push constants, not " + std::to_string(push_constants.size()));
        device_.submit([&](VkCommandBuffer commands) {
            const VkBuffer vertices = triangles.buffer_handle();
            constexpr VkDeviceSize start = 0;
            target_->begin(commands, clear_depth_);
            vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
            vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &start);
            if (push_bytes_)
                vkCmdPushConstants(commands, layout_, both_stages, 0, push_bytes_, push_constants.data());
            vkCmdDraw(commands, triangles.vertex_count(), 1, 0, 0);
            target_->end(commands);
        });
    }

    image& depth() { return *depth_; } ///< d32_float
    image& colour(std::size_t location) { return *colours_.at(location); }

private:
    static constexpr VkShaderStageFlags both_stages =
        VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

    device& device_;
    std::uint32_t push_bytes_;
    float clear_depth_;
    std::unique_ptr<image> depth_;
    std::vector<std::unique_ptr<image>> colours_;
    std::unique_ptr<detail::render_target> target_;
    detail::owned_pipeline_layout layout_;
    detail::owned_pipeline pipeline_;

    void make_pipeline(const rasteriser_options& options) {
        const spirv::words vertex =
            spirv::compile(options.vertex, spirv::shader_stage::vertex, "the vertex shader");
        const spirv::words fragment =
            spirv::compile(options.fragment, spirv::shader_stage::fragment, "the fragment shader");
        const VkPushConstantRange push{both_stages, 0, push_bytes_};
        auto info = detail::blank<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
        info.pushConstantRangeCount = push_bytes_ ? 1 : 0;
        info.pPushConstantRanges = &push;
        layout_ = detail::make<detail::owned_pipeline_layout>(device_.handle(), vkCreatePipelineLayout, info,
                                                              "a pipeline layout");

        constexpr VkVertexInputBindingDescription vertices{0, mesh::numbers_per_vertex * sizeof(float),
                                                           VK_VERTEX_INPUT_RATE_VERTEX};
        constexpr VkVertexInputAttributeDescription attributes[] = {
            {0, 0, VK_FORMAT_R32G32B32_SFLOAT, 0}, {1, 0, VK_FORMAT_R32G32B32_SFLOAT, 3 * sizeof(float)}};
        detail::graphics_description graphics{.vertex = vertex,
                                              .fragment = fragment,
                                              .layout = layout_,
                                              .target = target_.get(),
                                              .nearer = options.reversed_depth ? VK_COMPARE_OP_GREATER
                                                                               : VK_COMPARE_OP_LESS};
        graphics.vertex_input.vertexBindingDescriptionCount = 1;
        graphics.vertex_input.pVertexBindingDescriptions = &vertices;
        graphics.vertex_input.vertexAttributeDescriptionCount = 2;
        graphics.vertex_input.pVertexAttributeDescriptions = attributes;
        pipeline_ = detail::make_graphics_pipeline(device_, graphics);
    }
};

}
