// SPDX-License-Identifier: MIT
#pragma once

#include <crease/fixed_list.hpp>
#include <crease/open_number.hpp>

#include <cstddef>
#include <string_view>

namespace crease {

/// The characters of a number.
/// @param number  >= 0
constexpr std::size_t digits_of(int number) {
    std::size_t digits = 1;
    while ((number /= 10) != 0)
        ++digits;
    return digits;
}

/// @param to  has room for `digits`
constexpr void write_digits(char* to, std::size_t digits, std::size_t number) {
    for (; digits-- > 0; number /= 10)
        to[digits] = static_cast<char>('0' + number % 10);
}

/// What stands before the files of a program: version, constants and bindings. It is kept as the words and
/// numbers that it is joined of, as a compiler takes longer for many characters than for few words.
class interface_text {
public:
    /// An open number, which has no characters.
    struct gap {
        std::size_t at; ///< characters before it
        int number;
    };

    constexpr interface_text& operator<<(std::string_view text) { return add({text.data(), text.size(), 0}); }
    // A compiler knows the length of a literal, and std::string_view counts it character by character.
    constexpr interface_text& operator<<(const char* literal) {
        return add({literal, __builtin_strlen(literal), 0});
    }
    /// @param number  >= 0, or open
    constexpr interface_text& operator<<(int number) {
        if (open_number::is(number)) {
            gaps_.add({size_, number});
            return *this;
        }
        return add({nullptr, digits_of(number), static_cast<std::size_t>(number)});
    }
    constexpr interface_text& operator<<(unsigned number) { return *this << static_cast<int>(number); }

    constexpr std::size_t size() const { return size_; }
    constexpr const fixed_list<gap, 32>& gaps() const { return gaps_; }

    /// More than `size()` ever is, unless a host's parts have names of hundreds of characters.
    static constexpr std::size_t most_characters = 4096;

    /// Writes the words that fit.
    /// @tparam Characters  has an array `items` of characters, `size()` of them or more for the whole
    template <class Characters>
    constexpr void write(Characters& to) const {
        // Plain indices and no calls: a compiler evaluates this for each character.
        std::size_t at = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const char* text = words_[i].text;
            const std::size_t size = words_[i].size;
            if (at + size > sizeof to.items)
                return;
            if (text)
                for (std::size_t c = 0; c < size; ++c)
                    to.items[at + c] = text[c];
            else
                write_digits(to.items + at, size, words_[i].number);
            at += size;
        }
    }

private:
    struct word {
        const char* text; // null: the number
        std::size_t size; // characters
        std::size_t number;
    };

    constexpr interface_text& add(word next) {
        words_[count_++] = next;
        size_ += next.size;
        return *this;
    }

    word words_[640] = {}; // more than most constants and bindings take
    std::size_t count_ = 0, size_ = 0;
    fixed_list<gap, 32> gaps_;
};

}
