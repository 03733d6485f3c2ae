// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace crease {

/// What stands before the files of a program: version, constants and bindings. It is kept as the words and
/// numbers that it is joined of, as a compiler takes longer for many characters than for few words.
class interface_text {
public:
    constexpr interface_text& operator<<(std::string_view text) { return add({text.data(), text.size(), 0}); }
    // A compiler knows the length of a literal, and std::string_view counts it character by character.
    constexpr interface_text& operator<<(const char* literal) {
        return add({literal, __builtin_strlen(literal), 0});
    }
    /// @param number  >= 0
    constexpr interface_text& operator<<(int number) {
        return add({nullptr, digits_of(number), static_cast<std::size_t>(number)});
    }
    constexpr interface_text& operator<<(unsigned number) { return *this << static_cast<int>(number); }

    constexpr std::size_t size() const { return size_; }

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
                for (std::size_t c = size, rest = words_[i].number; c-- > 0; rest /= 10)
                    to.items[at + c] = static_cast<char>('0' + rest % 10);
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
    static constexpr std::size_t digits_of(int number) {
        std::size_t digits = 1;
        while ((number /= 10) != 0)
            ++digits;
        return digits;
    }

    word words_[640] = {}; // more than most constants and bindings take
    std::size_t count_ = 0, size_ = 0;
};

}
