// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/effect_view.hpp>

#include <vulkan/vulkan.h>

#include <string>

namespace crease::vulkan::detail {

/// What a pass that binds an image so needs it to be made for.
constexpr VkImageUsageFlags usage_of(access how, stage_kind stage) {
    if (how == access::attachment)
        return stage == stage_kind::geometry ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                                             : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    return how == access::sample ? VK_IMAGE_USAGE_SAMPLED_BIT : VK_IMAGE_USAGE_STORAGE_BIT;
}

/// Whether two resources are the pair of a history, which change places after each frame.
constexpr bool are_history(const resource& one, const resource& other) {
    return one.previous_of == other.name || other.previous_of == one.name;
}

/// What the passes of an effect, and the clear before them, need the image of a resource to be made for.
constexpr VkImageUsageFlags usage_by_passes(const effect_view& effect, std::size_t resource) {
    const crease::resource& of = effect.resources[resource];
    VkImageUsageFlags usage = of.cleared && of.samples == 1 ? VK_IMAGE_USAGE_TRANSFER_DST_BIT : 0;
    for (const pass& each : effect.passes)
        for (const binding& b : each.bindings)
            if (b.resource == resource || are_history(effect.resources[b.resource], of))
                usage |= usage_of(b.how, each.stage);
    return usage;
}

/// What passes use an image for, in words.
inline std::string uses_of(VkImageUsageFlags usage) {
    constexpr VkImageUsageFlags drawn =
        VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    std::string words;
    const auto add = [&](VkImageUsageFlags bits, const char* word) {
        if (usage & bits)
            words.append(words.empty() ? "" : ", ").append(word);
    };
    add(VK_IMAGE_USAGE_SAMPLED_BIT, "sampling");
    add(VK_IMAGE_USAGE_STORAGE_BIT, "storing");
    add(drawn, "rendering");
    add(VK_IMAGE_USAGE_TRANSFER_SRC_BIT, "copying from");
    add(VK_IMAGE_USAGE_TRANSFER_DST_BIT, "copying to");
    return words;
}

}
