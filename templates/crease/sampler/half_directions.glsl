// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_noise(ivec2 pixel);
crease_tap crease_stepped_tap(crease_receiver receiver, vec2 radius, float along, int steps, int power);
#else
__LINE__, R"glsl("
#endif

// Directions by importance: a point that is even on the unit sphere around the tip of the normal lies in the direction of a
// cosine-distributed ray, and the slice that holds it and the eye is drawn as often as it holds of the cosine lobe.
struct crease_pattern {
    vec3 noise;
    vec2 radius;  // texels: the way to the radius
    float offset; // of step 0, in steps
};

crease_pattern crease_pattern_begin(crease_receiver receiver) {
    return crease_pattern(crease_noise(receiver.pixel), vec2(0.0), 0.0);
}

int crease_direction_count() { return crease_half_directions_count; }

int crease_step_count() { return crease_half_directions_steps; }

// So every direction counts the same.
float crease_slice_weight(float share) { return 1.0; }

vec2 crease_pattern_direction(inout crease_pattern pattern, crease_receiver receiver, int direction) {
    float angle = (pattern.noise.x + float(direction)) * (6.28318531 / float(crease_half_directions_count));
    float height = 2.0 * fract(pattern.noise.z + 0.61803399 * float(direction)) - 1.0;
    vec3 on_sphere = vec3(sqrt(1.0 - height * height) * vec2(cos(angle), sin(angle)), height);
    vec3 ray = receiver.normal + on_sphere;
    vec2 across = vec2(dot(ray, receiver.tangent), dot(ray, receiver.bitangent));
    vec2 azimuth = across * inversesqrt(max(dot(across, across), 1e-12));
    pattern.radius = receiver.disk * azimuth;
    pattern.offset = fract(pattern.noise.y + 0.61803399 * float(direction + 1));
    return azimuth;
}

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    return crease_stepped_tap(receiver, pattern.radius, float(step) + pattern.offset,
                              crease_half_directions_steps, crease_half_directions_power);
}
#ifdef __cplusplus
")glsl"
#endif
