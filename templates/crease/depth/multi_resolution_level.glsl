// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_multi_resolution_normal(uint word);
crease_receiver crease_make_receiver(ivec2 pixel, vec2 texel, vec3 position, vec3 normal);
crease_receiver crease_with_reach(crease_receiver receiver);
vec2 crease_with_coarser(crease_receiver receiver, float occlusion);
crease_gathered crease_gather(crease_receiver receiver);
float crease_estimate_occlusion(crease_estimate estimate);
void crease_keep_occlusion(ivec2 texel, uint occlusion);
#else
__LINE__, R"glsl("
#endif

// Gathers in a smaller picture, and hands on what that one and all coarser ones have found.
int crease_resolution() { return crease_multi_resolution_level; }

void crease_build(ivec2 texel) {
    uvec4 stored = crease_load_resolutions(texel, crease_resolution());
    vec3 position = uintBitsToFloat(stored.xyz), normal = crease_multi_resolution_normal(stored.w);
    vec2 middle = (vec2(texel) + 0.5) * float(1 << crease_resolution()) - 0.5;
    vec2 found = vec2(0.0);
    if (-position.z < crease_background) {
        crease_receiver receiver = crease_make_receiver(texel, middle, position, normal);
        crease_gathered gathered = crease_gather(crease_with_reach(receiver));
        found = crease_with_coarser(receiver, crease_estimate_occlusion(gathered.estimate));
    }
    crease_keep_occlusion(texel, packUnorm2x16(found));
}
#ifdef __cplusplus
")glsl"
#endif
