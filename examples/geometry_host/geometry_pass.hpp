// SPDX-License-Identifier: MIT
#pragma once

#include "occlusion.hpp"
#include "picture.hpp"
#include "shaders.hpp"

#include <string_view>

/// The engine's geometry pass: to its depth image or, where that is null, to what its shader stores.
class geometry_pass {
public:
    static constexpr VkPushConstantRange camera{VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(picture::matrix)};

    /// @param capture  GLSL that defines crease_capture
    geometry_pass(renderer& gpu, image* depth, std::string_view capture, const occlusion::bound& bindings)
        : depth_(depth), bindings_(bindings) {
        make_render_pass(gpu);
        make_pipeline(gpu, capture);
    }

    void record(VkCommandBuffer commands, const picture::matrix& projection) {
        if (depth_)
            depth_->change(commands, depth_target);
        constexpr VkClearValue farthest{.depthStencil = {0, 0}}; // depth is reversed
        const VkRenderPassBeginInfo begin{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO,
                                          .renderPass = render_pass_,
                                          .framebuffer = framebuffer_,
                                          .renderArea = area,
                                          .clearValueCount = 1,
                                          .pClearValues = &farthest};
        vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, bindings_.layout, 0, 1,
                                &bindings_.set, 0, nullptr);
        vkCmdPushConstants(commands, bindings_.layout, camera.stageFlags, 0, camera.size, projection);
        vkCmdDraw(commands, shaders::vertices_of_box, shaders::boxes, 0, 0);
        vkCmdEndRenderPass(commands);
    }

private:
    static constexpr VkRect2D area{{0, 0}, {picture::width, picture::height}};

    void make_render_pass(renderer& gpu) {
        const VkAttachmentDescription attachment{.format = VK_FORMAT_D32_SFLOAT,
                                                 .samples = VK_SAMPLE_COUNT_1_BIT,
                                                 .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
                                                 .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
                                                 .initialLayout = depth_target.layout,
                                                 .finalLayout = depth_target.layout};
        const VkAttachmentReference reference{0, depth_target.layout};
        const VkSubpassDescription subpass{.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS,
                                           .pDepthStencilAttachment = depth_ ? &reference : nullptr};
        const VkRenderPassCreateInfo info{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO,
                                          .attachmentCount = depth_ ? 1u : 0u,
                                          .pAttachments = &attachment,
                                          .subpassCount = 1,
                                          .pSubpasses = &subpass};
        render_pass_ = gpu.make<VkRenderPass>(vkCreateRenderPass, info, vkDestroyRenderPass);
        const VkFramebufferCreateInfo framebuffer{.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO,
                                                  .renderPass = render_pass_,
                                                  .attachmentCount = info.attachmentCount,
                                                  .pAttachments = depth_ ? &depth_->view : nullptr,
                                                  .width = area.extent.width,
                                                  .height = area.extent.height,
                                                  .layers = 1};
        framebuffer_ = gpu.make<VkFramebuffer>(vkCreateFramebuffer, framebuffer, vkDestroyFramebuffer);
    }

    void make_pipeline(renderer& gpu, std::string_view capture) {
        const crease::piece vertex[] = {{"vertex", shaders::vertex}};
        const crease::piece fragment[] = {
            {"version", "#version 450\n"}, {"capture", capture}, {"fragment", shaders::fragment}};
        using crease::spirv::shader_stage;
        const VkPipelineShaderStageCreateInfo stages[] = {
            gpu.make_shader(VK_SHADER_STAGE_VERTEX_BIT, crease::spirv::compile(vertex, shader_stage::vertex)),
            gpu.make_shader(VK_SHADER_STAGE_FRAGMENT_BIT,
                            crease::spirv::compile(fragment, shader_stage::fragment))};
        const VkPipelineVertexInputStateCreateInfo no_input{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
        const VkPipelineInputAssemblyStateCreateInfo triangles{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
            .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
        const VkViewport viewport{0, 0, picture::width, picture::height, 0, 1};
        const VkPipelineViewportStateCreateInfo whole{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
            .viewportCount = 1,
            .pViewports = &viewport,
            .scissorCount = 1,
            .pScissors = &area};
        const VkPipelineRasterizationStateCreateInfo both_sides{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
            .cullMode = VK_CULL_MODE_NONE,
            .lineWidth = 1};
        const VkPipelineMultisampleStateCreateInfo one_sample{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
            .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
        const VkPipelineDepthStencilStateCreateInfo nearest{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
            .depthTestEnable = depth_ != nullptr, // layers are also behind what is seen
            .depthWriteEnable = depth_ != nullptr,
            .depthCompareOp = VK_COMPARE_OP_GREATER};
        const VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                                .stageCount = 2,
                                                .pStages = stages,
                                                .pVertexInputState = &no_input,
                                                .pInputAssemblyState = &triangles,
                                                .pViewportState = &whole,
                                                .pRasterizationState = &both_sides,
                                                .pMultisampleState = &one_sample,
                                                .pDepthStencilState = &nearest,
                                                .layout = bindings_.layout,
                                                .renderPass = render_pass_};
        const auto create = [](VkDevice device, const VkGraphicsPipelineCreateInfo* one,
                               const VkAllocationCallbacks* by, VkPipeline* made) {
            return vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, one, by, made);
        };
        pipeline_ = gpu.make<VkPipeline>(create, info, vkDestroyPipeline);
    }

    image* depth_;
    occlusion::bound bindings_;
    VkRenderPass render_pass_{};
    VkFramebuffer framebuffer_{};
    VkPipeline pipeline_{};
};
