// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_to_eye(vec3 position);
#else
__LINE__, R"glsl("
#endif

// A normal of any length as one of unit length; what has no direction counts as facing the eye.
vec3 crease_unit_normal(vec3 normal, vec3 position) {
    float squared = dot(normal, normal);
    return squared > 0.0 && squared < 1.0e30 ? normal * inversesqrt(squared) : crease_to_eye(position);
}
#ifdef __cplusplus
")glsl"
#endif
