// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_noise(ivec2 pixel);
crease_stepped_march crease_stepped_march_begin(crease_receiver receiver, vec2 direction, float offset);
crease_tap crease_stepped_tap(crease_stepped_march march, int step, int steps, int power);
float crease_stepped_spacing(crease_stepped_march march, int step, int steps, int power);
#else
__LINE__, R"glsl("
#endif

// Directions by importance: where a point is even on the unit sphere around the tip of the normal, the way to it is a
// ray of the cosine lobe, and the slice that holds it and the eye is drawn as often as it holds of the lobe.
struct crease_pattern {
    vec2 on_disk; // the normal along the axes of the disk
    vec3 noise;
    crease_stepped_march march;
};

crease_pattern crease_pattern_begin(crease_receiver receiver) {
    vec2 on_disk = vec2(dot(receiver.normal, receiver.tangent), dot(receiver.normal, receiver.bitangent));
    crease_stepped_march none = crease_stepped_march(vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0), 0.0);
    return crease_pattern(on_disk, crease_noise(receiver.pixel), none);
}

int crease_direction_count() { return crease_half_directions_count; }

int crease_step_count() { return crease_half_directions_steps; }

// So every direction counts the same.
float crease_slice_weight(float share) { return 1.0; }

vec2 crease_pattern_direction(inout crease_pattern pattern, crease_receiver receiver, int direction) {
    float angle = (pattern.noise.x + float(direction)) * (6.28318531 / float(crease_half_directions_count));
    float height = pattern.noise.z; // along the way to the eye, on either side
    vec2 across = pattern.on_disk + sqrt(1.0 - height * height) * vec2(cos(angle), sin(angle));
    across *= inversesqrt(max(dot(across, across), 1e-12));
    pattern.noise.yz = fract(pattern.noise.yz + 0.61803399);
    pattern.march = crease_stepped_march_begin(receiver, across, pattern.noise.y);
    return across;
}

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    return crease_stepped_tap(pattern.march, step, crease_half_directions_steps, crease_half_directions_power);
}

float crease_tap_spacing(crease_pattern pattern, crease_receiver receiver, int step) {
    return crease_stepped_spacing(pattern.march, step, crease_half_directions_steps, crease_half_directions_power);
}
#ifdef __cplusplus
")glsl"
#endif
