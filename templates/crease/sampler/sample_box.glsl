// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec4 crease_sample_area(vec2 texel, mat2 disk);
mat2 crease_disk_of(crease_receiver receiver);
#else
__LINE__, R"glsl("
#endif

// One tap: the area that the box around the receiver covers: statistical-volumetric-obscurance 4.2.
struct crease_pattern {
    bool unused;
};

crease_pattern crease_pattern_begin(crease_receiver receiver) { return crease_pattern(false); }

int crease_direction_count() { return 1; }

int crease_step_count() { return 1; }

vec2 crease_pattern_direction(inout crease_pattern pattern, crease_receiver receiver, int direction) { return vec2(0.0); }

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    return crease_tap(crease_sample_area(receiver.texel, crease_disk_of(receiver)), receiver.texel, true);
}
#ifdef __cplusplus
")glsl"
#endif
