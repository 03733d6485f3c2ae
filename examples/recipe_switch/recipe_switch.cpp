// SPDX-License-Identifier: MIT
// An engine that changes the recipe while it runs. The runner works on the engine's device, in its command
// buffers and on its images, which stay as they are from one recipe to the next.
#include "camera.hpp"
#include "screen.hpp"

#include <crease/vulkan.hpp>

#include <memory>
#include <string_view>

namespace {

constexpr std::string_view recipes[] = {
    "directions:4x4/single_layer/hbao/reconstructed_normals", "directions:4x4/single_layer/no_such_part",
    "poisson_disk:16/single_layer/hbao_plus/reconstructed_normals/bilateral",
    "directions:4x4/single_layer/hbao/reconstructed_normals/fragment/upsample:2"};

constexpr VkPhysicalDeviceFeatures enabled{.fragmentStoresAndAtomics = true,
                                           .shaderStorageImageExtendedFormats = true};

crease::vulkan::host_device described(const renderer& gpu) {
    return {.physical = gpu.physical(),
            .handle = gpu.device(),
            .queue = gpu.queue(),
            .queue_family = gpu.queue_family(),
            .api_version = VK_API_VERSION_1_1,
            .features = enabled,
            .extensions = {}};
}

/// An image of the engine's, as it was made and as it was left.
crease::vulkan::image seen(const char* name, const image& engines, VkFormat format, VkImageUsageFlags usage) {
    const image_use& last = engines.last;
    return crease::vulkan::image({.name = name,
                                  .handle = engines.handle,
                                  .view = engines.view,
                                  .format = format,
                                  .width = engines.size.width,
                                  .height = engines.size.height,
                                  .usage = usage},
                                 {last.stage, last.access, last.layout, true});
}

/// The engine's ambient occlusion, by a recipe that may change between frames.
class switched_occlusion {
public:
    switched_occlusion(crease::vulkan::device& device, crease::vulkan::image& depth,
                       crease::vulkan::image& visibility)
        : device_(device), depth_(depth), visibility_(visibility) {}

    /// @return whether there is such a recipe; if not, the one before stays
    bool choose(std::string_view text) {
        auto composed = std::make_unique<crease::composition>(crease::recipe(text));
        if (!*composed) {
            std::cout << text << ": " << composed->error() << '\n';
            return false;
        }
        runner_ = std::make_unique<crease::vulkan::runner>(device_, composed->view(), picture::width,
                                                           picture::height);
        runner_->bind("depth", depth_);
        runner_->bind("visibility", visibility_);
        composed_ = std::move(composed); // which the runner views
        return true;
    }

    void record(VkCommandBuffer commands) {
        runner_->record(commands, camera::parameters_for(composed_->view()));
    }

private:
    crease::vulkan::device& device_;
    crease::vulkan::image &depth_, &visibility_;
    std::unique_ptr<crease::composition> composed_;
    std::unique_ptr<crease::vulkan::runner> runner_;
};

}

/// @param arguments  optionally the path of PGM pictures, to which the recipe's index is added
int main(int count, char** arguments) {
    try {
        renderer gpu(enabled);
        constexpr VkImageUsageFlags usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT |
                                            VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
        image& depth = make_depth(gpu, camera::depth());
        image& visibility = gpu.make_image({picture::width, picture::height}, VK_FORMAT_R8_UNORM, usage,
                                           VK_IMAGE_ASPECT_COLOR_BIT);

        crease::vulkan::device device(described(gpu));
        crease::vulkan::image read = seen("depth", depth, VK_FORMAT_D32_SFLOAT,
                                          VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT);
        crease::vulkan::image written = seen("visibility", visibility, VK_FORMAT_R8_UNORM, usage);
        switched_occlusion occlusion(device, read, written);

        bool all = true;
        for (std::size_t i = 0; i < std::size(recipes); ++i) {
            if (!occlusion.choose(recipes[i]))
                continue; // an engine would go on with the recipe before
            gpu.run([&](VkCommandBuffer commands) {
                written.used({visibility.last.stage, visibility.last.access, visibility.last.layout, true});
                occlusion.record(commands);
                visibility.last = {written.last_use().layout, written.last_use().stages,
                                   written.last_use().access};
            });
            const auto texels = gpu.download(visibility);
            std::cout << recipes[i] << ": ";
            all &= corner::plausible(texels, camera::projection);
            if (count > 1)
                picture::write_pgm(arguments[1] + ("_" + std::to_string(i)) + ".pgm", texels, true);
        }
        return all ? 0 : 1;
    } catch (const std::exception& failure) {
        std::cerr << "recipe_switch: " << failure.what() << '\n';
        return 1;
    }
}
