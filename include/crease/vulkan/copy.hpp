// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/buffer.hpp>
#include <crease/vulkan/image.hpp>

#include <span>

namespace crease::vulkan::detail {

inline VkExtent3D extent_of(const image& of, std::uint32_t level) {
    const image_description& d = of.description();
    return {std::max(d.width >> level, 1u), std::max(d.height >> level, 1u), 1};
}

/// @throws error  where crease does not know its texels
inline std::size_t bytes_in(const image& of, std::uint32_t level) {
    const image_description& d = of.description();
    if (d.texels == format::none)
        throw error("the image '" + d.name + "' holds " + name_of(of.vulkan_format()) +
                    ", which crease does not copy");
    const VkExtent3D size = extent_of(of, level);
    return std::size_t{size.width} * size.height * d.layers * texel_of(d.texels).bytes;
}

inline std::size_t bytes_in(const image& of) {
    std::size_t bytes = 0;
    for (std::uint32_t level = 0; level < of.levels(); ++level)
        bytes += bytes_in(of, level);
    return bytes;
}

/// @throws error  where the image was not made for it
inline void expect_made_for(const image& of, VkImageUsageFlags wanted) {
    if (!(of.description().usage & wanted))
        throw error("the image '" + of.description().name + "' was not made for " + uses_of(wanted));
}

/// All levels, one after the other.
inline std::vector<VkBufferImageCopy> whole(const image& of) {
    std::vector<VkBufferImageCopy> regions;
    VkDeviceSize at = 0;
    for (std::uint32_t level = 0; level < of.levels(); ++level) {
        VkBufferImageCopy region{};
        region.bufferOffset = at;
        region.imageSubresource = {of.range().aspectMask, level, 0, of.description().layers};
        region.imageExtent = extent_of(of, level);
        regions.push_back(region);
        at += bytes_in(of, level);
    }
    return regions;
}

inline void expect_count(const image& of, std::size_t wanted, std::size_t given, const std::string& unit) {
    if (given != wanted)
        throw error("the image '" + of.description().name + "' takes " + std::to_string(wanted) + " " + unit +
                    ", not " + std::to_string(given));
}

inline void expect_texels(const image& of, format wanted) {
    const format has = of.description().texels;
    if (has != wanted)
        throw error("the image '" + of.description().name + "' holds " + texel_of(has).name + ", not " +
                    texel_of(wanted).name);
}

}

namespace crease::vulkan {

/// Fills an image made for VK_IMAGE_USAGE_TRANSFER_DST: row after row, layer after layer, level
/// after level, without gaps.
/// @throws error  where the number of bytes is not the image's, or it was not made for that
inline void upload(device& on, image& to, std::span<const std::byte> bytes) {
    detail::expect_made_for(to, VK_IMAGE_USAGE_TRANSFER_DST_BIT);
    detail::expect_count(to, detail::bytes_in(to), bytes.size(), "bytes");
    const buffer staging(on, bytes.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, transfer::to_device,
                         "upload of " + to.description().name);
    std::ranges::copy(bytes, staging.bytes().begin());
    on.submit([&](VkCommandBuffer commands) {
        const std::vector<VkBufferImageCopy> regions = detail::whole(to);
        to.transition(commands, copied_to);
        vkCmdCopyBufferToImage(commands, staging.handle(), to.handle(), copied_to.layout,
                               static_cast<std::uint32_t>(regions.size()), regions.data());
    });
}

/// Fills an image with real numbers, of which a texel takes one for each component; see above.
inline void upload(device& on, image& to, std::span<const float> numbers) {
    const detail::texel_type texel = detail::texel_of(to.description().texels);
    detail::expect_count(to, detail::bytes_in(to) / texel.bytes * texel.components, numbers.size(),
                         "numbers");
    upload(on, to, detail::bytes_of(numbers, to.description().texels));
}

/// Fills an r32_uint image; see above.
inline void upload(device& on, image& to, std::span<const std::uint32_t> numbers) {
    detail::expect_texels(to, format::r32_uint);
    upload(on, to, std::as_bytes(numbers));
}

/// The bytes of an image made for VK_IMAGE_USAGE_TRANSFER_SRC, in the order in which upload() takes them.
/// @throws error  where it was not made for that
inline std::vector<std::byte> download_bytes(device& on, image& from) {
    detail::expect_made_for(from, VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
    const buffer staging(on, detail::bytes_in(from), VK_BUFFER_USAGE_TRANSFER_DST_BIT, transfer::from_device,
                         "download of " + from.description().name);
    on.submit([&](VkCommandBuffer commands) {
        const std::vector<VkBufferImageCopy> regions = detail::whole(from);
        from.transition(commands, copied_from);
        vkCmdCopyImageToBuffer(commands, from.handle(), copied_from.layout, staging.handle(),
                               static_cast<std::uint32_t>(regions.size()), regions.data());
        detail::memory_barrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT,
                               VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT);
    });
    const std::span<const std::byte> bytes = staging.bytes();
    return {bytes.begin(), bytes.end()};
}

/// The real numbers of an image, one for each component of a texel: those of bytes in [0, 1].
/// @throws error  where it holds whole numbers
inline std::vector<float> download(device& on, image& from) {
    return detail::numbers_of(download_bytes(on, from), from.description().texels);
}

/// The whole numbers of an r32_uint image.
/// @throws error  where it holds others
inline std::vector<std::uint32_t> download_uint(device& on, image& from) {
    detail::expect_texels(from, format::r32_uint);
    const std::vector<std::byte> bytes = download_bytes(on, from);
    std::vector<std::uint32_t> numbers(bytes.size() / 4);
    std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return numbers;
}

}
