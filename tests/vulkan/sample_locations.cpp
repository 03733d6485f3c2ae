// SPDX-License-Identifier: MIT
#include <crease/vulkan/sample_locations.hpp>

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("every sample is placed at the centre of the texel") {
    for (std::uint32_t samples : {1u, 2u, 4u, 32u}) {
        const VkSampleLocationsInfoEXT info = vulkan::detail::at_the_centre(samples);
        CHECK(info.sampleLocationsPerPixel == static_cast<VkSampleCountFlagBits>(samples));
        REQUIRE(info.sampleLocationsCount == samples);
        CHECK((info.sampleLocationGridSize.width == 1 && info.sampleLocationGridSize.height == 1));
        for (std::uint32_t i = 0; i < samples; ++i)
            CHECK((info.pSampleLocations[i].x == 0.5f && info.pSampleLocations[i].y == 0.5f));
    }
}
