// SPDX-License-Identifier: MIT
// Depth sources that choose among the layers of a texel, against all fragments of the triangles: dual depth
// peeling, Bavoil and Myers 2008; layers with a least separation, Mara et al. 2016; the layers of static and
// of dynamic geometry.
#include "abuffer.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace {

using oracle::fragment;
using oracle::lens;
using oracle::named_triangles;
using lists = std::vector<std::vector<fragment>>;

constexpr unsigned width = 40, height = 24;

bool are_near(double a, double b) {
    return std::abs(a - b) <= 2e-5 * b;
}

/// A recipe that packs what a depth source captures.
std::string packing(const std::string& source) {
    return "directions:1x1/" + source + "/hbao";
}

std::string numbered(const std::string& source, std::size_t layers) {
    return packing(source + ":" + std::to_string(layers));
}

lists packed(const std::string& recipe, std::size_t layers, const oracle::triangles& drawn) {
    oracle::fragment_capture capture(recipe, width, height);
    capture.draw(drawn);
    return capture.packed(layers);
}

/// All fragments of each texel, of equal ones one, as a linked list keeps them.
lists distinct(const oracle::triangles& drawn) {
    oracle::fragment_capture whole(packing("linked_lists:1x64"), width, height);
    whole.draw(drawn);
    lists all = whole.listed();
    for (std::vector<fragment>& list : all)
        list.erase(std::unique(list.begin(), list.end()), list.end());
    return all;
}

/// The nearest of a list and the farthest: half of so many each, of the nearest one more where they are odd.
std::vector<fragment> ends_of(const std::vector<fragment>& list, std::size_t layers) {
    if (list.size() <= layers)
        return list;
    const auto nearest = static_cast<std::ptrdiff_t>((layers + 1) / 2),
               farthest = static_cast<std::ptrdiff_t>(layers / 2);
    std::vector<fragment> ends(list.begin(), list.begin() + nearest);
    ends.insert(ends.end(), list.end() - farthest, list.end());
    return ends;
}

/// Whether two fragments are so near to each other that rounding may order or unite them.
bool has_ties(const std::vector<fragment>& list) {
    for (std::size_t i = 1; i < list.size(); ++i)
        if (are_near(list[i - 1].depth, list[i].depth))
            return true;
    return false;
}

bool are_alike(const std::vector<fragment>& found, const std::vector<fragment>& expected) {
    return std::ranges::equal(found, expected, [](const fragment& a, const fragment& b) {
        return a.back == b.back && are_near(a.depth, b.depth);
    });
}

/// Whether these are the nearest fragment and after it each the nearest that lies at least so far behind the
/// one before; where rounding decides, either will do.
bool are_separated(const std::vector<fragment>& found, const std::vector<fragment>& all, std::size_t most,
                   double separation) {
    double from = 0; // all that is nearer is passed over
    for (const fragment& each : found) {
        const double rounding = 4e-5 * each.depth;
        if (each.depth < from - rounding || std::ranges::none_of(all, [&](const fragment& f) {
                return f.back == each.back && are_near(f.depth, each.depth);
            }))
            return false;
        for (const fragment& f : all)
            if (f.depth > from + rounding && f.depth < each.depth - rounding)
                return false;
        from = each.depth + separation;
    }
    return found.size() == most || (found.size() < most && std::ranges::none_of(all, [&](const fragment& f) {
                                        return f.depth > from + 4e-5 * f.depth;
                                    }));
}

}

TEST_CASE("dual peeling keeps what peeling keeps, bit by bit, where there are no more layers") {
    for (const named_triangles& each : oracle::fragment_scenes()) {
        CAPTURE(each.name);
        const lists peeled = packed(numbered("peeled_layers", 8), 8, each.drawn);
        const lists all = distinct(each.drawn);
        for (std::size_t layers : {8u, 9u, 16u}) {
            CAPTURE(layers);
            const lists dual = packed(numbered("dual_peeled_layers", layers), layers, each.drawn);
            std::size_t other = 0;
            for (std::size_t at = 0; at < all.size(); ++at)
                other += all[at].size() <= 8 && dual[at] != peeled[at];
            CHECK(other == 0);
        }
    }
}

TEST_CASE("dual peeling keeps the nearest and the farthest fragments in order, with their sides") {
    for (const named_triangles& each : oracle::fragment_scenes()) {
        CAPTURE(each.name);
        const oracle::fragment_lists all = oracle::rasterise(each.drawn, lens::standard, width, height);
        const lists exact = distinct(each.drawn);
        for (std::size_t layers : {1u, 2u, 3u, 4u, 7u, 16u}) {
            CAPTURE(layers);
            const lists found = packed(numbered("dual_peeled_layers", layers), layers, each.drawn);
            std::size_t other = 0, wrong = 0;
            for (std::size_t at = 0; at < found.size(); ++at) {
                other += found[at] != ends_of(exact[at], layers);
                wrong += !all.doubtful[at] && !has_ties(all.of[at]) &&
                         !are_alike(found[at], ends_of(all.of[at], layers));
            }
            CHECK(other == 0);
            CHECK(wrong == 0);
        }
    }
}

TEST_CASE("separated layers are the nearest fragment and the nearest so far behind, with their sides") {
    for (lens kind : {lens::standard, lens::orthographic})
        for (const named_triangles& each : oracle::fragment_scenes()) {
            CAPTURE(each.name);
            CAPTURE(static_cast<int>(kind));
            const oracle::fragment_lists all = oracle::rasterise(each.drawn, kind, width, height);
            for (std::size_t layers : {1u, 2u, 3u, 8u})
                for (const auto& pair : {std::pair{1.0f, 0.05f}, {1.0f, 0.5f}, {3.0f, 0.5f}, {0.5f, 9.0f}}) {
                    const float radius = pair.first, separation = pair.second;
                    CAPTURE(layers);
                    CAPTURE(radius);
                    CAPTURE(separation);
                    oracle::fragment_capture capture(numbered("separated_layers", layers), width, height,
                                                     kind);
                    capture.set("radius", radius);
                    capture.set("separation", separation);
                    capture.draw(each.drawn);
                    const lists found = capture.packed(layers);
                    std::size_t wrong = 0;
                    for (std::size_t at = 0; at < found.size(); ++at)
                        wrong += !all.doubtful[at] &&
                                 !are_separated(found[at], all.of[at], layers, radius * separation);
                    CHECK(wrong == 0);
                }
        }
}

TEST_CASE("without a separation layers are those that peeling keeps, bit by bit") {
    for (const named_triangles& each : oracle::fragment_scenes()) {
        CAPTURE(each.name);
        oracle::fragment_capture separated(numbered("separated_layers", 8), width, height);
        separated.set("separation", 0);
        separated.draw(each.drawn);
        CHECK(separated.packed(8) == packed(numbered("peeled_layers", 8), 8, each.drawn));
    }
}

TEST_CASE(
    "of static and of dynamic geometry the nearest fragment each, the nearer first, and one of equal ones") {
    const std::vector<named_triangles> all = oracle::fragment_scenes();
    const oracle::triangles one = oracle::soup(12, 20), other = oracle::turned(one);
    std::vector<std::pair<oracle::triangles, oracle::triangles>> pairs{{one, one}, {one, other}};
    for (const named_triangles& each : all)
        pairs.emplace_back(one, each.drawn);
    for (lens kind : {lens::standard, lens::orthographic})
        for (const auto& [still, moving] : pairs) {
            oracle::fragment_capture capture(packing("static_and_dynamic_layers"), width, height, kind,
                                             "pack_layers", {}, 0x3f8ccccdu);
            capture.draw(moving, still); // whose fragments must not stay
            capture.draw(still, moving);
            const lists found = capture.packed(2);
            const oracle::fragment_lists of_still = oracle::rasterise(still, kind, width, height),
                                         of_moving = oracle::rasterise(moving, kind, width, height);
            std::size_t wrong = 0, two = 0;
            for (std::size_t at = 0; at < found.size(); ++at) {
                std::vector<fragment> expected;
                bool doubtful = of_still.doubtful[at] || of_moving.doubtful[at];
                for (const oracle::fragment_lists* each : {&of_still, &of_moving}) {
                    std::vector<fragment> list = each->of[at];
                    list.resize(std::min<std::size_t>(list.size(), 2));
                    doubtful = doubtful || has_ties(list);
                    if (!list.empty())
                        expected.push_back(list.front());
                }
                std::ranges::sort(expected, {}, [](const fragment& f) { return std::pair(f.depth, f.back); });
                if (expected.size() == 2 && expected[0] == expected[1])
                    expected.pop_back();
                two += found[at].size() == 2;
                wrong += !doubtful && !has_ties(expected) && !are_alike(found[at], expected);
                if (still == moving)
                    CHECK(found[at].size() < 2);
            }
            CHECK(wrong == 0);
            if (still != moving && moving != all[0].drawn)
                CHECK(two > 100);
        }
    CHECK_NOTHROW(oracle::device().check_messages());
}

TEST_CASE("sources that choose layers give the occlusion of those that keep all, of the same layers") {
    const oracle::triangles few = oracle::soup(7, 11);
    oracle::triangles step, moving; // which hides the edge of the step
    oracle::add_quad(step, {-9, -9, -6}, {9, 0, 0}, {0, 18, 0});
    oracle::add_quad(step, {0, -9, -4.5f}, {9, 0, 0}, {0, 18, 0});
    oracle::add_quad(moving, {-0.6f, -0.6f, -2.5f}, {1.2f, 0, 0}, {0, 1.2f, 0});
    oracle::triangles both = step;
    both.insert(both.end(), moving.begin(), moving.end());
    CHECK(oracle::visibility_of("directions:2x4/layer_array:2/hbao", both, both) !=
          oracle::visibility_of("directions:2x4/single_layer/hbao", both, both));
    for (const std::string estimator : {"hbao", "hbao_plus", "cosine_bitmask"})
        for (const std::string traversal : {"all_layers", "front_first", "deferred_layers"}) {
            CAPTURE(estimator);
            CAPTURE(traversal);
            const std::string rest = "/" + estimator + "/" + traversal;
            const auto visibility = [&](const std::string& source, const oracle::triangles& first,
                                        const oracle::triangles& others) {
                return oracle::visibility_of("directions:2x4/" + source + rest, first, others);
            };
            CHECK(visibility("dual_peeled_layers:8", few, few) == visibility("peeled_layers:8", few, few));
            CHECK(visibility("dual_peeled_layers:2", few, few) != visibility("peeled_layers:2", few, few));
            const std::vector<float> two = visibility("layer_array:2", both, both);
            CHECK(visibility("static_and_dynamic_layers", step, moving) == two);
            CHECK(visibility("static_and_dynamic_layers", moving, step) == two);
        }
}
