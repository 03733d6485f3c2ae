// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// An orthographic projection, centred or not; depth standard or reversed.
float crease_linear_depth(float device) {
    float depth = device * crease_view.depth_unpack.x + crease_view.depth_unpack.y;
    return depth < crease_view.far_depth ? depth : crease_background; // the far plane occludes nothing
}

// How far rounding of the depth buffer, and of what is made of it, may bring two depths of one surface apart.
float crease_depth_rounding(float depth) { return 1.8e-7 * (depth + abs(depth - crease_view.depth_unpack.y)); }

vec3 crease_view_position(vec2 texel, float depth) {
    return vec3(texel * crease_view.from_texel.xy + crease_view.from_texel.zw, -depth);
}

vec2 crease_texel_at(vec3 position) {
    return (position.xy - crease_view.from_texel.zw) / crease_view.from_texel.xy;
}

vec3 crease_to_eye(vec3 position) { return vec3(0.0, 0.0, 1.0); }

void crease_axes(vec3 to_eye, out vec3 tangent, out vec3 bitangent) {
    tangent = vec3(1.0, 0.0, 0.0);
    bitangent = vec3(0.0, 1.0, 0.0);
}

mat2 crease_disk(vec3 position, vec3 tangent, vec3 bitangent) {
    vec2 scale = crease_radius / crease_view.from_texel.xy;
    return mat2(scale.x, 0.0, 0.0, scale.y);
}
#ifdef __cplusplus
")glsl"
#endif
