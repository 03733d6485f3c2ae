// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/image.hpp>

#include <vector>

namespace crease::vulkan::detail {

inline constexpr image_use drawn_to{VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
                                    VK_ACCESS_COLOR_ATTACHMENT_READ_BIT |
                                        VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT,
                                    VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, true};
inline constexpr image_use depth_tested{
    VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT,
    VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
    VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, true};

/// What becomes of the content that the images have before drawing.
enum class earlier_content : unsigned char { overwritten, cleared };

/// Images of one size that are drawn to together. They must outlive it.
class render_target {
public:
    /// @param colours  locations 0, 1, ...
    /// @param depth    null: no depth test
    /// @param size     texels, of all images; of none there need be any
    render_target(const device& on, std::vector<image*> colours, image* depth, VkExtent2D size,
                  earlier_content earlier)
        : colours_(std::move(colours)), depth_(depth), size_(size) {
        const VkAttachmentLoadOp load = earlier == earlier_content::cleared ? VK_ATTACHMENT_LOAD_OP_CLEAR
                                                                            : VK_ATTACHMENT_LOAD_OP_DONT_CARE;
        std::vector<VkAttachmentDescription> attachments;
        std::vector<VkAttachmentReference> colour_places;
        std::vector<VkImageView> views;
        for (image* each : attached()) {
            const image_use& use = each == depth_ ? depth_tested : drawn_to;
            attachments.push_back(attachment(*each, use.layout, load));
            views.push_back(each->view(0));
            if (each != depth_)
                colour_places.push_back({static_cast<std::uint32_t>(colour_places.size()), use.layout});
        }
        const VkAttachmentReference depth_place{static_cast<std::uint32_t>(colours_.size()),
                                                depth_tested.layout};
        VkSubpassDescription subpass{};
        subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
        subpass.colorAttachmentCount = static_cast<std::uint32_t>(colour_places.size());
        subpass.pColorAttachments = colour_places.data();
        subpass.pDepthStencilAttachment = depth_ ? &depth_place : nullptr;
        auto info = blank<VkRenderPassCreateInfo>(VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO);
        info.attachmentCount = static_cast<std::uint32_t>(attachments.size());
        info.pAttachments = attachments.data();
        info.subpassCount = 1;
        info.pSubpasses = &subpass;
        render_pass_ = make<owned_render_pass>(on.handle(), vkCreateRenderPass, info, "a render pass");

        auto frame = blank<VkFramebufferCreateInfo>(VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO);
        frame.renderPass = render_pass_;
        frame.attachmentCount = static_cast<std::uint32_t>(views.size());
        frame.pAttachments = views.data();
        frame.width = size.width;
        frame.height = size.height;
        frame.layers = 1;
        framebuffer_ = make<owned_framebuffer>(on.handle(), vkCreateFramebuffer, frame, "a framebuffer");
    }

    VkRenderPass render_pass() const { return render_pass_; }
    std::uint32_t colour_count() const { return static_cast<std::uint32_t>(colours_.size()); }
    bool has_depth() const { return depth_ != nullptr; }
    VkExtent2D size() const { return size_; }
    VkSampleCountFlagBits samples() const {
        const std::vector<image*> all = attached();
        return all.empty() ? VK_SAMPLE_COUNT_1_BIT
                           : static_cast<VkSampleCountFlagBits>(all[0]->description().samples);
    }

    bool is_centred() const { return depth_ && depth_->description().centred; }

    /// Begins to draw. Where it clears, colours become 0.
    void begin(VkCommandBuffer commands, float clear_depth = 1) const {
        std::vector<VkClearValue> clear;
        for (image* each : attached()) {
            each->transition(commands, each == depth_ ? depth_tested : drawn_to);
            VkClearValue value{};
            if (each == depth_)
                value.depthStencil.depth = clear_depth;
            clear.push_back(value);
        }
        auto info = blank<VkRenderPassBeginInfo>(VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO);
        info.renderPass = render_pass_;
        info.framebuffer = framebuffer_;
        info.renderArea.extent = size();
        info.clearValueCount = static_cast<std::uint32_t>(clear.size());
        info.pClearValues = clear.data();
        const VkSubpassSampleLocationsEXT drawn{0, at_the_centre(samples())};
        auto locations = blank<VkRenderPassSampleLocationsBeginInfoEXT>(
            VK_STRUCTURE_TYPE_RENDER_PASS_SAMPLE_LOCATIONS_BEGIN_INFO_EXT);
        locations.postSubpassSampleLocationsCount = 1;
        locations.pPostSubpassSampleLocations = &drawn;
        if (is_centred())
            info.pNext = &locations;
        vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
    }
    void end(VkCommandBuffer commands) const { vkCmdEndRenderPass(commands); }

private:
    std::vector<image*> colours_;
    image* depth_;
    VkExtent2D size_;
    owned_render_pass render_pass_;
    owned_framebuffer framebuffer_;

    std::vector<image*> attached() const {
        std::vector<image*> all = colours_;
        if (depth_)
            all.push_back(depth_);
        return all;
    }

    // The layout is the same before and after: image::transition makes the barriers.
    static VkAttachmentDescription attachment(const image& of, VkImageLayout layout,
                                              VkAttachmentLoadOp load) {
        VkAttachmentDescription a{};
        a.format = texel_of(of.description().texels).format;
        a.samples = static_cast<VkSampleCountFlagBits>(of.description().samples);
        a.loadOp = load;
        a.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
        a.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
        a.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
        a.initialLayout = a.finalLayout = layout;
        return a;
    }
};

}
