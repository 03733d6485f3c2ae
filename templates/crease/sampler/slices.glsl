// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_noise(ivec2 pixel);
crease_stepped_march crease_stepped_march_begin(crease_receiver receiver, vec2 direction, float offset);
crease_tap crease_stepped_tap(crease_stepped_march march, int step, int steps, int power);
float crease_stepped_spacing(crease_stepped_march march, int step, int steps, int power);
#else
__LINE__, R"glsl("
#endif

// Slices through the eye that divide the half circle evenly: Jimenez et al. 2016. Both directions of a slice have their
// taps at the same distances.
struct crease_pattern {
    vec3 noise;
    vec2 azimuth;
    crease_stepped_march march;
};

crease_pattern crease_pattern_begin(crease_receiver receiver) {
    crease_stepped_march none = crease_stepped_march(vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0), 0.0);
    return crease_pattern(crease_noise(receiver.pixel), vec2(0.0), none);
}

int crease_direction_count() { return 2 * crease_slices_count; }

int crease_step_count() { return crease_slices_steps; }

vec2 crease_pattern_direction(inout crease_pattern pattern, crease_receiver receiver, int direction) {
    float slice = float(direction / 2);
    float angle = (pattern.noise.x + slice) * (3.14159265 / float(crease_slices_count));
    pattern.azimuth = direction % 2 == 1 ? -pattern.azimuth : vec2(cos(angle), sin(angle));
    pattern.noise.y = direction % 2 == 1 ? pattern.noise.y : fract(pattern.noise.y + 0.61803399);
    pattern.march = crease_stepped_march_begin(receiver, pattern.azimuth, pattern.noise.y);
    return pattern.azimuth;
}

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    return crease_stepped_tap(pattern.march, step, crease_slices_steps, crease_slices_power);
}

float crease_tap_spacing(crease_pattern pattern, crease_receiver receiver, int step) {
    return crease_stepped_spacing(pattern.march, step, crease_slices_steps, crease_slices_power);
}
#ifdef __cplusplus
")glsl"
#endif
