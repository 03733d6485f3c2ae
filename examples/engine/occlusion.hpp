// SPDX-License-Identifier: MIT
#pragma once

#include "renderer.hpp"

#include <crease/crease.hpp>
#include <crease/spirv.hpp>

#include <span>
#include <stdexcept>

/// What the engine adds to its renderer to run an effect of crease: compute passes and geometry passes
/// without attachments, without history.
class occlusion {
public:
    /// @param depth  the engine's own, as large as the picture
    occlusion(renderer& on, const crease::effect_view& effect, const crease::parameters& values, image& depth)
        : gpu_(on), effect_(effect), picture_(depth.size) {
        const VkSamplerCreateInfo nearest{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                          .addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                          .addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE};
        sampler_ = on.make<VkSampler>(vkCreateSampler, nearest, vkDestroySampler);
        for (const crease::resource& r : effect.resources) {
            const bool is_image = r.kind == crease::resource_kind::image;
            images_.push_back(!is_image                           ? nullptr
                              : r.life == crease::lifetime::input ? &depth
                                                                  : &make_image(r, depth.size));
            buffers_.push_back(is_image ? buffer{} : make_buffer(r, depth.size));
        }
        crease::write_block(values, effect.views, effect.settings.size(),
                            static_cast<std::byte*>(buffers_[0].memory.bytes));
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
        wait_for_buffers(commands);
        for (std::size_t i = 0; i < effect_.resources.size(); ++i)
            if (effect_.resources[i].cleared)
                clear(commands, i, effect_.resources[i].clear);
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
        wait_for_buffers(commands);
    }

    /// The number in a report of one, once what was recorded is done.
    /// @throws std::runtime_error  where there is none of that name
    std::uint32_t report(std::string_view name) const {
        for (std::size_t i = 0; i < effect_.resources.size(); ++i)
            if (effect_.resources[i].name == name && effect_.resources[i].life == crease::lifetime::report)
                return *static_cast<const std::uint32_t*>(buffers_[i].memory.bytes);
        throw std::runtime_error("the effect reports no '" + std::string(name) + "'");
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

    struct buffer {
        renderer::mapped_buffer memory;
        VkDeviceSize size;
    };

    bool is_image(std::size_t resource) const { return images_[resource] != nullptr; }

    /// All that was written to buffers is done before what comes next, whoever does it.
    static void wait_for_buffers(VkCommandBuffer commands) {
        constexpr VkPipelineStageFlags shaders =
            VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
        const VkMemoryBarrier all{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                  .srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT,
                                  .dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT |
                                                   VK_ACCESS_TRANSFER_WRITE_BIT | VK_ACCESS_HOST_READ_BIT};
        vkCmdPipelineBarrier(commands, shaders | VK_PIPELINE_STAGE_TRANSFER_BIT,
                             shaders | VK_PIPELINE_STAGE_TRANSFER_BIT | VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                             &all, 0, nullptr, 0, nullptr);
    }

    /// Makes what a shader binds ready for it.
    void make_ready(VkCommandBuffer commands, std::span<const crease::binding> bindings,
                    VkPipelineStageFlags stage) {
        if (std::ranges::any_of(bindings, [this](const crease::binding& b) {
                return !is_image(b.resource) && b.how != crease::access::uniform;
            }))
            wait_for_buffers(commands);
        for (const crease::binding& b : bindings)
            if (!is_image(b.resource))
                continue;
            else if (b.how == crease::access::sample)
                images_[b.resource]->change(commands, {layout_of(b.how), stage, VK_ACCESS_SHADER_READ_BIT});
            else
                images_[b.resource]->change(
                    commands,
                    {layout_of(b.how), stage, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT});
    }

    void clear(VkCommandBuffer commands, std::size_t resource, std::uint32_t component) {
        if (!is_image(resource)) {
            vkCmdFillBuffer(commands, buffers_[resource].memory.handle, 0, VK_WHOLE_SIZE, component);
            return;
        }
        image& target = *images_[resource];
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

    buffer make_buffer(const crease::resource& of, VkExtent3D picture) {
        if (of.kind == crease::resource_kind::block)
            return {gpu_.make_buffer(effect_.block_size(), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT),
                    effect_.block_size()};
        const VkDeviceSize elements =
            VkDeviceSize{of.size.width_of(picture.width)} * of.size.height_of(picture.height) * of.layers;
        const VkDeviceSize bytes = elements * (of.element.ends_with('4')   ? 16
                                               : of.element.ends_with('2') ? 8
                                                                           : 4);
        return {
            gpu_.make_buffer(bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT),
            bytes};
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

    VkDescriptorType type_of(const crease::binding& b) const {
        return b.how == crease::access::uniform  ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER
               : !is_image(b.resource)           ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
               : b.how == crease::access::sample ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
                                                 : VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    }

    static VkImageLayout layout_of(crease::access how) {
        return how == crease::access::sample ? VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL
                                             : VK_IMAGE_LAYOUT_GENERAL;
    }

    VkDescriptorSetLayout make_set_layout(std::span<const crease::binding> of, VkShaderStageFlags stage) {
        std::vector<VkDescriptorSetLayoutBinding> bindings;
        for (const crease::binding& b : of)
            bindings.push_back({b.slot, type_of(b), 1, stage, nullptr});
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
            sizes.push_back({type_of(b), 1});
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

        for (const crease::binding& b : of) {
            const buffer& memory = buffers_[b.resource];
            const VkDescriptorBufferInfo bytes{memory.memory.handle, 0, memory.size};
            const VkDescriptorImageInfo texels{
                sampler_, images_[b.resource] ? images_[b.resource]->view : VK_NULL_HANDLE, layout_of(b.how)};
            const VkWriteDescriptorSet write{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                             .dstSet = set,
                                             .dstBinding = b.slot,
                                             .descriptorCount = 1,
                                             .descriptorType = type_of(b),
                                             .pImageInfo = &texels,
                                             .pBufferInfo = &bytes};
            vkUpdateDescriptorSets(gpu_.device(), 1, &write, 0, nullptr);
        }
        return set;
    }

    renderer& gpu_;
    crease::effect_view effect_;
    VkExtent3D picture_;
    VkSampler sampler_{};
    std::vector<image*> images_;  // by resource; null where it is a buffer
    std::vector<buffer> buffers_; // by resource
    std::vector<prepared> passes_;
};
