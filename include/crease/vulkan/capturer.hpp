// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/compile.hpp>
#include <crease/vulkan/mesh.hpp>
#include <crease/vulkan/runner.hpp>

#include <memory>
#include <span>
#include <vector>

namespace crease::vulkan {

/// What a host brings to a capture.
struct geometry_shaders {
    std::span<const piece> vertex;   ///< GLSL; `layout(location = 0) in vec3` is the position, 1 the normal
    std::span<const piece> fragment; ///< GLSL without `#version`; its main calls `crease_capture`
    std::uint32_t push_constant_bytes = 0; ///< that both shaders may read; a multiple of 4, at most 128
    bool reversed_depth = false;           ///< the greatest device depth is the nearest
};

/// Draws geometry so that it fills what an effect captures. Knows nothing of what that is.
class capturer {
public:
    /// @param which  index into the effect's captures
    /// @param to     the runner of the effect, whose image it fills; must outlive the capturer
    /// @throws error         where the device lacks a format, limit or memory
    /// @throws spirv::error  where the host's shaders with the capture's functions do not compile
    capturer(device& on, const effect_view& effect, std::size_t which, runner& to,
             const geometry_shaders& host)
        : device_(on), capture_(effect.captures[which]),
          filled_(effect.resources[capture_.bindings.back().resource]), image_(to.image_of(filled_.name)),
          push_bytes_(host.push_constant_bytes), clear_depth_(host.reversed_depth ? 0.0f : 1.0f),
          parameters_(on, sizeof(parameters), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, transfer::to_device,
                      "parameters"),
          timestamps_(on, 2), sampler_(detail::make_nearest_sampler(on)),
          descriptors_(on, capture_.bindings, VK_SHADER_STAGE_FRAGMENT_BIT, push_bytes_,
                       detail::geometry_stages) {
        detail::expect_push_size(on, push_bytes_);
        images_.resize(effect.resources.size());
        for (const binding& b : capture_.bindings)
            if (b.resource != 0)
                images_[b.resource] = &to.image_of(effect.resources[b.resource].name);
        const image_description& d = image_.description();
        target_ = std::make_unique<detail::render_target>(
            on, std::vector<image*>(), capture_.to_attachment() ? &image_ : nullptr,
            VkExtent2D{d.width, d.height}, detail::earlier_content::cleared);
        make_pipeline(host);
        descriptors_.write(images_, parameters_, sampler_);
        on.check_messages();
    }

    /// Clears what is captured and draws.
    /// @param push_constants  as many bytes as the shaders say
    /// @return milliseconds on the device, with the clearing; NaN where it has no timestamps
    /// @throws error  where they are not as many
    double draw(const mesh& triangles, const parameters& values,
                std::span<const std::byte> push_constants = {}) {
        detail::expect_push_constants(push_constants, push_bytes_);
        std::memcpy(parameters_.bytes().data(), &values, sizeof values);
        device_.submit([&](VkCommandBuffer commands) {
            timestamps_.begin(commands);
            if (!capture_.to_attachment())
                clear(commands);
            for (const binding& b : capture_.bindings)
                if (b.resource != 0 && has_descriptor(b.how))
                    images_[b.resource]->transition(
                        commands, detail::shader_use_of(b.how, VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT));
            target_->begin(commands, clear_depth_);
            descriptors_.bind(commands, VK_PIPELINE_BIND_POINT_GRAPHICS);
            detail::draw_mesh(commands, pipeline_, descriptors_.layout(), triangles, push_constants);
            target_->end(commands);
            timestamps_.mark(commands);
        });
        return timestamps_.intervals(device_)[0];
    }

private:
    device& device_;
    capture capture_;
    resource filled_;
    image& image_;
    std::uint32_t push_bytes_;
    float clear_depth_;
    buffer parameters_;
    detail::timestamps timestamps_;
    detail::owned_sampler sampler_;
    detail::descriptors descriptors_;
    std::vector<image*> images_; ///< by resource
    std::unique_ptr<detail::render_target> target_;
    detail::owned_pipeline pipeline_;

    void clear(VkCommandBuffer commands) {
        VkClearColorValue value;
        for (std::uint32_t& component : value.uint32)
            component = filled_.clear;
        const VkImageSubresourceRange range = image_.range();
        image_.transition(commands, copied_to);
        vkCmdClearColorImage(commands, image_.handle(), copied_to.layout, &value, 1, &range);
    }

    void make_pipeline(const geometry_shaders& host) {
        std::vector<piece> whole{{"version", "#version 450\n"}};
        whole.insert(whole.end(), capture_.pieces.begin(), capture_.pieces.end());
        whole.insert(whole.end(), host.fragment.begin(), host.fragment.end());
        const spirv::words vertex =
            spirv::compile(host.vertex, spirv::shader_stage::vertex, "the vertex shader");
        const spirv::words fragment = spirv::compile(whole, spirv::shader_stage::fragment,
                                                     "the capture '" + std::string(capture_.name) + "'");
        std::vector<std::int32_t> values;
        for (const constant& c : capture_.constants)
            values.push_back(c.value);
        const detail::specialization constants(capture_.constants, values);
        pipeline_ = detail::make_graphics_pipeline(
            device_, {.vertex = vertex,
                      .fragment = fragment,
                      .layout = descriptors_.layout(),
                      .target = target_.get(),
                      .constants = &constants,
                      .vertex_input = detail::mesh_input(vertex),
                      .nearer = clear_depth_ == 0 ? VK_COMPARE_OP_GREATER : VK_COMPARE_OP_LESS});
    }
};

}
