// SPDX-License-Identifier: MIT
// Occlusion by opacity, of every layer: a-buffer-ssao 2013, III, equations (1) to (4).
#include "abuffer.hpp"
#include "slices.hpp"
#include "volume.hpp"

#include <doctest/doctest.h>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace {

using oracle::layers_at;
using oracle::lens;
using oracle::picture;
using oracle::receiver;
using oracle::seen_layer;
using oracle::settings;
using oracle::surface_fragment;
using oracle::tap;
using surfaces = std::vector<std::vector<surface_fragment>>;

constexpr int width = 40, height = 24;
constexpr double radius = 2;

picture seen(lens kind = lens::standard) {
    picture p;
    p.width = width;
    p.height = height;
    p.projection = oracle::make_projection(kind, static_cast<double>(width) / height);
    return p;
}

double opacity_of(const surface_fragment& s) {
    return static_cast<double>(s.color >> 24) / 255;
}

glm::dvec3 position_of(const picture& p, int x, int y, const surface_fragment& s) {
    glm::dvec3 origin, direction;
    p.ray({x + 0.5, y + 0.5}, origin, direction);
    return origin + direction * ((-s.depth - origin.z) / direction.z);
}

/// The occlusion of a receiver by the layers at its taps, each by its opacity.
using occlusion_of =
    std::function<double(const picture& p, const receiver& r, const settings& s, const layers_at& layers)>;

double hbao_plus(const picture& p, const receiver& r, const settings& s, const layers_at& layers) {
    double occlusion = 0, weights = 0;
    for (const std::vector<tap>& direction : oracle::directions(p, r, s, 5, 4))
        for (const tap& t : direction) {
            double most = 0;
            for (const seen_layer& layer : layers(t.x, t.y)) {
                const glm::dvec3 v = layer.position - r.position;
                const double length = glm::length(v);
                if (length < s.radius)
                    most = std::max(most, layer.opacity * (1 - length * length / (s.radius * s.radius)) *
                                              std::max(glm::dot(v, r.normal) / length - s.bias, 0.0));
            }
            occlusion += t.weight * most;
            weights += t.weight;
        }
    return weights > 0 ? occlusion / weights : 0;
}

/// A layer reaches that share of its height over the beginning of the horizon.
double hbao(const picture& p, const receiver& r, const settings& s, const layers_at& layers) {
    double occlusion = 0;
    const std::vector<std::vector<tap>> taps = oracle::directions(p, r, s, 5, 4);
    for (const std::vector<tap>& direction : taps) {
        if (direction.empty())
            continue;
        const double tangent = oracle::tangent_angle(r, direction[0].azimuth);
        const double start = std::sin(std::min(tangent + s.bias, glm::half_pi<double>())) - std::sin(tangent);
        double highest = start;
        for (const tap& t : direction) {
            double most = 0, horizon = highest;
            for (const seen_layer& layer : layers(t.x, t.y)) {
                const glm::dvec3 v = layer.position - r.position;
                const double length = glm::length(v), above = oracle::rise_over_tangent(r, v);
                const double reached = start + layer.opacity * (above - start);
                const double occludes = (1 - length * length / (s.radius * s.radius)) * (reached - highest);
                if (above > highest && length < s.radius && glm::dot(v, r.normal) / length > s.threshold &&
                    occludes > most) {
                    most = occludes;
                    horizon = reached;
                }
            }
            occlusion += most;
            highest = horizon;
        }
    }
    return occlusion / static_cast<double>(taps.size());
}

/// How much nearer a position is than the receiver to the eye that looks at it.
double before(const receiver& r, glm::dvec3 position) {
    return r.to_eye.z < 0 ? r.position.z - position.z : position.z - r.position.z;
}

bool is_close_to_plane(const receiver& r, const settings& s, glm::dvec3 point) {
    return std::abs(glm::dot(point - r.position, r.normal)) <= s.bias * std::min(s.radius, -r.position.z);
}

/// What a layer lets through of a point is open.
double ssao(const picture& p, const receiver& r, const settings& s, const layers_at& layers) {
    double occluded = 0, points = 0;
    const std::vector<tap> taps = oracle::hemisphere_points(p, r, s, 12)[0];
    for (const tap& t : taps) {
        if (is_close_to_plane(r, s, t.point) || glm::dot(t.point - r.position, r.normal) < 0)
            continue;
        const std::vector<seen_layer> there = layers(t.x, t.y);
        double most = 0, known = there.empty() ? 1 : 0;
        for (const seen_layer& layer : there) {
            if (before(r, layer.position) < before(r, t.point)) {
                known = most > 0 ? known : 1;
                continue;
            }
            const double x = std::clamp(2 - 2 * before(r, layer.position) / s.radius, 0.0, 1.0);
            const double in_range = x * x * (3 - 2 * x);
            if (layer.opacity * in_range > most) {
                most = layer.opacity * in_range;
                known = 1 - layer.opacity + most;
            }
        }
        occluded += most;
        points += known;
    }
    return occluded / std::max(points, 1.0);
}

/// How much of what the plane leaves empty a layer fills, and how it counts.
double filled_over_plane(const receiver& r, const settings& s, const seen_layer& layer, double filled,
                         double under) {
    const double beyond = std::max(before(r, layer.position) - s.radius, 0.0);
    return layer.opacity * (filled - under) * (1 - std::min(beyond / (s.falloff * s.radius), 1.0));
}

double point_volume(const picture& p, const receiver& r, const settings& s, const layers_at& layers) {
    double more = 0, empty = 0;
    for (const tap& t : oracle::sphere_points(p, r, s, 12)) {
        if (is_close_to_plane(r, s, t.point))
            continue;
        const double under = glm::dot(t.point - r.position, r.normal) < 0 ? 1 : 0;
        const std::vector<seen_layer> there = layers(t.x, t.y);
        double most = there.empty() ? -under : -1;
        for (const seen_layer& layer : there)
            most = std::max(
                most, filled_over_plane(r, s, layer, before(r, layer.position) > before(r, t.point), under));
        more += most;
        empty += 1 - under;
    }
    return std::max(more / std::max(empty, 1.0), 0.0);
}

double line_volume(const picture& p, const receiver& r, const settings& s, const layers_at& layers) {
    double more = 0, empty = 0;
    for (const oracle::line& l : oracle::disk_lines(p, r, s, 12, false)) {
        if (!(l.far > l.near))
            continue;
        const std::vector<seen_layer> there = layers(l.x, l.y);
        double most = there.empty() ? -l.under : -l.far;
        for (const seen_layer& layer : there) {
            const double depth = std::clamp(-layer.position.z, l.near, l.far);
            most = std::max(most, filled_over_plane(
                                      r, s, layer, r.to_eye.z < 0 ? depth - l.near : l.far - depth, l.under));
        }
        more += l.weight * most;
        empty += l.weight * (l.far - l.near - l.under);
    }
    return std::max(more / std::max(empty, 0.1 * s.radius), 0.0);
}

double gtao(const picture& p, const receiver& r, const settings& s, const layers_at& layers) {
    return oracle::gtao(r, s, oracle::slices(p, r, s, 3, 4), layers);
}

double visibility_bitmask(const picture& p, const receiver& r, const settings& s, const layers_at& layers) {
    return oracle::visibility_bitmask(p, r, s, oracle::slices(p, r, s, 3, 4), layers);
}

/// What is seen of every layer, by the oracle.
struct seen_layers {
    std::vector<double> visibility;
    std::vector<double> integrated, separated; ///< colours times opacity, and opacity
};

seen_layers expected_of(const surfaces& layers, const settings& s, bool thin, const occlusion_of& estimate) {
    const picture p = seen();
    const layers_at layers_of_texel = [&](int x, int y) {
        std::vector<seen_layer> there;
        for (const surface_fragment& each : layers[p.index(x, y)])
            there.push_back({position_of(p, x, y, each), opacity_of(each)});
        return there;
    };
    seen_layers all;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double occluded = 0, through = 1;
            glm::dvec3 darkened(0), blended(0);
            for (const surface_fragment& layer : layers[p.index(x, y)]) {
                receiver r{x, y, x, y, position_of(p, x, y, layer), layer.normal, {}};
                r.to_eye = p.to_eye(r.position);
                const bool front = glm::dot(layer.normal, r.to_eye) > 0;
                const auto occlusion = [&](glm::dvec3 normal) { // from the side that it points to
                    receiver side = r;
                    side.normal = normal;
                    if (glm::dot(normal, r.to_eye) < 0)
                        side.to_eye = -r.to_eye;
                    const double visible =
                        std::pow(std::clamp(1 - s.strength * estimate(p, side, s, layers_of_texel), 0.0, 1.0),
                                 s.exponent);
                    return 1 - visible;
                };
                const double alpha = opacity_of(layer);
                double own = occlusion(front ? layer.normal : -layer.normal);
                if (thin) {
                    const double weight = front ? alpha : 1 - alpha; // (3)
                    own = weight * occlusion(layer.normal) + (1 - weight) * occlusion(-layer.normal);
                }
                const glm::dvec3 color(layer.color & 255u, layer.color >> 8 & 255u, layer.color >> 16 & 255u);
                darkened += through * alpha * (1 - own) * color / 255.0;
                blended += through * alpha * color / 255.0;
                occluded += through * alpha * own;
                through *= 1 - alpha;
            }
            all.visibility.push_back(1 - occluded);
            blended *= 1 - occluded;
            all.integrated.insert(all.integrated.end(), {darkened.r, darkened.g, darkened.b, 1 - through});
            all.separated.insert(all.separated.end(), {blended.r, blended.g, blended.b, 1 - through});
        }
    return all;
}

struct case_of {
    std::string sampler, estimator;
    occlusion_of occlusion;
    oracle::difference allowed = oracle::of_rounding;
};

/// The edges of a layer are rounded to sectors of 32; as many of all are hidden as its opacity rounds to,
/// spread from the eye on, so that fewer are at the tangent plane. At most half as much again as was
/// measured.
constexpr oracle::difference of_sectors{
    .typical = 0.04, .mean = 0.012, .border = 0.012, .most = 0.1, .bias = 0.011};

const case_of cases[] = {{"directions:5x4", "hbao_plus", hbao_plus},
                         {"directions:5x4", "hbao", hbao},
                         {"slices:3x4", "gtao", gtao},
                         {"slices:3x4", "visibility_bitmask", visibility_bitmask, of_sectors},
                         {"hemisphere_points:12", "ssao", ssao},
                         {"sphere_points:12", "point_volume", point_volume},
                         {"sphere_lines:12", "line_volume", line_volume}};

std::unique_ptr<oracle::fragment_capture> run(const std::string& recipe, const oracle::triangles& drawn,
                                              const std::array<std::uint32_t, 16>& colors) {
    auto capture =
        std::make_unique<oracle::fragment_capture>(recipe, width, height, lens::standard, "visibility");
    capture->set("radius", radius);
    capture->draw(drawn, colors);
    return capture;
}

/// Sixteen times a colour of this opacity.
std::array<std::uint32_t, 16> all_of(std::uint32_t opacity) {
    std::array<std::uint32_t, 16> colors;
    colors.fill(0x808080u | opacity << 24);
    return colors;
}

/// How open the inner side of a wall is, which is half transparent and open on its outer side, before what is
/// opaque; within a radius of 1. By the equations (2) and (3) the picture has it beside what is open of the
/// outer side.
class half_transparent_wall {
public:
    explicit half_transparent_wall(const std::string& parts)
        : outer_(captured(parts + "/every_layer")), both_(captured(parts + "/thin_layers")) {}
    double open_inside(const oracle::triangles& behind) {
        constexpr double alpha = 128 / 255.0;
        return 1 - (seen(*outer_, behind) - seen(*both_, behind)) / (alpha * (1 - alpha));
    }
    settings set() const { return oracle::settings_of(both_->parameters(), both_->effect()); }

private:
    using capture = std::unique_ptr<oracle::fragment_capture>;
    static constexpr unsigned across = 160, down = 96, middle = 32;

    static capture captured(const std::string& parts) {
        auto made = std::make_unique<oracle::fragment_capture>(parts + "/r32f", across, down, lens::standard,
                                                               "visibility");
        made->set("radius", 1);
        return made;
    }

    /// The mean of the picture's middle.
    static double seen(oracle::fragment_capture& by, const oracle::triangles& behind) {
        oracle::triangles drawn = oracle::wall(3);
        drawn.insert(drawn.end(), behind.begin(), behind.end());
        std::array<std::uint32_t, 16> colors = all_of(255);
        colors[0] = colors[1] = 0x80808080u;
        by.draw(drawn, colors);
        const std::vector<float> all = by.runner().download("visibility");
        double sum = 0;
        for (unsigned y = (down - middle) / 2; y < (down + middle) / 2; ++y)
            for (unsigned x = (across - middle) / 2; x < (across + middle) / 2; ++x)
                sum += double{all[y * across + x]};
        return sum / (middle * middle);
    }

    capture outer_, both_;
};

/// The visibility of the first of the surfaces of each texel alone, where all that is drawn has one opacity.
std::vector<float> first_alone(const std::string& parts, const surfaces& layers,
                               const oracle::triangles& drawn, std::uint32_t alpha = 255) {
    std::vector<float> depth, normals;
    for (std::size_t at = 0; at < layers.size(); ++at) {
        const picture p = seen();
        const auto x = static_cast<int>(at) % width, y = static_cast<int>(at) / width;
        glm::dvec3 normal(0, 0, 1);
        if (!layers[at].empty()) {
            normal = layers[at][0].normal;
            if (glm::dot(normal, p.to_eye(position_of(p, x, y, layers[at][0]))) < 0)
                normal = -normal;
        }
        depth.push_back(layers[at].empty() ? 0 : static_cast<float>(layers[at][0].depth));
        for (int i = 0; i < 3; ++i)
            normals.push_back(static_cast<float>(normal[i]));
        normals.push_back(0);
    }
    oracle::fragment_capture first(parts + "/r32f", width, height, lens::standard, "visibility", {}, {},
                                   "given_normals");
    first.set("radius", radius);
    first.runner().upload("depth", depth);
    first.runner().upload("normal", normals);
    first.draw(drawn, all_of(alpha));
    return first.runner().download("visibility");
}

}

TEST_CASE("every layer against the oracle: occlusion by opacity, blended front to back") {
    const oracle::triangles drawn = oracle::soup(40, 3);
    for (const case_of& each : cases)
        for (const bool thin : {false, true}) {
            CAPTURE(each.estimator);
            CAPTURE(thin);
            const auto made = run(each.sampler + "/linked_lists:32x64/" + each.estimator +
                                      (thin ? "/thin_layers" : "/every_layer") + "/r32f",
                                  drawn, oracle::every_color());
            settings s = oracle::settings_of(made->parameters(), made->effect());
            const std::vector<double> expected =
                expected_of(made->surfaces(), s, thin, each.occlusion).visibility;
            const std::vector<float> found = made->runner().download("visibility");
            CHECK(*std::ranges::min_element(found) < 0.8f);
            oracle::check_within(oracle::compare(found, expected, width), each.allowed);
        }
}

TEST_CASE("opacity 1 everywhere is the occlusion of the first surface by all layers") {
    const oracle::triangles drawn = oracle::soup(40, 9);
    for (const std::string parts :
         {"directions:5x4/linked_lists:32x64/hbao", "directions:5x4/linked_lists:32x64/hbao_plus",
          "directions:5x4/dual_peeled_layers:16/hbao", "directions:5x4/dual_peeled_layers:3/hbao_plus",
          "directions:5x4/static_and_dynamic_layers/hbao", "slices:3x4/linked_lists:32x64/gtao",
          "slices:3x4/linked_lists:32x64/visibility_bitmask",
          "slices:4x8/linked_lists:32x64/cosine_bitmask:0x0",
          "slices:4x8/linked_lists:32x64/cosine_bitmask:1x1", "slices:4x8/linked_lists:3x64/cosine_bitmask",
          "hemisphere_points:12/linked_lists:32x64/ssao", "sphere_points:12/linked_lists:32x64/point_volume",
          "sphere_lines:12/linked_lists:32x64/line_volume"}) {
        CAPTURE(parts);
        const auto of_layers = run(parts + "/every_layer/r32f", drawn, all_of(255));
        const std::vector<float> expected = first_alone(parts, of_layers->surfaces(), drawn);
        oracle::check_within(oracle::compare(of_layers->runner().download("visibility"),
                                             std::vector<double>(expected.begin(), expected.end()), width),
                             oracle::of_rounding);
    }
}

TEST_CASE("nodes of a compression occlude the first surface by their opacity in every resolution") {
    const oracle::triangles drawn = oracle::soup(16, 4);
    const std::string parts = "tap_grid:6/linked_lists:16x64/hbao_plus/multi_resolution:3x5";
    const surfaces layers = run(parts + "/every_layer/r32f", drawn, all_of(255))->surfaces();
    const std::vector<float> all = first_alone(parts, layers, drawn),
                             nodes = first_alone(parts + "/compressed:8", layers, drawn),
                             none = first_alone(parts + "/compressed:8", layers, drawn, 0);
    double apart = 0;
    for (std::size_t at = 0; at < all.size(); ++at)
        apart += std::abs(double{nodes[at]} - double{all[at]}) / static_cast<double>(all.size());
    CHECK(apart < 0.001); // depths are halves
    CHECK(*std::ranges::min_element(all) < 0.8f);
    CHECK(*std::ranges::min_element(none) == 1);
}

TEST_CASE("opacity 0 neither casts nor receives") {
    const oracle::triangles some = oracle::soup(20, 9), others = oracle::soup(20, 10);
    oracle::triangles both;
    for (std::size_t t = 0; t < some.size(); t += 3)
        for (const oracle::triangles* each : {&some, &others})
            both.insert(both.end(), each->begin() + static_cast<std::ptrdiff_t>(t),
                        each->begin() + static_cast<std::ptrdiff_t>(t) + 3);
    std::array<std::uint32_t, 16> colors = all_of(150);
    for (std::size_t i = 1; i < colors.size(); i += 2)
        colors[i] &= 0xffffffu;
    for (const std::string recipe :
         {"directions:5x4/linked_lists:16x64/hbao/thin_layers/r32f",
          "directions:5x4/dual_peeled_layers:16/hbao/thin_layers/r32f",
          "directions:5x4/dual_peeled_layers:4/hbao/thin_layers/r32f",
          "directions:5x4/static_and_dynamic_layers/hbao/thin_layers/r32f",
          "tap_grid:6/linked_lists:16x64/hbao_plus/thin_layers/multi_resolution/r32f"}) {
        CAPTURE(recipe);
        const auto alone = run(recipe, some, all_of(150)), beside = run(recipe, both, colors);
        CHECK(beside->runner().download("visibility") == alone->runner().download("visibility"));
        CHECK(beside->runner().download("visibility") !=
              run(recipe, both, all_of(150))->runner().download("visibility"));
    }
}

TEST_CASE("the more opaque an occluder, the less visible what it stands before") {
    oracle::triangles drawn = oracle::wall(5);
    oracle::add_quad(drawn, {-1, -0.8f, -4.2f}, {1.2f, 0, 0}, {0, 1.6f, 0});
    for (const std::string parts :
         {"directions:8x8/linked_lists:4x8/hbao", "directions:8x8/linked_lists:4x8/hbao_plus",
          "slices:8x8/linked_lists:4x8/gtao", "slices:16x8/linked_lists:4x8/visibility_bitmask",
          "half_directions:16x8/linked_lists:4x8/cosine_bitmask:0x0",
          "half_directions:16x8/linked_lists:4x8/cosine_bitmask:1x0",
          "hemisphere_points:32/linked_lists:4x8/ssao", "sphere_points:32/linked_lists:4x8/point_volume",
          "sphere_lines:32/linked_lists:4x8/line_volume"}) {
        CAPTURE(parts);
        oracle::fragment_capture capture(parts + "/every_layer/r32f", width, height, lens::standard,
                                         "visibility");
        capture.set("radius", radius);
        std::vector<std::vector<float>> pictures;
        std::vector<double> occluded;
        std::vector<bool> wall; // where nothing stands before it
        constexpr std::uint32_t opacities[] = {1, 32, 64, 100, 128, 180, 220, 254, 255};
        for (std::uint32_t opacity : opacities) {
            std::array<std::uint32_t, 16> colors = all_of(255);
            colors[2] = colors[3] = 0x808080u | opacity << 24;
            capture.draw(drawn, colors);
            pictures.push_back(capture.runner().download("visibility"));
            if (wall.empty())
                for (const std::vector<surface_fragment>& list : capture.surfaces())
                    wall.push_back(list.size() == 1);
            occluded.push_back(0);
            for (std::size_t at = 0; at < wall.size(); ++at)
                occluded.back() += wall[at] ? 1 - double{pictures.back()[at]} : 0;
        }
        REQUIRE(std::ranges::count(wall, true) > width * height / 2);
        REQUIRE(occluded.back() > 1);
        std::size_t brighter = 0;
        for (std::size_t i = 1; i < pictures.size(); ++i)
            for (std::size_t at = 0; at < wall.size(); ++at)
                brighter += wall[at] && pictures[i][at] > pictures[i - 1][at] + 1e-5f;
        CHECK(brighter == 0);
        for (std::size_t i = 0; i < occluded.size(); ++i) {
            CAPTURE(opacities[i]);
            CAPTURE(occluded[i] / occluded.back());
            CHECK(std::abs(occluded[i] / occluded.back() - opacities[i] / 255.0) < 0.1);
        }
    }
}

TEST_CASE(
    "layers are blended in order, their colours darkened by their own visibility or by the blended one") {
    const oracle::triangles drawn = oracle::soup(40, 3);
    const std::string parts = "directions:5x4/linked_lists:32x64/hbao_plus/";
    const auto integrated = run(parts + "composite:0/r32f", drawn, oracle::every_color()),
               separated = run(parts + "composite:1/r32f", drawn, oracle::every_color());
    const settings s = oracle::settings_of(integrated->parameters(), integrated->effect());
    const seen_layers expected = expected_of(integrated->surfaces(), s, false, hbao_plus);
    const std::vector<float> one = integrated->runner().download("color"),
                             other = separated->runner().download("color");
    CHECK(integrated->runner().download("visibility") == separated->runner().download("visibility"));
    for (const auto& [found, wanted] :
         {std::pair{&one, &expected.integrated}, {&other, &expected.separated}}) {
        REQUIRE(found->size() == wanted->size());
        std::size_t apart = 0;
        double mean = 0;
        for (std::size_t i = 0; i < found->size(); ++i) {
            const double d = std::abs(double{(*found)[i]} - (*wanted)[i]);
            apart += d > 0.004;
            mean += d / static_cast<double>(found->size());
        }
        CHECK(apart * 100 <= found->size());
        CHECK(mean < 0.0007);
    }
    double difference = 0, most = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        const double d = std::abs(double{one[i]} - double{other[i]});
        most = std::max(most, d);
        difference += d * d / static_cast<double>(one.size());
    }
    MESSAGE("separated against integrated: RMSE " << std::sqrt(difference) << ", at most " << most);
    CHECK(std::sqrt(difference) < 0.05);
}

TEST_CASE("the interior of a hull sees what stands behind it") {
    // What is behind is within the radius in all directions up to the angle whose cosine is `apart`.
    const auto hard = [](double apart, const settings&) { return apart * apart; };
    const auto linear = [](double apart, const settings&) { return 1 - (1 - apart) * (1 - apart); };
    // A horizon from the normal on, as near as what is straight behind.
    const auto horizon = [](double apart, const settings& s) {
        const double rise = std::min((1 - apart) / s.falloff, 1.0);
        return 1 - rise * rise;
    };
    struct closed_form {
        std::string parts;
        double (*open)(double apart, const settings& s);
    };
    for (const closed_form& each : {closed_form{"half_directions:1x24/linked_lists:2x4/cosine_bitmask", hard},
                                    {"half_directions:1x24/linked_lists:2x4/cosine_bitmask:1x0", linear},
                                    {"slices:1x24/linked_lists:2x4/gtao", horizon}}) {
        CAPTURE(each.parts);
        half_transparent_wall wall(each.parts);
        for (const double apart : {0.25, 0.5, 0.75}) {
            CAPTURE(apart);
            const double found = wall.open_inside(oracle::wall(static_cast<float>(3 + apart)));
            CHECK(std::abs(found - each.open(apart, wall.set())) < 0.04);
        }
    }
}

TEST_CASE("between the faces of a transparent hull all is open") {
    const float near = 1.5f, far = 4.2f; // farther apart than the radius
    oracle::triangles back, drawn;
    oracle::add_quad(drawn, {-8, -8, -near}, {16, 0, 0}, {0, 16, 0});
    oracle::add_quad(back, {-8, -8, -far}, {16, 0, 0}, {0, 16, 0});
    back = oracle::turned(back);
    drawn.insert(drawn.end(), back.begin(), back.end());
    std::array<std::uint32_t, 16> colors = all_of(255);
    colors[0] = colors[1] = 0x80808080u;
    for (const std::string parts : {"half_directions:8x8/linked_lists:4x8/cosine_bitmask:0x0",
                                    "half_directions:8x8/linked_lists:4x8/cosine_bitmask:1x0"}) {
        CAPTURE(parts);
        const auto hull = run(parts + "/every_layer/r32f", drawn, colors);
        CHECK(std::ranges::min(hull->runner().download("visibility")) > 0.99f);
    }
}

TEST_CASE("an opaque solid behind a hull begins where its front does") {
    half_transparent_wall wall("half_directions:1x24/linked_lists:3x4/cosine_bitmask:0x0");
    for (const double apart : {0.25, 0.5, 0.75}) {
        CAPTURE(apart);
        oracle::triangles solid = oracle::wall(static_cast<float>(3 + apart));
        const oracle::triangles back = oracle::turned(oracle::wall(static_cast<float>(4 + apart)));
        solid.insert(solid.end(), back.begin(), back.end());
        CHECK(std::abs(wall.open_inside(solid) - apart * apart) < 0.04);
    }
}

TEST_CASE("a hull that stands alone is open on both sides") {
    oracle::triangles slanted;
    oracle::add_quad(slanted, {-8, -6, -6}, {16, 0, 3}, {0, 12, 2});
    std::array<std::uint32_t, 16> colors = all_of(255);
    colors[0] = colors[1] = 0x80808080u;
    for (const std::string parts :
         {"directions:8x8/linked_lists:4x8/hbao", "directions:8x8/linked_lists:4x8/hbao_plus",
          "slices:8x8/linked_lists:4x8/gtao", "slices:8x8/linked_lists:4x8/visibility_bitmask",
          "half_directions:8x8/linked_lists:4x8/cosine_bitmask:0x0",
          "half_directions:8x8/linked_lists:4x8/cosine_bitmask", "hemisphere_points:32/linked_lists:4x8/ssao",
          "sphere_points:32/linked_lists:4x8/point_volume", "sphere_lines:32/linked_lists:4x8/line_volume"})
        for (const oracle::triangles& drawn : {oracle::wall(3), slanted}) {
            CAPTURE(parts);
            const auto thin = run(parts + "/thin_layers/r32f", drawn, colors);
            CHECK(std::ranges::min(thin->runner().download("visibility")) > 0.99f);
        }
}
