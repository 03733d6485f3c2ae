// SPDX-License-Identifier: MIT
#pragma once

#include <crease/array_view.hpp>

#include <bit>
#include <cstdint>

namespace crease {

/// The table of Algorithm 5 in stochastic-depth-ao 2020, as 256 texels a row: the subsets of `count` samples
/// (of 16, where there are more) as bits, those of fewer samples first; from texel 65,536 on, where the
/// subsets of 0, 1, 2, ... samples begin.
inline void fill_subsets(array_view<std::uint32_t> texels, unsigned count) {
    const unsigned samples = count < 16 ? count : 16;
    std::uint32_t used = 0;
    for (unsigned kept = 0; kept <= samples; ++kept) {
        texels[65536 + kept] = used;
        for (std::uint32_t subset = 0; subset < 1u << samples; ++subset)
            if (static_cast<unsigned>(std::popcount(subset)) == kept)
                texels[used++] = subset;
    }
    texels[65536 + samples + 1] = used;
}

}
