// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The square around the receiver, as an area: the loops of unsharp-mask-ssao's listing. The listing also reads one
// texel just past the far edge, which repeats the last; where that is asked for, it is a tap of its own.
struct crease_pattern {
    vec2 rows; // top and bottom edge, texels
};

// The edges of the square along one axis, within the depth image; or of the last texel, where the square reaches past
// it.
vec2 crease_box_area_edges(float texel, float size, bool past) {
    float before = texel - float(crease_box_area_size / 2);
    float after = before + float(crease_box_area_size / 2 * 2);
    if (past)
        return vec2(after > size ? size - 1.0 : size, size);
    return clamp(vec2(before, after), 0.0, size);
}

crease_pattern crease_pattern_begin(crease_receiver receiver) { return crease_pattern(vec2(0.0)); }

int crease_direction_count() { return 1 + crease_box_area_past; }

int crease_step_count() { return 1 + crease_box_area_past; }

vec2 crease_pattern_direction(inout crease_pattern pattern, crease_receiver receiver, int direction) {
    pattern.rows = crease_box_area_edges(receiver.texel.y, crease_depth_size().y, direction == 1);
    return vec2(0.0);
}

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    vec2 columns = crease_box_area_edges(receiver.texel.x, crease_depth_size().x, step == 1);
    vec4 area = vec4(columns.x, pattern.rows.x, columns.y, pattern.rows.y);
    return crease_tap(area, receiver.texel, all(lessThan(area.xy, area.zw)));
}
#ifdef __cplusplus
")glsl"
#endif
