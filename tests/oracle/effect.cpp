// SPDX-License-Identifier: MIT
#include "effect.hpp"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace oracle {

namespace {

constexpr double two_pi = 2 * glm::pi<double>();

tap texel_of(glm::dvec2 coordinates) {
    return {static_cast<int>(std::floor(coordinates.x)), static_cast<int>(std::floor(coordinates.y)), {}, {}};
}

double falloff(double distance, double radius) {
    return 1 - (distance / radius) * (distance / radius);
}

}

double share_inside(const picture& p, glm::dvec2 from, glm::dvec2 way) {
    const glm::dvec2 edges(way.x > 0 ? p.width : 0, way.y > 0 ? p.height : 0);
    double share = 1;
    for (int axis = 0; axis < 2; ++axis)
        if (way[axis] != 0)
            share = std::min(share, std::max((edges[axis] - from[axis]) / way[axis], 0.0));
    return share;
}

double radius_inside(const picture& p, const receiver& r, double radius) {
    glm::dvec3 across, up;
    axes(p, r, across, up);
    const glm::dvec2 a = texel_offset(p, r, across), b = texel_offset(p, r, up);
    const double texels = std::sqrt(std::abs(a.x * b.y - a.y * b.x)); // of a unit
    return std::min(radius, std::hypot(p.width, p.height) / 2 / texels);
}

glm::dvec2 texel_offset(const picture& p, const receiver& r, glm::dvec3 offset) {
    const double small = 1e-5;
    return (p.project(r.position + offset * small) - p.project(r.position - offset * small)) / (2 * small);
}

void axes(const picture& p, const receiver& r, glm::dvec3& across, glm::dvec3& up) {
    const glm::dvec3 eye = p.to_eye(r.position);
    across = p.is_perspective() ? glm::normalize(glm::cross(glm::dvec3(0, 1, 0), eye)) : glm::dvec3(1, 0, 0);
    up = glm::cross(eye, across);
}

glm::dvec3 reconstruct_normal(const picture& p, int x, int y) {
    const glm::dvec3 centre = p.position(x, y);
    const auto tangent = [&](int dx, int dy) {
        const bool before = p.contains(x - dx, y - dy), after = p.contains(x + dx, y + dy);
        if (!before && !after)
            return glm::dvec3(0);
        const glm::dvec3 behind = before ? centre - p.position(x - dx, y - dy) : glm::dvec3(0, 0, 1e9);
        const glm::dvec3 ahead = after ? p.position(x + dx, y + dy) - centre : glm::dvec3(0, 0, 1e9);
        return std::abs(ahead.z) < std::abs(behind.z) ? ahead : behind;
    };
    const glm::dvec3 normal = glm::cross(tangent(1, 0), tangent(0, 1));
    const glm::dvec3 eye = p.to_eye(centre);
    if (!(glm::length(normal) > 0))
        return eye;
    return glm::dot(normal, eye) < 0 ? -glm::normalize(normal) : glm::normalize(normal);
}

double tangent_angle(const receiver& r, glm::dvec3 azimuth) {
    return std::atan2(-glm::dot(r.normal, azimuth), glm::dot(r.normal, r.to_eye));
}

double rise_over_tangent(const receiver& r, glm::dvec3 offset) {
    const double towards = glm::dot(offset, r.to_eye);
    const glm::dvec3 across = offset - towards * r.to_eye;
    const double horizon = std::atan2(towards, glm::length(across));
    return std::sin(horizon) - std::sin(tangent_angle(r, glm::normalize(across)));
}

std::vector<std::vector<tap>> directions(const picture& p, const receiver& r, const settings& s, int count,
                                         int steps, int power) {
    const glm::dvec2 random(noise(r.pixel_x, r.pixel_y, s));
    glm::dvec3 across, up;
    axes(p, r, across, up);
    // Radii that make a texel: the root mean square over the directions on the screen.
    const glm::dmat2 radii =
        glm::inverse(glm::dmat2(texel_offset(p, r, s.radius * across), texel_offset(p, r, s.radius * up)));
    const double nearest = std::sqrt((glm::dot(radii[0], radii[0]) + glm::dot(radii[1], radii[1])) / 2);
    std::vector<std::vector<tap>> all;
    double offset = random.y;
    for (int i = 0; i < count; ++i) {
        // Of an even count each other one turns back: i / 2 steps, and (i + 1) / 2 halves of the circle.
        const double turns = count % 2 == 1 ? i : (i / 2) + ((i + 1) / 2) * (count / 2.0);
        const double angle = two_pi / count * (random.x + turns + 1);
        offset = std::fmod(offset + 0.61803399, 1.0);
        const glm::dvec3 azimuth = std::cos(angle) * across + std::sin(angle) * up;
        const glm::dvec2 whole = texel_offset(p, r, s.radius * azimuth);
        const glm::dvec2 first = glm::dvec2(r.x + 0.5, r.y + 0.5) + whole * nearest;
        const double share = share_inside(p, first, whole);
        std::vector<tap> along;
        for (int j = 0; j < steps; ++j) {
            const double u = (j + offset) / steps;
            tap t = texel_of(first + whole * share * std::pow(u, power));
            t.azimuth = azimuth;
            t.step = j;
            t.weight = share * std::pow(u, power - 1); // how far apart the taps are there
            if (p.contains(t.x, t.y))
                along.push_back(t);
        }
        all.push_back(along);
    }
    return all;
}

std::vector<std::vector<tap>> poisson_disk(const picture& p, const receiver& r, const settings& s,
                                           int count) {
    const glm::dvec2 random(noise(r.pixel_x, r.pixel_y, s));
    const double golden_angle = glm::pi<double>() * (3 - std::sqrt(5.0));
    glm::dvec3 across, up;
    axes(p, r, across, up);
    std::vector<tap> taps;
    for (int i = 0; i < count; ++i) {
        const double angle = two_pi * random.x + golden_angle * (i + 1),
                     distance = std::sqrt((i + random.y) / count);
        const glm::dvec2 centre(r.x + 0.5, r.y + 0.5),
            whole = texel_offset(p, r, s.radius * (std::cos(angle) * across + std::sin(angle) * up));
        const double share = share_inside(p, centre, whole);
        tap t = texel_of(centre + whole * share * distance);
        t.step = i;
        t.weight = share * share; // of the area
        if (p.contains(t.x, t.y) && !(t.x == r.x && t.y == r.y))
            taps.push_back(t);
    }
    return {taps};
}

std::vector<axis_march> axis_marches(const picture& p, const receiver& r, const settings& s, int steps,
                                     int reach) {
    glm::dvec3 across, up;
    axes(p, r, across, up);
    std::vector<axis_march> all;
    for (const glm::dvec2 axis : {glm::dvec2(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        // The azimuth whose offset lies along the axis: where what is across it vanishes.
        const glm::dvec2 side(-axis.y, axis.x);
        const double a = glm::dot(texel_offset(p, r, s.radius * across), side),
                     b = glm::dot(texel_offset(p, r, s.radius * up), side);
        glm::dvec3 azimuth = glm::normalize(b * across - a * up);
        double radius = glm::dot(texel_offset(p, r, s.radius * azimuth), axis);
        if (radius < 0) {
            azimuth = -azimuth;
            radius = -radius;
        }
        axis_march march{
            azimuth, radius, std::max(std::min(radius, static_cast<double>(reach)) / steps, 1.0), {}};
        for (int i = 1; i <= steps; ++i) {
            const double texels = std::floor(i * march.stride + 0.5);
            const int x = r.x + static_cast<int>(texels * axis.x),
                      y = r.y + static_cast<int>(texels * axis.y);
            march.taps.push_back({std::clamp(x, 0, p.width - 1), std::clamp(y, 0, p.height - 1), texels,
                                  p.contains(x, y) && texels <= std::max(radius, 1.0) + 0.5});
        }
        all.push_back(march);
    }
    return all;
}

std::vector<std::vector<tap>> axis_taps(const picture& p, const receiver& r, const settings& s, int steps,
                                        int reach) {
    std::vector<std::vector<tap>> all;
    for (const axis_march& march : axis_marches(p, r, s, steps, reach)) {
        std::vector<tap> along;
        for (int i = 0; i < steps; ++i) {
            const axis_march::place& at = march.taps[static_cast<std::size_t>(i)];
            if (!at.counts)
                continue;
            tap t{at.x, at.y, glm::dvec3(0)};
            t.azimuth = march.azimuth;
            t.step = i;
            t.weight = march.stride * steps / std::max(march.radius, 1.0); // the share of the radius reached
            along.push_back(t);
        }
        all.push_back(along);
    }
    return all;
}

std::vector<std::vector<tap>> hemisphere_points(const picture& p, const receiver& r, const settings& s,
                                                int count) {
    const glm::dvec2 random(noise(r.pixel_x, r.pixel_y, s));
    const glm::dvec3 axis = std::abs(r.normal.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 tangent = glm::normalize(glm::cross(axis, r.normal)),
                     bitangent = glm::cross(r.normal, tangent);
    const double golden_angle = glm::pi<double>() * (3 - std::sqrt(5.0));
    std::vector<tap> taps;
    for (int i = 0; i < count; ++i) {
        const double angle = two_pi * random.x + golden_angle * (i + 1);
        const double distance =
            radius_inside(p, r, s.radius) * std::fmod(random.y + 0.75487767 * (i + 1), 1.0);
        const double sine = std::sqrt((i + 0.5) / count), cosine = std::sqrt(1 - sine * sine);
        const glm::dvec3 point =
            r.position + distance * (sine * std::cos(angle) * tangent + sine * std::sin(angle) * bitangent +
                                     cosine * r.normal);
        if (!(point.z < 0))
            continue;
        tap t = texel_of(p.project(point));
        if (!p.contains(t.x, t.y))
            continue;
        const glm::dvec4 clip = p.projection * glm::dvec4(point, 1);
        t.point = p.unproject({t.x + 0.5, t.y + 0.5}, clip.z / clip.w); // the same depth, on the texel's ray
        taps.push_back(t);
    }
    return {taps};
}

double ssao(const picture& p, const receiver& r, const settings& s,
            const std::vector<std::vector<tap>>& taps) {
    double occluded = 0, points = 0;
    for (const tap& t : taps[0]) {
        if (!(glm::dot(t.point - r.position, r.normal) > s.bias * std::min(s.radius, -r.position.z)))
            continue;
        double most = 0; // of all layers
        bool open = false;
        for (const glm::dvec3& position : p.positions(t.x, t.y)) {
            // What hides the point counts up to half a radius before the receiver, and less and less up to
            // one.
            const double x = std::clamp((s.radius - (position.z - r.position.z)) / (s.radius / 2), 0.0, 1.0);
            if (position.z >= t.point.z)
                most = std::max(most, x * x * (3 - 2 * x));
            else
                open = true;
        }
        const double known = most > 0 ? most : open ? 1 : 0;
        occluded += most;
        points += known;
    }
    return occluded / std::max(points, 1.0);
}

double hbao(const picture& p, const receiver& r, const settings& s, const std::vector<std::vector<tap>>& taps,
            deferral how) {
    double occlusion = 0;
    for (const std::vector<tap>& direction : taps) {
        double highest = 0; // sin(h) - sin(t) of the highest so far
        if (!direction.empty()) {
            const double tangent = tangent_angle(r, direction[0].azimuth);
            highest = std::sin(std::min(tangent + s.bias, glm::half_pi<double>())) - std::sin(tangent);
        }
        // Looks at the first `count` layers of a tap; returns whether the front one is above the horizon.
        const auto look_at = [&](const tap& t, std::size_t count) {
            double most = 0, horizon = highest; // of the layer that occludes the most
            bool front_above = false;
            const std::vector<glm::dvec3> layers = p.positions(t.x, t.y);
            for (std::size_t i = 0; i < std::min(count, layers.size()); ++i) {
                const glm::dvec3 v = layers[i] - r.position;
                const double length = glm::length(v), above = rise_over_tangent(r, v);
                const double occludes = falloff(length, s.radius) * (above - highest);
                front_above = front_above || (i == 0 && above > highest);
                if (above > highest && length < s.radius && glm::dot(v, r.normal) / length > s.threshold &&
                    occludes > most) {
                    most = occludes;
                    horizon = above;
                }
            }
            occlusion += most;
            highest = horizon;
            return front_above;
        };
        std::map<int, std::vector<tap>> behind; // of each four steps
        for (const tap& t : direction) {
            const bool front_above = look_at(t, how.looks == 0 ? ~std::size_t{0} : 1);
            if (front_above || !how.skip)
                behind[t.step / 4].push_back(t);
        }
        for (const auto& [steps, wanted] : behind)
            for (std::size_t i = 0; i < std::min<std::size_t>(wanted.size(), how.looks); ++i)
                look_at(wanted[i], ~std::size_t{0});
    }
    return occlusion / static_cast<double>(taps.size());
}

double hbao_plus(const picture& p, const receiver& r, const settings& s,
                 const std::vector<std::vector<tap>>& taps, deferral how) {
    double occlusion = 0, weights = 0;
    for (const std::vector<tap>& direction : taps) {
        std::map<int, unsigned> looks; // of each four steps
        for (const tap& t : direction) {
            const std::vector<glm::dvec3> layers = p.positions(t.x, t.y);
            // Away from the eye leads further down from a front surface below the tangent plane.
            const bool settled = glm::dot(layers[0] - r.position, r.normal) <= 0 &&
                                 glm::dot(p.to_eye(layers[0]), r.normal) >= 0;
            const bool behind = how.looks == 0 || (!(settled && how.skip) && looks[t.step / 4]++ < how.looks);
            double most = 0; // of all layers that are looked at
            for (const glm::dvec3& position : std::span(layers).first(behind ? layers.size() : 1)) {
                const glm::dvec3 v = position - r.position;
                const double length = glm::length(v);
                if (length < s.radius)
                    most = std::max(most, falloff(length, s.radius) *
                                              std::max(glm::dot(v, r.normal) / length - s.bias, 0.0));
            }
            occlusion += t.weight * most;
            weights += t.weight;
        }
    }
    return weights > 0 ? occlusion / weights : 0;
}

}
