// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_at(vec2 texel);
int crease_strips_place(vec2 texel);
#else
__LINE__, R"glsl("
#endif

shared float crease_strips_depths[crease_strips_texels];

void crease_keep_in_strips(int place, vec2 texel) { crease_strips_depths[place] = crease_depth_at(texel); }

crease_layers crease_fetch_layers(vec2 texel) {
    int place = crease_strips_place(texel);
    if (place < 0)
        return crease_layers(texel, crease_depth_at(texel));
    return crease_layers(texel, crease_strips_depths[place]);
}
#ifdef __cplusplus
")glsl"
#endif
