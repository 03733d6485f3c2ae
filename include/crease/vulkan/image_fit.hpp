// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/effect_view.hpp>
#include <crease/vulkan/image.hpp>

#include <algorithm>
#include <bit>
#include <string>

namespace crease::vulkan::detail {

/// An image's place among the resources of an effect, which it must fit.
struct image_place {
    const resource& wanted;
    VkExtent2D size;         ///< of the resource, texels
    VkImageUsageFlags usage; ///< by the passes
};

/// An input may have any format that samples as the declared one does, and be larger; an output is as it is
/// declared.
/// @throws error  where the image does not fit
inline void expect_fit(const image_place& place, const image& given) {
    const image_description& has = given.description();
    const resource& wanted = place.wanted;
    const bool is_input = wanted.life == lifetime::input;
    const std::string refusal = "the image '" + has.name + "' cannot be the " +
                                (is_input ? "input '" : "output '") + std::string(wanted.name) + "': ";
    if (const VkImageUsageFlags missing = place.usage & ~has.usage)
        throw error(refusal + "it was not made for " + uses_of(missing));
    if (is_input ? holds_whole_numbers(given.vulkan_format()) != facts_of(wanted.texels).whole_numbers
                 : given.vulkan_format() != texel_of(wanted.texels).format)
        throw error(refusal + "it holds " + name_of(given.vulkan_format()) + ", and may hold " +
                    (is_input ? "what samples as " : "") + texel_of(wanted.texels).name);
    if (has.layers != wanted.layers || has.arrayed != wanted.arrayed || has.samples != wanted.samples)
        throw error(refusal + "it has " + std::to_string(has.layers) + " layers and " +
                    std::to_string(has.samples) + " samples a texel");
    if (has.levels < wanted.levels && has.levels < std::bit_width(std::max(has.width, has.height)))
        throw error(refusal + "it has " + std::to_string(has.levels) + " mip levels, not " +
                    std::to_string(wanted.levels));
    const bool is_small = has.width < place.size.width || has.height < place.size.height;
    const bool differs = has.width != place.size.width || has.height != place.size.height;
    if (is_input ? is_small : differs)
        throw error(refusal + "it is " + std::to_string(has.width) + " x " + std::to_string(has.height) +
                    ", and must be " + (is_input ? "at least " : "") + std::to_string(place.size.width) +
                    " x " + std::to_string(place.size.height));
}

}
