// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/descriptors.hpp>
#include <crease/vulkan/pipeline.hpp>
#include <crease/vulkan/shaders.hpp>

#include <memory>
#include <span>

namespace crease::vulkan::detail {

/// One pass with all that is needed to record it.
class prepared_pass {
public:
    /// @param values  of the pass's constants, in their order
    /// @param outputs  the images that the pass writes
    /// @param size     of the outputs, texels
    /// @param ways     round in which histories can lie
    prepared_pass(const device& on, const pass& of, std::span<const resource> resources,
                  const pass_shaders& shaders, std::span<const std::int32_t> values,
                  const std::vector<image*>& outputs, VkExtent2D size, std::size_t ways)
        : pass_(of), compute_(of.stage == stage_kind::compute),
          descriptors_(on, of.bindings, resources,
                       compute_ ? VK_SHADER_STAGE_COMPUTE_BIT : VK_SHADER_STAGE_FRAGMENT_BIT, ways) {
        const specialization constants(of.constants, values);
        if (compute_) {
            plan_groups(on, values, size);
            pipeline_ = make_compute_pipeline(on, shaders.main, descriptors_.layout(), constants);
            return;
        }
        set_outputs(on, outputs, size);
        pipeline_ = make_graphics_pipeline(on, {.vertex = shaders.vertex,
                                                .fragment = shaders.main,
                                                .layout = descriptors_.layout(),
                                                .target = target_.get(),
                                                .constants = &constants});
    }

    /// Other images that a fragment pass draws to, like those before in all but their content.
    void set_outputs(const device& on, const std::vector<image*>& outputs, VkExtent2D size) {
        if (!compute_ && outputs != outputs_)
            target_ =
                std::make_unique<render_target>(on, outputs, nullptr, size, earlier_content::overwritten);
        outputs_ = outputs;
    }

    std::string name() const { return std::string(pass_.name); }

    void write_descriptors(const bound_resources& bound, VkSampler sampler, std::size_t way) const {
        descriptors_.write(bound, sampler, way);
    }

    /// @param bound  as the descriptors of that way round were written
    void record(VkCommandBuffer commands, const bound_resources& bound, std::size_t way) const {
        prepare_for(commands, pass_.bindings, bound,
                    compute_ ? VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT : VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT);
        const VkPipelineBindPoint point =
            compute_ ? VK_PIPELINE_BIND_POINT_COMPUTE : VK_PIPELINE_BIND_POINT_GRAPHICS;
        vkCmdBindPipeline(commands, point, pipeline_);
        descriptors_.bind(commands, point, way);
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
    std::vector<image*> outputs_;
    std::unique_ptr<render_target> target_; ///< null where it computes
    owned_pipeline pipeline_;
    std::uint32_t groups_[2] = {0, 0};

    void plan_groups(const device& on, std::span<const std::int32_t> values, VkExtent2D texels_of) {
        const VkPhysicalDeviceLimits& most = on.limits();
        const std::uint32_t texels[] = {texels_of.width, texels_of.height};
        const bool in_lines[] = {pass_.covers == dispatch::columns, pass_.covers == dispatch::rows};
        std::uint64_t invocations = 1;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const auto size = static_cast<std::uint32_t>(values[axis]);
            invocations *= size;
            if (values[axis] < 1 || size > most.maxComputeWorkGroupSize[axis] ||
                invocations > most.maxComputeWorkGroupInvocations)
                throw error("pass '" + name() + "' wants workgroups of " + std::to_string(values[0]) + " x " +
                            std::to_string(values[1]) + ", which the device '" + on.name() + "' cannot run");
            groups_[axis] =
                pass_.covers == dispatch::texels || in_lines[axis] ? (texels[axis] + size - 1) / size : 1;
            if (groups_[axis] > most.maxComputeWorkGroupCount[axis])
                throw error("pass '" + name() + "' wants " + std::to_string(groups_[axis]) +
                            " workgroups in a row, more than the device '" + on.name() + "' can run");
        }
    }
};

}
