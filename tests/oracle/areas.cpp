// SPDX-License-Identifier: MIT
#include "areas.hpp"

#include <algorithm>
#include <cmath>

namespace oracle {

area_texels downsample(const picture& p, int divisor) {
    area_texels t{(p.width + divisor - 1) / divisor, (p.height + divisor - 1) / divisor, divisor, {}};
    t.texels.resize(static_cast<std::size_t>(t.width) * static_cast<std::size_t>(t.height));
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
            if (!p.background(x, y)) {
                area_texel& of = t.texels[static_cast<std::size_t>(y / divisor * t.width + x / divisor)];
                of.position += p.position(x, y);
                of.count += 1;
            }
    return t;
}

layering one_layer(const picture& p) {
    return layering(p.device.size(), 0);
}

namespace {

double depth_of(const area_texel& t) {
    return -t.position.z / t.count;
}

}

layering uniform_layers(const picture& p, const area_texels& t, int layers) {
    double nearest = 1e30, farthest = 0;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
            if (!p.background(x, y)) {
                nearest = std::min(nearest, -p.position(x, y).z);
                farthest = std::max(farthest, -p.position(x, y).z);
            }
    layering of;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
            const area_texel& own = t.at(x / t.divisor, y / t.divisor);
            const double share =
                own.count > 0 ? (depth_of(own) - nearest) / std::max(farthest - nearest, 1e-20) : 0;
            of.push_back(std::clamp(static_cast<int>(share * layers), 0, layers - 1));
        }
    return of;
}

std::array<double, 4> sample_area(const picture& p, glm::dvec2 texel, glm::dvec3 position, double radius) {
    // The disk of the radius that faces the eye, by the bounds of its outline near the position.
    const glm::dvec3 eye = p.to_eye(position);
    const glm::dvec3 across =
        p.is_perspective() ? glm::normalize(glm::cross(glm::dvec3(0, 1, 0), eye)) : glm::dvec3(1, 0, 0);
    const glm::dvec3 up = glm::cross(eye, across);
    const double small = 1e-5;
    const auto moved = [&](glm::dvec3 axis) {
        return (p.project(position + small * axis) - p.project(position - small * axis)) *
               (0.25 * radius / (2 * small)); // the box is half a radius wide
    };
    const glm::dvec2 a = moved(across), b = moved(up);
    const glm::dvec2 reach(std::hypot(a.x, b.x), std::hypot(a.y, b.y));
    return {texel.x - reach.x, texel.y - reach.y, texel.x + reach.x, texel.y + reach.y};
}

namespace {

/// The tables' texels whose centres are in an area of the picture.
glm::ivec4 box_of(const area_texels& t, const std::array<double, 4>& area) {
    const auto edge = [&](std::size_t i, int size) {
        return std::clamp(static_cast<int>(std::floor(area[i] / t.divisor + 0.5)), 0, size);
    };
    return {edge(0, t.width), edge(1, t.height), edge(2, t.width), edge(3, t.height)};
}

void add_texel(std::vector<area_texel>& sums, const picture& p, const area_texels& t, const layering& of,
               int x, int y) {
    for (int py = y * t.divisor; py < std::min((y + 1) * t.divisor, p.height); ++py)
        for (int px = x * t.divisor; px < std::min((x + 1) * t.divisor, p.width); ++px)
            if (!p.background(px, py)) {
                area_texel& sum = sums[static_cast<std::size_t>(of[p.index(px, py)])];
                sum.position += p.position(px, py);
                sum.count += 1;
            }
}

}

std::vector<area_texel> sums_of(const picture& p, const area_texels& t, const layering& of, int layers, int x,
                                int y) {
    std::vector<area_texel> sums(static_cast<std::size_t>(layers));
    add_texel(sums, p, t, of, x, y);
    return sums;
}

std::vector<area_texel> sums_over(const picture& p, const area_texels& t, const layering& of, int layers,
                                  const std::array<double, 4>& area) {
    const glm::ivec4 box = box_of(t, area);
    std::vector<area_texel> sums(static_cast<std::size_t>(layers));
    for (int y = box.y; y < box.w; ++y)
        for (int x = box.x; x < box.z; ++x)
            add_texel(sums, p, t, of, x, y);
    return sums;
}

layering adaptive_layers(const picture& p, const area_texels& t, const settings& s, int layers) {
    layering of = one_layer(p);
    for (int first = 1; first < layers; first *= 2) {
        layering next = of;
        for (int y = 0; y < t.height; ++y)
            for (int x = 0; x < t.width; ++x) {
                const area_texel& own = t.at(x, y);
                if (own.count == 0)
                    continue;
                const glm::dvec2 middle((x + 0.5) * t.divisor, (y + 0.5) * t.divisor);
                const auto area = sample_area(p, middle, own.position / own.count, s.radius);
                const std::vector<area_texel> around = sums_over(p, t, of, layers, area);
                for (int py = y * t.divisor; py < std::min((y + 1) * t.divisor, p.height); ++py)
                    for (int px = x * t.divisor; px < std::min((x + 1) * t.divisor, p.width); ++px) {
                        const int layer = of[p.index(px, py)];
                        const double depth = -p.position(px, py).z;
                        // A hundredth of the radius is the shader's margin against rounding.
                        const bool nearer =
                            depth < depth_of(around[static_cast<std::size_t>(layer)]) - 0.01 * s.radius;
                        if (layer + first < layers && !nearer)
                            next[p.index(px, py)] = layer + first;
                    }
            }
        of = next;
    }
    return of;
}

namespace {

area_texel operator*(const area_texel& sum, double factor) {
    return {sum.position * factor, sum.count * factor};
}

area_texel operator+(const area_texel& a, const area_texel& b) {
    return {a.position + b.position, a.count + b.count};
}

/// The sum over a square of the tables' texels, what of it lies beyond them left out.
area_texel sum_of_square(const area_texels& t, int left, int top, int side) {
    area_texel sum;
    for (int y = std::max(top, 0); y < std::min(top + side, t.height); ++y)
        for (int x = std::max(left, 0); x < std::min(left + side, t.width); ++x)
            sum = sum + t.at(x, y);
    return sum;
}

}

std::vector<area_texel> sums_of_squares(const area_texels& t, const std::array<double, 4>& area, int most) {
    const glm::ivec4 box = box_of(t, area);
    const int width = box.z - box.x, height = box.w - box.y;
    if (width < 1 || height < 1)
        return {};
    int side = 1;
    while (2 * side <= std::min({width, height, most}))
        side *= 2;
    std::vector<area_texel> sums;
    for (int x : {box.x, box.z - side})
        for (int y : {box.y, box.w - side})
            sums.push_back(sum_of_square(t, x, y, side) * (double{1} * width * height / (4.0 * side * side)));
    return sums;
}

std::vector<area_texel> sums_of_mips(const area_texels& t, const std::array<double, 4>& area, int last) {
    std::array<double, 4> box{};
    for (std::size_t i = 0; i < 4; ++i)
        box[i] = std::clamp(area[i] / t.divisor, 0.0, static_cast<double>(i % 2 == 0 ? t.width : t.height));
    const double width = box[2] - box[0], height = box[3] - box[1];
    std::vector<area_texel> sums;
    const auto between = [&](int level, double share) {
        const double side = std::exp2(level);
        const double x = (box[0] + box[2]) / 2 / side - 0.5, y = (box[1] + box[3]) / 2 / side - 0.5;
        const double left = std::floor(x), top = std::floor(y);
        for (int j : {0, 1})
            for (int i : {0, 1})
                sums.push_back(sum_of_square(t, static_cast<int>((left + i) * side),
                                             static_cast<int>((top + j) * side), static_cast<int>(side)) *
                               ((i == 0 ? 1 - x + left : x - left) * (j == 0 ? 1 - y + top : y - top) *
                                share * width * height / (side * side)));
    };
    const double level =
        std::clamp(std::log2(std::max({width, height, 1.0})) - 1, 0.0, static_cast<double>(last));
    const int lower = static_cast<int>(level);
    between(lower, 1 - (level - lower));
    between(std::min(lower + 1, last), level - lower);
    return sums;
}

double mean_height(const receiver& r, const settings& s, const std::vector<area_texel>& sums, bool oriented) {
    double occlusion = 0, texels = 0;
    for (const area_texel& sum : sums) {
        if (sum.count <= 0)
            continue;
        const glm::dvec3 mean = sum.position / sum.count;
        const double height =
            (oriented ? glm::dot(mean - r.position, r.normal) : mean.z - r.position.z) / s.radius;
        double own = std::clamp((height - s.bias) / s.threshold, 0.0, 1.0);
        if (height > s.threshold)
            own *= 1 - std::min(1.0, (height - s.threshold) / s.falloff);
        occlusion += own * sum.count;
        texels += sum.count;
    }
    // Less than four texels tell less, and one alone nothing.
    return texels > 1 ? occlusion / texels * std::min((texels - 1) / 3, 1.0) : 0;
}

}
