// SPDX-License-Identifier: MIT
// Occlusion of several resolutions against the equations of Hoang and Low 2010: pictures halved by the middle
// of four texels, an occlusion from near texels in each, and from coarse to fine their greatest and their
// mean.
#include "run.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace {

using oracle::lens;
using oracle::picture;
using oracle::settings;

struct texel {
    glm::dvec3 position{0, 0, -1e15}, normal{0, 0, 1};
    bool there() const { return position.z > -1e14; }
};

struct resolution {
    int width, height;
    std::vector<texel> texels;
    const texel& at(int x, int y) const {
        x = std::clamp(x, 0, width - 1);
        y = std::clamp(y, 0, height - 1);
        return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

resolution whole(const picture& p) {
    resolution all{p.width, p.height, {}};
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
            all.texels.push_back(
                p.background(x, y) ? texel{} : texel{p.position(x, y), glm::dvec3(p.normals[p.index(x, y)])});
    return all;
}

resolution halved(const resolution& fine, double step) {
    resolution coarse{std::max(fine.width / 2, 1), std::max(fine.height / 2, 1), {}};
    for (int y = 0; y < coarse.height; ++y)
        for (int x = 0; x < coarse.width; ++x) {
            std::array<texel, 4> four{fine.at(2 * x, 2 * y), fine.at(2 * x + 1, 2 * y),
                                      fine.at(2 * x, 2 * y + 1), fine.at(2 * x + 1, 2 * y + 1)};
            std::ranges::sort(four,
                              [](const texel& a, const texel& b) { return a.position.z > b.position.z; });
            texel own = four[1];
            if (four[3].there() && four[0].position.z - four[3].position.z <= step) {
                own.position = (four[1].position + four[2].position) / 2.0;
                own.normal = glm::normalize(four[1].normal + four[2].normal);
            }
            coarse.texels.push_back(own);
        }
    return coarse;
}

/// The mean over a square of side x side texels that lie `reach` texels of the resolution around, or the
/// radius.
double occlusion(const picture& p, const settings& s, const std::vector<resolution>& all, int level, int x,
                 int y, int side, int reach) {
    const resolution& own = all[static_cast<std::size_t>(level)];
    const texel& here = own.at(x, y);
    oracle::receiver r{x, y, x, y, here.position, here.normal, p.to_eye(here.position)};
    glm::dvec3 across, up;
    oracle::axes(p, r, across, up);
    const glm::dvec2 a = oracle::texel_offset(p, r, s.radius * across),
                     b = oracle::texel_offset(p, r, s.radius * up);
    const double scale = std::pow(2, level),
                 limit = std::min(1.0, reach * scale / std::sqrt(std::abs(a.x * b.y - a.y * b.x)));
    const glm::dvec2 centre = (glm::dvec2(x, y) + 0.5) * scale;
    double sum = 0, weights = 0;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const double u = 2.0 * column / (side - 1) - 1, v = 2.0 * row / (side - 1) - 1;
            const glm::dvec2 way = limit * (u * a + v * b);
            const double share = oracle::share_inside(p, centre, way);
            const glm::ivec2 found = glm::clamp(glm::ivec2(glm::floor(centre + way * share)), glm::ivec2(0),
                                                glm::ivec2(p.width - 1, p.height - 1));
            if (level == 0 && found == glm::ivec2(x, y))
                continue;
            weights += share * share;
            const texel& there = own.at(found.x >> level, found.y >> level);
            const glm::dvec3 offset = there.position - here.position;
            const double distance = glm::length(offset);
            if (&there != &here && distance < s.radius)
                sum += share * share * (1 - distance * distance / (s.radius * s.radius)) *
                       std::max(glm::dot(offset, here.normal) / distance - s.bias, 0.0);
        }
    return weights > 0 ? sum / weights : 0;
}

struct occlusions {
    double greatest = 0, mean = 0;
};

/// What a resolution and all coarser ones give together.
occlusions together(const picture& p, const settings& s, const std::vector<resolution>& all,
                    const std::vector<occlusions>& of_coarser, int level, int x, int y, int side, int reach) {
    const double own = occlusion(p, s, all, level, x, y, side, reach);
    const auto coarser = static_cast<int>(all.size()) - level - 1;
    if (coarser == 0)
        return {own, own};
    const texel& here = all[static_cast<std::size_t>(level)].at(x, y);
    const resolution& next = all[static_cast<std::size_t>(level) + 1];
    double greatest = 0, mean = 0, weights = 0;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            // A texel lies a quarter of a coarse one from the middle of its own, and so 3/4 from the next.
            const int u = std::clamp((x >> 1) + (i ? (x % 2 ? 1 : -1) : 0), 0, next.width - 1),
                      v = std::clamp((y >> 1) + (j ? (y % 2 ? 1 : -1) : 0), 0, next.height - 1);
            const texel& there = next.at(u, v);
            const double bilinear = (i ? 0.25 : 0.75) * (j ? 0.25 : 0.75);
            const double of_normal = std::pow((glm::dot(there.normal, here.normal) + 1) / 2, 8);
            const double apart = std::abs(there.position.z - here.position.z) / s.radius;
            const double weight = bilinear * of_normal * std::pow(1 / (1 + apart), 16);
            const occlusions& found =
                of_coarser[static_cast<std::size_t>(v) * static_cast<std::size_t>(next.width) +
                           static_cast<std::size_t>(u)];
            greatest += weight * found.greatest;
            mean += weight * found.mean;
            weights += weight;
        }
    if (weights < 1e-12)
        return {own, own};
    return {std::max(own, greatest / weights), (own + coarser * mean / weights) / (coarser + 1)};
}

/// The occlusion of each texel of the picture.
std::vector<double> expected_occlusion(const picture& p, const settings& s, int levels, int side, int reach,
                                       double step) {
    std::vector<resolution> all{whole(p)};
    while (static_cast<int>(all.size()) < levels && std::max(all.back().width, all.back().height) > 1)
        all.push_back(halved(all.back(), step * s.radius));
    std::vector<occlusions> found;
    for (int level = static_cast<int>(all.size()) - 1; level >= 0; --level) {
        const resolution& own = all[static_cast<std::size_t>(level)];
        std::vector<occlusions> here;
        for (int y = 0; y < own.height; ++y)
            for (int x = 0; x < own.width; ++x)
                here.push_back(own.at(x, y).there() ? together(p, s, all, found, level, x, y, side, reach)
                                                    : occlusions{});
        found = std::move(here);
    }
    std::vector<double> occlusion;
    for (const occlusions& each : found)
        occlusion.push_back(1 - (1 - each.greatest) * (1 - each.mean));
    return occlusion;
}

void check(lens kind, int width, int height, int levels, int side, int reach, double radius, double step,
           const oracle::difference& allowed = oracle::of_rounding) {
    CAPTURE(width);
    CAPTURE(levels);
    CAPTURE(side);
    CAPTURE(radius);
    const picture p = oracle::draw(oracle::still_life(), kind, width, height);
    const auto composed = oracle::compose(
        fmt::format("tap_grid:{}/multi_resolution:{}x{}/hbao_plus/r32f", side, levels, reach) +
        (kind == lens::orthographic ? "/orthographic" : ""));
    crease::parameters how = oracle::view_parameters(p, composed->view(), radius);
    oracle::set(how, composed->view(), "step", step);
    oracle::set(how, composed->view(), "bias", 0);
    const settings s = oracle::settings_of(how, composed->view());
    const std::vector<double> all = expected_occlusion(p, s, levels, side, reach, step);
    const oracle::visibility_image expected =
        oracle::main_pass(p, s, 1, false, [&](const oracle::receiver& r) { return all[p.index(r.x, r.y)]; });
    oracle::check_within(oracle::compare(oracle::run(p, composed->view(), how), expected), allowed);
}

}

TEST_CASE(
    "several resolutions together give the greatest and the mean of their occlusions, from coarse to fine") {
    check(lens::standard, 96, 64, 4, 6, 5, 1.2, 0.25);
    check(lens::reversed, 97, 61, 3, 5, 4, 0.5, 0.1); // halves with odd sides
    check(lens::orthographic, 80, 50, 2, 6, 5, 0.8, 0.25);
    check(lens::standard, 65, 33, 6, 4, 3, 2, 0.5);
    // Fewer resolutions than asked for; a tap that rounding moves to another texel counts for a whole corner.
    check(lens::standard, 9, 5, 6, 6, 5, 2, 0.25,
          {.typical = 0.06, .mean = 0.007, .border = 0.012, .most = 0.1, .bias = 0.007});
}

TEST_CASE("a plane is unoccluded in every resolution") {
    const picture p =
        oracle::draw({{oracle::surface::kind::plane, {0, -1, -3}, glm::normalize(glm::dvec3(0.3, 1, 0.2))}},
                     lens::standard, 161, 97);
    for (float visibility : oracle::run(p, "tap_grid:6/multi_resolution:4/hbao_plus", 3))
        CHECK(visibility > 0.995f);
}

TEST_CASE("coarser resolutions see farther: a corner is darker away from its edge") {
    const picture p = oracle::draw({{oracle::surface::kind::plane, {0, -1, 0}, {0, 1, 0}},
                                    {oracle::surface::kind::plane, {0, 0, -4}, {0, 0, 1}}},
                                   lens::standard, 160, 120);
    const auto mean = [&](const std::string& recipe) {
        double sum = 0;
        for (float visibility : oracle::run(p, recipe, 1.5))
            sum += visibility;
        return sum / (160 * 120);
    };
    CHECK(mean("tap_grid:6/multi_resolution:5/hbao_plus") <
          mean("tap_grid:6/multi_resolution:2/hbao_plus") - 0.01);
}
