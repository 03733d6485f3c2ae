// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
int crease_resolution();
vec3 crease_multi_resolution_normal(uint word);
uint crease_load_coarser(ivec2 texel, int level);
mat2 crease_disk_of(crease_receiver receiver);
#else
__LINE__, R"glsl("
#endif

// In each resolution taps reach as far as a few of its texels, at most the radius.
crease_receiver crease_with_reach(crease_receiver receiver) {
    float texels = sqrt(abs(determinant(crease_disk_of(receiver)))); // of the radius
    float share = min(1.0, float(crease_multi_resolution_reach << crease_resolution()) / texels);
    receiver.disk_x *= share;
    receiver.disk_y *= share;
    return receiver;
}

// How alike the surface of a texel is to the receiver's: Hoang and Low 2010, with depths in radii.
float crease_multi_resolution_likeness(uvec4 texel, crease_receiver receiver) {
    float alike = 0.5 + 0.5 * dot(crease_multi_resolution_normal(texel.w), receiver.normal);
    float near = 1.0 / (1.0 + abs(uintBitsToFloat(texel.z) - receiver.position.z) / crease_radius);
    return pow(max(alike, 0.0), 8.0) * pow(near, 16.0);
}

// The greatest and the mean of an occlusion and those of all coarser resolutions, which come from the four texels around
// the receiver; where none of them is of its surface, the occlusion stands for them.
vec2 crease_with_coarser(crease_receiver receiver, float occlusion) {
    int level = crease_resolution() + 1, count = crease_levels_of_resolutions() - level;
    vec2 own = vec2(clamp(occlusion, 0.0, 1.0)), sum = vec2(0.0);
    if (count <= 0)
        return own;
    vec2 between = (receiver.texel + 0.5) / float(1 << level) - 0.5, part = fract(between);
    ivec2 last = crease_size_of_resolutions(level) - 1;
    float weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1), at = clamp(ivec2(floor(between)) + corner, ivec2(0), last);
        vec2 share = mix(1.0 - part, part, vec2(corner));
        float weight = share.x * share.y * crease_multi_resolution_likeness(crease_load_resolutions(at, level), receiver);
        sum += weight * unpackUnorm2x16(crease_load_coarser(at, level));
        weights += weight;
    }
    vec2 far = weights > 1e-12 ? sum / weights : own;
    return vec2(max(own.x, far.x), (own.y + float(count) * far.y) / float(count + 1));
}
#ifdef __cplusplus
")glsl"
#endif
