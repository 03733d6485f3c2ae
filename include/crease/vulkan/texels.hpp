// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/resource.hpp>
#include <crease/vulkan/error.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace crease::vulkan::detail {

/// What a texel of a format is.
struct texel_type {
    VkFormat format = VK_FORMAT_UNDEFINED;
    unsigned components = 1;
    std::size_t bytes = 4; ///< of the whole texel
    const char* name = "none";
};

constexpr texel_type texel_of(format f) {
    switch (f) {
    case format::r8_unorm:
        return {VK_FORMAT_R8_UNORM, 1, 1, "r8_unorm"};
    case format::rgba8_unorm:
        return {VK_FORMAT_R8G8B8A8_UNORM, 4, 4, "rgba8_unorm"};
    case format::r32_uint:
        return {VK_FORMAT_R32_UINT, 1, 4, "r32_uint"};
    case format::r32_float:
        return {VK_FORMAT_R32_SFLOAT, 1, 4, "r32_float"};
    case format::rg32_uint:
        return {VK_FORMAT_R32G32_UINT, 2, 8, "rg32_uint"};
    case format::rgba32_uint:
        return {VK_FORMAT_R32G32B32A32_UINT, 4, 16, "rgba32_uint"};
    case format::rg32_float:
        return {VK_FORMAT_R32G32_SFLOAT, 2, 8, "rg32_float"};
    case format::rgba32_float:
        return {VK_FORMAT_R32G32B32A32_SFLOAT, 4, 16, "rgba32_float"};
    case format::rgba16_float:
        return {VK_FORMAT_R16G16B16A16_SFLOAT, 4, 8, "rgba16_float"};
    case format::d32_float:
        return {VK_FORMAT_D32_SFLOAT, 1, 4, "d32_float"};
    default:
        return {};
    }
}

/// Of the elements of a buffer, by their GLSL type; 0 of one that crease does not know.
constexpr std::size_t bytes_of_element(std::string_view glsl) {
    return glsl == "uint" || glsl == "int" || glsl == "float"     ? 4
           : glsl == "uvec2" || glsl == "ivec2" || glsl == "vec2" ? 8
           : glsl == "uvec4" || glsl == "ivec4" || glsl == "vec4" ? 16
                                                                  : 0;
}

/// To the nearest half, ties to even; too large becomes infinite.
inline std::uint16_t half_of(float number) {
    const auto bits = std::bit_cast<std::uint32_t>(number);
    const std::uint32_t sign = bits >> 16 & 0x8000u, magnitude = bits & 0x7fffffffu;
    constexpr std::uint32_t infinite = 0x7f800000u, first_too_large = 0x477ff000u, least_normal = 0x38800000u;
    if (magnitude > infinite)
        return static_cast<std::uint16_t>(sign | 0x7e00u); // NaN
    if (magnitude >= first_too_large)
        return static_cast<std::uint16_t>(sign | 0x7c00u);
    if (magnitude < least_normal) // a subnormal half counts in units of 2^-24
        return static_cast<std::uint16_t>(
            sign | static_cast<std::uint32_t>(std::nearbyint(std::ldexp(std::fabs(number), 24))));
    const std::uint32_t tie_to_even = 0xfffu + (magnitude >> 13 & 1u);
    return static_cast<std::uint16_t>(sign | (magnitude - 0x38000000u + tie_to_even) >> 13);
}

inline float float_of_half(std::uint16_t half) {
    const int exponent = half >> 10 & 0x1f, fraction = half & 0x3ff;
    float magnitude;
    if (exponent == 0x1f)
        magnitude = fraction ? std::nanf("") : HUGE_VALF;
    else if (exponent == 0)
        magnitude = std::ldexp(static_cast<float>(fraction), -24);
    else
        magnitude = std::ldexp(static_cast<float>(fraction + 0x400), exponent - 25);
    return half & 0x8000 ? -magnitude : magnitude;
}

/// Numbers as the bytes of texels; what bytes cannot hold is clamped to [0, 1].
/// @throws error  where the format holds whole numbers
inline std::vector<std::byte> bytes_of(std::span<const float> numbers, format f) {
    const texel_type type = texel_of(f);
    const std::size_t size = type.bytes / type.components;
    std::vector<std::byte> bytes(numbers.size() * size);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::byte* const to = &bytes[i * size];
        if (size == 1) {
            const float inside = numbers[i] >= 0 ? std::min(numbers[i], 1.0f) : 0.0f; // also for NaN
            *to = static_cast<std::byte>(std::lround(inside * 255));
        } else if (f == format::rgba16_float) {
            const std::uint16_t half = half_of(numbers[i]);
            std::memcpy(to, &half, size);
        } else if (!facts_of(f).whole_numbers && f != format::none) {
            std::memcpy(to, &numbers[i], size);
        } else {
            throw error(std::string(type.name) + " texels are not made of real numbers");
        }
    }
    return bytes;
}

/// The numbers that texels hold: those of bytes in [0, 1].
/// @throws error  where the format holds whole numbers
inline std::vector<float> numbers_of(std::span<const std::byte> bytes, format f) {
    const texel_type type = texel_of(f);
    const std::size_t size = type.bytes / type.components;
    std::vector<float> numbers(bytes.size() / size);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::byte* const from = &bytes[i * size];
        if (size == 1) {
            numbers[i] = static_cast<float>(std::to_integer<int>(*from)) / 255;
        } else if (f == format::rgba16_float) {
            std::uint16_t half;
            std::memcpy(&half, from, size);
            numbers[i] = float_of_half(half);
        } else if (!facts_of(f).whole_numbers && f != format::none) {
            std::memcpy(&numbers[i], from, size);
        } else {
            throw error(std::string(type.name) +
                        " texels are not real numbers: download_uint reads whole ones");
        }
    }
    return numbers;
}

}
