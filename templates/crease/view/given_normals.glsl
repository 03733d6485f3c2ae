// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_to_eye(vec3 position);
#else
__LINE__, R"glsl("
#endif

// The normals image holds view-space normals, facing the camera, of any length; one that has no direction counts as
// facing the eye.
vec3 crease_normal_at(vec2 texel, vec3 position) {
    vec3 normal = textureLod(crease_normal, (texel + 0.5) * crease_view.texel_size, 0.0).xyz;
    float squared = dot(normal, normal);
    return squared > 0.0 && squared < 1.0e30 ? normal * inversesqrt(squared) : crease_to_eye(position);
}
#ifdef __cplusplus
")glsl"
#endif
