// SPDX-License-Identifier: MIT
#include <crease/capture/subsets.hpp>

#include <doctest/doctest.h>

#include <bit>
#include <set>
#include <vector>

TEST_CASE("the table has every subset once, in the order of their sizes, and says where each size begins") {
    for (unsigned count : {1u, 3u, 8u, 16u, 32u}) {
        CAPTURE(count);
        const unsigned samples = count < 16 ? count : 16;
        std::vector<std::uint32_t> texels(256 * 257);
        crease::fill_subsets(texels, count);
        std::set<std::uint32_t> seen;
        for (unsigned kept = 0; kept <= samples; ++kept) {
            const std::uint32_t first = texels[65536 + kept], after = texels[65536 + kept + 1];
            CHECK(first <= after);
            for (std::uint32_t i = first; i < after; ++i) {
                CHECK(static_cast<unsigned>(std::popcount(texels[i])) == kept);
                CHECK(texels[i] < 1u << samples);
                seen.insert(texels[i]);
            }
        }
        CHECK(seen.size() == 1u << samples);
    }
}
