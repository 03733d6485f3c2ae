// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_share_inside(vec2 from, vec2 way);
mat2 crease_disk_of(crease_receiver receiver);
#else
__LINE__, R"glsl("
#endif

// The points of an even grid over the square around the radius, its edges included, the same for every pixel.
struct crease_pattern {
    float row; // of the square, -1 to 1
};

float crease_tap_grid_place(int point) { return 2.0 * float(point) / float(crease_tap_grid_side - 1) - 1.0; }

crease_pattern crease_pattern_begin(crease_receiver receiver) { return crease_pattern(0.0); }

int crease_direction_count() { return crease_tap_grid_side; }

int crease_step_count() { return crease_tap_grid_side; }

vec2 crease_pattern_direction(inout crease_pattern pattern, crease_receiver receiver, int direction) {
    pattern.row = crease_tap_grid_place(direction);
    return vec2(0.0);
}

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    vec2 way = crease_disk_of(receiver) * vec2(crease_tap_grid_place(step), pattern.row);
    float share = crease_share_inside(receiver.texel + 0.5, way);
    // What is cut at the picture's far edge ends between its last texel and none.
    vec2 texel = clamp(floor(receiver.texel + 0.5 + way * share), vec2(0.0), crease_depth_size() - 1.0);
    return crease_tap(texel, texel != receiver.texel && crease_inside(texel), share * share);
}
#ifdef __cplusplus
")glsl"
#endif
