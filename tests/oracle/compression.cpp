// SPDX-License-Identifier: MIT
// Compressed lists: a-buffer-ssao 2013, III.B and figure 6.
#include "abuffer.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace {

using oracle::lens;
using oracle::surface_fragment;
using surfaces = std::vector<std::vector<surface_fragment>>;

constexpr unsigned width = 40, height = 24;

/// Inserts one fragment after another into an array of `most` places, out of which the one goes that (5)
/// finds, in its latter half or in all of it: 1 - z of a depth buffer without a far plane is near / depth.
std::vector<surface_fragment> compress(const std::vector<surface_fragment>& all, std::size_t most,
                                       bool half) {
    std::vector<surface_fragment> kept;
    for (const surface_fragment& each : all) {
        kept.push_back(each);
        if (kept.size() <= most)
            continue;
        const auto weight = [](const surface_fragment& s) { return (s.color >> 24) * (0.1 / s.depth); };
        std::size_t least = half ? most / 2 : 0;
        for (std::size_t i = least; i < kept.size(); ++i)
            if (weight(kept[i]) < weight(kept[least]))
                least = i;
        kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(least));
    }
    return kept;
}

std::unique_ptr<oracle::fragment_capture> run(const std::string& parts, const oracle::triangles& drawn) {
    auto capture = std::make_unique<oracle::fragment_capture>("directions:5x4/linked_lists:32x64/hbao_plus/" +
                                                                  parts + "/r32f",
                                                              width, height, lens::standard, "visibility");
    capture->set("radius", 2);
    capture->draw(drawn);
    return capture;
}

double mean_difference(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::abs(double{a[i]} - double{b[i]});
    return sum / static_cast<double>(a.size());
}

}

TEST_CASE("kept nodes are those of equation (5)") {
    const oracle::triangles drawn = oracle::soup(90, 4);
    const surfaces all = run("every_layer", drawn)->surfaces();
    REQUIRE(std::ranges::max_element(all, {}, &std::vector<surface_fragment>::size)->size() > 12);
    for (std::size_t most : {1u, 3u, 4u, 8u})
        for (bool half : {false, true}) {
            CAPTURE(most);
            CAPTURE(half);
            const auto compressed =
                run("every_layer/compressed:" + std::to_string(most) + (half ? "x1" : "x0"), drawn);
            const surfaces kept = compressed->nodes();
            std::size_t other = 0;
            for (std::size_t at = 0; at < all.size(); ++at) {
                const std::vector<surface_fragment> expected = compress(all[at], most, half);
                bool same = kept[at].size() == expected.size();
                for (std::size_t i = 0; same && i < expected.size(); ++i)
                    same = std::abs(kept[at][i].depth / expected[i].depth - 1) < 1.0 / 1024 &&
                           kept[at][i].back == expected[i].back &&
                           kept[at][i].color >> 24 == expected[i].color >> 24 &&
                           glm::distance(kept[at][i].normal, expected[i].normal) < 1e-6;
                other += !same;
            }
            CHECK(other == 0);
        }
}

TEST_CASE("as many nodes as there are layers give the uncompressed result") {
    const oracle::triangles drawn = oracle::soup(16, 4);
    for (const std::string receivers : {"every_layer", "thin_layers"}) {
        CAPTURE(receivers);
        const auto whole = run(receivers, drawn);
        const surfaces all = whole->surfaces();
        REQUIRE(std::ranges::max_element(all, {}, &std::vector<surface_fragment>::size)->size() <= 8);
        const std::vector<float> expected = whole->runner().download("visibility");
        REQUIRE(*std::ranges::min_element(expected) < 0.8f);
        for (const std::string parts : {"/compressed:8", "/compressed:8x1", "/compressed_occluders:8"}) {
            CAPTURE(parts);
            const double apart =
                mean_difference(run(receivers + parts, drawn)->runner().download("visibility"), expected);
            CHECK(apart < 0.001); // depths are halves
            CHECK(apart > 0);
        }
    }
}

TEST_CASE("more nodes, the nearest among them, and receivers of all layers come nearer to all layers") {
    const oracle::triangles drawn = oracle::soup(90, 4);
    const std::vector<float> all = run("every_layer", drawn)->runner().download("visibility");
    const auto error = [&](const std::string& parts) {
        return mean_difference(run("every_layer/" + parts, drawn)->runner().download("visibility"), all);
    };
    const double two = error("compressed:2"), four = error("compressed:4"), eight = error("compressed:8"),
                 half = error("compressed:4x1"), of_all = error("compressed_occluders:4"),
                 half_of_all = error("compressed_occluders:4x1");
    MESSAGE("columns B " << four << ", C " << half << ", D " << of_all << " and " << half_of_all
                         << "; with 2 nodes " << two << ", with 8 " << eight);
    CHECK(eight < four);
    CHECK(four < two);
    CHECK(of_all < four);
    CHECK(half_of_all < half);
}
