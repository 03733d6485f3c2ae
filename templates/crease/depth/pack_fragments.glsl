// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_at(vec2 texel);
float crease_fragment_depth(uint key);
crease_fragments crease_sorted_fragments(ivec2 texel);
int crease_group_count();
bool crease_keeps_layer(float depth, float front);
#else
__LINE__, R"glsl("
#endif

// Packs the fragments of a texel in groups of four, nearest first; depths of back faces are negative.
void crease_build(ivec2 texel) {
    crease_fragments sorted = crease_sorted_fragments(texel);
    float front = crease_depth_at(vec2(texel));
    vec4 group = vec4(crease_background);
    int packed_count = 0;
    crease_unroll for (int i = 0; i < crease_most_layers; ++i) {
        float depth = crease_fragment_depth(sorted.keys[i]);
        if (!(depth < crease_background) || !crease_keeps_layer(abs(depth), front))
            continue;
        group[packed_count % 4] = depth;
        ++packed_count;
        if (packed_count % 4 == 0) {
            imageStore(crease_packed_layers, ivec3(texel, packed_count / 4 - 1), group);
            group = vec4(crease_background);
        }
    }
    if (packed_count / 4 < crease_group_count())
        imageStore(crease_packed_layers, ivec3(texel, packed_count / 4), group);
}
#ifdef __cplusplus
")glsl"
#endif
