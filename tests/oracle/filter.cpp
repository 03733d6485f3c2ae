// SPDX-License-Identifier: MIT
#include "effect.hpp"

#include <algorithm>
#include <cmath>

namespace oracle {

namespace {

std::size_t at(const visibility_image& image, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
}

/// Depth slope of one side: of the neighbour there, unless it looks like an edge and the other side does not.
double slope(double own, double other, double tightness) {
    return std::abs(own) * tightness > 1 && std::abs(own) > 2 * std::abs(other) ? -other : own;
}

visibility_image blur(const visibility_image& image, const settings& s, int radius, int dx, int dy) {
    visibility_image out = image;
    const double tightness = s.sharpness / s.radius;
    const auto depth = [&](int x, int y) {
        return image.depth[at(image, std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1))];
    };
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double centre = depth(x, y);
            if (centre >= 1e6)
                continue;
            const double before = depth(x - dx, y - dy) - centre, after = depth(x + dx, y + dy) - centre;
            double sum = 0, weights = 0;
            for (int i = -radius; i <= radius; ++i) {
                const int tx = x + i * dx, ty = y + i * dy;
                if (tx < 0 || ty < 0 || tx >= image.width || ty >= image.height)
                    continue;
                const double rise = i < 0 ? slope(before, after, tightness) : slope(after, before, tightness);
                const double apart = (depth(tx, ty) - centre - rise * std::abs(i)) * tightness;
                const double weight = std::exp2(-2.0 * i * i / (radius * radius) - apart * apart);
                sum += weight * image.visibility[at(image, tx, ty)];
                weights += weight;
            }
            out.visibility[at(out, x, y)] = sum / weights;
        }
    return out;
}

}

visibility_image bilateral(const visibility_image& image, const settings& s, int radius) {
    return blur(blur(image, s, radius, 1, 0), s, radius, 0, 1);
}

namespace {

/// The texel of the picture that a pixel of a smaller one stands for.
glm::ivec2 texel_of(const picture& p, int x, int y, int divisor) {
    return {std::min(x * divisor + (divisor - 1) / 2, p.width - 1),
            std::min(y * divisor + (divisor - 1) / 2, p.height - 1)};
}

/// A distance from a tangent plane, in that at which a weight ends; far off for background.
double reaches(const picture& p, const settings& s, glm::dvec3 from, glm::ivec2 to, glm::dvec3 normal,
               double depth) {
    if (p.background(to.x, to.y))
        return 1e6;
    const double reach = std::max(s.plane_reach * s.radius, 1e-4 * depth); // what rounding of depths allows
    return std::abs(glm::dot(p.position(to.x, to.y) - from, normal)) / reach;
}

/// A joint bilateral blur over the pixels that are up to so many to the sides.
visibility_image blur_by_planes(const visibility_image& image, const picture& p, const settings& s,
                                int radius, int divisor, glm::ivec2 sides) {
    visibility_image out = image;
    const double deviation = 0.75 * radius;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const glm::ivec2 own = texel_of(p, x, y, divisor);
            if (p.background(own.x, own.y))
                continue;
            const std::size_t centre = at(image, x, y);
            double sum = 0, weights = 0;
            for (int j = -sides.y; j <= sides.y; ++j)
                for (int i = -sides.x; i <= sides.x; ++i) {
                    const int px = std::clamp(x + i, 0, image.width - 1),
                              py = std::clamp(y + j, 0, image.height - 1);
                    const std::size_t other = at(image, px, py);
                    const double apart = reaches(p, s, p.position(own.x, own.y), texel_of(p, px, py, divisor),
                                                 image.normals[centre], image.depth[centre]);
                    const double alike = std::max(glm::dot(image.normals[centre], image.normals[other]), 0.0);
                    const double weight = std::exp(-(i * i + j * j) / (2 * deviation * deviation)) *
                                          std::max(1 - apart, 0.0) * std::max(std::pow(alike, 8), 0.2);
                    sum += weight * image.visibility[other];
                    weights += weight;
                }
            out.visibility[centre] = sum / weights;
        }
    return out;
}

}

visibility_image plane_filter(const visibility_image& image, const picture& p, const settings& s, int radius,
                              int divisor) {
    return blur_by_planes(image, p, s, radius, divisor, {radius, radius});
}

visibility_image separable_plane_filter(const visibility_image& image, const picture& p, const settings& s,
                                        int radius, int divisor) {
    const visibility_image rows = blur_by_planes(image, p, s, radius, divisor, {radius, 0});
    return blur_by_planes(rows, p, s, radius, divisor, {0, radius});
}

visibility_image upsample(const visibility_image& image, const picture& p, const settings& s, int factor) {
    visibility_image out{p.width, p.height, {}, {}, {}};
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
            const glm::dvec3 position = p.position(x, y);
            out.depth.push_back(p.background(x, y) ? 1e9 : -position.z);
            // Pixel (i, j) of the smaller picture stands for texel (i, j) * factor + (factor - 1) / 2 of this
            // one.
            const double px = static_cast<double>(x - (factor - 1) / 2) / factor;
            const double py = static_cast<double>(y - (factor - 1) / 2) / factor;
            const int x0 = static_cast<int>(std::floor(px)), y0 = static_cast<int>(std::floor(py));
            double sum = 0, weights = 0;
            glm::dvec3 normal(0);
            for (int j = 0; j < 2; ++j)
                for (int i = 0; i < 2; ++i) {
                    const int cx = std::clamp(x0 + i, 0, image.width - 1),
                              cy = std::clamp(y0 + j, 0, image.height - 1);
                    const std::size_t coarse = at(image, cx, cy);
                    const double near = (1 - std::abs(px - x0 - i)) * (1 - std::abs(py - y0 - j)) + 1e-3;
                    const double apart = reaches(p, s, position, texel_of(p, cx, cy, factor),
                                                 image.normals[coarse], -position.z);
                    const double weight = near * std::max(1 - apart, 1e-4 / (1 + apart));
                    sum += weight * image.visibility[coarse];
                    normal += weight * image.normals[coarse];
                    weights += weight;
                }
            out.visibility.push_back(p.background(x, y) ? 1 : sum / weights);
            out.normals.push_back(glm::normalize(normal));
        }
    return out;
}

}
