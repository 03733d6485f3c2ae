// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
int crease_resolution();
uvec4 crease_no_coarse_layer();
bool crease_is_coarse_layer(uvec4 layer);
crease_contribution crease_weigh_coarse_layer(crease_march march, crease_receiver receiver, crease_tap tap, uvec4 layer);
crease_contribution crease_combine(crease_contribution a, crease_contribution b);
#else
__LINE__, R"glsl("
#endif

// The layers of a texel of a smaller picture, in place of the depth source's; the first is fetched before any is weighed.
struct crease_layers {
    ivec2 texel; // of that picture
    uvec4 first;
};

bool crease_multi_resolution_own = false; // whether the tap that is fetched is left out

void crease_multi_resolution_leave_out(bool own) { crease_multi_resolution_own = own; }

ivec2 crease_coarse_texel(vec2 texel) {
    ivec2 last = crease_size_of_resolutions(crease_resolution() - 1) - 1;
    return clamp(ivec2(texel) >> crease_resolution(), ivec2(0), last);
}

crease_layers crease_fetch_first_layers(vec2 texel) {
    ivec2 at = crease_coarse_texel(texel);
    if (crease_multi_resolution_own)
        return crease_layers(at, crease_no_coarse_layer());
    return crease_layers(at, crease_load_resolutions(ivec3(at, 0), crease_resolution() - 1));
}

crease_contribution crease_combine_first_layers(crease_march march, crease_receiver receiver, crease_tap tap,
                                                crease_layers layers) {
    crease_contribution all = crease_weigh_coarse_layer(march, receiver, tap, layers.first);
    bool more = crease_is_coarse_layer(layers.first);
    for (int i = 1; more && i < crease_most_coarse_layers; ++i) {
        uvec4 layer = crease_load_resolutions(ivec3(layers.texel, i), crease_resolution() - 1);
        more = crease_is_coarse_layer(layer);
        if (more)
            all = crease_combine(all, crease_weigh_coarse_layer(march, receiver, tap, layer));
    }
    return all;
}
#ifdef __cplusplus
")glsl"
#endif
