#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Gathers the samples of a texel: many of them hold the same fragment, and as the most occluding counts, once is
// enough. So a tap looks at as many layers as there are, and not at as many as there are samples.

float crease_depth_at(vec2 texel);
float crease_captured_depth(ivec2 texel, int sample_index);
bool crease_is_packed(float depth, float front);

void crease_pack_group(ivec2 texel, int group, vec4 depths) {
    int groups = (crease_stochastic_layers_count + 3) / 4;
    imageStore(crease_packed_layers, ivec3(texel, crease_view_index * groups + group), depths);
}

void crease_build(ivec2 texel) {
    vec4 depths = vec4(crease_background);
    int group = 0;
    float front = crease_depth_at(vec2(texel) + 0.5 - crease_view.guard);
    for (int i = 0; i < crease_stochastic_layers_count; ++i) {
        float depth = crease_captured_depth(texel, i);
        bool there = depth > 0.0 && depth < crease_background && crease_is_packed(depth, front);
        if (there && all(notEqual(depths, vec4(depth)))) {
            if (depths.w < crease_background) {
                crease_pack_group(texel, group, depths);
                depths = vec4(crease_background);
                ++group;
            }
            depths = vec4(depth, depths.xyz);
        }
    }
    crease_pack_group(texel, group, depths);
    if (depths.w < crease_background && 4 * (group + 1) < crease_stochastic_layers_count)
        crease_pack_group(texel, group + 1, vec4(crease_background));
}
#ifdef __cplusplus
")glsl"
#endif
