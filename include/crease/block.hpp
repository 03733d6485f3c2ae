// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace crease::joining {

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

}
