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

visibility_image upsample(const visibility_image& image, const picture& p, const settings& s, int factor) {
    visibility_image out{p.width, p.height, {}, {}};
    const double tightness = s.sharpness / s.radius;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
            const glm::dvec3 position = p.position(x, y), normal(p.normals[p.index(x, y)]);
            out.depth.push_back(p.background(x, y) ? 1e9 : -position.z);
            // Pixel (i, j) of the smaller picture stands for texel (i, j) * factor + (factor - 1) / 2 of this
            // one.
            const double px = static_cast<double>(x - (factor - 1) / 2) / factor;
            const double py = static_cast<double>(y - (factor - 1) / 2) / factor;
            const int x0 = static_cast<int>(std::floor(px)), y0 = static_cast<int>(std::floor(py));
            double sum = 0, weights = 0;
            for (int j = 0; j < 2; ++j)
                for (int i = 0; i < 2; ++i) {
                    const int cx = std::clamp(x0 + i, 0, image.width - 1),
                              cy = std::clamp(y0 + j, 0, image.height - 1);
                    const std::size_t coarse = at(image, cx, cy);
                    const int tx = std::min(cx * factor + (factor - 1) / 2, p.width - 1),
                              ty = std::min(cy * factor + (factor - 1) / 2, p.height - 1);
                    const double near = (1 - std::abs(px - x0 - i)) * (1 - std::abs(py - y0 - j)) + 1e-3;
                    // Of background nothing counts.
                    const double apart = p.background(tx, ty)
                                             ? 1e9
                                             : glm::dot(p.position(tx, ty) - position, normal) * tightness;
                    const double weight = near / (1 + apart * apart);
                    sum += weight * image.visibility[coarse];
                    weights += weight;
                }
            out.visibility.push_back(p.background(x, y) ? 1 : sum / weights);
        }
    return out;
}

}
