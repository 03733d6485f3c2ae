// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_view_position(vec2 texel, float depth);
#else
__LINE__, R"glsl("
#endif

// The tangent plane of what a filter makes a mean for.
struct crease_plane {
    vec3 position; // view space
    vec3 normal;   // view space, unit
    float reach;   // distance from the plane at which a weight ends
};

crease_plane crease_plane_at(vec3 position, vec3 normal) {
    // Handed-on depths are exact to 2^-15 of themselves.
    return crease_plane(position, normal, max(crease_plane_reach * crease_radius, -6e-5 * position.z));
}

// How much a surface counts: less with its distance from the plane, and with the angle of its normal.
float crease_plane_weight(crease_plane plane, vec3 position, vec3 normal) {
    float apart = abs(dot(position - plane.position, plane.normal));
    float alike = max(dot(normal, plane.normal), 0.0);
    alike *= alike;
    alike *= alike;
    return max(1.0 - apart / plane.reach, 0.0) * alike * alike;
}
#ifdef __cplusplus
")glsl"
#endif
