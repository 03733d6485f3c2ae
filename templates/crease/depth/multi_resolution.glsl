// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
crease_layer crease_layer_of(vec3 position);
crease_fetched crease_fetch(vec2 texel);
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

// One layer, of the texel of that resolution.
struct crease_layers {
    vec3 position;
};

const int crease_most_layers = 1;

bool crease_multi_resolution_own = false; // whether the tap that is fetched falls on the receiver's texel

crease_fetched crease_fetch_tap(crease_pattern pattern, crease_receiver receiver, int step, crease_tap tap) {
    crease_multi_resolution_own = ivec2(tap.texel) >> crease_resolution() == ivec2(receiver.texel) >> crease_resolution();
    return crease_fetch(tap.texel);
}

crease_layers crease_fetch_layers(vec2 texel) {
    if (crease_multi_resolution_own)
        return crease_layers(crease_view_position(texel, crease_background));
    if (crease_resolution() == 0)
        return crease_layers(crease_view_position(texel, crease_depth_at(texel)));
    ivec2 last = crease_size_of_resolutions(crease_resolution()) - 1;
    ivec2 at = clamp(ivec2(texel) >> crease_resolution(), ivec2(0), last);
    return crease_layers(uintBitsToFloat(crease_load_resolutions(at, crease_resolution()).xyz));
}

int crease_layer_count(crease_layers layers) { return 1; }

crease_layer crease_layer_at(crease_layers layers, int i) { return crease_layer_of(layers.position); }

// What a pass that gathers in a picture of odd index has found for the one before it.
uint crease_load_coarser(ivec2 texel, int level) { return crease_load_odd_occlusion(texel, level).x; }

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
