#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Gathers the samples of a texel: many of them hold the same fragment, and as the most occluding counts, once is
// enough. So a tap looks at as many layers as there are, and not at as many as there are samples.

float crease_depth_at(vec2 texel);
float crease_captured_depth(ivec2 texel, int sample_index);
bool crease_is_packed(float depth, float front);

void crease_pack_layer(ivec2 texel, int layer, float depth) {
    int index = crease_view_index * crease_stochastic_layers_count + layer;
    imageStore(crease_packed_layers, ivec3(texel, index), vec4(depth));
}

void crease_build(ivec2 texel) {
    vec4 latest = vec4(crease_background); // samples of a fragment older than these four may be packed twice
    int packed_count = 0;
    // The depth image is the first camera's.
    float front = crease_view_index == 0 ? crease_depth_at(vec2(texel) + 0.5 - crease_view.guard) : 0.0;
    for (int i = 0; i < crease_stochastic_layers_count; ++i) {
        float depth = crease_captured_depth(texel, i);
        bool there = depth > 0.0 && depth < crease_background && crease_is_packed(depth, front);
        if (there && all(notEqual(latest, vec4(depth)))) {
            latest = vec4(depth, latest.xyz);
            crease_pack_layer(texel, packed_count, depth);
            ++packed_count;
        }
    }
    // The group that the last layer is in is fetched whole, or the next one where it is full.
    int last = min((packed_count / 4 + 1) * 4, crease_stochastic_layers_count);
    for (; packed_count < last; ++packed_count)
        crease_pack_layer(texel, packed_count, crease_background);
}
#ifdef __cplusplus
")glsl"
#endif
