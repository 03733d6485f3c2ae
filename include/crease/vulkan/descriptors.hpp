// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/effect_view.hpp>
#include <crease/vulkan/buffer.hpp>
#include <crease/vulkan/image.hpp>

#include <algorithm>
#include <span>
#include <vector>

namespace crease::vulkan::detail {

constexpr VkDescriptorType descriptor_of(access how, resource_kind of) {
    return how == access::uniform        ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER
           : of == resource_kind::buffer ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
           : how == access::sample       ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
                                         : VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
}

/// How shaders use an image that is bound so; of an attachment the render target knows.
constexpr image_use shader_use_of(access how, VkPipelineStageFlags stage) {
    if (how == access::store)
        return {stage, VK_ACCESS_SHADER_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL, true};
    if (how == access::modify)
        return {stage, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL, true};
    return {stage, VK_ACCESS_SHADER_READ_BIT,
            how == access::load ? VK_IMAGE_LAYOUT_GENERAL : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, false};
}

/// What the descriptors of an effect point to, by resource: of each an image or a buffer, null elsewhere.
struct bound_resources {
    std::vector<image*> images;
    std::vector<const buffer*> buffers; ///< 0 is the block of parameters
};

/// What may write a storage buffer.
inline constexpr VkPipelineStageFlags buffer_writers = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT |
                                                       VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT |
                                                       VK_PIPELINE_STAGE_TRANSFER_BIT;

/// Records the barriers that a program needs before it runs in a stage.
inline void prepare_for(VkCommandBuffer commands, std::span<const binding> of, const bound_resources& bound,
                        VkPipelineStageFlags stage) {
    bool has_buffers = false;
    for (const binding& b : of)
        if (image* used = has_descriptor(b.how) ? bound.images[b.resource] : nullptr) {
            if (b.level == binding::all_levels)
                used->transition(commands, shader_use_of(b.how, stage));
            else
                used->transition(commands, shader_use_of(b.how, stage), b.level);
        } else
            has_buffers = has_buffers || (b.resource != 0 && has_descriptor(b.how));
    if (has_buffers)
        memory_barrier(commands, buffer_writers, VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT,
                       stage, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT);
}

inline owned_sampler make_nearest_sampler(const device& on) {
    auto info = blank<VkSamplerCreateInfo>(VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO);
    info.magFilter = info.minFilter = VK_FILTER_NEAREST;
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.maxLod = VK_LOD_CLAMP_NONE; // a range of 0 to 0 makes llvmpipe look for the level lane by lane
    return make<owned_sampler>(on.handle(), vkCreateSampler, info, "a sampler");
}

/// The descriptor sets of one program, as many times as there are ways round in which histories can lie, and
/// the pipeline layout they make.
class descriptors {
public:
    /// @param of          bindings of `resources`
    /// @param ways        >= 1
    /// @param push_bytes  of push constants, which the stages of `pushed_to` read
    descriptors(const device& on, std::span<const binding> of, std::span<const resource> resources,
                VkShaderStageFlags stage, std::size_t ways, std::uint32_t push_bytes = 0,
                VkShaderStageFlags pushed_to = 0)
        : device_(on.handle()), sets_(ways) {
        for (const resource& r : resources)
            kinds_.push_back(r.kind);
        std::ranges::copy_if(of, std::back_inserter(bindings_),
                             [](const binding& b) { return has_descriptor(b.how); });
        std::uint32_t set_count = 0;
        for (const binding& b : bindings_)
            set_count = std::max(set_count, b.set + 1);
        for (std::uint32_t set = 0; set < set_count; ++set)
            layouts_.push_back(make_set_layout(set, stage));
        const std::vector<VkDescriptorSetLayout> handles(layouts_.begin(), layouts_.end());

        auto info = blank<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
        info.setLayoutCount = set_count;
        info.pSetLayouts = handles.data();
        const VkPushConstantRange push{pushed_to, 0, push_bytes};
        info.pushConstantRangeCount = push_bytes ? 1 : 0;
        info.pPushConstantRanges = &push;
        layout_ = make<owned_pipeline_layout>(device_, vkCreatePipelineLayout, info, "a pipeline layout");
        if (!bindings_.empty())
            allocate_sets(handles);
    }

    VkPipelineLayout layout() const { return layout_; }

    void write(const bound_resources& bound, VkSampler sampler, std::size_t way) const {
        for (const binding& b : bindings_) {
            auto write = blank<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
            write.dstSet = sets_[way][b.set];
            write.dstBinding = b.slot;
            write.descriptorCount = 1;
            write.descriptorType = type_of(b);
            VkDescriptorImageInfo texels{};
            VkDescriptorBufferInfo block{};
            if (const image* bound_image = bound.images[b.resource]) {
                const VkImageView view =
                    b.level == binding::all_levels ? bound_image->view() : bound_image->view(b.level);
                texels = {sampler, view, shader_use_of(b.how, 0).layout};
                write.pImageInfo = &texels;
            } else {
                block = {bound.buffers[b.resource]->handle(), 0, VK_WHOLE_SIZE};
                write.pBufferInfo = &block;
            }
            vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
        }
    }

    void bind(VkCommandBuffer commands, VkPipelineBindPoint point, std::size_t way) const {
        const std::vector<VkDescriptorSet>& sets = sets_[way];
        if (!sets.empty())
            vkCmdBindDescriptorSets(commands, point, layout_, 0, static_cast<std::uint32_t>(sets.size()),
                                    sets.data(), 0, nullptr);
    }

private:
    VkDevice device_;
    std::vector<resource_kind> kinds_; ///< by resource
    std::vector<binding> bindings_;    ///< those that have a descriptor
    std::vector<owned_set_layout> layouts_;
    owned_pipeline_layout layout_;
    owned_descriptor_pool pool_;
    std::vector<std::vector<VkDescriptorSet>> sets_; ///< by way round

    VkDescriptorType type_of(const binding& b) const { return descriptor_of(b.how, kinds_[b.resource]); }

    owned_set_layout make_set_layout(std::uint32_t set, VkShaderStageFlags stage) const {
        std::vector<VkDescriptorSetLayoutBinding> slots;
        for (const binding& b : bindings_)
            if (b.set == set)
                slots.push_back({b.slot, type_of(b), 1, stage, nullptr});
        auto info =
            blank<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
        info.bindingCount = static_cast<std::uint32_t>(slots.size());
        info.pBindings = slots.data();
        return make<owned_set_layout>(device_, vkCreateDescriptorSetLayout, info, "a descriptor set layout");
    }

    void allocate_sets(const std::vector<VkDescriptorSetLayout>& layouts) {
        const auto ways = static_cast<std::uint32_t>(sets_.size());
        std::vector<VkDescriptorPoolSize> sizes;
        for (const binding& b : bindings_)
            sizes.push_back({type_of(b), ways});
        auto info = blank<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
        info.maxSets = static_cast<std::uint32_t>(layouts.size()) * ways;
        info.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
        info.pPoolSizes = sizes.data();
        pool_ = make<owned_descriptor_pool>(device_, vkCreateDescriptorPool, info, "a descriptor pool");
        auto wanted = blank<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
        wanted.descriptorPool = pool_;
        wanted.descriptorSetCount = static_cast<std::uint32_t>(layouts.size());
        wanted.pSetLayouts = layouts.data();
        for (std::vector<VkDescriptorSet>& sets : sets_) {
            sets.resize(layouts.size());
            check(vkAllocateDescriptorSets(device_, &wanted, sets.data()), "make descriptor sets");
        }
    }
};

}
