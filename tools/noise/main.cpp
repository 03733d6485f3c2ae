// SPDX-License-Identifier: MIT
// Writes include/crease/parts/noise/blue_noise_tile.hpp.
#include "noise/void_and_cluster.hpp"

#include <cstdio>

int main() {
    const unsigned side = 64;
    const auto ranks = crease::tools::void_and_cluster(side);
    std::puts("// SPDX-License-Identifier: MIT\n"
              "#pragma once\n"
              "\n"
              "namespace crease {\n"
              "\n"
              "/// Texels to a side of the tile of blue noise.\n"
              "inline constexpr unsigned blue_noise_side = 64;\n"
              "\n"
              "/// A tile of blue noise by void-and-cluster: the rank of each texel, row after row, in two "
              "characters of 64\n"
              "/// each, the digits '#' to 'd' without the question mark and the backslash. Written by\n"
              "/// crease_blue_noise_tile.\n"
              "// clang-format off\n"
              "inline constexpr char blue_noise_ranks[] =");
    const auto character = [](unsigned digit) {
        unsigned code = digit + '#';
        code += code >= '?';
        return static_cast<int>(code + (code >= '\\'));
    };
    for (unsigned at = 0; at < side * side; ++at) {
        std::fputs(at % 32 == 0 ? "    \"" : "", stdout);
        std::putchar(character(ranks[at] / 64u));
        std::putchar(character(ranks[at] % 64u));
        std::fputs(at + 1 == side * side ? "\";\n" : at % 32 == 31 ? "\"\n" : "", stdout);
    }
    std::puts("\n}");
}
