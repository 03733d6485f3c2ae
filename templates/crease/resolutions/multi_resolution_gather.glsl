// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
int crease_resolution();
float crease_eye_side(crease_receiver receiver);
vec3 crease_unpack_surface_normal(uint word);
bool crease_is_coarse_layer(uvec4 layer);
uint crease_load_coarser(ivec3 texel, int resolution);
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

// How alike a layer of a coarser texel is to the receiver's surface, so far apart: Hoang and Low 2010, in radii.
float crease_multi_resolution_likeness(uvec4 layer, crease_receiver receiver, float apart) {
    float facing = crease_eye_side(receiver) * dot(crease_unpack_surface_normal(layer.w), receiver.normal);
    float near = 1.0 / (1.0 + abs(apart) / crease_radius);
    return pow(max(0.5 + 0.5 * facing, 0.0), 8.0) * pow(near, 16.0);
}

// What a coarser texel has found for the layer that goes on with the receiver's surface, and how alike it is in depth. Both
// sides of a slab are like it in depth where they are seen at a grazing angle, and one lies in its plane.
vec3 crease_multi_resolution_likest(ivec2 texel, int resolution, crease_receiver receiver) {
    int likest = 0;
    float most = 0.0, likeness = 0.0;
    for (int i = 0; i < crease_most_receivers; ++i) {
        uvec4 layer = crease_load_resolutions(ivec3(texel, i), resolution - 1);
        if (!crease_is_coarse_layer(layer))
            break;
        vec3 way = uintBitsToFloat(layer.xyz) - receiver.position;
        float own = crease_multi_resolution_likeness(layer, receiver, dot(way, receiver.normal));
        if (own > most) {
            most = own;
            likest = i;
            likeness = crease_multi_resolution_likeness(layer, receiver, way.z);
        }
    }
    if (crease_eye_side(receiver) < 0.0)
        likest += crease_most_receivers;
    return vec3(unpackUnorm2x16(crease_load_coarser(ivec3(texel, likest), resolution)), likeness);
}

// The greatest and the mean of an occlusion and those of all coarser resolutions, which come from the four texels around
// the receiver; where none of them is of its surface, the occlusion stands for them.
vec2 crease_with_coarser(crease_receiver receiver, float occlusion) {
    int coarsest = min(crease_levels_of_resolutions(), crease_multi_resolution_levels - 1);
    int next = crease_resolution() + 1, count = coarsest - crease_resolution();
    vec2 own = vec2(clamp(occlusion, 0.0, 1.0)), sum = vec2(0.0);
    if (count <= 0)
        return own;
    vec2 between = (receiver.texel + 0.5) / float(1 << next) - 0.5, part = fract(between);
    ivec2 last = crease_size_of_resolutions(next - 1) - 1;
    float weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1), texel = clamp(ivec2(floor(between)) + corner, ivec2(0), last);
        vec2 share = mix(1.0 - part, part, vec2(corner));
        vec3 likest = crease_multi_resolution_likest(texel, next, receiver);
        float weight = share.x * share.y * likest.z;
        sum += weight * likest.xy;
        weights += weight;
    }
    vec2 far = weights > 1e-12 ? sum / weights : own;
    return vec2(max(own.x, far.x), (own.y + float(count) * far.y) / float(count + 1));
}
#ifdef __cplusplus
")glsl"
#endif
