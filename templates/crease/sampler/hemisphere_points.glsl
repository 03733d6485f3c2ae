// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_noise(ivec2 pixel);
vec2 crease_texel_at(vec3 position);
float crease_radius_inside(crease_receiver receiver);
void crease_texel_ray(crease_receiver receiver, vec2 texel, out vec3 start, out vec3 ray);
#else
__LINE__, R"glsl("
#endif

// Points in the hemisphere over the receiver, turned about the normal by a random angle per pixel:
// stochastic-depth-ao 4.1. Directions are distributed by the cosine and distances evenly, so that the share of points
// behind a surface at distance d is the cosine-weighted occlusion with a linear falloff, 1 - d / R.
struct crease_pattern {
    vec3 tangent, bitangent; // view space, unit
    vec2 direction;          // unit, in the tangent plane
    float radius;            // view space
    float distance;          // in radii
};

crease_pattern crease_pattern_begin(crease_receiver receiver) {
    vec2 noise = crease_noise(receiver.pixel).xy;
    vec3 normal = receiver.normal;
    vec3 axis = abs(normal.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    vec3 tangent = normalize(cross(axis, normal));
    float angle = 6.28318531 * noise.x;
    return crease_pattern(tangent, cross(normal, tangent), vec2(cos(angle), sin(angle)),
                          crease_radius_inside(receiver), noise.y);
}

int crease_direction_count() { return 1; }

int crease_step_count() { return crease_hemisphere_points_count; }

vec2 crease_pattern_direction(inout crease_pattern pattern, crease_receiver receiver, int direction) { return vec2(0.0); }

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    const vec2 golden_angle = vec2(-0.73736888, 0.67549029);
    pattern.direction = vec2(golden_angle.x * pattern.direction.x - golden_angle.y * pattern.direction.y,
                             golden_angle.y * pattern.direction.x + golden_angle.x * pattern.direction.y);
    pattern.distance = fract(pattern.distance + 0.75487767);
    float share = (float(step) + 0.5) / float(crease_hemisphere_points_count);
    vec2 sideways = pattern.direction * sqrt(share);
    vec3 offset = (pattern.radius * pattern.distance) *
        (pattern.tangent * sideways.x + pattern.bitangent * sideways.y + receiver.normal * sqrt(1.0 - share));
    vec3 point = receiver.position + offset;
    vec2 texel = floor(crease_texel_at(point) + 0.5);
    vec3 start, ray;
    crease_texel_ray(receiver, texel, start, ray);
    vec3 moved = start - ray * offset.z;
    // A point that moving to its texel took out of the hemisphere is left out; so a plane is unoccluded at every slant.
    bool above = dot(moved, receiver.normal) > 0.0;
    return crease_tap(texel, above && point.z < 0.0 && crease_inside(texel), moved);
}
#ifdef __cplusplus
")glsl"
#endif
