// SPDX-License-Identifier: MIT
// An engine with its own Vulkan renderer that runs one variant of crease as a compute pass.
#include "corner.hpp"
#include "occlusion.hpp"

#include <span>
#include <stdexcept>
#include <string>

using ao = crease::effect<crease::directions<4, 4>, crease::single_layer, crease::hbao,
                          crease::reconstructed_normals>;

namespace {

std::vector<std::uint8_t> render(renderer& gpu, const std::vector<float>& texels,
                                 const crease::parameters& values) {
    image& depth = gpu.make_image({picture::width, picture::height}, VK_FORMAT_D32_SFLOAT,
                                  VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                  VK_IMAGE_ASPECT_DEPTH_BIT);
    gpu.upload(depth, std::as_bytes(std::span(texels)));
    occlusion effect(gpu, ao::view(), values, depth);
    gpu.run([&](VkCommandBuffer commands) { effect.record(commands); });
    return gpu.download(effect.visibility());
}

}

/// @param arguments  optionally the path of a PGM picture to write
int main(int count, char** arguments) {
    try {
        renderer gpu({.shaderStorageImageExtendedFormats = ao::features.extended_storage_formats});
        // Vulkan's own clip space: y down, so row 0 is the highest; depth reversed, the far plane at
        // infinity.
        constexpr crease::matrix_convention clip{.depth_zero_to_one = true};
        constexpr picture::matrix projection = {1, 0, 0, 0, 0, -16.f / 9, 0, 0, 0, 0, 0, -1, 0, 0, 0.1f, 0};
        crease::parameters values = ao::defaults;
        if (const auto fit =
                crease::set_projection(values.view, projection, picture::width, picture::height, clip);
            !fit)
            throw std::runtime_error(std::string(fit.error));
        values.radius = corner::radius;

        const auto visibility = render(gpu, corner::device_depth(projection, clip), values);
        if (count > 1)
            picture::write_pgm(arguments[1], visibility, true);
        return corner::plausible(visibility, projection) ? 0 : 1;
    } catch (const std::exception& failure) {
        std::cerr << "vulkan_host: " << failure.what() << '\n';
        return 1;
    }
}
