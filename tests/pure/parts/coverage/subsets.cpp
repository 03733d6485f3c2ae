// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <set>
#include <string>
#include <vector>

TEST_CASE("the table has every subset once, in the order of their sizes, and says where each size begins") {
    for (unsigned count : {1u, 3u, 8u, 16u, 32u}) {
        CAPTURE(count);
        const unsigned samples = count < 16 ? count : 16;
        const std::string text = "directions/stochastic_layers:" + std::to_string(count) + "/hbao";
        const auto composed = std::make_unique<crease::composition>(crease::recipe(std::string_view(text)));
        const auto resources = composed->view().resources;
        const auto table = std::ranges::find(resources, "subsets", &crease::resource::name);
        REQUIRE(table != resources.end());
        CHECK(table->life == crease::lifetime::constant);
        REQUIRE(static_cast<bool>(table->fill));
        std::vector<std::uint32_t> texels(table->size.fixed_width * table->size.fixed_height);
        REQUIRE(texels.size() == 256 * 257);
        table->fill(texels);
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
