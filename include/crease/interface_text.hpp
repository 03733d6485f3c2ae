// SPDX-License-Identifier: MIT
#pragma once

#include <crease/block.hpp>
#include <crease/fixed_list.hpp>
#include <crease/open_number.hpp>

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

/// The characters of a number.
/// @param number  >= 0
constexpr std::size_t digits_of(int number) {
    std::size_t digits = 1;
    while ((number /= 10) != 0)
        ++digits;
    return digits;
}

/// What stands before the files of a program: version, constants and bindings. It is kept in words, as a
/// compiler takes as long for a character as for a word.
class interface_text {
public:
    /// An open number, which has no characters.
    struct gap {
        std::size_t before; ///< characters between it and the one before
        int number;
    };

    constexpr interface_text& operator<<(std::string_view text) { return add(text.data(), text.size()); }
    // A compiler knows the length of a literal, and std::string_view counts it character by character.
    constexpr interface_text& operator<<(const char* literal) {
        return add(literal, __builtin_strlen(literal));
    }
    /// @param number  >= 0, or open
    constexpr interface_text& operator<<(int number) {
        if (open_number::is(number)) {
            gaps_.add({after_gaps(), number});
            last_gap_ = size_;
            return *this;
        }
        std::uint64_t word = 0;
        const std::size_t digits = digits_of(number);
        if (digits > 8)
            *this << number / 100'000'000;
        const std::size_t last = digits > 8 ? 8 : digits;
        for (std::size_t i = 0; i < last; ++i, number /= 10)
            word = word << 8 | static_cast<std::uint64_t>('0' + number % 10);
        add(word, last);
        return *this;
    }
    constexpr interface_text& operator<<(unsigned number) { return *this << static_cast<int>(number); }

    constexpr std::size_t size() const { return size_; }
    constexpr const fixed_list<gap, 32>& gaps() const { return gaps_; }
    constexpr std::size_t after_gaps() const { return size_ - last_gap_; }

    /// More than `size()` ever is, unless a host's parts have names of hundreds of characters.
    static constexpr std::size_t most_characters = 4096;

    /// The first characters.
    template <std::size_t Size>
    constexpr joining::block<Size> first() const {
        joining::block<Size> all{};
        if constexpr (Size >= 8)
            for (std::size_t i = 0; i < Size / 8; ++i)
                all.words[i] = words_[i];
        if constexpr (Size % 8 != 0)
            for (std::size_t i = 0; i < Size % 8; ++i)
                all.rest[i] = static_cast<char>(words_[Size / 8] >> (8 * i));
        return all;
    }

    /// Writes all characters.
    void write(char* to) const { std::memcpy(to, words_, size_); }

private:
    constexpr interface_text& add(const char* from, std::size_t count) {
        for (; count > 8; count -= 8, from += 8)
            add(pack(from, 8), 8);
        add(pack(from, count), count);
        return *this;
    }
    /// @param count  <= 8; the characters behind are zeros
    constexpr void add(std::uint64_t characters, std::size_t count) {
        if (size_ + count > most_characters)
            return;
        const std::size_t at = size_ / 8, before = size_ % 8;
        words_[at] |= characters << (8 * before);
        if (before + count > 8)
            words_[at + 1] = characters >> (64 - 8 * before);
        size_ += count;
    }

    std::uint64_t words_[most_characters / 8] = {};
    std::size_t size_ = 0, last_gap_ = 0;
    fixed_list<gap, 32> gaps_;
};

}
