// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec4 crease_whole_group(vec4 group);
int crease_group_count();
int crease_strips_place(vec2 texel);
#else
__LINE__, R"glsl("
#endif

// The nearest four layers of each texel: a-buffer-ssao V.B. Those behind them stay in the image.
shared vec4 crease_strips_groups[crease_strips_texels];

void crease_keep_in_strips(int place, vec2 texel) {
    crease_strips_groups[place] = crease_whole_group(crease_load_packed_layers(ivec3(texel, 0)));
}

void crease_fetch_groups(inout crease_layers layers, int first, int end) {
    int place = first == 0 ? crease_strips_place(layers.texel) : -1;
    crease_unroll for (int group = first; group < end; ++group) {
        if (group == 0 && place >= 0)
            layers.groups[group] = crease_strips_groups[place];
        else
            layers.groups[group] = crease_whole_group(crease_load_packed_layers(
                ivec3(layers.texel, crease_view_index * crease_group_count() + group)));
    }
}
#ifdef __cplusplus
")glsl"
#endif
