// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/descriptors.hpp>
#include <crease/vulkan/pipeline.hpp>
#include <crease/vulkan/shaders.hpp>

#include <memory>

namespace crease::vulkan::detail {

/// One pass with all that is needed to record it.
class prepared_pass {
public:
    /// @param values  of the pass's constants, in their order
    /// @param output  of the resource that the pass writes; the image that a fragment pass draws to
    /// @param width,height  of the output, texels
    prepared_pass(const device& on, const pass& of, const pass_shaders& shaders,
                  std::span<const std::int32_t> values, image* output, std::uint32_t width,
                  std::uint32_t height)
        : pass_(of), compute_(of.stage == stage_kind::compute),
          descriptors_(on, of, compute_ ? VK_SHADER_STAGE_COMPUTE_BIT : VK_SHADER_STAGE_FRAGMENT_BIT) {
        const specialization constants(of.constants, values);
        if (compute_) {
            plan_groups(on, values, width, height);
            pipeline_ = make_compute_pipeline(on, shaders.main, descriptors_.layout(), constants);
            return;
        }
        target_ =
            std::make_unique<render_target>(on, std::vector{output}, nullptr, earlier_content::overwritten);
        pipeline_ = make_graphics_pipeline(on, {.vertex = shaders.vertex,
                                                .fragment = shaders.main,
                                                .layout = descriptors_.layout(),
                                                .target = target_.get(),
                                                .constants = &constants});
    }

    std::string name() const { return std::string(pass_.name); }

    void write_descriptors(std::span<image* const> images, const buffer& parameters,
                           VkSampler sampler) const {
        descriptors_.write(images, parameters, sampler);
    }

    /// @param images  by resource, as the descriptors were written
    void record(VkCommandBuffer commands, std::span<image* const> images) const {
        const VkPipelineStageFlags stage =
            compute_ ? VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT : VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT;
        for (const binding& b : pass_.bindings)
            if (b.how == access::sample || b.how == access::store)
                images[b.resource]->transition(commands, shader_use_of(b.how, stage));
        const VkPipelineBindPoint point =
            compute_ ? VK_PIPELINE_BIND_POINT_COMPUTE : VK_PIPELINE_BIND_POINT_GRAPHICS;
        vkCmdBindPipeline(commands, point, pipeline_);
        descriptors_.bind(commands, point);
        if (compute_) {
            vkCmdDispatch(commands, groups_[0], groups_[1], 1);
        } else {
            target_->begin(commands);
            vkCmdDraw(commands, 3, 1, 0, 0);
            target_->end(commands);
        }
    }

private:
    pass pass_;
    bool compute_;
    descriptors descriptors_;
    std::unique_ptr<render_target> target_;
    owned_pipeline pipeline_;
    std::uint32_t groups_[2] = {0, 0};

    void plan_groups(const device& on, std::span<const std::int32_t> values, std::uint32_t width,
                     std::uint32_t height) {
        const VkPhysicalDeviceLimits& most = on.limits();
        const std::uint32_t texels[] = {width, height};
        std::uint64_t invocations = 1;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const auto size = static_cast<std::uint32_t>(values[axis]);
            invocations *= size;
            if (values[axis] < 1 || size > most.maxComputeWorkGroupSize[axis] ||
                invocations > most.maxComputeWorkGroupInvocations)
                throw error("pass '" + name() + "' wants workgroups of " + std::to_string(values[0]) + " x " +
                            std::to_string(values[1]) + ", which the device '" + on.name() + "' cannot run");
            groups_[axis] = (texels[axis] + size - 1) / size;
            if (groups_[axis] > most.maxComputeWorkGroupCount[axis])
                throw error("pass '" + name() + "' wants " + std::to_string(groups_[axis]) +
                            " workgroups in a row, more than the device '" + on.name() + "' can run");
        }
    }
};

}
