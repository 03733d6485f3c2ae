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

struct eight {
    char characters[8];
};

/// A number's characters.
template <int Number>
struct number {
    using characters = block<digits_of(Number)>;
    static constexpr characters text = (interface_text{} << Number).template first<digits_of(Number)>();
};

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

// A place per block, as a type may be a base only once.
template <std::size_t, class Block>
struct placed : Block {};

template <class... Blocks>
struct joined : Blocks... {};

template <class Places, class... Blocks>
struct placed_all;
template <std::size_t... Place, class... Blocks>
struct placed_all<std::index_sequence<Place...>, Blocks...> {
    using type = joined<placed<Place, Blocks>...>;
};

/// Blocks one after the other.
template <class... Blocks>
using sequence = typename placed_all<std::make_index_sequence<sizeof...(Blocks)>, Blocks...>::type;

/// The block at a place of a sequence.
template <std::size_t Place, class Block>
constexpr const Block& block_in(const placed<Place, Block>& all) {
    return all;
}

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

/// Files that are joined at once, as many programs have the same in a row.
template <const glsl_file*... Files>
struct file_group {
    using blocks = sequence<block<Files->text.size()>...>;
    static constexpr blocks text{{block_of<Files>}...};
};

inline constexpr std::size_t files_in_group = 6;

/// One after the other.
template <class First, class Second>
struct pair {
    First first;
    Second second;
};

}
