// SPDX-License-Identifier: MIT
#pragma once

#include "occlusion.hpp"
#include "picture.hpp"

#include <span>
#include <vector>

/// The engine's depth buffer, once it is filled.
inline image& make_depth(renderer& gpu, const std::vector<float>& texels) {
    image& depth = gpu.make_image({picture::width, picture::height}, VK_FORMAT_D32_SFLOAT,
                                  VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                  VK_IMAGE_ASPECT_DEPTH_BIT);
    gpu.upload(depth, std::as_bytes(std::span(texels)));
    return depth;
}

/// The visibility that an effect finds in a depth buffer.
inline std::vector<std::uint8_t> render(renderer& gpu, const crease::effect_view& effect,
                                        const crease::parameters& values, const std::vector<float>& texels) {
    occlusion passes(gpu, effect, values, make_depth(gpu, texels));
    gpu.run([&](VkCommandBuffer commands) { passes.record(commands); });
    return gpu.download(passes.visibility());
}
