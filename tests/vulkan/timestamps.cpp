// SPDX-License-Identifier: MIT
#include <crease/vulkan/timestamps.hpp>

#include "validated_device.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace crease;

TEST_CASE("there is a time between each two marks, and NaN where the device has none") {
    vulkan::device& device = validated_device();
    vulkan::detail::timestamps marks(device, 3);
    for (int run = 0; run < 2; ++run) {
        device.submit([&](VkCommandBuffer commands) {
            marks.begin(commands);
            marks.mark(commands);
            marks.mark(commands);
        });
        const std::vector<double> times = marks.intervals(device);
        REQUIRE(times.size() == 2);
        for (double time : times)
            CHECK((device.has_timestamps() ? time >= 0 && time < 10000 : std::isnan(time)));
    }
    CHECK_NOTHROW(device.check_messages());
}
