// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_unpack_surface_normal(uint word);
bool crease_is_coarse_layer(uvec4 layer);
ivec2 crease_coarse_texel(vec2 texel);
void crease_multi_resolution_leave_out(bool own);
crease_fetched crease_fetch(vec2 texel);
crease_receiver crease_make_receiver(ivec2 pixel, vec2 texel, vec3 position, vec3 normal);
crease_receiver crease_turned_round(crease_receiver receiver);
crease_receiver crease_with_reach(crease_receiver receiver);
vec2 crease_with_coarser(crease_receiver receiver, float occlusion);
crease_gathered crease_gather(crease_receiver receiver);
float crease_estimate_occlusion(crease_estimate estimate);
void crease_keep_occlusion(ivec3 texel, uint occlusion);
#else
__LINE__, R"glsl("
#endif

// Gathers in a smaller picture, and hands on what that one and all coarser ones have found.
int crease_resolution() { return crease_multi_resolution_level; }

// A tap that falls on the receiver's texel of that picture finds nothing there.
crease_fetched crease_fetch_tap(crease_pattern pattern, crease_receiver receiver, int step, inout crease_tap tap) {
    crease_multi_resolution_leave_out(crease_coarse_texel(tap.texel) == receiver.pixel);
    return crease_fetch(tap.texel);
}

// Of each layer that receives, and where both sides of it do, of the side that is seen and then of the other.
void crease_build(ivec2 texel) {
    vec2 middle = (vec2(texel) + 0.5) * float(1 << crease_resolution()) - 0.5;
    for (int i = 0; i < crease_most_receivers; ++i) {
        uvec4 layer = crease_load_resolutions(ivec3(texel, i), crease_resolution() - 1);
        if (!crease_is_coarse_layer(layer))
            break;
        crease_receiver receiver = crease_make_receiver(texel, middle, uintBitsToFloat(layer.xyz),
                                                        crease_unpack_surface_normal(layer.w));
        for (int side = 0; side < crease_receiver_sides; ++side) {
            crease_gathered gathered = crease_gather(crease_with_reach(receiver));
            vec2 found = crease_with_coarser(receiver, crease_estimate_occlusion(gathered.estimate));
            crease_keep_occlusion(ivec3(texel, i + side * crease_most_receivers), packUnorm2x16(found));
            receiver = crease_turned_round(receiver);
        }
    }
}
#ifdef __cplusplus
")glsl"
#endif
