// SPDX-License-Identifier: MIT
#include "effect.hpp"

#include <crease/parts/noise/blue_noise.hpp>

#include <cmath>
#include <map>
#include <utility>

namespace oracle {

namespace {

glm::dvec3 hashed_noise(int x, int y, std::uint32_t frame) {
    std::uint32_t v[3] = {static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), frame};
    for (std::uint32_t& c : v)
        c = c * 1664525u + 1013904223u;
    const auto mix = [&v] {
        const std::uint32_t a = v[0] + v[1] * v[2], b = v[1] + v[2] * v[0], c = v[2] + v[0] * v[1];
        v[0] = a, v[1] = b, v[2] = c;
    };
    mix();
    for (std::uint32_t& c : v)
        c ^= c >> 16;
    mix();
    return glm::dvec3(v[0] >> 8, v[1] >> 8, v[2] >> 8) / 16777216.0;
}

glm::dvec3 tiled_noise(int x, int y, std::uint32_t frame, int side) {
    const double place = (static_cast<double>(frame) * side + y % side) * side + x % side;
    return glm::fract(0.5 +
                      place * glm::dvec3((std::sqrt(5.0) - 1) / 2, std::sqrt(2.0) - 1, std::sqrt(3.0) - 1));
}

double gradient(double x, double y) {
    return glm::fract(52.9829189 * glm::fract(0.06711056 * x + 0.00583715 * y)); // of less than 0 too
}

glm::dvec3 interleaved_gradient_noise(int x, int y, std::uint32_t frame) {
    const double moved = 5.588238 * (frame % 64), u = x + moved, v = y + moved;
    return {gradient(u, v), gradient(v + 17, u + 47), gradient(38 - v, u + 69)};
}

/// Counts the places of a Hilbert curve: a square with a corner and two sides, cut in four, each with a curve
/// of its own, of which the first and the last are turned over.
void walk(std::map<std::pair<int, int>, int>& places, glm::dvec2 corner, glm::dvec2 first, glm::dvec2 second,
          int depth) {
    if (depth == 0) {
        const glm::ivec2 middle(corner + (first + second) / 2.0);
        const int count = static_cast<int>(places.size());
        places[{middle.x, middle.y}] = count;
        return;
    }
    const glm::dvec2 a = first / 2.0, b = second / 2.0;
    walk(places, corner, b, a, depth - 1);
    walk(places, corner + a, a, b, depth - 1);
    walk(places, corner + a + b, a, b, depth - 1);
    walk(places, corner + a + second, -b, -a, depth - 1);
}

/// R2, whose steps are powers of the inverse of the root of x^3 = x + 1, and the golden ratio's sequence.
glm::dvec3 steps_of_sequences() {
    double root = 1.5;
    for (int i = 0; i < 60; ++i)
        root = std::cbrt(1 + root);
    return {1 / root, 1 / (root * root), (std::sqrt(5.0) - 1) / 2};
}

glm::dvec3 hilbert_r2_noise(int x, int y, std::uint32_t frame) {
    static const auto places = [] {
        std::map<std::pair<int, int>, int> all;
        walk(all, {0, 0}, {0, 64}, {64, 0}, 6);
        return all;
    }();
    return glm::fract(0.5 + (places.at({x % 64, y % 64}) + 1140.0 * frame) * steps_of_sequences());
}

glm::dvec3 blue_noise(int x, int y, std::uint32_t frame) {
    const auto at = [x, y](int right, int down, double values) {
        const unsigned rank =
            crease::blue_noise::rank(static_cast<unsigned>(x + right), static_cast<unsigned>(y + down));
        return (std::floor(rank * values / 4096) + 0.5) / values;
    };
    return glm::fract(glm::dvec3(at(0, 0, 2048), at(21, 39, 2048), at(43, 13, 1024)) +
                      static_cast<double>(frame) * steps_of_sequences());
}

}

glm::dvec3 noise(int x, int y, const settings& s) {
    if (s.noise.starts_with("tiled_noise"))
        return tiled_noise(x, y, s.frame, s.noise == "tiled_noise" ? 4 : std::stoi(s.noise.substr(12)));
    return s.noise == "interleaved_gradient_noise" ? interleaved_gradient_noise(x, y, s.frame)
           : s.noise == "hilbert_r2_noise"         ? hilbert_r2_noise(x, y, s.frame)
           : s.noise == "blue_noise"               ? blue_noise(x, y, s.frame)
                                                   : hashed_noise(x, y, s.frame);
}

}
