// SPDX-License-Identifier: MIT
#include "slices.hpp"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace oracle {

namespace {

constexpr double pi = glm::pi<double>();
constexpr double golden = 0.61803399;

std::vector<march_tap> march(const picture& p, const receiver& r, const settings& s, glm::dvec3 azimuth,
                             double offset, int steps, int power) {
    const glm::dvec2 radius = texel_offset(p, r, s.radius * azimuth);
    const glm::dvec2 first = glm::dvec2(r.x + 0.5, r.y + 0.5) + glm::normalize(radius);
    // The half slice is on one side of the line through the receiver across its direction.
    const glm::dvec2 line = glm::normalize(texel_offset(p, r, s.radius * glm::cross(azimuth, r.to_eye)));
    const auto apart = [&](glm::dvec2 way) { return way.x * line.y - way.y * line.x; };
    std::vector<march_tap> taps;
    for (int i = 0; i < steps; ++i) {
        const double share = std::pow((i + offset) / steps, power);
        const glm::dvec2 at = glm::floor(first + radius * share);
        const int x = static_cast<int>(std::clamp(at.x, 0.0, p.width - 1.0)),
                  y = static_cast<int>(std::clamp(at.y, 0.0, p.height - 1.0));
        const double ahead = apart({x - r.x, y - r.y}) * (apart(radius) < 0 ? -1 : 1);
        taps.push_back({x, y, share, power / (i + offset), ahead > 0.5});
    }
    return taps;
}

/// The angle of the tangent plane from the way to the eye, in the slice of an azimuth.
double tangent_of(double n_dot_v, double n_dot_azimuth) {
    return std::atan2(n_dot_v, -n_dot_azimuth);
}

/// The integral of the cosine lobe over a half slice from the eye to an angle, by the midpoint rule.
double lobe(double n_dot_v, double n_dot_azimuth, double angle) {
    constexpr int parts = 400;
    double sum = 0;
    for (int i = 0; i < parts; ++i) {
        const double t = angle * (i + 0.5) / parts;
        sum += (n_dot_v * std::cos(t) + n_dot_azimuth * std::sin(t)) * std::sin(t);
    }
    return sum * angle / parts;
}

/// A point seen from a receiver: its angle from the way to the eye, and that of the tangent plane in its
/// slice.
struct direction_of {
    double angle, tangent;
    direction_of(const receiver& r, glm::dvec3 way) {
        const double towards = glm::dot(way, r.to_eye);
        const glm::dvec3 across = way - towards * r.to_eye;
        angle = std::atan2(glm::length(across), towards);
        tangent = tangent_of(std::max(glm::dot(r.normal, r.to_eye), 0.0),
                             glm::dot(r.normal, glm::normalize(across)));
    }
};

layers_at layers_of(const picture& p) {
    return [&p](int x, int y) {
        std::vector<seen_layer> all;
        for (const glm::dvec3& position : p.positions(x, y))
            all.push_back({position});
        return all;
    };
}

/// The mean of what directions say, each with its weight.
template <class Occlusion>
double weighted_mean(const receiver& r, const half_slices& where, Occlusion occlusion) {
    double sum = 0, weights = 0;
    for (const half_slice& each : where.all) {
        const double a = std::max(glm::dot(r.normal, r.to_eye), 0.0), b = glm::dot(r.normal, each.azimuth);
        const double share = lobe(a, b, tangent_of(a, b)), weight = where.by_importance ? 1 : share;
        sum += weight * occlusion(each, a, b, share);
        weights += weight;
    }
    return sum / std::max(weights, 1e-6);
}

}

half_slices half_directions(const picture& p, const receiver& r, const settings& s, int count, int steps,
                            int power) {
    const glm::dvec3 random = noise(r.pixel_x, r.pixel_y, s);
    glm::dvec3 across, up;
    axes(p, r, across, up);
    half_slices found{.by_importance = true, .all = {}};
    for (int i = 0; i < count; ++i) {
        // A ray of the cosine lobe ends on the unit sphere around the tip of the normal.
        const double angle = 2 * pi * (random.x + i) / count, height = std::fmod(random.z + golden * i, 1.0);
        const glm::dvec3 ray =
            r.normal + height * r.to_eye +
            std::sqrt(1 - height * height) * (std::cos(angle) * across + std::sin(angle) * up);
        const glm::dvec3 azimuth = glm::normalize(ray - glm::dot(ray, r.to_eye) * r.to_eye);
        found.all.push_back(
            {azimuth, march(p, r, s, azimuth, std::fmod(random.y + golden * (i + 1), 1.0), steps, power)});
    }
    return found;
}

half_slices axis_slices(const picture& p, const receiver& r, const settings& s, int steps, int reach) {
    half_slices found;
    for (const axis_march& march : axis_marches(p, r, s, steps, reach)) {
        half_slice along{march.azimuth, {}};
        for (const axis_march::place& at : march.taps)
            along.taps.push_back({at.x, at.y, at.texels / march.radius,
                                  1.0 / static_cast<double>(along.taps.size() + 1), at.counts});
        found.all.push_back(along);
    }
    return found;
}

half_slices slices(const picture& p, const receiver& r, const settings& s, int count, int steps, int power) {
    const glm::dvec3 random = noise(r.pixel_x, r.pixel_y, s);
    glm::dvec3 across, up;
    axes(p, r, across, up);
    half_slices found;
    for (int i = 0; i < count; ++i)
        for (double side : {1.0, -1.0}) {
            const double angle = pi * (random.x + i) / count;
            const glm::dvec3 azimuth = side * (std::cos(angle) * across + std::sin(angle) * up);
            found.all.push_back({azimuth, march(p, r, s, azimuth, std::fmod(random.y + golden * (i + 1), 1.0),
                                                steps, power)});
        }
    return found;
}

double gtao(const picture& p, const receiver& r, const settings& s, const half_slices& where) {
    return gtao(r, s, where, layers_of(p));
}

double gtao(const receiver& r, const settings& s, const half_slices& where, const layers_at& layers) {
    return weighted_mean(r, where, [&](const half_slice& each, double a, double b, double share) {
        double rise = 0;
        for (const march_tap& t : each.taps)
            for (const seen_layer& layer : layers(t.x, t.y)) {
                if (!t.counts)
                    continue;
                const glm::dvec3 way = layer.position - r.position;
                const direction_of seen(r, way);
                const glm::dvec3 stretched(way.x, way.y, way.z * (1 + s.thin_occluders));
                const double nearness =
                    std::clamp((1 - glm::length(stretched) / s.radius) / s.falloff, 0.0, 1.0);
                rise = std::max(rise, std::sqrt(layer.opacity) * nearness *
                                          (std::cos(seen.angle) - std::cos(seen.tangent)));
            }
        const double horizon = std::acos(std::min(std::cos(tangent_of(a, b)) + rise, 1.0));
        return share > 0 ? 1 - lobe(a, b, horizon) / share : 0;
    });
}

namespace {

/// What a layer hides of a half slice, in shares of the angle from the way to the eye down to the tangent
/// plane.
struct span {
    double from, to, opacity;
};

std::vector<span> spans(const picture& p, const receiver& r, const settings& s, const half_slice& each,
                        const layers_at& layers) {
    std::vector<span> all;
    for (const march_tap& t : each.taps)
        for (const seen_layer& layer : layers(t.x, t.y)) {
            if (!t.counts)
                continue;
            const glm::dvec3 way = layer.position - r.position, eye = p.to_eye(layer.position);
            const glm::dvec3 back = glm::dot(eye, r.to_eye) > 0 ? -eye : eye;
            // What of the slab is within the radius, by the quadratic equation.
            const double half = glm::dot(way, back),
                         root = half * half - glm::dot(way, way) + s.radius * s.radius;
            if (!(root > 0))
                continue;
            const double from = std::max(-half - std::sqrt(root), 0.0),
                         to = std::min(-half + std::sqrt(root), s.thickness * s.radius);
            if (!(from < to))
                continue;
            const auto share = [&](double along) {
                const direction_of seen(r, way + along * back);
                return std::min(seen.angle / seen.tangent, 1.0);
            };
            all.push_back({share(from), share(to), layer.opacity});
        }
    return all;
}

}

double visibility_bitmask(const picture& p, const receiver& r, const settings& s, const half_slices& where) {
    return weighted_mean(r, where, [&](const half_slice& each, double, double, double) {
        bool hidden[32] = {};
        const auto sector = [](double share) { return static_cast<int>(std::floor(32 * share + 0.5)); };
        for (const span& layer : spans(p, r, s, each, layers_of(p)))
            for (int i = sector(layer.from); i < sector(layer.to); ++i)
                hidden[i] = true;
        return static_cast<double>(std::count(std::begin(hidden), std::end(hidden), true)) / 32;
    });
}

double visibility_bitmask(const picture& p, const receiver& r, const settings& s, const half_slices& where,
                          const layers_at& layers) {
    return weighted_mean(r, where, [&](const half_slice& each, double, double, double) {
        constexpr int rays = 512;
        const std::vector<span> all = spans(p, r, s, each, layers);
        double hidden = 0;
        for (int i = 0; i < rays; ++i) {
            double most = 0;
            for (const span& layer : all)
                if (layer.from * rays <= i + 0.5 && i + 0.5 < layer.to * rays)
                    most = std::max(most, layer.opacity);
            hidden += most / rays;
        }
        return hidden;
    });
}

// The cheap form, which the shader has too, written out tap by tap. Its angles count from the projected
// normal.
double cosine_bitmask(const picture& p, const receiver& r, const settings& s, const half_slices& where,
                      bool linear, bool isolated) {
    double sum = 0, weights = 0;
    for (const half_slice& each : where.all) {
        const double a = std::max(glm::dot(r.normal, r.to_eye), 0.0), b = glm::dot(r.normal, each.azimuth);
        const double length = std::hypot(a, b), cg = a / length, sg = b / length;
        const auto b_of = [](double x) { return x * (2 - (2 - pi / 2) * x * x); };
        const double share = std::max(a * cg * cg + b * (pi / 2 + b_of(sg)), 0.02);
        const auto sector = [&](double x) { // from the tangent plane
            const double open = a * (1 - x * x) + b * (pi / 2 - b_of(x));
            return static_cast<int>(std::clamp(31 * open / share + 0.5, 0.0, 31.0));
        };
        struct layer {
            glm::dvec3 position;
            const march_tap* tap;
        };
        std::uint32_t hidden = 0;
        double near_sum = 0;
        const auto hide = [&](std::uint32_t bits, double nearness) {
            near_sum += std::popcount(bits & ~hidden) * nearness;
            hidden |= bits;
        };
        // The sectors of a slab and its nearness.
        const auto slab = [&](const layer& l, double thickness, double& nearness) -> std::uint32_t {
            const glm::dvec3 ray = p.is_perspective() ? -l.position / l.position.z : glm::dvec3(0, 0, -1);
            const auto in_slice = [&](glm::dvec3 way) {
                const double height = glm::dot(way, r.normal) + 1e-5 * r.position.z;
                return glm::dvec2(height * cg / length,
                                  glm::dot(way, each.azimuth) - glm::dot(way, r.normal) * sg / length);
            };
            glm::dvec2 front = in_slice(l.position - r.position),
                       back = in_slice(l.position + thickness * ray - r.position);
            front.y *= std::max(0.4, 1 - 0.3 * l.tap->gap);
            const double distance = std::min(glm::length(front), glm::length(back)) / cg;
            nearness = 1 - distance / s.radius;
            if (!l.tap->counts || !(front.x > 0) || !(distance < s.radius))
                return 0;
            const int upper = sector(front.y / glm::length(front)),
                      lower = back.x > 0 ? std::min(sector(back.y / glm::length(back)), upper) : 0;
            return (std::uint32_t{1} << upper) - (std::uint32_t{1} << lower);
        };
        const double endless = std::numeric_limits<double>::infinity();
        const auto front_depth = [&](std::size_t i) {
            return i < each.taps.size() ? -p.positions(each.taps[i].x, each.taps[i].y)[0].z : endless;
        };
        for (std::size_t i = 0; i < each.taps.size(); ++i) {
            const march_tap& t = each.taps[i];
            const std::vector<glm::dvec3> layers = p.positions(t.x, t.y);
            const double before = i == 0 ? -r.position.z : front_depth(i - 1);
            double thickness = s.thickness;
            if (isolated && front_depth(i) + 0.1 * s.radius < std::min(before, front_depth(i + 1)))
                thickness = std::min(thickness, 0.03 + t.gap * t.distance);
            std::uint32_t behind = 0;
            double behind_nearness = 0, counted = 0, nearness = 0;
            for (std::size_t j = layers.size();
                 j-- > 1;) { // the farthest first, as each goes before those behind it
                const std::uint32_t own = slab({layers[j], &t}, s.thickness * s.radius, nearness);
                const double added = std::popcount(behind & ~own);
                behind_nearness = std::popcount(own) * nearness + added * behind_nearness;
                counted = std::popcount(own) + added;
                behind_nearness /= std::max(counted, 1.0);
                behind |= own;
            }
            const std::uint32_t own = slab({layers[0], &t}, thickness * s.radius, nearness);
            hide(behind, behind_nearness);
            hide(own, nearness);
        }
        const double weight = where.by_importance ? 1 : share;
        sum += weight * (linear ? near_sum : std::popcount(hidden)) / 31;
        weights += weight;
    }
    return sum / std::max(weights, 1e-6);
}

}
