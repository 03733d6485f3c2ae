// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_receiver crease_with_reach(crease_receiver receiver);
vec2 crease_with_coarser(crease_receiver receiver, float occlusion);
crease_gathered crease_gather(crease_receiver receiver);
float crease_estimate_occlusion(crease_estimate estimate);
crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver);
float crease_visibility_of(float occlusion);
#else
__LINE__, R"glsl("
#endif

// How often the sides of the picture are halved in which a pass gathers: the main pass in that of the depth image.
int crease_resolution() { return 0; }

// What a pass that gathers in a picture of odd index has found for the one before it.
uint crease_load_coarser(ivec3 texel, int resolution) { return crease_load_odd_occlusion(texel, resolution - 1).x; }

// The greatest occlusion that a resolution gives finds what is near, the mean what is far as well: Hoang and Low 2010.
crease_result crease_result_of(crease_receiver receiver) {
    crease_gathered gathered = crease_gather(crease_with_reach(receiver));
    crease_result result = crease_conclude(gathered, receiver);
    vec2 all = crease_with_coarser(receiver, crease_estimate_occlusion(gathered.estimate));
    result.visibility = crease_visibility_of(1.0 - (1.0 - all.x) * (1.0 - all.y));
    return result;
}
#ifdef __cplusplus
")glsl"
#endif
