// SPDX-License-Identifier: MIT
// An engine with its own Vulkan renderer that runs one variant of crease as a compute pass.
#include "corner.hpp"
#include "renderer.hpp"

#include <crease/crease.hpp>
#include <crease/spirv.hpp>

#include <cstring>

using ao = crease::effect<crease::directions<8, 4>, crease::single_layer, crease::hbao,
                          crease::reconstructed_normals>;

namespace {

constexpr const crease::pass& pass = ao::passes[0];
static_assert(ao::passes.size() == 1); // so that the images below are all that there are
constexpr VkExtent3D size{corner::width, corner::height, 1};

struct frame {
    renderer::mapped_buffer parameters;
    VkSampler sampler;
    renderer::image depth, visibility;
};

VkDescriptorType type_of(crease::access how) {
    return how == crease::access::uniform  ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER
           : how == crease::access::sample ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
                                           : VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
}

VkDescriptorSetLayout make_set_layout(renderer& gpu) {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (const crease::binding& b : pass.bindings)
        bindings.push_back({b.slot, type_of(b.how), 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
    const VkDescriptorSetLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                               .bindingCount = static_cast<std::uint32_t>(bindings.size()),
                                               .pBindings = bindings.data()};
    return gpu.make<VkDescriptorSetLayout>(vkCreateDescriptorSetLayout, info, vkDestroyDescriptorSetLayout);
}

VkDescriptorSet make_set(renderer& gpu, VkDescriptorSetLayout layout, const frame& images) {
    std::vector<VkDescriptorPoolSize> sizes;
    for (const crease::binding& b : pass.bindings)
        sizes.push_back({type_of(b.how), 1});
    const VkDescriptorPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                               .maxSets = 1,
                                               .poolSizeCount = static_cast<std::uint32_t>(sizes.size()),
                                               .pPoolSizes = sizes.data()};
    const auto pool = gpu.make<VkDescriptorPool>(vkCreateDescriptorPool, pool_info, vkDestroyDescriptorPool);
    const VkDescriptorSetAllocateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                           .descriptorPool = pool,
                                           .descriptorSetCount = 1,
                                           .pSetLayouts = &layout};
    VkDescriptorSet set;
    renderer::check(vkAllocateDescriptorSets(gpu.device(), &info, &set), "allocating a descriptor set");

    const VkDescriptorBufferInfo buffer{images.parameters.handle, 0, sizeof(crease::parameters)};
    const VkDescriptorImageInfo depth{images.sampler, images.depth.view,
                                      VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    const VkDescriptorImageInfo output{VK_NULL_HANDLE, images.visibility.view, VK_IMAGE_LAYOUT_GENERAL};
    for (const crease::binding& b : pass.bindings) {
        const VkWriteDescriptorSet write{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                         .dstSet = set,
                                         .dstBinding = b.slot,
                                         .descriptorCount = 1,
                                         .descriptorType = type_of(b.how),
                                         .pImageInfo = b.name == "depth" ? &depth : &output,
                                         .pBufferInfo = &buffer};
        vkUpdateDescriptorSets(gpu.device(), 1, &write, 0, nullptr);
    }
    return set;
}

VkPipeline make_pipeline(renderer& gpu, VkPipelineLayout layout) {
    const crease::spirv::words module = crease::spirv::compile(pass);
    const VkShaderModuleCreateInfo module_info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                               .codeSize = module.size() * sizeof module[0],
                                               .pCode = module.data()};
    const VkComputePipelineCreateInfo info{
        .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
        .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                  .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                  .module =
                      gpu.make<VkShaderModule>(vkCreateShaderModule, module_info, vkDestroyShaderModule),
                  .pName = "main"},
        .layout = layout};
    const auto create = [](VkDevice device, const VkComputePipelineCreateInfo* one,
                           const VkAllocationCallbacks* by, VkPipeline* made) {
        return vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, one, by, made);
    };
    return gpu.make<VkPipeline>(create, info, vkDestroyPipeline);
}

struct state {
    VkImageLayout layout;
    VkPipelineStageFlags stage;
    VkAccessFlags access;
};

constexpr state nothing{VK_IMAGE_LAYOUT_UNDEFINED, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, 0};
constexpr state copy_target{VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_PIPELINE_STAGE_TRANSFER_BIT,
                            VK_ACCESS_TRANSFER_WRITE_BIT};
constexpr state copy_source{VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_PIPELINE_STAGE_TRANSFER_BIT,
                            VK_ACCESS_TRANSFER_READ_BIT};
constexpr state sampled{VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                        VK_ACCESS_SHADER_READ_BIT};
constexpr state stored{VK_IMAGE_LAYOUT_GENERAL, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                       VK_ACCESS_SHADER_WRITE_BIT};

void change(VkCommandBuffer commands, const renderer::image& image, const state& from, const state& to) {
    const VkImageMemoryBarrier barrier{.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
                                       .srcAccessMask = from.access,
                                       .dstAccessMask = to.access,
                                       .oldLayout = from.layout,
                                       .newLayout = to.layout,
                                       .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                       .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                       .image = image.handle,
                                       .subresourceRange = image.range};
    vkCmdPipelineBarrier(commands, from.stage, to.stage, 0, 0, nullptr, 0, nullptr, 1, &barrier);
}

std::vector<std::uint8_t> render(renderer& gpu, const std::vector<float>& depth,
                                 const crease::parameters& values) {
    const VkSamplerCreateInfo sampler{
        .sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO, // as crease::access::sample asks
        .addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
        .addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE};
    const frame images{.parameters = gpu.make_buffer(sizeof values, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT),
                       .sampler = gpu.make<VkSampler>(vkCreateSampler, sampler, vkDestroySampler),
                       .depth = gpu.make_image(size, VK_FORMAT_D32_SFLOAT,
                                               VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                               VK_IMAGE_ASPECT_DEPTH_BIT),
                       .visibility =
                           gpu.make_image(size, VK_FORMAT_R8_UNORM,
                                          VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                                          VK_IMAGE_ASPECT_COLOR_BIT)};
    std::memcpy(images.parameters.bytes, &values, sizeof values);
    const std::size_t bytes = depth.size() * sizeof depth[0];
    const auto upload = gpu.make_buffer(bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    std::memcpy(upload.bytes, depth.data(), bytes);
    const auto download = gpu.make_buffer(depth.size(), VK_BUFFER_USAGE_TRANSFER_DST_BIT);

    const VkDescriptorSetLayout set_layout = make_set_layout(gpu);
    const VkPipelineLayoutCreateInfo layout_info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                                 .setLayoutCount = 1,
                                                 .pSetLayouts = &set_layout};
    const auto layout =
        gpu.make<VkPipelineLayout>(vkCreatePipelineLayout, layout_info, vkDestroyPipelineLayout);
    const VkPipeline pipeline = make_pipeline(gpu, layout);
    const VkDescriptorSet set = make_set(gpu, set_layout, images);

    gpu.run([&](VkCommandBuffer commands) {
        const VkBufferImageCopy whole_depth{.imageSubresource = {VK_IMAGE_ASPECT_DEPTH_BIT, 0, 0, 1},
                                            .imageExtent = size};
        change(commands, images.depth, nothing, copy_target);
        vkCmdCopyBufferToImage(commands, upload.handle, images.depth.handle, copy_target.layout, 1,
                               &whole_depth);
        change(commands, images.depth, copy_target, sampled);
        change(commands, images.visibility, nothing, stored);

        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0, nullptr);
        vkCmdDispatch(commands, (size.width + pass.group_width() - 1) / pass.group_width(),
                      (size.height + pass.group_height() - 1) / pass.group_height(), 1);

        const VkBufferImageCopy whole{.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
                                      .imageExtent = size};
        change(commands, images.visibility, stored, copy_source);
        vkCmdCopyImageToBuffer(commands, images.visibility.handle, copy_source.layout, download.handle, 1,
                               &whole);
        const VkMemoryBarrier to_host{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                      .srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT,
                                      .dstAccessMask = VK_ACCESS_HOST_READ_BIT};
        vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                             &to_host, 0, nullptr, 0, nullptr);
    });
    const auto* texels = static_cast<const std::uint8_t*>(download.bytes);
    return {texels, texels + depth.size()};
}

}

/// @param arguments  optionally the path of a PGM picture to write
int main(int count, char** arguments) {
    try {
        renderer gpu({.shaderStorageImageExtendedFormats = ao::features.extended_storage_formats});
        // Vulkan's own clip space: y down, so row 0 is the highest; depth reversed, the far plane at
        // infinity.
        constexpr crease::clip_space clip{.depth_zero_to_one = true};
        constexpr corner::matrix projection = {1, 0, 0, 0, 0, -16.f / 9, 0, 0, 0, 0, 0, -1, 0, 0, 0.1f, 0};
        crease::parameters values = ao::defaults;
        crease::set_projection(values.view, projection, corner::width, corner::height, clip);
        values.radius = corner::radius;

        const auto visibility = render(gpu, corner::device_depth(projection, clip), values);
        if (count > 1 && !corner::write_pgm(arguments[1], visibility, true))
            throw std::runtime_error("cannot write " + std::string(arguments[1]));
        return corner::plausible(visibility, projection) ? 0 : 1;
    } catch (const std::exception& failure) {
        std::cerr << "vulkan_host: " << failure.what() << '\n';
        return 1;
    }
}
