// SPDX-License-Identifier: MIT
#include <crease/vulkan/image.hpp>

#include "sentence.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("the default device exists and is listed") {
    const std::string name = validated_device().name();
    const std::vector<std::string> all = vulkan::device_names();
    CHECK(std::ranges::find(all, name) != all.end());
    CHECK_NOTHROW(vulkan::device({.name = name.substr(0, 4)}));
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
