// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_multi_resolution_normal(uint word);
uint crease_multi_resolution_pack(vec3 normal);
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

// A texel of a smaller picture, of four: view-space position, as bits, and packed normal. Of four that are near each other
// in depth the mean of the middle two, else the second nearest: Hoang and Low 2010.
uvec4 crease_halved(uvec4 a, uvec4 b, uvec4 c, uvec4 d) {
    crease_multi_resolution_order(a, b);
    crease_multi_resolution_order(c, d);
    crease_multi_resolution_order(a, c); // a is the nearest
    crease_multi_resolution_order(b, d); // d is the farthest
    crease_multi_resolution_order(b, c);
    float apart = uintBitsToFloat(a.z) - uintBitsToFloat(d.z);
    if (!(apart <= crease_multi_resolution_step * crease_radius))
        return b;
    vec3 position = 0.5 * (uintBitsToFloat(b.xyz) + uintBitsToFloat(c.xyz));
    vec3 normal = crease_multi_resolution_normal(b.w) + crease_multi_resolution_normal(c.w);
    return uvec4(floatBitsToUint(position), crease_multi_resolution_pack(normal));
}
#ifdef __cplusplus
")glsl"
#endif
