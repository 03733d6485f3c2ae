// SPDX-License-Identifier: MIT
// Depth sources that keep every fragment against all fragments of the triangles: a-buffer-ssao 2013, IV.
#include "abuffer.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

using oracle::fragment;
using oracle::lens;
using scene = oracle::named_triangles;
using lists = std::vector<std::vector<fragment>>;

constexpr unsigned width = 40, height = 24;

bool are_near(double a, double b) {
    return std::abs(a - b) <= 2e-5 * b;
}

/// Whether these are the nearest `most` of all fragments of a texel, nearest first; at depths that rounding
/// cannot tell apart sides may come in either order.
bool are_nearest(const std::vector<fragment>& found, const std::vector<fragment>& all, std::size_t most) {
    if (found.size() != std::min(all.size(), most))
        return false;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const bool there = std::ranges::any_of(all, [&](const fragment& f) {
            return f.back == found[i].back && are_near(found[i].depth, f.depth);
        });
        if (!there || !are_near(found[i].depth, all[i].depth) ||
            (i > 0 && found[i].depth < found[i - 1].depth))
            return false;
    }
    // As many back faces as there are, where the end does not cut through equal depths.
    if (found.size() < all.size() && are_near(all[found.size()].depth, all[found.size() - 1].depth))
        return true;
    const auto backs = [&](const std::vector<fragment>& of) {
        return std::count_if(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(found.size()),
                             [](const fragment& f) { return f.back; });
    };
    return backs(found) == backs(all);
}

/// In how many texels that are not doubtful the lists are not the nearest.
std::size_t wrong(const lists& found, const oracle::fragment_lists& all, std::size_t most) {
    REQUIRE(found.size() == all.of.size());
    std::size_t count = 0;
    for (std::size_t at = 0; at < found.size(); ++at)
        count += !all.doubtful[at] && !are_nearest(found[at], all.of[at], most) ? 1 : 0;
    return count;
}

std::size_t total(const lists& of) {
    return std::accumulate(
        of.begin(), of.end(), std::size_t{0},
        [](std::size_t sum, const std::vector<fragment>& list) { return sum + list.size(); });
}

/// How many fragments lie behind the nearest `most` of their texels.
std::size_t beyond(const lists& of, std::size_t most) {
    std::size_t count = 0;
    for (const std::vector<fragment>& list : of)
        count += list.size() - std::min(list.size(), most);
    return count;
}

/// A recipe that packs what a depth source captures.
std::string packing(const std::string& source) {
    return "directions:1x1/" + source + "/hbao";
}

std::vector<float> visibility(const std::string& recipe, const oracle::triangles& drawn,
                              std::optional<float> thickness = {}) {
    return oracle::visibility_of(recipe, drawn, drawn, thickness);
}

double mean_difference(const std::vector<float>& a, const std::vector<float>& b) {
    REQUIRE(a.size() == b.size());
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::abs(a[i] - b[i]);
    return sum / static_cast<double>(a.size());
}

}

TEST_CASE("the A-buffer oracle has texels of 0 to 64 fragments and more, and few that are doubtful") {
    const oracle::fragment_lists all =
        oracle::rasterise(oracle::fragment_scenes().back().drawn, lens::standard, width, height);
    const auto longest = std::ranges::max_element(all.of, {}, &std::vector<fragment>::size);
    CHECK(longest->size() > 64);
    CHECK(oracle::rasterise(oracle::fragment_scenes()[0].drawn, lens::standard, width, height).of ==
          std::vector<std::vector<fragment>>(std::size_t{width} * height));
    CHECK(std::ranges::count(all.doubtful, true) < width * height / 4);
}

/// Checks the lists of a source against all fragments, and what is packed of them.
void check_lists(const std::string& source) {
    for (lens kind : {lens::standard, lens::orthographic})
        for (const scene& each : oracle::fragment_scenes()) {
            CAPTURE(each.name);
            CAPTURE(static_cast<int>(kind));
            const oracle::fragment_lists all = oracle::rasterise(each.drawn, kind, width, height);
            for (std::size_t layers : {1u, 2u, 3u, 8u, 32u}) {
                CAPTURE(layers);
                oracle::fragment_capture capture(packing(source + ":" + std::to_string(layers) + "x64"),
                                                 width, height, kind);
                capture.draw(each.drawn);
                const lists listed = capture.listed();
                CHECK(wrong(listed, all, ~std::size_t{0}) == 0);
                CHECK(wrong(capture.packed(layers), all, layers) == 0);
                CHECK(capture.count_in("fragments_beyond_pool") == 0);
                CHECK(capture.count_in("fragments_beyond_layers") == beyond(listed, layers));
            }
        }
}

TEST_CASE("linked lists hold every fragment once, and pack the nearest in order, with their sides") {
    check_lists("linked_lists");
}

TEST_CASE("linear lists hold every fragment once, and pack the nearest in order, with their sides") {
    check_lists("linear_lists");
}

TEST_CASE("linear lists stand one behind another, whichever part of the role scan sums their lengths") {
    const oracle::triangles drawn = oracle::soup(60, 2);
    oracle::fragment_capture work_efficient("directions:1x1/linear_lists:8x64/hbao/work_efficient_scan", 150,
                                            300);
    oracle::fragment_capture by_subgroups("directions:1x1/linear_lists:8x64/hbao/subgroup_scan", 150, 300);
    work_efficient.draw(drawn);
    by_subgroups.draw(drawn);
    const lists listed = work_efficient.listed();
    CHECK(total(listed) > 100'000);
    CHECK(listed == by_subgroups.listed());
    CHECK(work_efficient.packed(8) == by_subgroups.packed(8));
}

TEST_CASE("linear lists stand one behind another in more columns than a workgroup has, and in long ones") {
    oracle::triangles walls;
    for (int i = 0; i < 60; ++i) {
        const oracle::triangles one = oracle::wall(1 + 0.05f * static_cast<float>(i));
        walls.insert(walls.end(), one.begin(), one.end());
    }
    // 18000 fragments in a column, whose sum is scanned in two parts; and 270 columns.
    for (const std::pair<unsigned, unsigned>& size : {std::pair{20u, 300u}, {270u, 45u}})
        for (const std::string scan : {"work_efficient_scan", "subgroup_scan"}) {
            CAPTURE(size.first);
            CAPTURE(scan);
            oracle::fragment_capture capture(packing("linear_lists:2x64") + "/" + scan, size.first,
                                             size.second);
            capture.draw(walls);
            CHECK(total(capture.listed()) == std::size_t{60} * size.first * size.second);
        }
}

TEST_CASE("a layer array holds the nearest fragments in order, with their sides, and counts the others") {
    for (lens kind : {lens::standard, lens::orthographic})
        for (const scene& each : oracle::fragment_scenes()) {
            CAPTURE(each.name);
            CAPTURE(static_cast<int>(kind));
            const oracle::fragment_lists all = oracle::rasterise(each.drawn, kind, width, height);
            oracle::fragment_capture lists_of_all(packing("linked_lists:1x64"), width, height, kind);
            lists_of_all.draw(each.drawn);
            for (std::size_t layers : {1u, 2u, 3u, 8u, 32u}) {
                CAPTURE(layers);
                oracle::fragment_capture capture(packing("layer_array:" + std::to_string(layers)), width,
                                                 height, kind);
                capture.draw(each.drawn);
                CHECK(wrong(capture.packed(layers), all, layers) == 0);
                CHECK(capture.count_in("fragments_beyond_layers") == beyond(lists_of_all.listed(), layers));
            }
        }
}

TEST_CASE("peeling and lists agree exactly, but that peeling keeps one of equal fragments") {
    for (const scene& each : oracle::fragment_scenes()) {
        CAPTURE(each.name);
        for (std::size_t layers : {1u, 3u, 8u}) {
            CAPTURE(layers);
            oracle::fragment_capture peeled(packing("peeled_layers:" + std::to_string(layers)), width,
                                            height);
            oracle::fragment_capture whole(packing("linked_lists:1x64"), width, height);
            peeled.draw(each.drawn);
            whole.draw(each.drawn);
            lists expected = whole.listed();
            for (std::vector<fragment>& list : expected) {
                list.erase(std::unique(list.begin(), list.end()), list.end());
                list.resize(std::min(list.size(), layers));
            }
            CHECK(peeled.packed(layers) == expected);
        }
    }
}

/// Checks what a source of lists loses of a pool of each size.
void check_pools(const std::string& source, std::size_t least) {
    const oracle::triangles drawn = oracle::soup(80, 5);
    const oracle::fragment_lists all = oracle::rasterise(drawn, lens::standard, width, height);
    oracle::fragment_capture whole(packing(source + ":32x64"), width, height);
    whole.draw(drawn);
    const lists everything = whole.listed();
    const std::size_t wanted = beyond(everything, 1); // nodes
    REQUIRE(wanted > 1000);
    for (const std::size_t size : {least, std::size_t{1}, std::size_t{2}, std::size_t{7}, wanted / 3,
                                   wanted - 1, wanted, wanted + 1}) {
        CAPTURE(size);
        oracle::fragment_capture capture(packing(source + ":32x64"), width, height, lens::standard,
                                         "pack_layers", static_cast<unsigned>(size));
        for (int frame = 0; frame < 2; ++frame) { // the second finds a pool in use
            capture.draw(drawn);
            const lists kept = capture.listed();
            CHECK(capture.count_in("fragments_beyond_pool") == wanted - std::min(wanted, size));
            CHECK(total(kept) == total(everything) - capture.count_in("fragments_beyond_pool"));
            std::size_t lost_nearest = 0, strange = 0;
            for (std::size_t at = 0; at < kept.size(); ++at) {
                const auto same = [&](const fragment& a, const fragment& b) {
                    return a.depth == b.depth && a.back == b.back;
                };
                lost_nearest += kept[at].empty() != everything[at].empty() ||
                                (!kept[at].empty() && !same(kept[at][0], everything[at][0]));
                // Sorted alike, so a part of all comes in their order.
                std::size_t place = 0;
                for (const fragment& each : kept[at]) {
                    while (place < everything[at].size() && !same(everything[at][place], each))
                        ++place;
                    strange += place++ >= everything[at].size();
                }
            }
            CHECK(lost_nearest == 0);
            CHECK(strange == 0);
            const lists packed = capture.packed(32);
            std::size_t other = 0;
            for (std::size_t at = 0; at < kept.size(); ++at)
                other += !are_nearest(packed[at], kept[at], 32);
            CHECK(other == 0);
        }
    }
    CHECK_NOTHROW(oracle::device().check_messages());
}

TEST_CASE("a pool of any size loses no nearest fragment, corrupts no linked list and counts what it lost") {
    check_pools("linked_lists", 0);
}

TEST_CASE("a pool of any size loses no nearest fragment, corrupts no linear list and counts what it lost") {
    check_pools("linear_lists", 1);
}

TEST_CASE("all sources give the same occlusion for the same fragments, with every traversal") {
    const oracle::triangles drawn = oracle::soup(30, 11);
    for (const std::string estimator : {"hbao", "cosine_bitmask"}) {
        CAPTURE(estimator);
        const std::vector<float> single = visibility("directions:2x4/single_layer/" + estimator, drawn);
        for (const std::string traversal : {"all_layers", "front_first", "deferred_layers"})
            for (const std::string layers : {"2", "18"}) {
                CAPTURE(traversal);
                CAPTURE(layers);
                const std::string rest = "/" + estimator + "/" + traversal;
                const std::vector<float> of_array =
                    visibility("directions:2x4/layer_array:" + layers + rest, drawn);
                CHECK(of_array == visibility("directions:2x4/linked_lists:" + layers + "x64" + rest, drawn));
                CHECK(of_array == visibility("directions:2x4/linear_lists:" + layers + "x64" + rest, drawn));
                CHECK(of_array != single);
                if (layers == "2") {
                    CHECK(of_array == visibility("directions:2x4/peeled_layers:2" + rest, drawn));
                }
            }
    }
}

TEST_CASE("what memory held before a frame does not matter, rubbish or another frame's lists") {
    const oracle::triangles drawn = oracle::soup(30, 11), other = oracle::soup(90, 12);
    const auto capture = [](const std::string& source, std::optional<unsigned> free_nodes,
                            std::optional<std::uint32_t> rubbish) {
        return std::make_unique<oracle::fragment_capture>(packing(source), width, height, lens::standard,
                                                          "visibility", free_nodes, rubbish);
    };
    // Numbers that are wrong as counts, indices, keys and depths; 0x7fc00000 is not a number.
    constexpr std::uint32_t all_rubbish[] = {0u, 1u, 0x3f8ccccdu, 0x7fc00000u, 0xdeadbeefu, ~0u};
    for (const std::string source : {"layer_array:8", "peeled_layers:8", "dual_peeled_layers:8",
                                     "separated_layers:8", "linked_lists:8x64", "linear_lists:8x64"}) {
        CAPTURE(source);
        const auto clean = capture(source, {}, {});
        clean->draw(drawn);
        for (const std::uint32_t rubbish : all_rubbish) {
            CAPTURE(rubbish);
            const auto poisoned = capture(source, {}, rubbish);
            for (const oracle::triangles* before : {&drawn, &other}) {
                poisoned->draw(*before);
                poisoned->draw(drawn);
                CHECK(poisoned->packed(8) == clean->packed(8));
                CHECK(poisoned->runner().download("visibility") == clean->runner().download("visibility"));
            }
        }
    }
    for (const std::string source : {"linked_lists:8x64", "linear_lists:8x64"}) {
        CAPTURE(source);
        const auto whole = capture(source, {}, {}), full = capture(source, 100, {});
        whole->draw(drawn);
        full->draw(drawn);
        const lists everything = whole->packed(8);
        const std::uint32_t lost = full->count_in("fragments_beyond_pool");
        CHECK(lost > 500);
        for (const std::uint32_t rubbish : all_rubbish) {
            CAPTURE(rubbish);
            const auto poisoned = capture(source, 100, rubbish);
            poisoned->draw(other);
            poisoned->draw(drawn);
            CHECK(poisoned->count_in("fragments_beyond_pool") == lost);
            const lists kept = poisoned->packed(8);
            for (std::size_t at = 0; at < kept.size(); ++at)
                for (const fragment& each : kept[at]) // none is made up
                    CHECK(std::ranges::find(everything[at], each) != everything[at].end());
        }
    }
    CHECK_NOTHROW(oracle::device().check_messages());
}

TEST_CASE(
    "a linear list that gets more fragments than were counted, or fewer, leaves the others as they are") {
    const oracle::triangles drawn = oracle::soup(30, 11), more = oracle::soup(60, 11),
                            fewer = oracle::soup(10, 11);
    oracle::fragment_capture counted(packing("linear_lists:32x64"), width, height);
    counted.draw(drawn);
    for (const oracle::triangles* stored : {&more, &fewer}) {
        oracle::fragment_capture alone(packing("linear_lists:32x64"), width, height);
        alone.draw(*stored);
        oracle::fragment_capture both(packing("linear_lists:32x64"), width, height, lens::standard,
                                      "pack_layers", std::nullopt, 0x3f8ccccdu);
        both.draw(drawn, *stored);
        const lists expected = alone.packed(32), room = counted.packed(32), found = both.packed(32);
        std::size_t lost = 0;
        for (std::size_t at = 0; at < found.size(); ++at) {
            const std::size_t places = std::max<std::size_t>(room[at].size(), 1);
            CHECK(found[at].size() == std::min(expected[at].size(), places));
            lost += expected[at].size() - found[at].size();
            for (const fragment& each : found[at])
                CHECK(std::ranges::find(expected[at], each) != expected[at].end());
            CHECK((found[at].empty() || found[at][0] == expected[at][0]));
        }
        CHECK(both.count_in("fragments_beyond_pool") == lost);
    }
}

TEST_CASE("the bitmask is solid from a front face to the next back face, and thin behind others") {
    const float near = 2.8f, far = 4.5f, radius = 3, least = 0.15f; // of 8 taps
    oracle::triangles wall = oracle::wall(5), front, back;
    oracle::add_quad(front, {-9, -9, -near}, {9, 0, 0}, {0, 18, 0});
    oracle::add_quad(back, {-9, -9, -far}, {9, 0, 0}, {0, 18, 0});
    oracle::triangles solid = wall, sheets = wall;
    for (oracle::triangles* each : {&solid, &sheets})
        each->insert(each->end(), front.begin(), front.end());
    sheets.insert(sheets.end(), back.begin(), back.end());
    back = oracle::turned(back);
    solid.insert(solid.end(), back.begin(), back.end());
    const std::string layers = "directions:4x8/layer_array:4/cosine_bitmask:0x0",
                      single = "directions:4x8/single_layer/cosine_bitmask:0x0";
    // The back face is a thin layer of its own.
    const std::vector<float> expected = visibility(single, solid, (far - near) / radius + least);
    CHECK(mean_difference(visibility(layers, solid), expected) < 0.002);
    CHECK(mean_difference(visibility(layers, sheets), expected) > 0.01);
    CHECK(mean_difference(visibility(single, solid, least), expected) > 0.01);
}

TEST_CASE("an array of one or two layers says of the last layer what one of four says") {
    oracle::triangles drawn = oracle::wall(5);
    const std::string four = "directions:4x8/layer_array:4/cosine_bitmask:0x0",
                      one = "directions:4x8/layer_array:1/cosine_bitmask:0x0",
                      two = "directions:4x8/layer_array:2/cosine_bitmask:0x0";
    oracle::add_quad(drawn, {-9, -9, -2.8f}, {9, 0, 0}, {0, 18, 0});
    const std::vector<float> expected = visibility(four, drawn);
    CHECK(visibility(two, drawn) == expected);
    CHECK(visibility(one, drawn) != expected);
    oracle::triangles step; // left and right of each other
    oracle::add_quad(step, {-9, -9, -2.8f}, {9, 0, 0}, {0, 18, 0});
    oracle::add_quad(step, {0, -9, -4}, {9, 0, 0}, {0, 18, 0});
    CHECK(visibility(one, step) == visibility(four, step));
}
