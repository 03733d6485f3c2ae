// SPDX-License-Identifier: MIT
#pragma once

#include <crease/interface_text.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace crease::joining {

template <std::size_t Size>
struct characters {
    char items[Size];
};

// A block is text in few items, as a compiler copies and checks the items of constants one by one.
#pragma pack(push, 1)
template <std::size_t Size, std::size_t Words = Size / 8, std::size_t Rest = Size % 8>
struct block {
    std::uint64_t words[Words];
    char rest[Rest];
};
template <std::size_t Size, std::size_t Words>
struct block<Size, Words, 0> {
    std::uint64_t words[Words];
};
template <std::size_t Size, std::size_t Rest>
struct block<Size, 0, Rest> {
    char rest[Rest];
};
#pragma pack(pop)

struct eight {
    char characters[8];
};

/// A number's characters.
template <int Number>
constexpr auto write_number() {
    characters<digits_of(Number)> all{};
    write_digits(all.items, sizeof all, Number);
    return __builtin_bit_cast(block<sizeof all>, all);
}
template <int Number>
inline constexpr auto digits = write_number<Number>();

template <std::size_t Size>
constexpr block<Size> block_at(const char* from) {
    block<Size> all{};
    if constexpr (Size >= 8)
        for (std::size_t i = 0; i < Size / 8; ++i, from += 8)
            all.words[i] = std::bit_cast<std::uint64_t>(
                eight{{from[0], from[1], from[2], from[3], from[4], from[5], from[6], from[7]}});
    if constexpr (Size % 8 != 0)
        for (std::size_t i = 0; i < Size % 8; ++i)
            all.rest[i] = from[i];
    return all;
}

/// One after the other.
template <class First, class Second>
struct pair {
    First first;
    Second second;
};

// A block per place, as a type may be a base only once.
template <std::size_t, class Block>
struct placed : Block {};

template <class... Blocks>
struct joined : Blocks... {};

// Never copied to characters, which would take a compiler longer than all else together.
template <class Blocks>
union text_of {
    Blocks blocks;
    char characters[sizeof(Blocks)];
};

template <class Blocks>
constexpr std::string_view view_of(const text_of<Blocks>& text) {
    return {text.characters, sizeof(Blocks) - 1};
}

// Each file's characters are copied once, however many programs hold them.
template <const glsl_file* File>
inline constexpr auto block_of = block_at<File->text.size()>(File->text.data());

template <class Places, const glsl_file*... Files>
struct files;
template <std::size_t... Place, const glsl_file*... Files>
struct files<std::index_sequence<Place...>, Files...> {
    static constexpr joined<placed<Place, block<Files->text.size()>>...> text{{block_of<Files>}...};
};

template <const glsl_file*... Files>
inline constexpr const auto& joined_files = files<std::make_index_sequence<sizeof...(Files)>, Files...>::text;

/// How many files are joined at once.
inline constexpr std::size_t group_size = 6;

}
