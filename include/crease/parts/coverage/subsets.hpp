// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

#include <bit>
#include <cstdint>

namespace crease {

/// The table of Algorithm 5 in stochastic-depth-ao 2020, as 256 texels a row: the subsets of `Samples`
/// samples as bits, those of fewer samples first; from texel 65,536 on, where the subsets of 0, 1, 2, ...
/// samples begin.
template <unsigned Samples>
inline void fill_subsets(array_view<std::uint32_t> texels) {
    std::uint32_t used = 0;
    for (unsigned kept = 0; kept <= Samples; ++kept) {
        texels[65536 + kept] = used;
        for (std::uint32_t subset = 0; subset < 1u << Samples; ++subset)
            if (static_cast<unsigned>(std::popcount(subset)) == kept)
                texels[used++] = subset;
    }
    texels[65536 + Samples + 1] = used;
}

/// That of the samples that the depth source keeps of a texel; of 16, where there are more.
constexpr void shape_subsets(resource& own, const shape_of& effect) {
    constexpr decltype(resource::fill) fills[] = {
        fill_subsets<1>,  fill_subsets<2>,  fill_subsets<3>,  fill_subsets<4>,
        fill_subsets<5>,  fill_subsets<6>,  fill_subsets<7>,  fill_subsets<8>,
        fill_subsets<9>,  fill_subsets<10>, fill_subsets<11>, fill_subsets<12>,
        fill_subsets<13>, fill_subsets<14>, fill_subsets<15>, fill_subsets<16>};
    const int samples = effect.number_of(role::depth_source, "count");
    own.fill = fills[samples < 16 ? samples - 1 : 15];
}

}
