// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_at(vec2 texel);
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
        float depth = uintBitsToFloat(sorted.keys[i] >> 1);
        if (sorted.keys[i] == crease_no_fragment || !(depth < crease_background) || !crease_keeps_layer(depth, front))
            continue;
        group[packed_count % 4] = (sorted.keys[i] & 1u) == 0u ? depth : -depth;
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
