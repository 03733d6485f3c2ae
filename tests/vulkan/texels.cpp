// SPDX-License-Identifier: MIT
#include <crease/vulkan/texels.hpp>

#include <doctest/doctest.h>

#include <limits>

using namespace crease;
using vulkan::detail::float_of_half;
using vulkan::detail::half_of;

TEST_CASE("every half survives the way to float and back") {
    for (unsigned bits = 0; bits < 0x10000; ++bits) {
        const auto half = static_cast<std::uint16_t>(bits);
        const float number = float_of_half(half);
        if (std::isnan(number))
            CHECK((half_of(number) & 0x7c00) == 0x7c00);
        else if (half_of(number) != half)
            FAIL("half " << bits);
    }
}

TEST_CASE("a float becomes the nearest half, ties to even") {
    for (unsigned bits = 0; bits < 0x7bff; ++bits) {
        const float low = float_of_half(static_cast<std::uint16_t>(bits));
        const float high = float_of_half(static_cast<std::uint16_t>(bits + 1));
        const float middle = (low + high) / 2;
        if (half_of(middle) != bits + (bits & 1) || half_of(std::nextafter(middle, 0.0f)) != bits ||
            half_of(std::nextafter(middle, HUGE_VALF)) != bits + 1)
            FAIL("half " << bits);
    }
    CHECK(half_of(65519.0f) == 0x7bff);
    CHECK(half_of(65520.0f) == 0x7c00);
    CHECK(half_of(-1e30f) == 0xfc00);
    CHECK(half_of(-0.0f) == 0x8000);
}

TEST_CASE("bytes are rounded and clamped") {
    const float numbers[] = {-1, 0, 0.5f, 1, 2, std::numeric_limits<float>::quiet_NaN()};
    for (format texels : {format::r8_unorm, format::rgba8_unorm}) {
        const std::vector<std::byte> bytes = vulkan::detail::bytes_of(numbers, texels);
        CHECK(bytes == std::vector<std::byte>{std::byte{0}, std::byte{0}, std::byte{128}, std::byte{255},
                                              std::byte{255}, std::byte{0}});
    }
}
