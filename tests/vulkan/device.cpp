// SPDX-License-Identifier: MIT
#include <crease/vulkan/image.hpp>

#include "sentence.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

#include <cstdlib>

using namespace crease;

namespace {

/// Sets an environment variable for as long as this lives.
class environment {
public:
    environment(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
    ~environment() { unsetenv(name_); }

private:
    const char* name_;
};

}

TEST_CASE("the default device exists and is listed") {
    const std::string name = validated_device().name();
    const std::vector<std::string> all = vulkan::device_names();
    CHECK(std::ranges::find(all, name) != all.end());
    CHECK_NOTHROW(vulkan::device({.name = name.substr(0, 4)}));
}

TEST_CASE("a device that is not there: the sentence lists those that are") {
    const std::string said = sentence_of([] { vulkan::device({.name = "Voodoo 2"}); });
    CHECK(contains(said, "there is no Vulkan device named 'Voodoo 2'; there is '"));
    CHECK(contains(said, validated_device().name()));
}

TEST_CASE("no driver") {
    const environment nowhere("VK_DRIVER_FILES", "/nowhere.json");
    CHECK(contains(sentence_of([] { vulkan::device(); }), "there is no Vulkan 1.1"));
}

TEST_CASE("no validation layer") {
    const environment nowhere("VK_LAYER_PATH", "/nowhere");
    CHECK(sentence_of([] { vulkan::device({.name = {}, .validation = true}); }) ==
          "validation was asked for, but there is no layer VK_LAYER_KHRONOS_validation");
    CHECK_NOTHROW(vulkan::device());
}

TEST_CASE("a feature that is not there is named") {
    CHECK(vulkan::detail::missing_features({}, {.extended_storage_formats = true}) ==
          "shaderStorageImageExtendedFormats");
    CHECK(vulkan::detail::missing_features({.extended_storage_formats = true}, {}).empty());
    CHECK(vulkan::detail::missing_features({}, {.subgroup_arithmetic = true}) ==
          "arithmetic of subgroups in compute shaders");
    CHECK(validated_device().features().subgroup_arithmetic);
    CHECK_NOTHROW(validated_device().require({}));
    CHECK_NOTHROW(validated_device().require(validated_device().features()));
}

TEST_CASE("a missing barrier is thrown by the submission that lacks it, once") {
    vulkan::device device({.name = {}, .validation = true});
    vulkan::image image(device, {.name = "test",
                                 .texels = format::r8_unorm,
                                 .width = 4,
                                 .height = 4,
                                 .usage = VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    const std::string said = sentence_of([&] {
        device.submit([&](VkCommandBuffer commands) {
            constexpr VkClearColorValue zero{};
            const VkImageSubresourceRange range = image.range();
            image.transition(commands, vulkan::copied_to);
            for (int i = 0; i < 2; ++i)
                vkCmdClearColorImage(commands, image.handle(), vulkan::copied_to.layout, &zero, 1, &range);
        });
    });
    CHECK(contains(said, "Vulkan validation says:\n"));
    CHECK(contains(said, "SYNC-HAZARD-WRITE-AFTER-WRITE"));
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("each feature that is wanted and not there is named, and no other") {
    const device_features all{.extended_storage_formats = true,
                              .fragment_stores_and_atomics = true,
                              .subgroup_arithmetic = true,
                              .depth_samples = 4 | 8,
                              .centred_depth_samples = 4};
    const auto missing = [&](device_features there) { return vulkan::detail::missing_features(there, all); };
    CHECK(missing(all) == "");
    device_features there = all;
    there.extended_storage_formats = false;
    CHECK(missing(there) == "shaderStorageImageExtendedFormats");
    there = all;
    there.fragment_stores_and_atomics = false;
    CHECK(missing(there) == "fragmentStoresAndAtomics");
    there = all;
    there.subgroup_arithmetic = false;
    CHECK(missing(there) == "arithmetic of subgroups in compute shaders");
    there = all;
    there.depth_samples = 2 | 8;
    CHECK(missing(there) == "depth images of 4 samples a texel");
    there.depth_samples = 0;
    CHECK(missing(there) == "depth images of 4 samples a texel, depth images of 8 samples a texel");
    there = all;
    there.centred_depth_samples = 8;
    CHECK(missing(there) == "VK_EXT_sample_locations for 4 samples a texel");
}

TEST_CASE("features are those that the driver has, of all that the effect needs together") {
    VkPhysicalDeviceFeatures flags{};
    VkPhysicalDeviceLimits limits{};
    VkPhysicalDeviceSubgroupProperties subgroups{};
    CHECK(vulkan::detail::features_of(flags, limits, subgroups, ~0u) == device_features{});
    flags.shaderStorageImageExtendedFormats = VK_TRUE;
    CHECK(vulkan::detail::features_of(flags, limits, subgroups, 0) ==
          device_features{.extended_storage_formats = true});
    flags = {};
    flags.fragmentStoresAndAtomics = VK_TRUE;
    CHECK(vulkan::detail::features_of(flags, limits, subgroups, 0) ==
          device_features{.fragment_stores_and_atomics = true});
    flags = {};
    subgroups.supportedOperations = VK_SUBGROUP_FEATURE_ARITHMETIC_BIT;
    CHECK(vulkan::detail::features_of(flags, limits, subgroups, 0) == device_features{});
    subgroups.supportedStages = VK_SHADER_STAGE_COMPUTE_BIT;
    CHECK(vulkan::detail::features_of(flags, limits, subgroups, 0) ==
          device_features{.subgroup_arithmetic = true});
    subgroups = {};
    limits.framebufferDepthSampleCounts = 1 | 2 | 4;  // drawn to
    limits.sampledImageDepthSampleCounts = 1 | 4 | 8; // and read
    CHECK(vulkan::detail::features_of(flags, limits, subgroups, 8 | 4) ==
          device_features{.depth_samples = 1 | 4, .centred_depth_samples = 4});
}
