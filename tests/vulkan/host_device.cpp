// SPDX-License-Identifier: MIT
#include <crease/vulkan/runner.hpp>

#include "little_effect.hpp"
#include "own_host.hpp"
#include "sentence.hpp"
#include "sized.hpp"

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("a runner works on a host's device, which outlives it") {
    own_host host;
    {
        vulkan::device device(host.described());
        CHECK(device.handle() == host.described().handle);
        vulkan::runner runner(device, little::effect, 9, 7);
        runner.upload("depth", std::vector<float>(9 * 7, 0.25f));
        parameters p = sized(9, 7);
        p.radius = 0.5f; // with a gain of 2 the visibility is the depth
        runner.run(p);
        for (float each : runner.download("visibility"))
            CHECK(std::abs(each - 0.25f) < 1.0f / 255);
    }
    CHECK(vkDeviceWaitIdle(host.described().handle) == VK_SUCCESS);
    CHECK(host.messages().empty());
}

TEST_CASE("a host's device that lacks something is refused by the name of that") {
    own_host host;
    const auto said = [](const vulkan::host_device& of) { return sentence_of([&] { vulkan::device{of}; }); };
    vulkan::host_device other = host.described();
    CHECK(said(other) == "");
    other.queue = VK_NULL_HANDLE;
    CHECK(said(other) ==
          "a host's device has a VkPhysicalDevice, a VkDevice and a VkQueue; the third is null");
    CHECK(contains(said({}), "the first is null"));
    other = host.described();
    other.queue_family = 9;
    CHECK(contains(said(other), "has no queue family 9; it has "));
    other = host.described();
    other.api_version = VK_API_VERSION_1_0;
    CHECK(contains(said(other), "is of Vulkan 1.0; crease needs 1.1"));
    CHECK(host.messages().empty());
}

TEST_CASE("what the host did not enable its device has not") {
    own_host host;
    vulkan::host_device bare = host.described();
    bare.features = {};
    vulkan::device device(bare);
    CHECK(!device.features().extended_storage_formats);
    CHECK(device.features().centred_depth_samples == 0);
    effect_view wanting = little::effect;
    wanting.features.extended_storage_formats = true;
    CHECK(sentence_of([&] { vulkan::runner(device, wanting, 4, 4); }) ==
          "the device '" + device.name() +
              "' was made without shaderStorageImageExtendedFormats, which the effect requires");
    const vulkan::device whole(host.described());
    CHECK(whole.features().extended_storage_formats);
}

TEST_CASE("sample locations count where the host enabled them") {
    own_host host;
    vulkan::host_device with = host.described();
    constexpr const char* names[] = {"VK_KHR_swapchain", VK_EXT_SAMPLE_LOCATIONS_EXTENSION_NAME};
    with.extensions = names;
    const vulkan::device device(with);
    CHECK(device.features().centred_depth_samples ==
          (device.features().depth_samples & vulkan::detail::placeable_samples(with.physical)));
}

TEST_CASE("a queue family must both draw and compute") {
    VkQueueFamilyProperties family{};
    family.queueFlags = VK_QUEUE_COMPUTE_BIT | VK_QUEUE_TRANSFER_BIT;
    CHECK(!vulkan::detail::draws_and_computes(family));
    family.queueFlags = VK_QUEUE_GRAPHICS_BIT;
    CHECK(!vulkan::detail::draws_and_computes(family));
    family.queueFlags |= VK_QUEUE_COMPUTE_BIT;
    CHECK(vulkan::detail::draws_and_computes(family));
}
