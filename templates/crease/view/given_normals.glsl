// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The image holds normals as they are.
vec3 crease_stored_normal(vec2 texel) {
    return textureLod(crease_normal, (texel + 0.5) * crease_view.texel_size, 0.0).xyz;
}
#ifdef __cplusplus
")glsl"
#endif
