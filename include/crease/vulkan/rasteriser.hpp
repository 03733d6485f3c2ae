// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/compile.hpp>
#include <crease/vulkan/mesh.hpp>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace crease::vulkan {

/// What a rasteriser draws with and to.
struct rasteriser_options {
    std::span<const piece> vertex;         ///< GLSL; `layout(location = 0) in vec3` is the position, 1 the
                                           ///< normal, `in vec4` at 2 the colour
    std::span<const piece> fragment;       ///< GLSL; writes each of the colours
    std::span<const format> colours;       ///< of locations 0, 1, ...; at least one
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
        detail::expect_push_size(on, push_bytes_);
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
        target_ = std::make_unique<detail::render_target>(
            on, colours, depth_.get(), VkExtent2D{width, height}, detail::earlier_content::cleared);
        make_pipeline(options);
        on.check_messages();
    }

    /// Clears the images and draws: depth to the background, colours to 0.
    /// @param push_constants  as many bytes as the options say
    /// @throws error  where they are not as many, or the shaders take colours and the mesh has none
    void draw(const mesh& triangles, std::span<const std::byte> push_constants = {}) {
        detail::expect_push_constants(push_constants, push_bytes_);
        detail::expect_colours(triangles, input_);
        device_.submit([&](VkCommandBuffer commands) {
            target_->begin(commands, clear_depth_);
            detail::draw_mesh(commands, pipeline_, layout_, triangles, push_constants);
            target_->end(commands);
        });
    }

    image& depth() { return *depth_; } ///< d32_float
    /// What the fragment shader wrote to a location.
    image& colour(std::size_t location) { return *colours_.at(location); }

private:
    device& device_;
    std::uint32_t push_bytes_;
    float clear_depth_;
    std::unique_ptr<image> depth_;
    std::vector<std::unique_ptr<image>> colours_;
    std::unique_ptr<detail::render_target> target_;
    detail::owned_pipeline_layout layout_;
    VkPipelineVertexInputStateCreateInfo input_;
    detail::owned_pipeline pipeline_;

    void make_pipeline(const rasteriser_options& options) {
        const spirv::words vertex =
            spirv::compile(options.vertex, spirv::shader_stage::vertex, "the vertex shader");
        const spirv::words fragment =
            spirv::compile(options.fragment, spirv::shader_stage::fragment, "the fragment shader");
        const VkPushConstantRange push{detail::geometry_stages, 0, push_bytes_};
        auto info = detail::blank<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
        info.pushConstantRangeCount = push_bytes_ ? 1 : 0;
        info.pPushConstantRanges = &push;
        layout_ = detail::make<detail::owned_pipeline_layout>(device_.handle(), vkCreatePipelineLayout, info,
                                                              "a pipeline layout");

        input_ = detail::mesh_input(vertex);
        const detail::graphics_description graphics{.vertex = vertex,
                                                    .fragment = fragment,
                                                    .layout = layout_,
                                                    .target = target_.get(),
                                                    .vertex_input = input_,
                                                    .nearer = options.reversed_depth ? VK_COMPARE_OP_GREATER
                                                                                     : VK_COMPARE_OP_LESS};
        pipeline_ = detail::make_graphics_pipeline(device_, graphics);
    }
};

}
