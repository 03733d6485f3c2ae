#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// What the samples of a texel kept, each depth once, in groups of four; crease_background after the last.

int crease_group_count() { return (crease_stochastic_layers_count + 3) / 4; }

float crease_stochastic_layers_fetch(vec2 texel, int layer) {
    if (layer >= crease_stochastic_layers_count)
        return crease_background;
    // The image is as large as the first camera asks, also where the second is smaller.
    vec2 at = (texel + crease_view.guard) / vec2(textureSize(crease_packed_layers, 0).xy);
    int index = crease_view_index * crease_stochastic_layers_count + layer;
    return textureLod(crease_packed_layers, vec3(at, float(index)), 0.0).x;
}

// Fetches that do not wait for each other.
vec4 crease_fetch_group(vec2 texel, int group) {
    return vec4(crease_stochastic_layers_fetch(texel, 4 * group), crease_stochastic_layers_fetch(texel, 4 * group + 1),
                crease_stochastic_layers_fetch(texel, 4 * group + 2),
                crease_stochastic_layers_fetch(texel, 4 * group + 3));
}

// The first group; the others are fetched where they are asked for.
struct crease_layers {
    vec4 depths;
};

crease_layers crease_fetch_layers(vec2 texel) { return crease_layers(crease_fetch_group(texel, 0)); }
#ifdef __cplusplus
")glsl"
#endif
