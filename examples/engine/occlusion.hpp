// SPDX-License-Identifier: MIT
#pragma once

#include "renderer.hpp"

#include <crease/crease.hpp>
#include <crease/spirv.hpp>

#include <span>
#include <stdexcept>

/// What the engine adds to its renderer to run an effect of crease: compute passes and geometry passes
/// without attachments, without buffers and history.
class occlusion {
public:
    /// @param depth  the engine's own, as large as the picture
    occlusion(renderer& on, const crease::effect_view& effect, const crease::parameters& values, image& depth)
        : gpu_(on), effect_(effect), picture_(depth.size),
          parameters_(on.make_buffer(effect.block_size(), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT)) {
        crease::write_block(values, effect.views, effect.settings.size(),
                            static_cast<std::byte*>(parameters_.bytes));
        const VkSamplerCreateInfo nearest{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                          .addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                          .addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE};
        sampler_ = on.make<VkSampler>(vkCreateSampler, nearest, vkDestroySampler);
        for (const crease::resource& r : effect.resources)
            images_.push_back(r.kind == crease::resource_kind::block ? nullptr
                              : r.life == crease::lifetime::input    ? &depth
                                                                     : &make_image(r, depth.size));
        for (const crease::pass& each : effect.passes)
            passes_.push_back(each.stage == crease::stage_kind::compute ? prepare(each) : prepared{});
    }

    /// What a pipeline binds.
    struct bound {
        VkPipelineLayout layout;
        VkDescriptorSet set;
    };

    /// @param push  constants of the engine's own, beside what crease asks for
    bound bind(std::span<const crease::binding> bindings, VkShaderStageFlags stage,
               std::span<const VkPushConstantRange> push = {}) {
        const VkDescriptorSetLayout set_layout = make_set_layout(bindings, stage);
        const VkPipelineLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                              .setLayoutCount = 1,
                                              .pSetLayouts = &set_layout,
                                              .pushConstantRangeCount =
                                                  static_cast<std::uint32_t>(push.size()),
                                              .pPushConstantRanges = push.data()};
        return {gpu_.make<VkPipelineLayout>(vkCreatePipelineLayout, info, vkDestroyPipelineLayout),
                make_set(bindings, set_layout)};
    }

    /// Runs all passes.
    /// @param draw  is called where a geometry pass stands among them, to draw what that captures
    void record(VkCommandBuffer commands, const std::function<void(const crease::pass&)>& draw = {}) {
        for (std::size_t i = 0; i < effect_.resources.size(); ++i)
            if (effect_.resources[i].cleared)
                clear(commands, *images_[i], effect_.resources[i].clear);
        for (std::size_t i = 0; i < passes_.size(); ++i) {
            const crease::pass& pass = effect_.passes[i];
            if (pass.stage == crease::stage_kind::geometry) {
                make_ready(commands, pass.bindings, VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT);
                draw(pass);
                continue;
            }
            make_ready(commands, pass.bindings, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT);
            vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, passes_[i].pipeline);
            vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, passes_[i].bindings.layout, 0,
                                    1, &passes_[i].bindings.set, 0, nullptr);
            vkCmdDispatch(
                commands,
                groups(pass, pass.size.width_of(picture_.width), pass.group_width(), crease::dispatch::rows),
                groups(pass, pass.size.height_of(picture_.height), pass.group_height(),
                       crease::dispatch::columns),
                1);
        }
    }

    /// The last resource, which the last pass writes.
    image& visibility() { return *images_.back(); }

private:
    struct prepared {
        bound bindings;
        VkPipeline pipeline;
    };

    /// Workgroups along an axis: one where each of the pass's reaches all along it.
    static std::uint32_t groups(const crease::pass& pass, unsigned texels, unsigned group,
                                crease::dispatch along) {
        return pass.covers == along ? 1 : (texels + group - 1) / group;
    }

    /// Makes the images ready for a shader that binds them.
    void make_ready(VkCommandBuffer commands, std::span<const crease::binding> bindings,
                    VkPipelineStageFlags stage) {
        for (const crease::binding& b : bindings)
            if (b.how == crease::access::sample)
                images_[b.resource]->change(commands, {layout_of(b.how), stage, VK_ACCESS_SHADER_READ_BIT});
            else if (b.how != crease::access::uniform)
                images_[b.resource]->change(
                    commands,
                    {layout_of(b.how), stage, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT});
    }

    static void clear(VkCommandBuffer commands, image& target, std::uint32_t component) {
        const VkClearColorValue value{.uint32 = {component, component, component, component}};
        target.change(commands, copy_target);
        vkCmdClearColorImage(commands, target.handle, copy_target.layout, &value, 1, &target.range);
    }

    static VkFormat format_of(crease::format texels) {
        switch (texels) {
        case crease::format::r8_unorm:
            return VK_FORMAT_R8_UNORM;
        case crease::format::rgba8_unorm:
            return VK_FORMAT_R8G8B8A8_UNORM;
        case crease::format::r32_uint:
            return VK_FORMAT_R32_UINT;
        case crease::format::rg32_uint:
            return VK_FORMAT_R32G32_UINT;
        case crease::format::rgba32_uint:
            return VK_FORMAT_R32G32B32A32_UINT;
        case crease::format::r32_float:
            return VK_FORMAT_R32_SFLOAT;
        case crease::format::rg32_float:
            return VK_FORMAT_R32G32_SFLOAT;
        case crease::format::rgba16_float:
            return VK_FORMAT_R16G16B16A16_SFLOAT;
        case crease::format::rgba32_float:
            return VK_FORMAT_R32G32B32A32_SFLOAT;
        default:
            throw std::runtime_error("a format that crease does not write");
        }
    }

    image& make_image(const crease::resource& of, VkExtent3D picture) {
        const VkExtent2D size{of.size.width_of(picture.width), of.size.height_of(picture.height)};
        image& made = gpu_.make_image(size, format_of(of.texels),
                                      VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                          VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                      VK_IMAGE_ASPECT_COLOR_BIT, of.arrayed ? of.layers : 0);
        if (of.life == crease::lifetime::constant) {
            std::vector<std::uint32_t> texels(size.width * size.height);
            of.fill(texels);
            gpu_.upload(made, std::as_bytes(std::span(texels)));
        }
        return made;
    }

    prepared prepare(const crease::pass& of) {
        const bound bindings = bind(of.bindings, VK_SHADER_STAGE_COMPUTE_BIT);
        const VkComputePipelineCreateInfo info{
            .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
            .stage = gpu_.make_shader(VK_SHADER_STAGE_COMPUTE_BIT, crease::spirv::compile(of)),
            .layout = bindings.layout};
        const auto create = [](VkDevice device, const VkComputePipelineCreateInfo* one,
                               const VkAllocationCallbacks* by, VkPipeline* made) {
            return vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, one, by, made);
        };
        return {bindings, gpu_.make<VkPipeline>(create, info, vkDestroyPipeline)};
    }

    static VkDescriptorType type_of(crease::access how) {
        return how == crease::access::uniform  ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER
               : how == crease::access::sample ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
                                               : VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    }

    static VkImageLayout layout_of(crease::access how) {
        return how == crease::access::sample ? VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL
                                             : VK_IMAGE_LAYOUT_GENERAL;
    }

    VkDescriptorSetLayout make_set_layout(std::span<const crease::binding> of, VkShaderStageFlags stage) {
        std::vector<VkDescriptorSetLayoutBinding> bindings;
        for (const crease::binding& b : of)
            bindings.push_back({b.slot, type_of(b.how), 1, stage, nullptr});
        const VkDescriptorSetLayoutCreateInfo info{
            .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
            .bindingCount = static_cast<std::uint32_t>(bindings.size()),
            .pBindings = bindings.data()};
        return gpu_.make<VkDescriptorSetLayout>(vkCreateDescriptorSetLayout, info,
                                                vkDestroyDescriptorSetLayout);
    }

    VkDescriptorSet make_set(std::span<const crease::binding> of, VkDescriptorSetLayout layout) {
        std::vector<VkDescriptorPoolSize> sizes;
        for (const crease::binding& b : of)
            sizes.push_back({type_of(b.how), 1});
        const VkDescriptorPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                                   .maxSets = 1,
                                                   .poolSizeCount = static_cast<std::uint32_t>(sizes.size()),
                                                   .pPoolSizes = sizes.data()};
        const auto pool =
            gpu_.make<VkDescriptorPool>(vkCreateDescriptorPool, pool_info, vkDestroyDescriptorPool);
        const VkDescriptorSetAllocateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                               .descriptorPool = pool,
                                               .descriptorSetCount = 1,
                                               .pSetLayouts = &layout};
        VkDescriptorSet set;
        renderer::check(vkAllocateDescriptorSets(gpu_.device(), &info, &set), "allocating a descriptor set");

        const VkDescriptorBufferInfo block{parameters_.handle, 0, effect_.block_size()};
        for (const crease::binding& b : of) {
            const VkDescriptorImageInfo texels{
                sampler_, images_[b.resource] ? images_[b.resource]->view : VK_NULL_HANDLE, layout_of(b.how)};
            const VkWriteDescriptorSet write{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                             .dstSet = set,
                                             .dstBinding = b.slot,
                                             .descriptorCount = 1,
                                             .descriptorType = type_of(b.how),
                                             .pImageInfo = &texels,
                                             .pBufferInfo = &block};
            vkUpdateDescriptorSets(gpu_.device(), 1, &write, 0, nullptr);
        }
        return set;
    }

    renderer& gpu_;
    crease::effect_view effect_;
    VkExtent3D picture_;
    renderer::mapped_buffer parameters_;
    VkSampler sampler_{};
    std::vector<image*> images_; // by resource
    std::vector<prepared> passes_;
};
