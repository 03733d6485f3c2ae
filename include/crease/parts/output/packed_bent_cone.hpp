// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/output/bent_cone.hpp>

namespace crease {

inline constexpr glsl_file encoding_packed_bent_cone_glsl{
    "encoding/packed_bent_cone.glsl",
#include <crease/encoding/packed_bent_cone.glsl>
};

/// The bent normal, the cone and visibility in the bytes of one texel.
///
/// Red and green: the bent normal n in view space as a point of the octahedron. With p = 2 * (red, green) - 1
/// and z = 1 - |p.x| - |p.y| it is (p, z) made unit, where z < 0 with p.x moved by z towards 0 and p.y
/// likewise; 8 bits each way are at most 1 degree away. Blue: the half angle of the bent cone over pi / 2.
/// Alpha: visibility. Where there is background n is (0, 0, 1), the cone and visibility are 1.
inline constexpr resource packed_bent_cone_image{.name = "packed_bent_cone",
                                                 .texels = format::rgba8_unorm,
                                                 .life = lifetime::output,
                                                 .read = access::load};

/// Output: the image `packed_bent_cone` of the mean open direction, the cone around it and visibility: 4
/// bytes where `bent_cone` writes 9, and no image of visibility alone.
struct packed_bent_cone {
    using needs = traits<known_directions, open_directions>;
    static constexpr const glsl_file* files[] = {&encoding_octahedron_glsl, &encoding_packed_bent_cone_glsl,
                                                 &encoding_visibility_depth_cone_glsl, &open_directions_glsl,
                                                 &bent_cone_glsl};
    static constexpr resource images[] = {between_image(format::rg32_uint), packed_bent_cone_image};
    static constexpr part description{
        .kind = role::output,
        .name = "packed_bent_cone",
        .summary = "the bent normal with its cone, and visibility, in the bytes of one texel",
        .source = "stochastic-depth-ao 2020, 7.1, Algorithms 10 and 11",
        .files = files,
        .resources = images,
        .needs = needs::list,
        .offers = traits<handed_on_normals, any_resolution>::list,
    };
};

}
