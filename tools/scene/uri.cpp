// SPDX-License-Identifier: MIT
#include "scene/uri.hpp"

#include "scene/scene.hpp"

#include <array>
#include <charconv>
#include <cstdint>

namespace crease::tools {
namespace {

constexpr std::string_view base64_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t no_digit = 64;

constexpr auto value_of_digit = [] {
    std::array<std::uint8_t, 256> values;
    values.fill(no_digit);
    for (std::size_t i = 0; i < base64_digits.size(); ++i)
        values[static_cast<unsigned char>(base64_digits[i])] = static_cast<std::uint8_t>(i);
    return values;
}();

}

std::string percent_decoded(std::string_view text) {
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            decoded += text[i];
            continue;
        }
        const std::string_view digits = text.substr(i + 1, 2);
        unsigned char byte = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
        if (error != std::errc() || end != digits.data() + 2)
            throw scene_error("a URI has a % without two hexadecimal digits after it");
        decoded += static_cast<char>(byte);
        i += 2;
    }
    return decoded;
}

std::string base64_decoded(std::string_view text) {
    while (text.ends_with('='))
        text.remove_suffix(1);
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int filled = 0;
    for (const char digit : text) {
        const std::uint8_t value = value_of_digit[static_cast<unsigned char>(digit)];
        if (value == no_digit)
            throw scene_error("a data URI is not base64");
        bits = bits << 6 | value;
        filled += 6;
        if (filled >= 8) {
            filled -= 8;
            bytes += static_cast<char>(bits >> filled & 0xffu);
        }
    }
    return bytes;
}

}
