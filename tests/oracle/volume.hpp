// SPDX-License-Identifier: MIT
// Volumetric obscurance and the unsharp mask as the papers state them, in double precision and apart from the
// shaders.
#pragma once

#include "effect.hpp"

namespace oracle {

/// Where the ray of a texel passes through the volume of a receiver: depths, entering and leaving, and how
/// much of that is under the receiver's tangent plane.
struct line {
    int x, y;
    double near, far, under;
    double weight = 1; ///< by the area of the picture that it stands for
};

/// The points of a receiver, those off the picture left out.
std::vector<tap> sphere_points(const picture& p, const receiver& r, const settings& s, int count);

/// The lines of a receiver, those off the picture left out; through the sphere, or the half of it that the
/// normal points to.
std::vector<line> disk_lines(const picture& p, const receiver& r, const settings& s, int count,
                             bool hemisphere);

/// Occlusion in [0, 1] by (4.1) with the fall-off of A.2: how much more of the volume is filled than by the
/// receiver's tangent plane, as a share of what that leaves empty.
double point_volume(const picture& p, const receiver& r, const settings& s, const std::vector<tap>& points);
double line_volume(const picture& p, const receiver& r, const settings& s, const std::vector<line>& lines);

/// The shade of a texel, to the letter of the listing, on a depth buffer that is clamped to its edge.
/// @param near,far the planes of the projection
double unsharp_shade(const picture& p, int i, int j, int kernel_dimension, double near, double far,
                     double threshold, double factor);

/// The same without a far plane, which leaves the limit of F / 2 times (1), the depth itself, in units of 50
/// radii.
double unsharp_shade_without_far(const picture& p, int i, int j, int kernel_dimension, double radius,
                                 double threshold, double factor);

/// The same as the first where texels are in layers of equal thickness in the listing's depth, and a layer of
/// the window is left out as a whole: where its mean is as far from the texel's depth as the threshold. What
/// the listing reads once more past an edge stands apart.
double unsharp_shade_of_layers(const picture& p, int i, int j, int kernel_dimension, double near, double far,
                               double threshold, double factor, int layers);

}
