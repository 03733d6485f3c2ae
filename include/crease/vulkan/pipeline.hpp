// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/effect_view.hpp>
#include <crease/vulkan/render_target.hpp>

#include <span>
#include <vector>

namespace crease::vulkan::detail {

/// Values of specialization constants, as a pipeline takes them.
class specialization {
public:
    /// @param values  one for each of `constants`, in their order
    specialization(std::span<const constant> constants, std::span<const std::int32_t> values)
        : values_(values.begin(), values.end()) {
        for (std::size_t i = 0; i < constants.size(); ++i)
            entries_.push_back(
                {constants[i].id, static_cast<std::uint32_t>(i * sizeof values_[0]), sizeof values_[0]});
    }

    /// Views this object.
    VkSpecializationInfo info() const {
        return {static_cast<std::uint32_t>(entries_.size()), entries_.data(),
                values_.size() * sizeof values_[0], values_.data()};
    }

private:
    std::vector<std::int32_t> values_;
    std::vector<VkSpecializationMapEntry> entries_;
};

inline owned_shader_module make_module(const device& on, std::span<const std::uint32_t> words) {
    auto info = blank<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
    info.codeSize = words.size_bytes();
    info.pCode = words.data();
    return make<owned_shader_module>(on.handle(), vkCreateShaderModule, info, "a shader module");
}

inline VkPipelineShaderStageCreateInfo stage_of(VkShaderStageFlagBits stage, VkShaderModule module,
                                                const VkSpecializationInfo* constants) {
    auto info = blank<VkPipelineShaderStageCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO);
    info.stage = stage;
    info.module = module;
    info.pName = "main";
    info.pSpecializationInfo = constants;
    return info;
}

inline owned_pipeline make_compute_pipeline(const device& on, std::span<const std::uint32_t> words,
                                            VkPipelineLayout layout, const specialization& constants) {
    const owned_shader_module module = make_module(on, words);
    const VkSpecializationInfo values = constants.info();
    auto info = blank<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
    info.stage = stage_of(VK_SHADER_STAGE_COMPUTE_BIT, module, &values);
    info.layout = layout;
    const auto create = [](VkDevice device, const auto* what, const VkAllocationCallbacks* by,
                           VkPipeline* made) {
        return vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, what, by, made);
    };
    return make<owned_pipeline>(on.handle(), create, info, "a compute pipeline");
}

/// What a graphics pipeline is made from: triangles, both sides, over the whole of a target.
struct graphics_description {
    std::span<const std::uint32_t> vertex, fragment; ///< SPIR-V
    VkPipelineLayout layout = VK_NULL_HANDLE;
    const render_target* target = nullptr;
    const specialization* constants = nullptr; ///< of the fragment shader
    VkPipelineVertexInputStateCreateInfo vertex_input = blank<VkPipelineVertexInputStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO);
    VkCompareOp nearer =
        VK_COMPARE_OP_LESS; ///< a fragment is drawn where its depth compares so; if there is depth
};

inline owned_pipeline make_graphics_pipeline(const device& on, const graphics_description& from) {
    const owned_shader_module vertex = make_module(on, from.vertex),
                              fragment = make_module(on, from.fragment);
    const VkSpecializationInfo values = from.constants ? from.constants->info() : VkSpecializationInfo{};
    const VkPipelineShaderStageCreateInfo stages[] = {
        stage_of(VK_SHADER_STAGE_VERTEX_BIT, vertex, nullptr),
        stage_of(VK_SHADER_STAGE_FRAGMENT_BIT, fragment, &values)};
    auto assembly = blank<VkPipelineInputAssemblyStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO);
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;

    const VkExtent2D size = from.target->size();
    const VkViewport viewport{0, 0, static_cast<float>(size.width), static_cast<float>(size.height), 0, 1};
    const VkRect2D scissor{{0, 0}, size};
    auto view =
        blank<VkPipelineViewportStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO);
    view.viewportCount = view.scissorCount = 1;
    view.pViewports = &viewport;
    view.pScissors = &scissor;

    auto raster = blank<VkPipelineRasterizationStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO);
    raster.polygonMode = VK_POLYGON_MODE_FILL;
    raster.cullMode = VK_CULL_MODE_NONE;
    raster.lineWidth = 1;
    auto samples =
        blank<VkPipelineMultisampleStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO);
    samples.rasterizationSamples = from.target->samples();
    auto locations = blank<VkPipelineSampleLocationsStateCreateInfoEXT>(
        VK_STRUCTURE_TYPE_PIPELINE_SAMPLE_LOCATIONS_STATE_CREATE_INFO_EXT);
    locations.sampleLocationsEnable = VK_TRUE;
    locations.sampleLocationsInfo = at_the_centre(from.target->samples());
    if (from.target->is_centred())
        samples.pNext = &locations;
    auto depth = blank<VkPipelineDepthStencilStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO);
    depth.depthTestEnable = depth.depthWriteEnable = from.target->has_depth();
    depth.depthCompareOp = from.nearer;

    VkPipelineColorBlendAttachmentState written{};
    written.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT |
                             VK_COLOR_COMPONENT_A_BIT;
    const std::vector<VkPipelineColorBlendAttachmentState> blends(from.target->colour_count(), written);
    auto blend =
        blank<VkPipelineColorBlendStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO);
    blend.attachmentCount = from.target->colour_count();
    blend.pAttachments = blends.data();

    auto info = blank<VkGraphicsPipelineCreateInfo>(VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO);
    info.stageCount = 2;
    info.pStages = stages;
    info.pVertexInputState = &from.vertex_input;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &view;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blend;
    info.layout = from.layout;
    info.renderPass = from.target->render_pass();
    const auto create = [](VkDevice device, const auto* what, const VkAllocationCallbacks* by,
                           VkPipeline* made) {
        return vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, what, by, made);
    };
    return make<owned_pipeline>(on.handle(), create, info, "a graphics pipeline");
}

}
