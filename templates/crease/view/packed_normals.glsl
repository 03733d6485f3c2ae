// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The image holds n / 2 + 1 / 2 of each component n.
vec3 crease_stored_normal(vec2 texel) {
    return textureLod(crease_normal, (texel + 0.5) * crease_view.texel_size, 0.0).xyz * 2.0 - 1.0;
}
#ifdef __cplusplus
")glsl"
#endif
