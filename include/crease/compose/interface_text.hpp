// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace crease {

static_assert(std::endian::native == std::endian::little, "crease packs text for little-endian processors");

/// Characters in a word, the first in the lowest byte, filled up with zeros. A function of its own, as a
/// compiler keeps what one returned for the same arguments.
/// @param count  <= 8
constexpr std::uint64_t pack(const char* from, std::size_t count) {
    std::uint64_t word = 0;
    while (count-- > 0)
        word = word << 8 | static_cast<unsigned char>(from[count]);
    return word;
}

/// What stands before the definitions of a program: version, constants, resources and settings. It is kept in
/// words, as a compiler takes as long for a character as for a word. What does not fit is left out, and
/// `is_cut` says so.
class interface_text {
public:
    constexpr interface_text& operator<<(std::string_view text) { return add(text.data(), text.size()); }
    // A compiler knows the length of a literal, and std::string_view counts it character by character.
    constexpr interface_text& operator<<(const char* literal) {
        return add(literal, __builtin_strlen(literal));
    }
    constexpr interface_text& operator<<(int number) {
        if (number < 0) {
            *this << "-";
            return *this << static_cast<unsigned>(-(number + 1)) + 1u;
        }
        return *this << static_cast<unsigned>(number);
    }
    constexpr interface_text& operator<<(unsigned number) {
        if (number >= 100'000'000)
            *this << number / 100'000'000;
        std::uint64_t word = 0;
        std::size_t digits = 0;
        const bool is_rest = number >= 100'000'000;
        for (unsigned rest = number % 100'000'000; rest != 0 || digits == 0 || (is_rest && digits < 8);
             rest /= 10, ++digits)
            word = word << 8 | static_cast<std::uint64_t>('0' + rest % 10);
        add(word, digits);
        return *this;
    }

    constexpr std::size_t size() const { return size_; }
    constexpr bool is_cut() const { return is_cut_; }

    static constexpr std::size_t most_characters = 6000;

    /// Writes all characters.
    void write(char* to) const { std::memcpy(to, words, size_); }

    std::uint64_t words[most_characters / 8] =
        {}; ///< eight characters each, the first in the lowest byte; then zeros

private:
    constexpr interface_text& add(const char* from, std::size_t count) {
        for (; count > 8; count -= 8, from += 8)
            add(pack(from, 8), 8);
        add(pack(from, count), count);
        return *this;
    }
    /// @param count  <= 8; the characters behind are zeros
    constexpr void add(std::uint64_t characters, std::size_t count) {
        if (size_ + count > most_characters) {
            is_cut_ = true;
            return;
        }
        const std::size_t at = size_ / 8, before = size_ % 8;
        words[at] |= characters << (8 * before);
        if (before + count > 8)
            words[at + 1] = characters >> (64 - 8 * before);
        size_ += count;
    }

    std::size_t size_ = 0;
    bool is_cut_ = false;
};

}
