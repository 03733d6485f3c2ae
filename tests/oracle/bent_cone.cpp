// SPDX-License-Identifier: MIT
// The bent normal and its cone, from the equations of stochastic-depth-ao 7.1.
#include "run.hpp"

#include <doctest/doctest.h>
#include <glm/gtc/constants.hpp>

#include <cmath>
#include <memory>

namespace {

using oracle::lens;
using kind = oracle::surface::kind;

/// The unit direction of a point of the octahedron |x| + |y| + |z| = 1, of which z < 0 is folded outwards.
glm::dvec3 of_octahedron(glm::dvec2 point) {
    const double z = 1 - std::abs(point.x) - std::abs(point.y);
    const double x = z < 0 ? std::copysign(1 - std::abs(point.y), point.x) : point.x;
    const double y = z < 0 ? std::copysign(1 - std::abs(point.x), point.y) : point.y;
    return glm::normalize(glm::dvec3(x, y, z));
}

/// The texels of an image that a recipe gives.
std::vector<float> texels_of(const oracle::picture& p, const std::string& text, std::string_view image,
                             double radius, double bias) {
    const crease::recipe chosen{std::string_view(text)};
    REQUIRE_MESSAGE(static_cast<bool>(chosen), chosen.error());
    const auto composed = std::make_unique<crease::composition>(chosen);
    crease::parameters how = oracle::view_parameters(p, composed->view(), radius);
    oracle::set(how, composed->view(), "bias", bias);
    return oracle::run(p, composed->view(), how, image);
}

/// The bent normals and the angles of the cones.
std::vector<glm::dvec4> run(const oracle::picture& p, const std::string& text, double radius, double bias) {
    const bool packed = text.find("packed") != std::string::npos;
    const std::vector<float> four =
        texels_of(p, text, packed ? "packed_bent_cone" : "bent_cone", radius, bias);
    std::vector<glm::dvec4> all;
    for (std::size_t i = 0; i < four.size(); i += 4) {
        const glm::dvec4 texel(four[i], four[i + 1], four[i + 2], four[i + 3]);
        if (!packed)
            REQUIRE(std::abs(glm::length(glm::dvec3(texel)) - 1) < 0.001); // half floats
        all.push_back(packed ? glm::dvec4(of_octahedron(glm::dvec2(texel) * 2.0 - 1.0),
                                          texel.z * glm::half_pi<double>())
                             : texel);
    }
    return all;
}

double degrees_between(glm::dvec3 a, glm::dvec3 b) {
    return std::acos(glm::clamp(glm::dot(glm::normalize(a), glm::normalize(b)), -1.0, 1.0)) * 180 /
           glm::pi<double>();
}

/// The receiver's normal, turned by an angle away from an azimuth, about the axis across it and the direction
/// to the eye.
glm::dvec3 turned(const oracle::receiver& r, glm::dvec3 azimuth, double turn) {
    const glm::dvec3 axis = glm::normalize(glm::cross(azimuth, r.to_eye));
    return r.normal * std::cos(turn) + glm::cross(axis, r.normal) * std::sin(turn) +
           axis * (glm::dot(axis, r.normal) * (1 - std::cos(turn)));
}

/// Algorithm 10 of a receiver, of whose points none is beside the picture: the mean direction of the points,
/// weighed by how open they are.
glm::dvec4 ssao_cone(const oracle::picture& p, const oracle::receiver& r, const oracle::settings& s,
                     const std::vector<oracle::tap>& points) {
    glm::dvec3 sum(0);
    double open = 0;
    for (const oracle::tap& t : points) {
        const glm::dvec3 way = t.point - r.position;
        if (!(glm::dot(way, r.normal) > s.bias * std::min(s.radius, -r.position.z)))
            continue;
        if (p.position(t.x, t.y).z >= t.point.z)
            continue; // occluded, or hidden by what is out of range
        sum += glm::normalize(way);
        open += 1;
    }
    const double mean_length = glm::length(sum) / std::max(open, 1e-6);
    return {glm::length(sum) > 1e-6 ? glm::normalize(sum) : r.normal,
            glm::half_pi<double>() * (1 - std::max(2 * mean_length - 1, 0.0))};
}

/// The same for HBAO+: the normal of each direction, turned by the angle whose sine is the greatest of its
/// terms.
glm::dvec4 hbao_plus_cone(const oracle::picture& p, const oracle::receiver& r, const oracle::settings& s,
                          const std::vector<std::vector<oracle::tap>>& directions) {
    glm::dvec3 sum(0);
    double cone = 0;
    for (const auto& direction : directions) {
        double highest = 0;
        for (const oracle::tap& t : direction) {
            const glm::dvec3 v = p.position(t.x, t.y) - r.position;
            if (glm::length(v) < s.radius)
                highest = std::max(highest, glm::dot(v, r.normal) / glm::length(v) - s.bias);
        }
        const double turn = std::asin(std::min(highest, 1.0));
        sum += direction.empty() ? r.normal : turned(r, direction[0].azimuth, turn);
        cone += glm::half_pi<double>() - turn;
    }
    return {glm::normalize(sum), cone / static_cast<double>(directions.size())};
}

/// Algorithm 11 of a receiver: the normal of each direction, turned away from its horizon, and the mean
/// angle.
glm::dvec4 hbao_cone(const oracle::picture& p, const oracle::receiver& r, const oracle::settings& s,
                     const std::vector<std::vector<oracle::tap>>& directions) {
    glm::dvec3 sum(0);
    double cone = 0;
    for (const auto& direction : directions) {
        if (direction.empty()) {
            sum += r.normal;
            cone += glm::half_pi<double>();
            continue;
        }
        const glm::dvec3 azimuth = direction[0].azimuth;
        const double tangent = oracle::tangent_angle(r, azimuth),
                     start = std::min(tangent + s.bias, glm::half_pi<double>());
        double highest = std::sin(start) - std::sin(tangent);
        for (const oracle::tap& t : direction) {
            const glm::dvec3 v = p.position(t.x, t.y) - r.position;
            const double length = glm::length(v), above = oracle::rise_over_tangent(r, v);
            if (above > highest && length < s.radius && glm::dot(v, r.normal) / length > s.threshold)
                highest = above;
        }
        const double turn = std::asin(std::min(std::sin(tangent) + highest, 1.0)) - start;
        sum += turned(r, azimuth, turn);
        cone += glm::half_pi<double>() - turn;
    }
    return {glm::normalize(sum), cone / static_cast<double>(directions.size())};
}

}

TEST_CASE("on a plane the bent normal is the normal, and the cone is open") {
    for (const char* recipe :
         {"directions:8x4/single_layer/hbao/bent_cone", "directions:8x4/single_layer/hbao_plus/bent_cone",
          "hemisphere_points:64/single_layer/ssao/bent_cone"}) {
        CAPTURE(std::string(recipe));
        const glm::dvec3 normal(0, std::sin(0.6), std::cos(0.6));
        const oracle::picture p = oracle::draw({{kind::plane, {0, 0, -3}, normal}}, lens::standard, 65, 41);
        const glm::dvec4 middle = run(p, recipe, 0.5, 0.1)[p.index(32, 20)];
        const bool points = std::string(recipe).find("ssao") != std::string::npos;
        CHECK(degrees_between(glm::dvec3(middle), normal) <
              (points ? 6 : 0.5)); // 64 points are not quite even
        // Of cosine-distributed points the mean is 2/3 long, which the paper's formula makes a narrower cone;
        // points too near the plane are left out, which makes it narrower yet.
        const double expected = glm::half_pi<double>() * (points ? 2.0 / 3 : 1.0);
        CHECK(std::abs(middle.w - expected) < (points ? 0.25 : 0.01));
    }
}

TEST_CASE("beside a wall the bent normal leans away from it, by every estimator") {
    for (const char* recipe :
         {"directions:8x8/single_layer/hbao/bent_cone", "directions:8x8/single_layer/hbao_plus/bent_cone",
          "hemisphere_points:64/single_layer/ssao/bent_cone"}) {
        CAPTURE(std::string(recipe));
        const oracle::picture p =
            oracle::draw({{kind::plane, {0, 0, -4}, {0, 0, 1}}, {kind::plane, {0.3, 0, 0}, {-1, 0, 0}}},
                         lens::standard, 129, 81);
        const std::vector<glm::dvec4> all = run(p, recipe, 0.6, 0.1);
        for (int x = 66; x < 69; ++x) { // 0.04 to 0.21 from the wall
            const glm::dvec4 at = all[p.index(x, 40)];
            CHECK(at.x < -0.05);
            CHECK(at.z > 0.5);
            CHECK(at.w < glm::half_pi<double>());
        }
    }
}

TEST_CASE("Algorithms 10 and 11 and the form with lambda, whole images") {
    constexpr int points = 12;
    for (lens lens_kind : {lens::standard, lens::orthographic})
        for (const char* parts : {"directions:6x4/single_layer/hbao", "directions:6x4/single_layer/hbao_plus",
                                  "hemisphere_points:12/single_layer/ssao"}) {
            CAPTURE(std::string(parts));
            const oracle::picture p = oracle::draw(oracle::still_life(), lens_kind, 97, 61);
            const std::string text =
                std::string(parts) + "/bent_cone" + (lens_kind == lens::orthographic ? "/orthographic" : "");
            const std::vector<glm::dvec4> found = run(p, text, 0.5, 0.15);
            const oracle::settings s{.radius = 0.5, .bias = 0.15};
            double degrees = 0, apart = 0, count = 0;
            for (int y = 0; y < p.height; ++y)
                for (int x = 0; x < p.width; ++x) {
                    if (p.background(x, y)) {
                        CHECK(found[p.index(x, y)].z == 1);
                        CHECK(std::abs(found[p.index(x, y)].w - glm::half_pi<double>()) < 0.001);
                        continue;
                    }
                    oracle::receiver r{x, y, x, y, p.position(x, y), glm::dvec3(p.normals[p.index(x, y)]),
                                       {}};
                    r.to_eye = p.to_eye(r.position);
                    glm::dvec4 expected;
                    if (text.find("ssao") != std::string::npos) {
                        const auto all = oracle::hemisphere_points(p, r, s, points)[0];
                        if (all.size() < points)
                            continue; // some are beside the picture: a test of their own
                        expected = ssao_cone(p, r, s, all);
                    } else {
                        const auto all = oracle::directions(p, r, s, 6, 4);
                        expected = text.find("hbao_plus") != std::string::npos ? hbao_plus_cone(p, r, s, all)
                                                                               : hbao_cone(p, r, s, all);
                    }
                    const glm::dvec4 at = found[p.index(x, y)];
                    degrees += degrees_between(glm::dvec3(at), glm::dvec3(expected));
                    apart += std::abs(at.w - expected.w);
                    ++count;
                }
            CHECK(count > 1000);
            // Half floats, and taps whose texel rounds the other way.
            const bool by_points = text.find("ssao") != std::string::npos;
            CHECK(degrees / count < (by_points ? 0.15 : 0.03));
            CHECK(apart / count < (by_points ? 0.01 : 0.003));
        }
}

TEST_CASE("the picture's edge neither bends a normal nor narrows a cone") {
    for (const char* recipe :
         {"directions:8x4/single_layer/hbao/bent_cone", "directions:8x4/single_layer/hbao_plus/bent_cone",
          "hemisphere_points:64/single_layer/ssao/bent_cone"}) {
        CAPTURE(std::string(recipe));
        const glm::dvec3 normal(0, 0, 1);
        const oracle::picture p = oracle::draw({{kind::plane, {0, 0, -3}, normal}}, lens::standard, 65, 41);
        const std::vector<glm::dvec4> all = run(p, recipe, 0.5, 0.1);
        const glm::dvec4 middle = all[p.index(32, 20)];
        for (int x : {0, 64}) {
            const glm::dvec4 edge = all[p.index(x, 20)];
            CHECK(degrees_between(glm::dvec3(edge), normal) < 6);
            CHECK(std::abs(edge.w - middle.w) < 0.2);
        }
    }
}

TEST_CASE("one texel holds what two images hold, to a byte each") {
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, 97, 61);
    for (const char* parts :
         {"directions:6x4/single_layer/hbao/", "directions:6x4/single_layer/hbao_plus/fragment/",
          "hemisphere_points:12/single_layer/ssao/", "directions:6x4/single_layer/hbao/bilateral/"}) {
        CAPTURE(std::string(parts));
        const std::vector<glm::dvec4> two = run(p, std::string(parts) + "bent_cone", 0.5, 0.15);
        const std::vector<glm::dvec4> one = run(p, std::string(parts) + "packed_bent_cone", 0.5, 0.15);
        double most_degrees = 0, most_apart = 0;
        for (int y = 0; y < p.height; ++y)
            for (int x = 0; x < p.width; ++x) {
                const std::size_t i = p.index(x, y);
                if (p.background(x, y)) {
                    CHECK(std::abs(one[i].w - glm::half_pi<double>()) < 1e-5);
                    CHECK(degrees_between(glm::dvec3(one[i]), {0, 0, 1}) < 1);
                    CHECK(degrees_between(glm::dvec3(two[i]), {0, 0, 1}) < 1);
                    continue;
                }
                most_degrees =
                    std::max(most_degrees, degrees_between(glm::dvec3(one[i]), glm::dvec3(two[i])));
                most_apart = std::max(most_apart, std::abs(one[i].w - two[i].w));
            }
        CHECK(most_degrees < 1);
        CHECK(most_degrees > 0.1);
        CHECK(most_apart < 0.5 / 255 * glm::half_pi<double>() + 0.001); // half a byte, and half floats
    }
}

TEST_CASE("the alpha of a packed bent cone is the visibility") {
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, 97, 61);
    const std::string parts = "directions:6x4/single_layer/hbao";
    const std::vector<float> alone = texels_of(p, parts, "visibility", 0.5, 0.15),
                             texels =
                                 texels_of(p, parts + "/packed_bent_cone", "packed_bent_cone", 0.5, 0.15);
    std::size_t apart = 0;
    for (std::size_t i = 0; i < alone.size(); ++i)
        apart += std::abs(alone[i] - texels[4 * i + 3]) > 1.5f / 255;
    CHECK(apart == 0);
}

TEST_CASE("a filter keeps the bent normal of a plane, and of one whose normal points away from the camera") {
    for (const glm::dvec3 normal :
         {glm::dvec3(std::sin(0.5), 0, std::cos(0.5)), {0.1, std::cos(0.2), -std::sin(0.2)}}) {
        CAPTURE(normal.z);
        const glm::dvec3 at(0, normal.z > 0 ? 0 : -1, normal.z > 0 ? -3 : 0);
        const oracle::picture p = oracle::draw({{kind::plane, at, normal}}, lens::standard, 64, 40);
        REQUIRE(!p.background(32, 39));
        for (const char* filters : {"/bilateral", "/upsample:2", "/bilateral/upsample:3", "/plane_filter"})
            for (const char* stage : {"", "/fragment"}) {
                CAPTURE(std::string(filters));
                const auto all = run(
                    p, std::string("directions:8x4/single_layer/hbao/bent_cone") + filters + stage, 0.5, 0.1);
                for (int y = normal.z > 0 ? 0 : 32; y < p.height; ++y)
                    for (int x = 0; x < p.width; ++x) {
                        const glm::dvec4 each = all[p.index(x, y)];
                        CHECK(degrees_between(glm::dvec3(each), normal) < 0.5);
                        CHECK(std::abs(each.w - glm::half_pi<double>()) < 0.015);
                    }
            }
    }
}
