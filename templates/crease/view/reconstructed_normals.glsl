// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
vec3 crease_to_eye(vec3 position);
#else
__LINE__, R"glsl("
#endif

// The normal of the plane through the receiver and two neighbours: of left and right, and of up and down, the one that
// is nearer in depth.
vec3 crease_reconstructed_normals_tangent(vec2 texel, vec3 position, vec2 axis) {
    vec2 before_texel = texel - axis, after_texel = texel + axis;
    vec3 before = crease_view_position(before_texel, crease_depth_at(before_texel));
    vec3 after = crease_view_position(after_texel, crease_depth_at(after_texel));
    bool has_before = crease_inside(before_texel);
    bool has_after = crease_inside(after_texel);
    bool take_after = has_after && (!has_before || abs(after.z - position.z) < abs(before.z - position.z));
    return take_after ? after - position : position - before;
}

vec3 crease_normal_at(vec2 texel, vec3 position) {
    vec3 normal = cross(crease_reconstructed_normals_tangent(texel, position, vec2(1.0, 0.0)),
                        crease_reconstructed_normals_tangent(texel, position, vec2(0.0, 1.0)));
    float squared = dot(normal, normal);
    vec3 to_eye = crease_to_eye(position);
    if (!(squared > 0.0 && squared < 1e30)) // a picture one texel wide, or a neighbour that is not finite
        return to_eye;
    normal *= inversesqrt(squared);
    return dot(normal, to_eye) < 0.0 ? -normal : normal;
}
#ifdef __cplusplus
")glsl"
#endif
