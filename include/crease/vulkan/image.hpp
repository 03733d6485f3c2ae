// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/formats.hpp>
#include <crease/vulkan/host_image.hpp>
#include <crease/vulkan/memory.hpp>
#include <crease/vulkan/sample_locations.hpp>
#include <crease/vulkan/usage.hpp>

#include <algorithm>
#include <bit>
#include <vector>

namespace crease::vulkan {

/// What an image is made as.
struct image_description {
    std::string name;             ///< in errors
    format texels = format::none; ///< the format
    std::uint32_t width = 0;      ///< texels
    std::uint32_t height = 0;     ///< texels
    std::uint32_t layers = 1;     ///< array layers
    std::uint32_t samples = 1;    ///< samples of a texel
    std::uint32_t levels = 1;     ///< mip levels, fewer where the size has no more
    bool arrayed = false;         ///< seen as an array, also where it has one layer
    bool centred = false;         ///< all samples of a texel lie at its centre
    VkImageUsageFlags usage = 0;  ///< what it may be used for
};

/// One way in which commands use an image.
struct image_use {
    VkPipelineStageFlags stages = VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT; ///< that use it
    VkAccessFlags access = 0;                                        ///< by them
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;                ///< it must be in
    bool writes = false;                                             ///< whether they write it
};

/// The source of a copy.
inline constexpr image_use copied_from{VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT,
                                       VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, false};
/// The destination of a copy.
inline constexpr image_use copied_to{VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT,
                                     VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, true};

/// An image of the device, its views, and the record of the last use of each mip level, from which barriers
/// follow. What others record that use it, they tell by used().
class image {
public:
    /// @throws error  where a size is 0, or the device has no such images, or not enough memory
    image(const device& on, const image_description& description)
        : description_(description), format_(detail::texel_of(description.texels).format) {
        const std::uint32_t longest = std::max(description.width, description.height);
        description_.levels =
            std::clamp(description.levels, 1u, static_cast<std::uint32_t>(std::bit_width(longest | 1)));
        last_.resize(description_.levels);
        const detail::texel_type texel = detail::texel_of(description.texels);
        const std::string what = "the image '" + description.name + "' of " +
                                 std::to_string(description.width) + " x " +
                                 std::to_string(description.height) + " " + texel.name;
        if (description.width == 0 || description.height == 0)
            throw error(what + " has no texels");
        auto info = detail::blank<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
        info.imageType = VK_IMAGE_TYPE_2D;
        info.format = texel.format;
        info.extent = {description.width, description.height, 1};
        info.mipLevels = description_.levels;
        info.arrayLayers = description.layers;
        info.samples = static_cast<VkSampleCountFlagBits>(description.samples);
        info.tiling = VK_IMAGE_TILING_OPTIMAL;
        info.usage = description.usage;
        if (description.centred)
            info.flags = VK_IMAGE_CREATE_SAMPLE_LOCATIONS_COMPATIBLE_DEPTH_BIT_EXT;
        expect_supported(on, info, what);
        own_ = detail::make<detail::owned_image>(on.handle(), vkCreateImage, info, what);
        image_ = own_;
        VkMemoryRequirements needs;
        vkGetImageMemoryRequirements(on.handle(), image_, &needs);
        memory_ = detail::allocate(on, needs, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, what);
        detail::check(vkBindImageMemory(on.handle(), image_, memory_, 0), "bind " + what);
        if (!(description.usage & viewable))
            return;
        own_view_ = make_view(on, range(), what);
        viewed_ = own_view_;
        for (std::uint32_t level = 0; levels() > 1 && level < levels(); ++level)
            level_views_.push_back(make_view(on, range(level), what));
    }
    /// Uses a host's image as it is, which must outlive this.
    /// @param last  what the host did with it last, and so the layout that it is in; by default what it holds
    ///              is of no account
    /// @throws error  where it has no handle, view or size
    explicit image(const host_image& of, const image_use& last = {})
        : description_{.name = of.name,
                       .texels = detail::named(of.format),
                       .width = of.width,
                       .height = of.height,
                       .layers = of.layers,
                       .samples = of.samples,
                       .arrayed = of.arrayed,
                       .usage = of.usage},
          format_(of.format), image_(of.handle), viewed_(of.view), last_{last} {
        const char* const missing = !of.handle                         ? "VkImage"
                                    : !of.view                         ? "VkImageView"
                                    : of.width == 0 || of.height == 0  ? "size"
                                    : of.format == VK_FORMAT_UNDEFINED ? "format"
                                                                       : nullptr;
        if (missing)
            throw error("the host's image '" + of.name + "' has no " + missing);
    }
    image(const image&) = delete;
    image& operator=(const image&) = delete;

    /// What it was made as.
    const image_description& description() const { return description_; }
    /// Of a host's image any that Vulkan has; its description then knows those of crease alone.
    VkFormat vulkan_format() const { return format_; }
    /// The image itself.
    VkImage handle() const { return image_; }
    /// Mip levels; of a host's image one.
    std::uint32_t levels() const { return description_.levels; }
    /// Of all levels; null where the image is only copied.
    VkImageView view() const { return viewed_; }
    /// Of one level.
    VkImageView view(std::uint32_t level) const {
        return level_views_.empty() ? view() : static_cast<VkImageView>(level_views_[level]);
    }

    /// Of all levels.
    VkImageSubresourceRange range() const {
        return {detail::aspects_of(format_), 0, levels(), 0, description_.layers};
    }
    /// Of one level.
    VkImageSubresourceRange range(std::uint32_t level) const {
        return {detail::aspects_of(format_), level, 1, 0, description_.layers};
    }

    /// Whether any command has used it.
    bool is_used() const { return last_[0].layout != VK_IMAGE_LAYOUT_UNDEFINED; }

    /// Its last use, and so the layout in which it is left.
    const image_use& last_use() const { return last_[0]; }
    /// Says what others recorded since, and so the layout that it is in now.
    void used(const image_use& last) { last_.assign(levels(), last); }

    /// Records the barriers that the next use of all levels needs after the last one.
    void transition(VkCommandBuffer commands, const image_use& next) {
        for (std::uint32_t level = 0; level < levels(); ++level)
            transition(commands, next, level);
    }

    /// The same of one level.
    void transition(VkCommandBuffer commands, const image_use& next, std::uint32_t level) {
        image_use& last = last_[level];
        const bool both_read = !last.writes && !next.writes && last.layout == next.layout;
        const bool ready = both_read && (last.stages & next.stages) == next.stages;
        if (ready)
            return;
        auto barrier = detail::blank<VkImageMemoryBarrier>(VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER);
        barrier.srcAccessMask = last.writes ? last.access : 0;
        barrier.dstAccessMask = next.access;
        barrier.oldLayout = last.layout;
        barrier.newLayout = next.layout;
        barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        barrier.image = image_;
        barrier.subresourceRange = range(level);
        const VkSampleLocationsInfoEXT centres = detail::at_the_centre(description_.samples);
        if (description_.centred)
            barrier.pNext = &centres;
        vkCmdPipelineBarrier(commands, last.stages, next.stages, 0, 0, nullptr, 0, nullptr, 1, &barrier);
        const VkPipelineStageFlags readers =
            both_read ? last.stages : 0; // a later write waits for all of them
        last = next;
        last.stages |= readers;
    }

private:
    image_description description_;
    VkFormat format_;
    detail::owned_memory memory_; ///< this and what follows are null where the image is a host's
    detail::owned_image own_;
    detail::owned_image_view own_view_;
    std::vector<detail::owned_image_view> level_views_; ///< where there are several
    VkImage image_ = VK_NULL_HANDLE;
    VkImageView viewed_ = VK_NULL_HANDLE;
    std::vector<image_use> last_; ///< by level

    static constexpr VkImageUsageFlags viewable = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                                                  VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT |
                                                  VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;

    detail::owned_image_view make_view(const device& on, const VkImageSubresourceRange& seen,
                                       const std::string& what) const {
        auto view = detail::blank<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
        view.image = image_;
        view.viewType = description_.arrayed ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D;
        view.format = format_;
        view.subresourceRange = seen;
        return detail::make<detail::owned_image_view>(on.handle(), vkCreateImageView, view,
                                                      "a view of " + what);
    }

    static void expect_supported(const device& on, const VkImageCreateInfo& info, const std::string& what) {
        VkImageFormatProperties most;
        const VkResult found = vkGetPhysicalDeviceImageFormatProperties(
            on.physical(), info.format, info.imageType, info.tiling, info.usage, info.flags, &most);
        const std::string refusal = "the device '" + on.name() + "' cannot hold " + what;
        if (found == VK_ERROR_FORMAT_NOT_SUPPORTED)
            throw error(refusal + ": it has no such images for " + detail::uses_of(info.usage));
        detail::check(found, "ask for the limits of " + what);
        if (info.extent.width > most.maxExtent.width || info.extent.height > most.maxExtent.height)
            throw error(refusal + ": the largest is " + std::to_string(most.maxExtent.width) + " x " +
                        std::to_string(most.maxExtent.height));
        if (info.arrayLayers > most.maxArrayLayers)
            throw error(refusal + " with " + std::to_string(info.arrayLayers) + " layers: the most is " +
                        std::to_string(most.maxArrayLayers));
        if (info.mipLevels > most.maxMipLevels)
            throw error(refusal + " with " + std::to_string(info.mipLevels) + " levels: the most is " +
                        std::to_string(most.maxMipLevels));
        if (!(info.samples & most.sampleCounts))
            throw error(refusal + " with " + std::to_string(info.samples) + " samples a texel");
    }
};

}
