// SPDX-License-Identifier: MIT
// Depth sources that keep surfaces against all fragments of the triangles: a-buffer-ssao 2013, IV.
#include "abuffer.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace {

using oracle::fragment;
using oracle::lens;
using oracle::surface_fragment;
using surfaces = std::vector<std::vector<surface_fragment>>;

constexpr unsigned width = 40, height = 24;
const std::array<std::uint32_t, 16> colors = oracle::every_color();

/// A recipe that packs the surfaces that a depth source captures.
std::string packing(const std::string& source) {
    return "directions:1x1/" + source + "/hbao/every_layer";
}

/// What of all fragments of a texel is seen, if only in part.
std::vector<fragment> opaque_in_part(const std::vector<fragment>& all) {
    std::vector<fragment> seen;
    for (const fragment& each : all)
        if (colors[each.triangle % 16] >> 24 != 0)
            seen.push_back(each);
    return seen;
}

bool are_near(double a, double b) {
    return std::abs(a - b) <= 2e-5 * b;
}

glm::dvec3 normal_of(const oracle::triangles& drawn, std::size_t triangle) {
    const glm::dvec3 a = drawn[3 * triangle], b = drawn[3 * triangle + 1], c = drawn[3 * triangle + 2];
    return glm::normalize(glm::cross(b - a, c - a));
}

/// Whether a kept surface is that of a fragment.
bool is_of(const surface_fragment& kept, const fragment& f, const oracle::triangles& drawn) {
    constexpr double tenth_of_a_degree = 0.00175;
    return kept.back == f.back && are_near(kept.depth, f.depth) && kept.color == colors[f.triangle % 16] &&
           glm::length(kept.normal - normal_of(drawn, f.triangle)) < tenth_of_a_degree;
}

/// Whether these are the nearest `most` of all fragments of a texel, nearest first, each once.
bool are_nearest(const std::vector<surface_fragment>& kept, const std::vector<fragment>& all,
                 std::size_t most, const oracle::triangles& drawn) {
    if (kept.size() != std::min(all.size(), most))
        return false;
    std::set<std::size_t> taken;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        std::size_t at = 0;
        while (at < all.size() && (taken.contains(at) || !is_of(kept[i], all[at], drawn)))
            ++at;
        if (at == all.size() || !are_near(kept[i].depth, all[i].depth) ||
            (i > 0 && kept[i].depth < kept[i - 1].depth))
            return false;
        taken.insert(at);
    }
    return true;
}

std::size_t wrong(const surfaces& kept, const oracle::fragment_lists& all, std::size_t most,
                  const oracle::triangles& drawn) {
    std::size_t count = 0;
    for (std::size_t at = 0; at < kept.size(); ++at)
        count += !all.doubtful[at] && !are_nearest(kept[at], opaque_in_part(all.of[at]), most, drawn);
    return count;
}

std::size_t total(const surfaces& of) {
    std::size_t count = 0;
    for (const std::vector<surface_fragment>& list : of)
        count += list.size();
    return count;
}

/// Where receivers are first surfaces, puts them at a depth of 5.
void put_receivers(oracle::fragment_capture& capture) {
    const crease::effect_view effect = capture.effect();
    if (std::ranges::find(effect.resources, "depth", &crease::resource::name) != effect.resources.end())
        capture.runner().upload("depth", std::vector<float>(std::size_t{width} * height, 5.0f));
}

/// Checks what a source keeps against all fragments.
/// @param pool  the number of a source of lists
/// @param most  layers that the source takes
void check_surfaces(const std::string& source, const std::string& pool, std::size_t most) {
    for (lens kind : {lens::standard, lens::orthographic})
        for (unsigned triangles : {6u, 60u, 400u}) {
            CAPTURE(triangles);
            const oracle::triangles drawn = oracle::soup(triangles, triangles);
            const oracle::fragment_lists all = oracle::rasterise(drawn, kind, width, height);
            for (std::size_t layers : {1u, 3u, 4u, 9u, 32u}) {
                CAPTURE(layers);
                layers = std::min(layers, most);
                oracle::fragment_capture capture(packing(source + ":" + std::to_string(layers) + pool), width,
                                                 height, kind);
                capture.draw(drawn);
                const surfaces kept = capture.surfaces();
                CHECK(wrong(kept, all, layers, drawn) == 0);
                if (!pool.empty())
                    CHECK(capture.count_in("fragments_beyond_pool") == 0);
                const auto opacities = capture.opacities();
                std::size_t other = 0;
                for (std::size_t at = 0; at < kept.size(); ++at)
                    for (std::size_t i = 0; i < kept[at].size(); ++i)
                        other += opacities[at][i] != kept[at][i].color >> 24;
                CHECK(other == 0);
            }
        }
}

/// Checks what a source of lists loses of a pool of each size.
/// @param mixes  whether the nearest of two fragments beside the pool may take the colour of the other
void check_pools(const std::string& source, bool mixes) {
    const oracle::triangles drawn = oracle::soup(80, 5);
    const std::string recipe = packing(source + ":32x64");
    oracle::fragment_capture whole(recipe, width, height);
    whole.draw(drawn);
    REQUIRE(whole.count_in("fragments_beyond_layers") == 0);
    const surfaces everything = whole.surfaces();
    const std::size_t wanted = total(everything);
    REQUIRE(wanted > 1000);
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{1}, std::size_t{7}, wanted / 3, wanted - 1, wanted, wanted + 1}) {
        CAPTURE(size);
        oracle::fragment_capture capture(recipe, width, height, lens::standard, "pack_layers",
                                         static_cast<unsigned>(size));
        for (int frame = 0; frame < 2; ++frame) {
            capture.draw(drawn);
            const surfaces kept = capture.surfaces();
            CHECK(total(kept) == wanted - capture.count_in("fragments_beyond_pool"));
            if (size >= wanted)
                CHECK(total(kept) == wanted);
            std::size_t lost = 0, strange = 0, mixed = 0;
            for (std::size_t at = 0; at < kept.size(); ++at) {
                const auto& all = everything[at];
                const auto same = [](const surface_fragment& a, const surface_fragment& b) {
                    return a.depth == b.depth && a.back == b.back;
                };
                lost += kept[at].empty() != all.empty() ||
                        (!kept[at].empty() && !same(kept[at].front(), all.front()));
                for (const surface_fragment& each : kept[at]) {
                    const auto whole_same = [&](const surface_fragment& other) {
                        return same(each, other) && other.color == each.color &&
                               glm::distance(other.normal, each.normal) <= 1e-9;
                    };
                    const bool is_there =
                        std::ranges::any_of(all, [&](const auto& other) { return same(each, other); });
                    strange += !is_there;
                    mixed += is_there && std::ranges::none_of(all, whole_same);
                }
            }
            CHECK(lost == 0);
            CHECK(strange == 0);
            CHECK(mixed * 50 <= (mixes ? kept.size() : 0)); // of fragments whose keys begin alike
        }
    }
    CHECK_NOTHROW(oracle::device().check_messages());
}

}

TEST_CASE("linked lists keep the nearest surfaces in order, and none of no opacity") {
    check_surfaces("linked_lists", "x64", 32);
}

TEST_CASE("linear lists keep the nearest surfaces in order, and none of no opacity") {
    check_surfaces("linear_lists", "x64", 32);
}

TEST_CASE("a layer array keeps the nearest surfaces in order, and none of no opacity") {
    check_surfaces("layer_array", "", 32);
}

TEST_CASE("peeling keeps the nearest surfaces in order, and none of no opacity") {
    check_surfaces("peeled_layers", "", 8);
}

TEST_CASE("dual peeling keeps the nearest and the farthest surfaces in order, and none of no opacity") {
    for (lens kind : {lens::standard, lens::orthographic})
        for (unsigned triangles : {6u, 60u}) {
            CAPTURE(triangles);
            const oracle::triangles drawn = oracle::soup(triangles, triangles);
            const oracle::fragment_lists all = oracle::rasterise(drawn, kind, width, height);
            for (std::size_t layers : {1u, 4u, 5u, 16u}) {
                CAPTURE(layers);
                oracle::fragment_capture capture(packing("dual_peeled_layers:" + std::to_string(layers)),
                                                 width, height, kind);
                capture.draw(drawn);
                const surfaces kept = capture.surfaces();
                std::size_t other = 0;
                for (std::size_t at = 0; at < kept.size(); ++at) {
                    std::vector<fragment> seen = opaque_in_part(all.of[at]);
                    if (seen.size() > layers) { // what lies between is lost
                        const auto nearest = static_cast<std::ptrdiff_t>((layers + 1) / 2),
                                   farthest = static_cast<std::ptrdiff_t>(layers / 2);
                        seen.erase(seen.begin() + nearest, seen.end() - farthest);
                    }
                    other += !all.doubtful[at] && !are_nearest(kept[at], seen, layers, drawn);
                }
                CHECK(other == 0);
                CHECK(total(kept) > 200);
            }
        }
}

TEST_CASE("of static and of dynamic geometry the nearest surface each, and none of no opacity") {
    const oracle::triangles still = oracle::soup(12, 20), moving = oracle::soup(12, 21);
    for (lens kind : {lens::standard, lens::orthographic}) {
        oracle::fragment_capture capture(packing("static_and_dynamic_layers"), width, height, kind);
        capture.draw(moving, still); // whose surfaces must not stay
        capture.draw(still, moving);
        const surfaces kept = capture.surfaces();
        const oracle::fragment_lists of_still = oracle::rasterise(still, kind, width, height),
                                     of_moving = oracle::rasterise(moving, kind, width, height);
        std::size_t other = 0, two = 0;
        for (std::size_t at = 0; at < kept.size(); ++at) {
            std::vector<std::pair<fragment, const oracle::triangles*>> expected;
            for (const auto& [lists, drawn] : {std::pair{&of_still, &still}, {&of_moving, &moving}})
                if (const std::vector<fragment> seen = opaque_in_part(lists->of[at]); !seen.empty())
                    expected.emplace_back(seen.front(), drawn);
            std::ranges::sort(expected, {}, [](const auto& each) { return each.first.depth; });
            const bool same = std::ranges::equal(kept[at], expected, [](const auto& k, const auto& e) {
                return is_of(k, e.first, *e.second);
            });
            other += !of_still.doubtful[at] && !of_moving.doubtful[at] && !same;
            two += kept[at].size() == 2;
        }
        CHECK(other == 0);
        CHECK(two > 100);
    }
    CHECK_NOTHROW(oracle::device().check_messages());
}

TEST_CASE("static and dynamic layers with opacity give what lists give of the same fragments") {
    oracle::triangles still, moving; // which hides the edge of the step
    oracle::add_quad(still, {-9, -9, -6}, {9, 0, 0}, {0, 18, 0});
    oracle::add_quad(still, {0, -9, -4.5f}, {9, 0, 0}, {0, 18, 0});
    oracle::add_quad(moving, {-0.6f, -0.6f, -2.5f}, {1.2f, 0, 0}, {0, 1.2f, 0});
    oracle::triangles both = still;
    both.insert(both.end(), moving.begin(), moving.end());
    oracle::color_table half;
    half.fill(0x80808080u);
    const auto visibility = [&half](const std::string& source, const std::string& rest,
                                    const oracle::triangles& first, const oracle::triangles& others) {
        oracle::fragment_capture capture("directions:2x4/" + source + "/hbao/" + rest + "/r32f", width,
                                         height, lens::standard, "visibility");
        capture.set("radius", 3);
        put_receivers(capture);
        capture.draw(first, others, half);
        return capture.runner().download("visibility");
    };
    for (const std::string rest : {"every_layer", "thin_layers", "every_layer/compressed:2", "compressed:2",
                                   "every_layer/compressed_occluders:1"}) {
        CAPTURE(rest);
        const std::vector<float> lists = visibility("linked_lists:4x8", rest, both, both);
        CHECK(visibility("static_and_dynamic_layers", rest, still, moving) == lists);
        CHECK(*std::ranges::min_element(lists) < 0.95f);
        CHECK(visibility("static_and_dynamic_layers", rest, still, still) != lists);
    }
}

TEST_CASE("a layer array counts the surfaces that lie behind its layers, as lists do") {
    const oracle::triangles drawn = oracle::soup(60, 2);
    for (const std::string layers : {"1", "5", "32"}) {
        CAPTURE(layers);
        oracle::fragment_capture array(packing("layer_array:" + layers), width, height),
            lists(packing("linked_lists:" + layers + "x64"), width, height);
        array.draw(drawn);
        lists.draw(drawn);
        CHECK(array.count_in("fragments_beyond_layers") == lists.count_in("fragments_beyond_layers"));
    }
}

TEST_CASE("of coplanar surfaces an array keeps each once and peeling one of each side, and none is mixed") {
    oracle::triangles drawn = oracle::soup(5, 7);
    const oracle::triangles same = drawn, other = oracle::turned(drawn);
    for (const oracle::triangles* each : {&same, &same, &other})
        drawn.insert(drawn.end(), each->begin(), each->end());
    const oracle::fragment_lists all = oracle::rasterise(drawn, lens::standard, width, height);
    const auto kept_by = [&drawn](const std::string& source) {
        oracle::fragment_capture capture(packing(source), width, height);
        capture.draw(drawn);
        return capture.surfaces();
    };
    CHECK(wrong(kept_by("layer_array:20"), all, 20, drawn) == 0);
    const surfaces peeled = kept_by("peeled_layers:8"), array = kept_by("layer_array:20");
    std::size_t mixed = 0, missing = 0, twice = 0;
    for (std::size_t at = 0; at < peeled.size(); ++at) {
        std::set<std::pair<double, bool>> depths;
        for (const surface_fragment& each : array[at])
            depths.emplace(each.depth, each.back);
        missing += peeled[at].size() != std::min<std::size_t>(depths.size(), 8);
        for (const surface_fragment& each : peeled[at]) {
            twice += depths.erase({each.depth, each.back}) == 0;
            mixed += !all.doubtful[at] && std::ranges::none_of(all.of[at], [&](const fragment& f) {
                return is_of(each, f, drawn);
            });
        }
    }
    CHECK(mixed == 0);
    CHECK(missing == 0);
    CHECK(twice == 0);
}

TEST_CASE("separated layers keep the surfaces of their fragments") {
    const oracle::triangles drawn = oracle::soup(60, 2);
    const oracle::fragment_lists all = oracle::rasterise(drawn, lens::standard, width, height);
    oracle::fragment_capture capture(packing("separated_layers:3"), width, height),
        peeled(packing("peeled_layers:3"), width, height);
    capture.set("separation", 0);
    capture.draw(drawn);
    CHECK(wrong(capture.surfaces(), all, 3, drawn) == 0);
    capture.set("separation", 0.5f);
    capture.draw(drawn);
    std::size_t strange = 0, near = 0;
    const surfaces kept = capture.surfaces();
    for (std::size_t at = 0; at < kept.size(); ++at)
        for (std::size_t i = 0; i < kept[at].size(); ++i) {
            near += i > 0 && kept[at][i].depth < kept[at][i - 1].depth + 0.4999;
            strange += !all.doubtful[at] && std::ranges::none_of(all.of[at], [&](const fragment& f) {
                return is_of(kept[at][i], f, drawn);
            });
        }
    CHECK(total(kept) > 1000);
    CHECK(strange == 0);
    CHECK(near == 0);
}

TEST_CASE("a pool of any size loses no nearest surface of linked lists, and counts what it lost") {
    check_pools("linked_lists", true);
}

TEST_CASE("a pool of any size loses no nearest surface of linear lists, mixes none and counts what it lost") {
    check_pools("linear_lists", false);
}

TEST_CASE("all sources of surfaces give the same occlusion for the same fragments, compressed or not") {
    const oracle::triangles drawn = oracle::soup(30, 11);
    const auto visibility = [&drawn](const std::string& source, const std::string& rest) {
        oracle::fragment_capture capture("directions:2x4/" + source + "/hbao/every_layer/r32f" + rest, width,
                                         height, lens::standard, "visibility");
        capture.set("radius", 3);
        capture.draw(drawn);
        return capture.runner().download("visibility");
    };
    for (const std::string rest : {"", "/compressed:4", "/compressed_occluders:4"}) {
        CAPTURE(rest);
        const std::vector<float> linked = visibility("linked_lists:16x64", rest);
        CHECK(linked == visibility("linear_lists:16x64", rest));
        CHECK(linked == visibility("layer_array:16", rest));
        CHECK(linked == visibility("dual_peeled_layers:16", rest));
        CHECK(visibility("linked_lists:8x64", rest) == visibility("peeled_layers:8", rest));
        CHECK(std::ranges::min(linked) < 0.8f);
    }
}

TEST_CASE("coplanar surfaces come out the same in whatever order they are drawn") {
    oracle::triangles drawn = oracle::soup(5, 7);
    const oracle::triangles same = drawn, other = oracle::turned(drawn);
    for (const oracle::triangles* each : {&same, &other})
        drawn.insert(drawn.end(), each->begin(), each->end());
    const std::size_t count = drawn.size() / 3;
    REQUIRE(count <= colors.size());
    for (const std::string source : {"linked_lists:20x64", "linear_lists:20x64", "layer_array:20"})
        for (const std::string rest : {"composite", "composite/compressed_occluders:4",
                                       "every_layer/compressed:4", "thin_layers", "compressed:2"}) {
            CAPTURE(source);
            CAPTURE(rest);
            oracle::fragment_capture capture("directions:2x4/" + source + "/hbao/" + rest + "/r32f", width,
                                             height, lens::standard, "visibility");
            capture.set("radius", 3);
            put_receivers(capture);
            std::vector<float> visibility, blended;
            for (std::size_t step : {1u, 2u, 7u, 14u}) { // which have no divisor in common with 15
                oracle::triangles permuted;
                oracle::color_table permuted_colors = colors;
                for (std::size_t i = 0; i < count; ++i) {
                    const std::size_t from = i * step % count;
                    permuted.insert(permuted.end(), &drawn[3 * from], &drawn[3 * from] + 3);
                    permuted_colors[i] = colors[from];
                }
                capture.draw(permuted, permuted_colors);
                const std::vector<float> found = capture.runner().download("visibility"),
                                         color = rest.starts_with("composite")
                                                     ? capture.runner().download("color")
                                                     : std::vector<float>();
                if (step == 1) {
                    visibility = found;
                    blended = color;
                }
                CHECK(found == visibility);
                CHECK(color == blended);
            }
            CHECK(*std::ranges::min_element(visibility) < 0.9f);
        }
}
