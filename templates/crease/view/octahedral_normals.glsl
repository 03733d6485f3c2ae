// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The image holds the point of an octahedron, whose lower half is folded over its upper, packed to [0, 1]: Cigolle et
// al. 2014.
vec3 crease_stored_normal(vec2 texel) {
    vec2 point = textureLod(crease_normal, (texel + 0.5) * crease_view.texel_size, 0.0).xy * 2.0 - 1.0;
    float height = 1.0 - abs(point.x) - abs(point.y), folded = max(-height, 0.0);
    return vec3(point - folded * vec2(point.x < 0.0 ? -1.0 : 1.0, point.y < 0.0 ? -1.0 : 1.0), height);
}
#ifdef __cplusplus
")glsl"
#endif
