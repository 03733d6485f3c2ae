// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_unpack_surface_normal(uint word);
uint crease_pack_surface_normal(vec3 normal);
uvec4 crease_no_coarse_layer();
bool crease_is_coarse_layer(uvec4 layer);
uvec4 crease_finer_layer(ivec2 texel, int i);
#else
__LINE__, R"glsl("
#endif

// The nearer of two first.
void crease_multi_resolution_order(inout uvec4 a, inout uvec4 b) {
    if (uintBitsToFloat(a.z) < uintBitsToFloat(b.z)) {
        uvec4 farther = a;
        a = b;
        b = farther;
    }
}

// A layer of a smaller picture, of four: of such as are near each other in depth the mean of the middle two, else the
// second nearest: Hoang and Low 2010. Behind layers that are not near each other, places in order are no longer those of
// one surface, and a mean would lie between two.
uvec4 crease_halved(uvec4 a, uvec4 b, uvec4 c, uvec4 d, inout bool aligned) {
    crease_multi_resolution_order(a, b);
    crease_multi_resolution_order(c, d);
    crease_multi_resolution_order(a, c); // a is the nearest
    crease_multi_resolution_order(b, d); // d is the farthest
    crease_multi_resolution_order(b, c);
    float apart = uintBitsToFloat(a.z) - uintBitsToFloat(d.z);
    aligned = aligned && apart <= crease_multi_resolution_step * crease_radius;
    if (!aligned)
        return b;
    vec3 position = 0.5 * (uintBitsToFloat(b.xyz) + uintBitsToFloat(c.xyz));
    vec3 normal = crease_unpack_surface_normal(b.w) + crease_unpack_surface_normal(c.w);
    uint opacity = ((b.w >> 24u) + (c.w >> 24u) + 1u) / 2u;
    return uvec4(floatBitsToUint(position), crease_pack_surface_normal(normal) | opacity << 24u);
}

// The next layer of a texel that has more.
uvec4 crease_next_layer(ivec2 texel, int i, inout bool more) {
    uvec4 layer = more ? crease_finer_layer(texel, i) : crease_no_coarse_layer();
    more = crease_is_coarse_layer(layer);
    return layer;
}

// Each layer of those that are the same in order from the eye. So a coarse texel has as many layers before any depth as at
// least two of the four have.
void crease_build(ivec2 texel) {
    ivec2 first = 2 * texel;
    bool a = true, b = true, c = true, d = true, more = true, aligned = true;
    for (int i = 0; more && i < crease_most_coarse_layers; ++i) {
        uvec4 layer = crease_halved(crease_next_layer(first, i, a), crease_next_layer(first + ivec2(1, 0), i, b),
                                    crease_next_layer(first + ivec2(0, 1), i, c),
                                    crease_next_layer(first + ivec2(1, 1), i, d), aligned);
        imageStore(crease_resolutions, ivec3(texel, i), layer);
        more = crease_is_coarse_layer(layer);
    }
}
#ifdef __cplusplus
")glsl"
#endif
