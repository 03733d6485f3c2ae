// SPDX-License-Identifier: MIT
// Statistical volumetric obscurance as the paper states it: no tables, every area is summed texel by texel,
// in double precision. An area holds a table's texels whose centres are in it.
#pragma once

#include "effect.hpp"

#include <array>

namespace oracle {

/// What a texel of a table stands for: the sum of the positions of the picture's texels in it, and their
/// count.
struct area_texel {
    glm::dvec3 position{0};
    double count = 0;
};

/// The texels of the tables, their sides smaller than the picture's by `divisor`.
struct area_texels {
    int width = 0, height = 0, divisor = 1;
    std::vector<area_texel> texels;
    const area_texel& at(int x, int y) const {
        return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};
area_texels downsample(const picture& p, int divisor);

/// A layer for each texel of the picture.
using layering = std::vector<int>;
layering one_layer(const picture& p);
/// Of equal depth, between the picture's nearest and farthest (4.3), by the mean of each of the tables'
/// texels.
layering uniform_layers(const picture& p, const area_texels& t, int layers);
/// Each layer split by the mean of the same layer around each of the tables' texels, until there are as many
/// (4.4, Algorithm 2).
layering adaptive_layers(const picture& p, const area_texels& t, const settings& s, int layers);

/// The area of the sample box around a position: left, top, right and bottom edge in the picture's texels.
std::array<double, 4> sample_area(const picture& p, glm::dvec2 texel, glm::dvec3 position, double radius);

/// The sum of each layer over one texel of the tables, and over an area of the picture.
std::vector<area_texel> sums_of(const picture& p, const area_texels& t, const layering& of, int layers, int x,
                                int y);
std::vector<area_texel> sums_over(const picture& p, const area_texels& t, const layering& of, int layers,
                                  const std::array<double, 4>& area);

/// The sums over an area by the four squares in its corners, as wide as the greatest power of two, up to
/// `most`, that fits in it (3.3, N-buffer); all together as if over as many texels as the area has.
std::vector<area_texel> sums_of_squares(const area_texels& t, const std::array<double, 4>& area, int most);

/// The sums over an area by the four texels around its middle in each of two mip levels up to `last`, the
/// wider of which is as wide as the area or less (3.3, trilinear filter); all together as if over as many
/// texels as the area has.
std::vector<area_texel> sums_of_mips(const area_texels& t, const std::array<double, 4>& area, int last);

/// Occlusion in [0, 1] of a receiver by the sums of layers: equations 4.3 to 4.6 and the falloff of A.2.
double mean_height(const receiver& r, const settings& s, const std::vector<area_texel>& sums, bool oriented);

}
