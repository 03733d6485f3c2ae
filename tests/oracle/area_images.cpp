// SPDX-License-Identifier: MIT
// Summed-area tables, their layers and statistical volumetric obscurance against the oracle's.
#include "areas.hpp"
#include "run.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>

namespace {

using oracle::lens;
using kind = oracle::surface::kind;

constexpr double one_step = 1.0 / 255;

/// What an effect that has run on a picture leaves.
struct rendered {
    oracle::settings settings;
    std::vector<float> visibility, tables, range;
};

rendered render(const oracle::picture& p, const std::string& text, double radius,
                const std::map<std::string, int>& constants = {}) {
    auto& [composed, runner] = oracle::prepare(text, p, constants);
    const crease::parameters how = oracle::view_parameters(p, composed, radius);
    oracle::upload(runner, composed, p);
    runner.run(how);
    const bool has_tables = std::ranges::any_of(
        composed.view().resources, [](const crease::resource& each) { return each.name == "area_tables"; });
    return {oracle::settings_of(how, composed), runner.download("visibility"),
            has_tables ? runner.download("area_tables") : std::vector<float>(), runner.download("range")};
}

/// The sums of a layer of a recipe's tables, with the centring undone: `before(x, y)` is exclusive.
struct table {
    const std::vector<float>& texels;
    int width, height, layer;
    double centre;

    glm::dvec4 before(int x, int y) const {
        if (x == 0 || y == 0)
            return glm::dvec4(0);
        const std::size_t at = 4 * static_cast<std::size_t>((layer * height + y - 1) * width + x - 1);
        return {texels[at + 2], texels[at + 3], texels[at] - centre * texels[at + 1], texels[at + 1]};
    }
    glm::dvec4 over(int left, int top, int right, int bottom) const {
        return before(right, bottom) - before(left, bottom) - before(right, top) + before(left, top);
    }
};

/// Sums over the texels up to and including each, in double precision.
std::vector<glm::dvec4> summed(const oracle::area_texels& t) {
    std::vector<glm::dvec4> sums(t.texels.size());
    for (int y = 0; y < t.height; ++y) {
        glm::dvec4 row(0);
        for (int x = 0; x < t.width; ++x) {
            const std::size_t at = static_cast<std::size_t>(y * t.width + x);
            row += glm::dvec4(t.texels[at].position, t.texels[at].count);
            sums[at] = row + (y == 0 ? glm::dvec4(0) : sums[at - static_cast<std::size_t>(t.width)]);
        }
    }
    return sums;
}

oracle::picture facing_plane(int width, int height) {
    return oracle::draw({{kind::plane, {0, 0, -7.3}, {0, 0, 1}}}, lens::standard, width, height);
}

/// A picture of a huge size, without the time that drawing takes: a plane of depth that leans.
oracle::picture huge_picture(bool leaning) {
    oracle::picture p = facing_plane(1, 1);
    p.width = 3840;
    p.height = 2160;
    p.projection = oracle::make_projection(lens::standard, 3840.0 / 2160);
    const float one = p.device[0];
    p.device.resize(std::size_t{3840} * 2160);
    for (std::size_t i = 0; i < p.device.size(); ++i)
        p.device[i] = leaning ? 0.9f + 0.09f * static_cast<float>(i % 3840) / 3840.0f : one;
    p.normals.assign(p.device.size(), glm::vec3(0, 0, 1));
    return p;
}

}

TEST_CASE("tables hold the sums of all texels before, at any size") {
    const auto check = [](const oracle::picture& p, int divisor, const std::string& scan,
                          const std::map<std::string, int>& constants = {}) {
        CAPTURE(p.width);
        CAPTURE(p.height);
        CAPTURE(divisor);
        CAPTURE(scan);
        const rendered r = render(
            p, "sample_box/summed_area:" + std::to_string(divisor) + "/mean_height/" + scan + "/linear_depth",
            0.5, constants);
        const oracle::area_texels t = oracle::downsample(p, divisor);
        REQUIRE(r.tables.size() == 4 * t.texels.size());
        const std::vector<glm::dvec4> expected = summed(t);
        const double centre = r.range[2];
        double greatest = 0, apart = 0;
        bool counts_equal = true;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            glm::dvec4 sum = expected[i];
            sum.z += centre * sum.w;
            const glm::dvec4 ours(r.tables[4 * i + 2], r.tables[4 * i + 3], r.tables[4 * i],
                                  r.tables[4 * i + 1]);
            for (int c = 0; c < 3; ++c) {
                greatest = std::max(greatest, std::abs(sum[c]));
                apart = std::max(apart, std::abs(sum[c] - ours[c]));
            }
            counts_equal = counts_equal && ours.w == sum.w;
        }
        CHECK(counts_equal);
        CHECK(apart <= greatest * 1e-6 + 1e-6);
    };
    for (const glm::ivec2 size :
         {glm::ivec2(97, 61), {1, 1}, {1, 9}, {300, 1}, {1, 300}, {641, 359}, {16, 16}})
        for (int divisor : {1, 2, 3, 4})
            for (const char* scan : {"work_efficient_scan", "subgroup_scan"})
                check(oracle::draw(oracle::still_life(), lens::standard, size.x, size.y), divisor, scan);
    for (const char* scan : {"work_efficient_scan", "subgroup_scan"})
        check(huge_picture(true), 1, scan);
    // Lines of more pieces than a subgroup has invocations.
    for (const char* scan : {"work_efficient_scan", "subgroup_scan"})
        check(oracle::draw(oracle::still_life(), lens::standard, 97, 61), 1, scan,
              {{"compute.width", 32}, {"compute.height", 32}});
}

TEST_CASE("the range of the picture is that of its depths, and none of background alone") {
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::off_centre, 131, 77);
    double nearest = 1e30, farthest = 0, sum = 0, count = 0;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
            if (!p.background(x, y)) {
                const double depth = -p.position(x, y).z;
                nearest = std::min(nearest, depth);
                farthest = std::max(farthest, depth);
                sum += depth;
                count += 1;
            }
    const std::vector<float> range = render(p, "sample_box/summed_area/mean_height", 0.5).range;
    CHECK(std::abs(range[0] - nearest) < 5e-6 * nearest);
    CHECK(std::abs(range[1] - farthest) < 8e-5 * farthest);
    CHECK(std::abs(range[2] - sum / count) < 1e-5 * sum / count);
    CHECK(static_cast<double>(range[3]) == count);
    const oracle::picture empty = oracle::draw({}, lens::standard, 20, 20);
    CHECK(render(empty, "sample_box/summed_area/mean_height", 0.5).range == std::vector<float>(4, 0.0f));
}

TEST_CASE("the mean of a picture of one depth is that depth, of any area at 3840 x 2160") {
    const oracle::picture p = huge_picture(false);
    const rendered r = render(p, "sample_box/summed_area/mean_height", 0.5);
    const table all{r.tables, p.width, p.height, 0, r.range[2]};
    const glm::dvec4 whole = all.over(0, 0, p.width, p.height);
    std::mt19937 random(1);
    for (int i = 0; i < 20000; ++i) {
        const int width = 1 + static_cast<int>(random() % (i % 2 ? 12 : 1000)),
                  height = 1 + static_cast<int>(random() % (i % 3 ? 12 : 1000));
        const int left = static_cast<int>(random() % static_cast<unsigned>(p.width - width + 1)),
                  top = static_cast<int>(random() % static_cast<unsigned>(p.height - height + 1));
        const glm::dvec4 sum = all.over(left, top, left + width, top + height);
        REQUIRE(sum.w == width * height);
        REQUIRE(std::abs(sum.z / sum.w - whole.z / whole.w) < 1e-4);
    }
    CHECK(*std::min_element(r.visibility.begin(), r.visibility.end()) >= 0.995f);
}

TEST_CASE("each texel is in exactly one adaptive layer, and the layers' sums are the root's") {
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, 97, 61);
    for (int layers : {2, 3, 4, 8})
        for (int divisor : {1, 2}) {
            CAPTURE(layers);
            CAPTURE(divisor);
            const rendered r = render(p,
                                      "sample_box/summed_area_adaptive:" + std::to_string(layers) + "x" +
                                          std::to_string(divisor) + "/mean_height",
                                      0.5);
            const oracle::area_texels t = oracle::downsample(p, divisor);
            const oracle::layering expected = oracle::adaptive_layers(p, t, r.settings, layers);
            double elsewhere = 0;
            for (int y = 0; y < t.height; ++y)
                for (int x = 0; x < t.width; ++x) {
                    // The tree: table t splits layer t - 2^k and leaves the nearer part in its place.
                    std::vector<double> counts(static_cast<std::size_t>(layers));
                    for (int i = 0; i < layers; ++i) {
                        const double own =
                            table{r.tables, t.width, t.height, i, r.range[2]}.over(x, y, x + 1, y + 1).w;
                        if (i == 0) {
                            counts[0] = own;
                            continue;
                        }
                        int level = 1;
                        while (2 * level <= i)
                            level *= 2;
                        counts[static_cast<std::size_t>(i)] =
                            counts[static_cast<std::size_t>(i - level)] - own;
                        counts[static_cast<std::size_t>(i - level)] = own;
                    }
                    const auto in_layers = oracle::sums_of(p, t, expected, layers, x, y);
                    double sum = 0;
                    for (int i = 0; i < layers; ++i) {
                        const double own = counts[static_cast<std::size_t>(i)];
                        REQUIRE(own >= 0);
                        sum += own;
                        elsewhere += std::abs(own - in_layers[static_cast<std::size_t>(i)].count) / 2;
                    }
                    REQUIRE(sum == t.at(x, y).count);
                }
            // Where a depth is its neighbourhood's mean to the last bits, either layer is right.
            CHECK(elsewhere < static_cast<double>(p.device.size()) / 50);
        }
}

namespace {

using sums_of_area = std::function<std::vector<oracle::area_texel>(const std::array<double, 4>&)>;

/// How a picture by a source of areas differs from the oracle's.
/// @param prepare  gives the sums of the layers over an area, of a picture, its tables' texels and the
/// settings
template <class Prepare>
oracle::difference differ(const std::string& source, int divisor, lens projection, bool oriented,
                          const Prepare& prepare, const std::string& parts = "") {
    const oracle::picture p = oracle::draw(oracle::still_life(), projection, 97, 61);
    const rendered r = render(p,
                              "sample_box/" + source + "/mean_height:" + (oriented ? "1" : "0") + parts +
                                  (projection == lens::orthographic ? "/orthographic" : ""),
                              0.5);
    const oracle::settings s = r.settings;
    const oracle::area_texels t = oracle::downsample(p, divisor);
    const sums_of_area sums = prepare(p, t, s);
    const auto expected = oracle::main_pass(p, s, 1, false, [&](const oracle::receiver& each) {
        const auto area = oracle::sample_area(p, {each.x + 0.5, each.y + 0.5}, each.position, s.radius);
        return oracle::mean_height(each, s, sums(area), oriented);
    });
    return oracle::compare(r.visibility, expected);
}

/// The sums of layers, each texel of the picture in one.
sums_of_area of_layers(const oracle::picture& p, const oracle::area_texels& t, const oracle::layering& of,
                       int layers) {
    return [&p, &t, of, layers](const auto& area) { return oracle::sums_over(p, t, of, layers, area); };
}

const auto one = [](const auto& p, const auto& t, const auto&) {
    return of_layers(p, t, oracle::one_layer(p), 1);
};
const auto even = [](const auto& p, const auto& t, const auto&) {
    return of_layers(p, t, oracle::uniform_layers(p, t, 7), 7);
};
template <int Layers>
const auto adaptive = [](const auto& p, const auto& t, const auto& s) {
    return of_layers(p, t, oracle::adaptive_layers(p, t, s, Layers), Layers);
};
template <int Levels>
const auto squares = [](const auto&, const auto& t, const auto&) -> sums_of_area {
    return [&t](const auto& area) { return oracle::sums_of_squares(t, area, 1 << (Levels - 1)); };
};
template <int Levels>
const auto mips = [](const auto&, const auto& t, const auto&) -> sums_of_area {
    return [&t](const auto& area) { return oracle::sums_of_mips(t, area, Levels - 1); };
};

}

TEST_CASE("mean height over every source of areas") {
    for (lens projection :
         {lens::standard, lens::reversed, lens::infinite, lens::off_centre, lens::orthographic})
        for (bool oriented : {true, false})
            for (int divisor : {1, 2, 4}) {
                CAPTURE(static_cast<int>(projection));
                CAPTURE(oriented);
                CAPTURE(divisor);
                const std::string by = std::to_string(divisor);
                const auto check = [&](const std::string& source, const auto& prepare, double most = 1) {
                    CAPTURE(source);
                    const oracle::difference d = differ(source, divisor, projection, oriented, prepare);
                    CHECK(d.typical < 0.02);
                    CHECK(d.mean < 0.6 * one_step);
                    CHECK(d.most < most);
                };
                check("summed_area:" + by, one);
                check("summed_area_uniform:7x" + by, even);
                check("summed_area_adaptive:4x" + by, adaptive<4>);
                check("n_buffer:9x" + by, squares<9>);
                check("n_buffer:3x" + by, squares<3>);
                check("mip_chain:9x" + by, mips<9>, 0.008);
                check("mip_chain:2x" + by, mips<2>, 0.008);
                if (divisor == 2) {
                    check("summed_area_adaptive:2x2", adaptive<2>);
                    check("summed_area_adaptive:8x2", adaptive<8>);
                }
            }
}

TEST_CASE("mean height in the fragment stage") {
    CHECK(differ("summed_area_adaptive:4x2", 2, lens::standard, true, adaptive<4>, "/fragment").mean <
          0.6 * one_step);
}

TEST_CASE("more uniform layers come nearer to the volume that is not layered") {
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, 97, 61);
    double before = 1;
    for (int layers : {4, 16, 64}) {
        const rendered r =
            render(p, "sample_box/summed_area_uniform:" + std::to_string(layers) + "/mean_height", 0.5);
        const oracle::settings s = r.settings;
        const oracle::area_texels t = oracle::downsample(p, 1);
        // Each texel of the area is a layer of its own.
        const auto expected = oracle::main_pass(p, s, 1, false, [&](const oracle::receiver& each) {
            const auto area = oracle::sample_area(p, {each.x + 0.5, each.y + 0.5}, each.position, s.radius);
            double occlusion = 0, texels = 0;
            for (int y = std::max(0, static_cast<int>(std::floor(area[1] + 0.5)));
                 y < std::min(p.height, static_cast<int>(std::floor(area[3] + 0.5))); ++y)
                for (int x = std::max(0, static_cast<int>(std::floor(area[0] + 0.5)));
                     x < std::min(p.width, static_cast<int>(std::floor(area[2] + 0.5))); ++x) {
                    if (p.background(x, y))
                        continue;
                    const double height = glm::dot(p.position(x, y) - each.position, each.normal) / s.radius;
                    const double own = std::clamp((height - s.bias) / s.threshold, 0.0, 1.0);
                    occlusion += own * (1 - std::clamp((height - s.threshold) / s.falloff, 0.0, 1.0));
                    texels += 1;
                }
            return texels > 1 ? occlusion / texels * std::min((texels - 1) / 3, 1.0) : 0.0;
        });
        const double apart = oracle::compare(r.visibility, expected).mean;
        CAPTURE(layers);
        MESSAGE(layers << " uniform layers: " << apart << " from the volume");
        CHECK(apart < before);
        before = apart;
    }
    CHECK(before < 0.02);
}

TEST_CASE("a box in front of a wall darkens nothing beyond the radius, but for a single layer") {
    // The box's face is three radii in front of the wall.
    oracle::picture p =
        oracle::draw({{kind::plane, {0, 0, -6}, {0, 0, 1}}, {kind::half_plane, {0, 0, -3}, {0, 0, 1}}},
                     lens::standard, 320, 180);
    const auto darkest_of_wall = [&](const std::string& source) {
        const std::vector<float> image = render(p, "sample_box/" + source + "/mean_height", 1).visibility;
        float darkest = 1;
        for (int y = 0; y < p.height; ++y)
            for (int x = 0; x < p.width; ++x)
                if (-p.position(x, y).z > 5)
                    darkest = std::min(darkest, image[p.index(x, y)]);
        return darkest;
    };
    CHECK(darkest_of_wall("summed_area") < 0.8f);
    CHECK(darkest_of_wall("summed_area_adaptive:2") >= 0.995f);
    CHECK(darkest_of_wall("summed_area_adaptive:4") >= 0.995f);
}

namespace {

/// The cube from -1 to 1 as seen from `eye`, before a wall that faces the eye 34 behind it.
oracle::picture cube_before_a_wall(glm::dvec3 eye) {
    oracle::picture p = oracle::draw({{kind::plane, {0, 0, -38}, {0, 0, 1}}}, lens::standard, 240, 180);
    const glm::dvec3 back = glm::normalize(eye), right = glm::normalize(glm::cross({0, 1, 0}, back));
    const glm::dmat3 to_world(right, glm::cross(back, right), back);
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
            glm::dvec3 start, ray;
            p.ray({x + 0.5, y + 0.5}, start, ray);
            const glm::dvec3 from = eye + to_world * start, way = to_world * ray;
            double enters = 0, leaves = 1e9;
            int face = 0;
            for (int i = 0; i < 3; ++i) {
                const double a = (-1 - from[i]) / way[i], b = (1 - from[i]) / way[i];
                if (std::min(a, b) > enters) {
                    enters = std::min(a, b);
                    face = i;
                }
                leaves = std::min(leaves, std::max(a, b));
            }
            if (enters >= leaves)
                continue;
            const glm::dvec4 clip = p.projection * glm::dvec4(start + enters * ray, 1);
            p.device[p.index(x, y)] = static_cast<float>(clip.z / clip.w);
            glm::dvec3 normal(0);
            normal[face] = way[face] < 0 ? 1 : -1;
            p.normals[p.index(x, y)] = glm::vec3(glm::transpose(to_world) * normal);
        }
    return p;
}

}

TEST_CASE("a cube far before a wall has no outline that one table does not give it") {
    struct view {
        glm::dvec3 eye;
        bool
            grazing; ///< whether a face is seen at a few degrees, over which one mean takes the wall for near
    };
    for (const view& from : {view{{2.2, 1.8, 3.2}, false}, view{{0, 0, 4}, false}, view{{4, 2, 5}, false},
                             view{{1.05, 0.3, 4}, true}, view{{3, 1.05, 3}, true}})
        for (double radius : {0.4, 0.8, 1.6}) {
            const oracle::picture p = cube_before_a_wall(from.eye);
            /// The occlusion of all pixels together.
            const auto occluded = [&](const std::string& source, bool of_cube) {
                const std::vector<float> image =
                    render(p, "sample_box/" + source + "/mean_height", radius).visibility;
                double sum = 0;
                for (int y = 0; y < p.height; ++y)
                    for (int x = 0; x < p.width; ++x)
                        if ((-p.position(x, y).z < 20) == of_cube)
                            sum += 1 - image[p.index(x, y)];
                return sum;
            };
            for (const char* source : {"n_buffer", "mip_chain"}) {
                CAPTURE(from.eye.x);
                CAPTURE(radius);
                CAPTURE(std::string(source));
                CHECK(occluded(source, false) < 0.005);
                CHECK(occluded(source, true) <= (from.grazing ? 1.1 * occluded("summed_area", true) : 0.005));
            }
        }
}
