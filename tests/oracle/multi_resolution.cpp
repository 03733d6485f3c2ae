// SPDX-License-Identifier: MIT
// Occlusion of several resolutions against the equations of Hoang and Low 2010: pictures halved by the middle
// of four texels, an occlusion from near texels in each, and from coarse to fine their greatest and their
// mean. Of layers each is halved with those of the same place in order, and finds in coarser texels the layer
// that goes on with its surface.
#include "abuffer.hpp"
#include "run.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace {

using oracle::lens;
using oracle::picture;
using oracle::settings;
using oracle::surface_fragment;

struct layer {
    glm::dvec3 position, normal;
    double opacity = 1;
};

struct resolution {
    int width, height;
    std::vector<std::vector<layer>> texels; ///< nearest first
    const std::vector<layer>& at(int x, int y) const {
        x = std::clamp(x, 0, width - 1);
        y = std::clamp(y, 0, height - 1);
        return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

resolution whole(const picture& p) {
    resolution all{p.width, p.height, {}};
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
            all.texels.emplace_back();
            if (!p.background(x, y))
                all.texels.back().push_back({p.position(x, y), glm::dvec3(p.normals[p.index(x, y)])});
        }
    return all;
}

/// The layers that an effect keeps, their normals towards the eye.
resolution whole(const picture& p, const std::vector<std::vector<surface_fragment>>& surfaces) {
    resolution all{p.width, p.height, {}};
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
            all.texels.emplace_back();
            for (const surface_fragment& each : surfaces[p.index(x, y)]) {
                glm::dvec3 origin, direction;
                p.ray({x + 0.5, y + 0.5}, origin, direction);
                const glm::dvec3 at = origin + direction * ((-each.depth - origin.z) / direction.z);
                const bool seen = glm::dot(each.normal, p.to_eye(at)) >= 0;
                all.texels.back().push_back(
                    {at, seen ? each.normal : -each.normal, static_cast<double>(each.color >> 24) / 255});
            }
        }
    return all;
}

/// Of four texels the layers: as long as two of them have one more, the next of each, halved. One that is not
/// near in all four leaves those behind it out of step.
std::vector<layer> halved(const std::array<const std::vector<layer>*, 4>& four, double step) {
    std::vector<layer> kept;
    bool in_step = true;
    for (std::size_t i = 0;; ++i) {
        std::vector<layer> there;
        for (const std::vector<layer>* each : four)
            if (i < each->size())
                there.push_back((*each)[i]);
        if (there.size() < 2)
            return kept;
        std::ranges::sort(there, [](const layer& a, const layer& b) { return a.position.z > b.position.z; });
        layer own = there[1];
        in_step &= there.size() == 4 && there[0].position.z - there[3].position.z <= step;
        if (in_step) {
            own.position = (there[1].position + there[2].position) / 2.0;
            own.normal = glm::normalize(there[1].normal + there[2].normal);
            own.opacity = (there[1].opacity + there[2].opacity) / 2;
        }
        kept.push_back(own);
    }
}

resolution halved(const resolution& fine, double step) {
    resolution coarse{std::max(fine.width / 2, 1), std::max(fine.height / 2, 1), {}};
    for (int y = 0; y < coarse.height; ++y)
        for (int x = 0; x < coarse.width; ++x)
            coarse.texels.push_back(halved({&fine.at(2 * x, 2 * y), &fine.at(2 * x + 1, 2 * y),
                                            &fine.at(2 * x, 2 * y + 1), &fine.at(2 * x + 1, 2 * y + 1)},
                                           step));
    return coarse;
}

struct shape {
    int levels, side, reach;
    double step;
};

/// Of the side of a layer that the normal points to, the mean over a square of side x side texels that lie
/// `reach` texels of the resolution around, or the radius; of each the layer that occludes the most.
double occlusion(const picture& p, const settings& s, const shape& how, const resolution& own, int level,
                 int x, int y, const layer& here, glm::dvec3 normal) {
    oracle::receiver r{x, y, x, y, here.position, here.normal, p.to_eye(here.position)};
    glm::dvec3 across, up;
    oracle::axes(p, r, across, up);
    const glm::dvec2 a = oracle::texel_offset(p, r, s.radius * across),
                     b = oracle::texel_offset(p, r, s.radius * up);
    const double scale = std::pow(2, level),
                 limit = std::min(1.0, how.reach * scale / std::sqrt(std::abs(a.x * b.y - a.y * b.x)));
    const glm::dvec2 centre = (glm::dvec2(x, y) + 0.5) * scale;
    double sum = 0, weights = 0;
    for (int row = 0; row < how.side; ++row)
        for (int column = 0; column < how.side; ++column) {
            const double u = 2.0 * column / (how.side - 1) - 1, v = 2.0 * row / (how.side - 1) - 1;
            const glm::dvec2 way = limit * (u * a + v * b);
            const double share = oracle::share_inside(p, centre, way);
            const glm::ivec2 found = glm::clamp(glm::ivec2(glm::floor(centre + way * share)), glm::ivec2(0),
                                                glm::ivec2(p.width - 1, p.height - 1));
            if (level == 0 && found == glm::ivec2(x, y))
                continue;
            weights += share * share;
            const std::vector<layer>& there = own.at(found.x >> level, found.y >> level);
            if (&there == &own.at(x, y))
                continue;
            double most = 0;
            for (const layer& each : there) {
                const glm::dvec3 offset = each.position - here.position;
                const double distance = glm::length(offset);
                if (distance < s.radius)
                    most = std::max(most, each.opacity * (1 - distance * distance / (s.radius * s.radius)) *
                                              std::max(glm::dot(offset, normal) / distance - s.bias, 0.0));
            }
            sum += share * share * most;
        }
    return weights > 0 ? sum / weights : 0;
}

struct occlusions {
    double greatest = 0, mean = 0;
};

/// Of each layer of a texel, of the side that is seen and of the other.
using found_of_texel = std::vector<std::array<occlusions, 2>>;

/// What a resolution and all coarser ones give together for a side of a layer.
occlusions together(const picture& p, const settings& s, const shape& how, const std::vector<resolution>& all,
                    const std::vector<found_of_texel>& of_coarser, int level, int x, int y, const layer& here,
                    std::size_t side) {
    const double own = occlusion(p, s, how, all[static_cast<std::size_t>(level)], level, x, y, here,
                                 side == 0 ? here.normal : -here.normal);
    const auto coarser = static_cast<int>(all.size()) - level - 1;
    if (coarser == 0)
        return {own, own};
    const resolution& next = all[static_cast<std::size_t>(level) + 1];
    double greatest = 0, mean = 0, weights = 0;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            // A texel lies a quarter of a coarse one from the middle of its own, and so 3/4 from the next.
            const int u = std::clamp((x >> 1) + (i ? (x % 2 ? 1 : -1) : 0), 0, next.width - 1),
                      v = std::clamp((y >> 1) + (j ? (y % 2 ? 1 : -1) : 0), 0, next.height - 1);
            const double bilinear = (i ? 0.25 : 0.75) * (j ? 0.25 : 0.75);
            const std::vector<layer>& there = next.at(u, v);
            const auto likeness = [&](const layer& each, double apart) {
                const double of_normal = std::pow((glm::dot(each.normal, here.normal) + 1) / 2, 8);
                return of_normal * std::pow(1 / (1 + std::abs(apart) / s.radius), 16);
            };
            double most = 0;
            std::size_t likest = 0;
            for (std::size_t k = 0; k < there.size(); ++k) {
                const double from_plane = glm::dot(there[k].position - here.position, here.normal);
                if (likeness(there[k], from_plane) > most) {
                    most = likeness(there[k], from_plane);
                    likest = k;
                }
            }
            if (there.empty())
                continue;
            const double weight =
                bilinear * likeness(there[likest], there[likest].position.z - here.position.z);
            const occlusions& found =
                of_coarser[static_cast<std::size_t>(v) * static_cast<std::size_t>(next.width) +
                           static_cast<std::size_t>(u)][likest][side];
            greatest += weight * found.greatest;
            mean += weight * found.mean;
            weights += weight;
        }
    if (weights < 1e-12)
        return {own, own};
    return {std::max(own, greatest / weights), (own + coarser * mean / weights) / (coarser + 1)};
}

/// The occlusion of both sides of each layer of each texel of the picture.
std::vector<std::vector<std::array<double, 2>>> expected_occlusion(const picture& p, const settings& s,
                                                                   const shape& how, resolution finest) {
    std::vector<resolution> all{std::move(finest)};
    while (static_cast<int>(all.size()) < how.levels && std::max(all.back().width, all.back().height) > 1)
        all.push_back(halved(all.back(), how.step * s.radius));
    std::vector<found_of_texel> found;
    for (int level = static_cast<int>(all.size()) - 1; level >= 0; --level) {
        const resolution& own = all[static_cast<std::size_t>(level)];
        std::vector<found_of_texel> here;
        for (int y = 0; y < own.height; ++y)
            for (int x = 0; x < own.width; ++x) {
                here.emplace_back();
                for (const layer& each : own.at(x, y))
                    here.back().push_back({together(p, s, how, all, found, level, x, y, each, 0),
                                           together(p, s, how, all, found, level, x, y, each, 1)});
            }
        found = std::move(here);
    }
    std::vector<std::vector<std::array<double, 2>>> occlusion;
    for (const found_of_texel& texel : found) {
        occlusion.emplace_back();
        for (const std::array<occlusions, 2>& each : texel)
            occlusion.back().push_back({1 - (1 - each[0].greatest) * (1 - each[0].mean),
                                        1 - (1 - each[1].greatest) * (1 - each[1].mean)});
    }
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
        fmt::format("tap_grid:{}/single_layer/hbao_plus/multi_resolution:{}x{}/r32f", side, levels, reach) +
        (kind == lens::orthographic ? "/orthographic" : ""));
    crease::parameters how = oracle::view_parameters(p, composed->view(), radius);
    oracle::set(how, composed->view(), "step", step);
    oracle::set(how, composed->view(), "bias", 0);
    const settings s = oracle::settings_of(how, composed->view());
    const auto all = expected_occlusion(p, s, {levels, side, reach, step}, whole(p));
    const oracle::visibility_image expected = oracle::main_pass(
        p, s, 1, false, [&](const oracle::receiver& r) { return all[p.index(r.x, r.y)][0][0]; });
    oracle::check_within(oracle::compare(oracle::run(p, composed->view(), how), expected), allowed);
}

picture seen(lens kind, unsigned width, unsigned height) {
    picture p;
    p.width = static_cast<int>(width);
    p.height = static_cast<int>(height);
    p.projection = oracle::make_projection(kind, static_cast<double>(width) / height);
    return p;
}

/// An effect of several resolutions over what lists keep of triangles.
struct layers_of_triangles {
    unsigned width, height;
    lens kind = lens::standard;
    std::optional<std::uint32_t> rubbish{};

    std::unique_ptr<oracle::fragment_capture>
    run(const std::string& parts, const oracle::triangles& drawn,
        const oracle::color_table& colors = oracle::every_color()) const {
        auto capture = std::make_unique<oracle::fragment_capture>(
            "tap_grid:6/linked_lists:10x64/hbao_plus/" + parts + "/r32f", width, height, kind, "visibility",
            std::nullopt, rubbish);
        capture->set("radius", 2);
        capture->set("bias", 0);
        capture->draw(drawn, colors);
        return capture;
    }
};

/// The visibility of layers, each by its opacity, and where they are thin of both of its sides.
std::vector<double> expected_visibility(const picture& p, const settings& s, const shape& how,
                                        const resolution& layers, bool thin) {
    const auto occluded = expected_occlusion(p, s, how, layers);
    std::vector<double> visibility;
    for (std::size_t at = 0; at < layers.texels.size(); ++at) {
        double seen = 0, through = 1;
        for (std::size_t i = 0; i < layers.texels[at].size(); ++i) {
            const double alpha = layers.texels[at][i].opacity;
            const auto visible = [&](std::size_t side) {
                return std::pow(std::clamp(1 - s.strength * occluded[at][i][side], 0.0, 1.0), s.exponent);
            };
            seen += through * alpha * (thin ? alpha * visible(0) + (1 - alpha) * visible(1) : visible(0));
            through *= 1 - alpha;
        }
        visibility.push_back(seen + through);
    }
    return visibility;
}

void check_layers(const layers_of_triangles& size, const oracle::triangles& drawn, bool thin) {
    CAPTURE(size.width);
    CAPTURE(thin);
    const auto made =
        size.run(thin ? "thin_layers/multi_resolution:3x5" : "every_layer/multi_resolution:3x5", drawn);
    const settings s = oracle::settings_of(made->parameters(), made->effect());
    const picture p = seen(size.kind, size.width, size.height);
    const std::vector<double> expected =
        expected_visibility(p, s, {3, 6, 5, 0.25}, whole(p, made->surfaces()), thin);
    const std::vector<float> found = made->runner().download("visibility");
    CHECK(*std::ranges::min_element(found) < 0.8f);
    oracle::check_within(oracle::compare(found, expected, p.width), oracle::of_rounding);
}

double mean_difference(const std::vector<float>& a, const std::vector<float>& b) {
    REQUIRE(a.size() == b.size());
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::abs(double{a[i]} - double{b[i]});
    return sum / static_cast<double>(a.size());
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
    for (float visibility : oracle::run(p, "tap_grid:6/single_layer/hbao_plus/multi_resolution:4", 3))
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
    CHECK(mean("tap_grid:6/single_layer/hbao_plus/multi_resolution:5") <
          mean("tap_grid:6/single_layer/hbao_plus/multi_resolution:2") - 0.01);
}

TEST_CASE(
    "each layer of lists in several resolutions: halved by its place in order, and found again by likeness") {
    const oracle::triangles drawn = oracle::soup(30, 3);
    check_layers({40, 24}, drawn, false);
    check_layers({40, 24}, drawn, true);
    check_layers({37, 23}, drawn, false); // halves with odd sides
    check_layers({40, 24, lens::anamorphic}, drawn, false);
    check_layers({40, 24, lens::anamorphic}, drawn, true);
    for (const std::uint32_t rubbish : {0x7fc00000u, ~0u}) // what memory held before
        check_layers({24, 16, lens::standard, rubbish}, drawn, true);
}

TEST_CASE("a wall behind the edge of glass is open, whatever is close behind the wall") {
    oracle::triangles drawn;
    oracle::add_quad(drawn, {-9, -9, -3}, {9, 0, 0}, {3, 18, 0}); // clear glass, whose edge is slanted
    oracle::add_quad(drawn, {-9, -9, -4.5f}, {18, 0, 0}, {0, 18, 0});
    oracle::add_quad(drawn, {-9, -9, -4.9f}, {18, 0, 0}, {0, 18, 0}); // nearer to the wall than a step
    oracle::color_table colors;
    colors.fill(0xff808080u);
    colors[0] = colors[1] = 0x01808080u;
    for (const std::string receivers : {"every_layer", "thin_layers"}) {
        CAPTURE(receivers);
        const auto made = layers_of_triangles{40, 24}.run(receivers + "/multi_resolution:3x5", drawn, colors);
        CHECK(std::ranges::min(made->runner().download("visibility")) > 0.98f);
    }
}

TEST_CASE("nodes of a compression are layers of all resolutions; receivers of all layers have all of them") {
    const oracle::triangles drawn = oracle::soup(16, 4);
    const layers_of_triangles size{40, 24};
    for (const std::string receivers : {"every_layer", "thin_layers"}) {
        CAPTURE(receivers);
        const std::string parts = receivers + "/multi_resolution:3x5";
        const std::vector<float> all = size.run(parts, drawn)->runner().download("visibility");
        REQUIRE(*std::ranges::min_element(all) < 0.8f);
        for (const std::string compression : {"/compressed:8", "/compressed_occluders:8"}) {
            CAPTURE(compression);
            const double apart =
                mean_difference(size.run(parts + compression, drawn)->runner().download("visibility"), all);
            CHECK(apart < 0.001); // depths are halves
            CHECK(apart > 0);
        }
        const auto four = size.run(parts + "/compressed:2", drawn);
        CHECK(mean_difference(four->runner().download("visibility"), all) > 0.001);
    }
}

TEST_CASE("the nearest layer alone, where it is opaque, gives what a single layer gives") {
    oracle::color_table opaque;
    opaque.fill(0xff808080u);
    const layers_of_triangles size{40, 24};
    const oracle::triangles drawn = oracle::soup(40, 9);
    const picture p = seen(lens::standard, 40, 24);
    oracle::fragment_capture nearest(
        "tap_grid:6/linked_lists:1x64/hbao_plus/every_layer/multi_resolution/r32f", size.width, size.height,
        lens::standard, "visibility");
    nearest.set("radius", 2);
    nearest.draw(drawn, opaque);
    const resolution layers = whole(p, nearest.surfaces());
    std::vector<float> depth, normals;
    for (const std::vector<layer>& texel : layers.texels) {
        REQUIRE(texel.size() <= 1);
        const layer own = texel.empty() ? layer{{}, {0, 0, 1}} : texel[0];
        depth.push_back(texel.empty() ? 0 : static_cast<float>(-own.position.z));
        for (int i = 0; i < 3; ++i)
            normals.push_back(static_cast<float>(own.normal[i]));
        normals.push_back(0);
    }
    const auto single =
        oracle::compose("tap_grid:6/single_layer/hbao_plus/multi_resolution/linear_depth/r32f");
    crease::vulkan::runner runner(oracle::device(), single->view(), size.width, size.height);
    runner.upload("depth", depth);
    runner.upload("normal", normals);
    runner.run(nearest.parameters());
    const std::vector<float> expected = runner.download("visibility");
    const std::vector<float> found = nearest.runner().download("visibility");
    CHECK(*std::ranges::min_element(found) < 0.8f);
    CHECK(mean_difference(found, expected) < 1e-5);
}
