// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/output/octahedron.hpp>
#include <crease/parts/output/outputs.hpp>

namespace crease {

inline constexpr glsl_file encoding_bent_cone_glsl{
    "encoding/bent_cone.glsl",
#include <crease/encoding/bent_cone.glsl>
};

inline constexpr glsl_file encoding_visibility_depth_cone_glsl{
    "encoding/visibility_depth_cone.glsl",
#include <crease/encoding/visibility_depth_cone.glsl>
};

inline constexpr glsl_file open_directions_glsl{
    "output/open_directions.glsl",
#include <crease/output/open_directions.glsl>
};

inline constexpr glsl_file bent_cone_glsl{
    "output/bent_cone.glsl",
#include <crease/output/bent_cone.glsl>
};

/// Taps along directions that the estimator is told.
CREASE_TRAIT(known_directions, sampler,
             "the output needs taps along known directions, which the sampler does not propose");

/// Knows which directions are open: crease_open_direction, crease_open_mean, crease_open_cone.
CREASE_TRAIT(open_directions, estimator,
             "the output needs to know open directions, which the estimator does not");

/// The bent normal in view space, unit, and the half angle of the bent cone in radians; 0, 0, 1, pi / 2 where
/// there is background.
inline constexpr resource bent_cone_image{
    .name = "bent_cone", .texels = format::rgba16_float, .life = lifetime::output, .read = access::load};

/// Output: visibility, and the image `bent_cone` of the mean open direction and the cone around it.
struct bent_cone {
    using needs = traits<known_directions, open_directions>;
    static constexpr const glsl_file* files[] = {
        &encoding_visibility_glsl, &encoding_octahedron_glsl,
        &encoding_bent_cone_glsl,  &encoding_visibility_depth_cone_glsl,
        &open_directions_glsl,     &bent_cone_glsl};
    static constexpr resource images[] = {between_image(format::rg32_uint), visibility_image,
                                          bent_cone_image};
    static constexpr part description{
        .kind = role::output,
        .name = "bent_cone",
        .summary = "visibility, and the bent normal with its cone",
        .source = "stochastic-depth-ao 2020, 7.1, Algorithms 10 and 11",
        .files = files,
        .resources = images,
        .needs = needs::list,
        .offers = traits<handed_on_normals, any_resolution>::list,
    };
};

}
