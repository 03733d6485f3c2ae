// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Each texel of a square around the receiver's: the loops of unsharp-mask-ssao's listing.
struct crease_pattern {
    float row; // texels, from the receiver
};

int crease_box_window_half() { return crease_box_window_size / 2; }

crease_pattern crease_pattern_begin(crease_receiver receiver) { return crease_pattern(0.0); }

int crease_direction_count() { return 2 * crease_box_window_half(); }

int crease_step_count() { return 2 * crease_box_window_half(); }

vec2 crease_pattern_direction(inout crease_pattern pattern, crease_receiver receiver, int direction) {
    pattern.row = float(direction - crease_box_window_half());
    return vec2(0.0);
}

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    vec2 texel = receiver.texel + vec2(float(step - crease_box_window_half()), pattern.row);
    // The listing also reads one texel just past the far edge, which repeats the last.
    vec2 size = crease_depth_size();
    bool inside = all(greaterThanEqual(texel, vec2(0.0))) && all(lessThanEqual(texel, size));
    return crease_tap(min(texel, size - 1.0), inside, 1.0);
}
#ifdef __cplusplus
")glsl"
#endif
