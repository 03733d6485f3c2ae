// SPDX-License-Identifier: MIT
#pragma once

#include "image/image.hpp"
#include "scene/scene.hpp"

#include <cstdint>
#include <functional>

namespace crease::tools {

/// Settings that no truth can be traced with.
struct truth_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Thrown where the progress callback asked to stop.
struct truth_cancelled : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct truth_settings {
    unsigned width = 1280, height = 720; ///< texels, 1 to 16384
    float radius = 1;                    ///< world units, >= 0; 0 means that nothing occludes
    unsigned rays = 256;                 ///< for each texel, > 0
    bool first_layer = false;            ///< whether to make ao_first_layer
    bool hull =
        false; ///< whether transparent surfaces are thin hulls, which what lies behind them occludes too
    std::uint32_t seed = 1; ///< changes the rays; with the same seed the images are the same
    unsigned threads = 0;   ///< 0: one for each core; the images do not depend on it
    std::function<bool(double)> progress = {}; ///< called now and then, on the calling thread, with the
                                               ///< fraction done; false cancels
};

/// What a camera sees, ray traced. Row 0 is at the top.
struct truth {
    image ao_hard;   ///< visibility where a hit at distance d <= radius occludes by 1
    image ao_linear; ///< ... by 1 - d / radius
    image ao_quad;   ///< ... by 1 - (d / radius)^2
    image depth;     ///< positive linear view depth of the first surface; the camera's far in the background
    image bent; ///< 3 channels: the mean direction of the open rays, each weighed by its visibility as in
                ///< ao_linear, in view space, unit; 0 in the background
    image ao_first_layer; ///< as ao_linear, but what the camera cannot see behind a nearer surface occludes
                          ///< nothing; only where the settings ask for it
    image normal; ///< 3 channels: unit geometric normal of the first surface in view space, facing the
                  ///< camera; 0 in the background
};

/// Raise it with each change after which `trace_truth` gives other images.
inline constexpr int tracer_version = 1;

/// 1 where geometry that the camera cannot see takes more than 0.15 of the visibility, else 0.
image hidden_mask(const truth& traced);

/// Traces a ray through the centre of each texel, clipped to [near, far] as a rasteriser does, and from what
/// it hits `rays` more, cosine-weighted around the geometric normal on the side of the camera. Visibility is
/// 1 - the mean occlusion; background is 1. The field of view is the camera's; its width and height are not
/// used.
///
/// A surface stops a ray with its opacity as probability: of the surfaces i that a ray meets front to back,
/// with opacities a_i, each gets the share s_i = a_i (1 - a_0) ... (1 - a_(i-1)). What occludes is the sum of
/// s_i f(d_i), with f of the three above; and of the camera's ray each surface is a receiver, so that the
/// visibility of a texel is 1 - the sum of s_i AO_i. With `hull`, AO_i is a_i of the hemisphere towards the
/// camera and 1 - a_i of the other, which is what Bauer et al. 2013 have as equations 2 to 4, whichever side
/// is the front.
/// @throws truth_error, truth_cancelled, scene_error
truth trace_truth(const mesh& scene, const camera& from, const truth_settings& settings);

}
