// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// A perspective projection, centred or not; depth standard, reversed or infinite: stochastic-depth-ao 4.4.
float crease_linear_depth(float device) {
    float inverse = device * crease_view.depth_unpack.x + crease_view.depth_unpack.y;
    return inverse * crease_view.far_depth > 1.0 ? 1.0 / inverse : crease_background; // the far plane occludes nothing
}

// How far rounding of the depth buffer, and of what is made of it, may bring two depths of one surface apart.
float crease_depth_rounding(float depth) {
    return 1.8e-7 * depth * (1.0 + abs(1.0 - depth * crease_view.depth_unpack.y)); // a device depth is 1 / depth less this
}

vec3 crease_view_position(vec2 texel, float depth) {
    return vec3((texel * crease_view.from_texel.xy + crease_view.from_texel.zw) * depth, -depth);
}

vec2 crease_texel_at(vec3 position) {
    return (position.xy / -position.z - crease_view.from_texel.zw) / crease_view.from_texel.xy;
}

vec3 crease_to_eye(vec3 position) { return -normalize(position); }

void crease_axes(vec3 to_eye, out vec3 tangent, out vec3 bitangent) {
    tangent = normalize(vec3(to_eye.z, 0.0, -to_eye.x));
    bitangent = cross(to_eye, tangent);
}

// Derivative of the projection at `position` along two axes that face the eye, times the radius.
mat2 crease_disk(vec3 position, vec3 tangent, vec3 bitangent) {
    vec2 ray = position.xy / -position.z;
    vec2 scale = crease_radius / (-position.z * crease_view.from_texel.xy);
    return mat2((tangent.xy + ray * tangent.z) * scale, (bitangent.xy + ray * bitangent.z) * scale);
}
#ifdef __cplusplus
")glsl"
#endif
