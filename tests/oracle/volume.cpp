// SPDX-License-Identifier: MIT
#include "volume.hpp"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace oracle {

namespace {

/// How a surface at this depth counts: fully up to the radius before the receiver, and then less and less.
double reach(const receiver& r, const settings& s, double depth) {
    const double height = -r.position.z - depth;
    if (height <= s.radius)
        return 1;
    return 1 - std::min(1.0, (height - s.radius) / (s.falloff * s.radius));
}

double surface_depth(const picture& p, int x, int y) {
    return p.background(x, y) ? 1e15 : -p.position(x, y).z;
}

}

std::vector<tap> sphere_points(const picture& p, const receiver& r, const settings& s, int count) {
    const glm::dvec2 random(noise(r.pixel_x, r.pixel_y, s));
    glm::dvec3 across, up;
    axes(p, r, across, up);
    const double golden_angle = glm::pi<double>() * (3 - std::sqrt(5.0));
    std::vector<tap> points;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * glm::pi<double>() * random.x + golden_angle * (i + 1);
        const double distance =
            radius_inside(p, r, s.radius) * std::cbrt(std::fmod(random.y + 0.75487767 * (i + 1), 1.0));
        const double cosine = 1 - (2 * i + 1.0) / count, sine = std::sqrt(1 - cosine * cosine);
        const glm::dvec3 point = r.position + distance * (sine * std::cos(angle) * across +
                                                          sine * std::sin(angle) * up + cosine * r.to_eye);
        if (!(point.z < 0))
            continue;
        const glm::dvec2 at = p.project(point);
        tap t{static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)), {}};
        if (!p.contains(t.x, t.y))
            continue;
        const glm::dvec4 clip = p.projection * glm::dvec4(point, 1);
        t.point = p.unproject({t.x + 0.5, t.y + 0.5}, clip.z / clip.w);
        points.push_back(t);
    }
    return points;
}

std::vector<line> disk_lines(const picture& p, const receiver& r, const settings& s, int count,
                             bool hemisphere) {
    const glm::dvec2 random(noise(r.pixel_x, r.pixel_y, s));
    glm::dvec3 across, up;
    axes(p, r, across, up);
    const double golden_angle = glm::pi<double>() * (3 - std::sqrt(5.0));
    std::vector<line> lines;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * glm::pi<double>() * random.x + golden_angle * (i + 1);
        const glm::dvec2 centre(r.x + 0.5, r.y + 0.5),
            whole = texel_offset(p, r, s.radius * (std::cos(angle) * across + std::sin(angle) * up));
        const double share = share_inside(p, centre, whole);
        const glm::dvec2 at = centre + whole * share * std::sqrt((i + random.y) / count);
        line l{
            static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)), 0, 0, 0, share * share};
        if (!p.contains(l.x, l.y))
            continue;
        glm::dvec3 origin, ray;
        p.ray({l.x + 0.5, l.y + 0.5}, origin, ray);
        // The ray through a sphere, by the quadratic equation.
        const glm::dvec3 from = origin - r.position;
        const double b = glm::dot(from, ray), c = glm::dot(from, from) - s.radius * s.radius;
        if (b * b > c) {
            double enter = -b - std::sqrt(b * b - c), leave = -b + std::sqrt(b * b - c);
            // A ray that goes down is under the plane from there on; one that comes up was so until there.
            const double down = glm::dot(ray, r.normal);
            const double plane = std::clamp(-glm::dot(from, r.normal) / down, enter, leave);
            l.under = (down < 0 ? leave - plane : plane - enter) * -ray.z;
            if (hemisphere) {
                (down < 0 ? leave : enter) = plane;
                l.under = 0;
            }
            l.near = -(origin + enter * ray).z;
            l.far = -(origin + leave * ray).z;
        }
        lines.push_back(l);
    }
    return lines;
}

double point_volume(const picture& p, const receiver& r, const settings& s, const std::vector<tap>& points) {
    double more = 0, empty = 0;
    for (const tap& t : points) {
        const double height = glm::dot(t.point - r.position, r.normal);
        if (std::abs(height) <= s.bias * std::min(s.radius, -r.position.z))
            continue;
        const double depth = surface_depth(p, t.x, t.y);
        const bool filled = depth < -t.point.z;
        if (height > 0)
            more += filled ? reach(r, s, depth) : 0;
        else
            more -= filled ? 0 : 1;
        empty += height > 0;
    }
    return std::max(more / std::max(empty, 1.0), 0.0);
}

double line_volume(const picture& p, const receiver& r, const settings& s, const std::vector<line>& lines) {
    double more = 0, empty = 0;
    for (const line& l : lines) {
        if (!(l.far > l.near))
            continue;
        const double depth = surface_depth(p, l.x, l.y);
        more += l.weight * reach(r, s, depth) * (l.far - std::clamp(depth, l.near, l.far) - l.under);
        empty += l.weight * (l.far - l.near - l.under);
    }
    return std::max(more / std::max(empty, 0.1 * s.radius), 0.0);
}

namespace {

/// The texel that holds a place of the depth buffer in [0, 1].
glm::ivec2 texel_of(const picture& p, double u, double v) {
    return {std::min(static_cast<int>(std::floor(u * p.width + 1e-9)), p.width - 1),
            std::min(static_cast<int>(std::floor(v * p.height + 1e-9)), p.height - 1)};
}

// Equation (1) at a place of the depth buffer in [0, 1].
double linearize_depth(const picture& p, double u, double v, double near, double far) {
    const glm::ivec2 at = texel_of(p, u, v);
    const double z = p.device[p.index(at.x, at.y)];
    return (2.0 * near) / (far + near - z * (far - near));
}

}

namespace {

/// The listing's loops, over any function of places of the depth buffer in [0, 1].
template <class Depth>
double shade_by(const Depth& depth_at, const picture& p, int i, int j, int kernel_dimension, double threshold,
                double factor) {
    const double own = depth_at((i + 0.5) / p.width, (j + 0.5) / p.height);
    double sum = 0, neighbour_count = 0;
    const int half = kernel_dimension / 2;
    for (int x = i - half; x < i + half; x++)
        for (int y = j - half; y < j + half; y++) {
            const double u = static_cast<double>(x) / p.width, v = static_cast<double>(y) / p.height;
            if (u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0 && std::abs(own - depth_at(u, v)) < threshold) {
                sum += depth_at(u, v);
                neighbour_count++;
            }
        }
    sum = sum / neighbour_count;
    return factor * (own - std::max(0.0, sum));
}

}

double unsharp_shade(const picture& p, int i, int j, int kernel_dimension, double near, double far,
                     double threshold, double factor) {
    return shade_by([&](double u, double v) { return linearize_depth(p, u, v, near, far); }, p, i, j,
                    kernel_dimension, threshold, factor);
}

double unsharp_shade_without_far(const picture& p, int i, int j, int kernel_dimension, double radius,
                                 double threshold, double factor) {
    return shade_by(
        [&](double u, double v) {
            const glm::ivec2 at = texel_of(p, u, v);
            return p.background(at.x, at.y) ? 1e15 : -p.position(at.x, at.y).z / (50 * radius);
        },
        p, i, j, kernel_dimension, threshold, factor);
}

double unsharp_shade_of_layers(const picture& p, int i, int j, int kernel_dimension, double near, double far,
                               double threshold, double factor, int layers) {
    double nearest = 1, farthest = 0;
    for (float z : p.device) {
        const double depth = (2.0 * near) / (far + near - z * (far - near));
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    std::vector<double> sums(4 * static_cast<std::size_t>(layers)), counts(sums.size());
    const int half = kernel_dimension / 2;
    for (int x = i - half; x < i + half; x++)
        for (int y = j - half; y < j + half; y++) {
            if (x < 0 || x > p.width || y < 0 || y > p.height)
                continue;
            const double depth = linearize_depth(p, static_cast<double>(x) / p.width,
                                                 static_cast<double>(y) / p.height, near, far);
            const int layer = static_cast<int>((depth - nearest) / (farthest - nearest) * layers);
            const int past = (x == p.width ? 1 : 0) + (y == p.height ? 2 : 0);
            const auto of = static_cast<std::size_t>(4 * std::min(layer, layers - 1) + past);
            sums[of] += depth;
            counts[of] += 1;
        }
    const double own = linearize_depth(p, (i + 0.5) / p.width, (j + 0.5) / p.height, near, far);
    double sum = 0, count = 0;
    for (std::size_t of = 0; of < sums.size(); ++of)
        if (counts[of] > 0 && std::abs(own - sums[of] / counts[of]) < threshold) {
            sum += sums[of];
            count += counts[of];
        }
    return count > 0 ? factor * (own - sum / count) : 0;
}

}
