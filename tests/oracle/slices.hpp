// SPDX-License-Identifier: MIT
// Samplers and estimators by half slices, in double precision and apart from the shaders.
#pragma once

#include "effect.hpp"

#include <vector>

namespace oracle {

/// A texel that a march along a half slice proposes: where the picture ends, one of its edge.
struct march_tap {
    int x, y;
    double distance, gap; ///< from the receiver, radii; between the taps around it, as a share of that
    bool counts;          ///< whether it is in the half slice, half a texel ahead
};

/// A direction: unit, across the direction to the eye.
struct half_slice {
    glm::dvec3 azimuth;
    std::vector<march_tap> taps;
};

/// The half slices of a receiver; those by importance count the same, the others by their shares of the
/// cosine lobe.
struct half_slices {
    bool by_importance = false;
    std::vector<half_slice> all;
};

half_slices half_directions(const picture& p, const receiver& r, const settings& s, int count, int steps,
                            int power = 2);
half_slices slices(const picture& p, const receiver& r, const settings& s, int count, int steps,
                   int power = 2);
half_slices axis_slices(const picture& p, const receiver& r, const settings& s, int steps, int reach);

/// Occlusion in [0, 1] of a receiver from its half slices, by the layers of the picture or by others.
double gtao(const picture& p, const receiver& r, const settings& s, const half_slices& where);
double gtao(const receiver& r, const settings& s, const half_slices& where, const layers_at& layers);
double visibility_bitmask(const picture& p, const receiver& r, const settings& s, const half_slices& where);
/// Of layers with opacities, ray by ray and without sectors: each loses what the most opaque layer in its way
/// hides.
double visibility_bitmask(const picture& p, const receiver& r, const settings& s, const half_slices& where,
                          const layers_at& layers);
double cosine_bitmask(const picture& p, const receiver& r, const settings& s, const half_slices& where,
                      bool linear, bool isolated);

}
