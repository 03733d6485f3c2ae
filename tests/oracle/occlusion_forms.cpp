// SPDX-License-Identifier: MIT
// Receivers that something occludes: each estimator against the integral that it stands for, over the
// geometry itself. There are no texels and no taps in the integrals: what the eye sees in any direction is
// the nearest of the surfaces there.
#include "areas.hpp"
#include "run.hpp"

#include <doctest/doctest.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace {

using oracle::lens;
using kind = oracle::surface::kind;

constexpr double two_pi = 2 * glm::pi<double>();

struct scene {
    std::string name;
    std::vector<oracle::surface> surfaces;
    lens seen_by;
    double radius;
    std::vector<glm::ivec2> receivers; ///< first texels of blocks of 4 x 4
};

/// A receiver in its scene.
struct place {
    const scene& of;
    const oracle::picture& p;
    oracle::settings s;
    glm::dvec2 texel;
    oracle::receiver r;
};

/// What the eye sees through a place of the picture, and the normal there.
glm::dvec3 seen(const scene& of, const oracle::picture& p, glm::dvec2 texel, glm::dvec3* normal = nullptr) {
    glm::dvec3 eye, ray;
    p.ray(texel, eye, ray);
    double nearest = std::numeric_limits<double>::infinity();
    for (const oracle::surface& s : of.surfaces) {
        double t;
        if (s.shape == kind::inside_of_sphere) {
            const double b = glm::dot(eye - s.point, ray);
            t = -b + std::sqrt(b * b - glm::dot(eye - s.point, eye - s.point) + s.radius * s.radius);
        } else {
            t = glm::dot(s.point - eye, s.normal) / glm::dot(ray, s.normal);
            if (s.shape == kind::half_plane && (eye + t * ray).x < s.point.x)
                continue;
        }
        if (t > 0 && t < nearest) {
            nearest = t;
            if (normal)
                *normal = s.shape == kind::inside_of_sphere ? (s.point - eye - t * ray) / s.radius
                          : glm::dot(s.normal, ray) < 0     ? s.normal
                                                            : -s.normal;
        }
    }
    return eye + nearest * ray;
}

/// Two axes across a unit vector.
void axes_of(glm::dvec3 normal, glm::dvec3& a, glm::dvec3& b) {
    a = glm::normalize(
        glm::cross(std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), normal));
    b = glm::cross(normal, a);
}

/// How far a surface is nearer to the eye than the receiver, in radii.
double before(const place& at, glm::dvec3 surface) {
    return (surface.z - at.r.position.z) / at.s.radius;
}

/// The weight of a surface before a volume: all up to one radius, and over `falloff` more down to nothing.
double reach(const place& at, glm::dvec3 surface) {
    return std::clamp((1 + at.s.falloff - before(at, surface)) / at.s.falloff, 0.0, 1.0);
}

/// The mean over the hemisphere, weighed by the cosine, and over distances up to the radius, of the points
/// higher than the bias: those behind a surface are occluded as `weight` says of it, and where not all counts
/// as much as that too.
double over_hemisphere(const place& at, bool all_count, const std::function<double(glm::dvec3)>& weight) {
    glm::dvec3 a, b;
    axes_of(at.r.normal, a, b);
    const int heights = 40, turns = 64, distances = 40;
    double occluded = 0, all = 0;
    for (int i = 0; i < heights; ++i)
        for (int j = 0; j < turns; ++j)
            for (int k = 0; k < distances; ++k) {
                const double sine2 = (i + 0.5) / heights, turn = two_pi * (j + 0.5) / turns;
                const glm::dvec3 way = std::sqrt(1 - sine2) * at.r.normal +
                                       std::sqrt(sine2) * (std::cos(turn) * a + std::sin(turn) * b);
                const glm::dvec3 point = at.r.position + at.s.radius * (k + 0.5) / distances * way;
                if (glm::dot(point - at.r.position, at.r.normal) <= at.s.bias * at.s.radius)
                    continue;
                const glm::dvec3 surface = seen(at.of, at.p, at.p.project(point));
                const bool hidden = surface.z > point.z;
                occluded += hidden ? weight(surface) : 0;
                all += hidden && !all_count ? weight(surface) : 1;
            }
    return occluded / all;
}

double ssao(const place& at) {
    return over_hemisphere(at, false, [&](glm::dvec3 surface) {
        const double x = std::clamp(2 * (1 - before(at, surface)), 0.0, 1.0);
        return x * x * (3 - 2 * x);
    });
}

double points_of_hemisphere(const place& at) {
    return over_hemisphere(at, true, [&](glm::dvec3 surface) { return reach(at, surface); });
}

/// The filled volume of the sphere less the half under the tangent plane, over the other half; what is under
/// that plane and yet empty counts against it.
double points_of_sphere(const place& at) {
    const int heights = 80, turns = 64, distances = 40;
    double more = 0, empty = 0;
    glm::dvec3 a, b;
    axes_of(at.r.normal, a, b);
    for (int i = 0; i < heights; ++i)
        for (int j = 0; j < turns; ++j)
            for (int k = 0; k < distances; ++k) {
                const double height = (2 * i + 1.0) / heights - 1, turn = two_pi * (j + 0.5) / turns;
                const double sine = std::sqrt(1 - height * height);
                const glm::dvec3 way =
                    height * at.r.normal + sine * (std::cos(turn) * a + std::sin(turn) * b);
                const glm::dvec3 point = at.r.position + at.s.radius * std::cbrt((k + 0.5) / distances) * way;
                if (std::abs(glm::dot(point - at.r.position, at.r.normal)) <= at.s.bias * at.s.radius)
                    continue;
                const glm::dvec3 surface = seen(at.of, at.p, at.p.project(point));
                const bool filled = surface.z > point.z;
                if (filled != (height < 0))
                    more += filled ? reach(at, surface) : -1;
                empty += height > 0;
            }
    return std::max(more / empty, 0.0);
}

/// The mean over the disk of the radius that faces the eye, of a function of places in the picture.
void over_disk(const place& at, const std::function<void(glm::dvec2)>& visit) {
    const glm::dvec3 a = at.p.is_perspective() ? glm::normalize(glm::cross(glm::dvec3(0, 1, 0), at.r.to_eye))
                                               : glm::dvec3(1, 0, 0);
    const glm::dvec3 b = glm::cross(at.r.to_eye, a);
    const int rings = 120, turns = 240;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < turns; ++j) {
            const double distance = at.s.radius * std::sqrt((i + 0.5) / rings),
                         turn = two_pi * (j + 0.5) / turns;
            visit(at.texel +
                  oracle::texel_offset(at.p, at.r, distance * (std::cos(turn) * a + std::sin(turn) * b)));
        }
}

/// What of the chords that view rays have in the volume is filled, less what a plane would fill.
double lines(const place& at, bool hemisphere) {
    double more = 0, empty = 0;
    over_disk(at, [&](glm::dvec2 texel) {
        glm::dvec3 eye, ray;
        at.p.ray(texel, eye, ray);
        const glm::dvec3 to_eye = eye - at.r.position;
        const double middle = -glm::dot(to_eye, ray);
        const double squared = at.s.radius * at.s.radius - glm::dot(to_eye, to_eye) + middle * middle;
        if (squared <= 0)
            return;
        const double surface = glm::dot(seen(at.of, at.p, texel) - eye, ray);
        // The chord in small pieces, each over the tangent plane or under it.
        const int pieces = 64;
        const double piece = 2 * std::sqrt(squared) / pieces;
        for (int i = 0; i < pieces; ++i) {
            const double t = middle - std::sqrt(squared) + (i + 0.5) * piece;
            const bool over = glm::dot(to_eye + t * ray, at.r.normal) > 0, filled = t > surface;
            const double length = piece * -ray.z;
            empty += over ? length : 0;
            if (filled && over)
                more += length * reach(at, eye + surface * ray);
            else if (!filled && !over && !hemisphere)
                more -= length;
        }
    });
    return std::max(more / empty, 0.0);
}

/// Of the disk's places the rise over the tangent plane, less the bias, with the falloff 1 - (r / R)^2.
double rises(const place& at) {
    double occlusion = 0, all = 0;
    over_disk(at, [&](glm::dvec2 texel) {
        const glm::dvec3 way = seen(at.of, at.p, texel) - at.r.position;
        const double share = glm::length(way) / at.s.radius;
        if (share < 1)
            occlusion += (1 - share * share) *
                         std::max(glm::dot(way, at.r.normal) / glm::length(way) - at.s.bias, 0.0);
        all += 1;
    });
    return occlusion / all;
}

/// The height over the tangent plane of the mean of all that the box around the receiver shows.
double height_of_mean(const place& at) {
    const auto area = oracle::sample_area(at.p, at.texel, at.r.position, at.s.radius);
    glm::dvec3 sum(0);
    const int places = 240;
    for (int i = 0; i < places; ++i)
        for (int j = 0; j < places; ++j)
            sum += seen(at.of, at.p,
                        {area[0] + (area[2] - area[0]) * (i + 0.5) / places,
                         area[1] + (area[3] - area[1]) * (j + 0.5) / places});
    const double height = glm::dot(sum / double{places * places} - at.r.position, at.r.normal) / at.s.radius;
    return std::clamp((height - at.s.bias) / at.s.threshold, 0.0, 1.0) *
           (1 - std::clamp((height - at.s.threshold) / at.s.falloff, 0.0, 1.0));
}

struct form {
    std::string recipe;
    double size; ///< of the radius, beside the scene's
    std::function<double(const place&)> occlusion;
    double bound; ///< of the difference
};

const std::vector<form>& forms() {
    static const std::vector<form> all{
        {"hemisphere_points:256/single_layer/ssao", 1, ssao, 0.004},
        {"poisson_disk:256/single_layer/hbao_plus", 1, rises, 0.006},
        {"hemisphere_points:256/single_layer/point_volume", 1, points_of_hemisphere, 0.005},
        {"sphere_points:256/single_layer/point_volume", 1, points_of_sphere, 0.02},
        {"hemisphere_lines:256/single_layer/line_volume", 1, [](const place& at) { return lines(at, true); },
         0.012},
        {"sphere_lines:256/single_layer/line_volume", 1, [](const place& at) { return lines(at, false); },
         0.012},
        {"sample_box/summed_area/mean_height", 2, height_of_mean, 0.015},
    };
    return all;
}

const std::vector<scene>& scenes() {
    static const std::vector<scene> all{
        {"a floor by a wall",
         {{kind::plane, {0, -0.7, 0}, {0, 1, 0}}, {kind::plane, {0, 0, -4}, {0, 0, 1}}},
         lens::standard,
         0.8,
         {{158, 144}, {100, 152}, {158, 126}, {220, 114}}},
        {"under an overhang",
         {{kind::plane, {0, -0.5, 0}, {0, 1, 0}},
          {kind::half_plane, {0, 0.45, 0}, {0, 1, 0}},
          {kind::plane, {0, 0, -9}, {0, 0, 1}}},
         lens::standard,
         1.2,
         {{176, 136}, {196, 142}}},
        {"the inside of a sphere",
         {{kind::inside_of_sphere, {0, 0, -3}, {}, 2}},
         lens::standard,
         1.2,
         {{158, 104}, {220, 130}}},
        {"a step seen at a slant",
         {{kind::plane, {0, 0, -4}, {0, 0.6, 0.8}}, {kind::half_plane, {0, 0.24, -3.68}, {0, 0.6, 0.8}}},
         lens::orthographic,
         0.9,
         {{150, 104}, {140, 104}, {160, 104}}},
    };
    return all;
}

}

TEST_CASE("what something occludes, by the integral that each estimator stands for") {
    for (const scene& of : scenes()) {
        const oracle::picture p = oracle::draw(of.surfaces, of.seen_by, 320, 213);
        for (const form& f : forms()) {
            const std::string recipe =
                f.recipe + "/tiled_noise" + (of.seen_by == lens::orthographic ? "/orthographic" : "");
            auto& [composed, runner] = oracle::prepare(recipe, p);
            crease::parameters how = oracle::view_parameters(p, composed, f.size * of.radius);
            oracle::set(how, composed, "strength", 1);
            oracle::set(how, composed, "exponent", 1);
            oracle::upload(runner, composed, p);
            runner.run(how);
            const std::vector<float> image = runner.download("visibility");
            for (const glm::ivec2 block : of.receivers) {
                place at{of, p, oracle::settings_of(how, composed), glm::dvec2(block) + 2.0, {}};
                at.r.position = seen(of, p, at.texel, &at.r.normal);
                at.r.to_eye = p.to_eye(at.r.position);
                double mean = 0; // over all places of the tile of the noise
                for (int i = 0; i < 16; ++i)
                    mean += image[p.index(block.x + i % 4, block.y + i / 4)] / 16.0;
                const double occlusion = f.occlusion(at);
                CAPTURE(of.name);
                CAPTURE(recipe);
                CAPTURE(block.x);
                CAPTURE(block.y);
                CAPTURE(1 - occlusion);
                CAPTURE(mean);
                CHECK(std::abs(mean - (1 - occlusion)) <= f.bound);
            }
        }
    }
}

TEST_CASE("what is further than the radius before a receiver occludes no point of its hemisphere") {
    for (double radius : {0.5, 1.4}) {
        const oracle::picture p = oracle::draw(
            {{kind::plane, {0, 0, -6}, {0, 0, 1}}, {kind::half_plane, {0, 0, -6 + 1.02 * radius}, {0, 0, 1}}},
            lens::orthographic, 200, 133);
        const std::vector<float> image =
            oracle::run(p, "hemisphere_points:64/single_layer/ssao/orthographic", radius);
        CHECK(*std::min_element(image.begin(), image.end()) == 1.0f);
    }
}
