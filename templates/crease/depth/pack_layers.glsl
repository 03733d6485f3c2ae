// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_at(vec2 texel);
int crease_group_count();
float crease_captured_depth(ivec2 texel, int sample_index);
bool crease_keeps_layer(float depth, float front);
#else
__LINE__, R"glsl("
#endif

// Packs the samples of a texel: many of them hold the same fragment, and each depth is kept once, as only the most
// occluding layer of a tap counts. So a tap reads as many layers as there are, not as many as there are samples.
void crease_build(ivec2 texel) {
    vec4 groups[(crease_most_layers + 3) / 4];
    crease_unroll for (int group = 0; group < crease_group_count(); ++group)
        groups[group] = vec4(crease_background);
    // The depth image is the first camera's.
    float front = crease_view_index == 0 ? crease_depth_at(vec2(texel)) : 0.0;
    int packed_count = 0;
    crease_unroll for (int i = 0; i < crease_most_layers; ++i) {
        float depth = crease_captured_depth(texel, i);
        bool there = depth > 0.0 && depth < crease_background && crease_keeps_layer(depth, front);
        crease_unroll for (int group = 0; group < crease_group_count(); ++group)
            there = there && all(notEqual(groups[group], vec4(depth)));
        int place = there ? packed_count : -1;
        crease_unroll for (int group = 0; group < crease_group_count(); ++group)
            groups[group] = mix(groups[group], vec4(depth), equal(ivec4(0, 1, 2, 3) + 4 * group, ivec4(place)));
        packed_count += there ? 1 : 0;
    }
    crease_unroll for (int group = 0; group < crease_group_count(); ++group)
        if (packed_count >= 4 * group)
            imageStore(crease_packed_layers, ivec3(texel, crease_view_index * crease_group_count() + group),
                       groups[group]);
}
#ifdef __cplusplus
")glsl"
#endif
