// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Even steps both ways along the picture's row and column, the same for every pixel: a-buffer-ssao V.B, after Bavoil 2011.
struct crease_pattern {
    vec2 axis;    // texels: unit
    float radius; // texels along it
    float stride; // texels from a tap to the next, at least one
};

crease_pattern crease_pattern_begin(crease_receiver receiver) { return crease_pattern(vec2(0.0), 0.0, 1.0); }

int crease_direction_count() { return 4; }

int crease_step_count() { return crease_axes_steps; }

// The direction on the disk that the disk takes to the axis: that of the adjugate, as some dialects have no inverse.
vec2 crease_pattern_direction(inout crease_pattern pattern, crease_receiver receiver, int direction) {
    float side = direction % 2 == 0 ? 1.0 : -1.0;
    pattern.axis = direction < 2 ? vec2(side, 0.0) : vec2(0.0, side);
    float area = receiver.disk_x.x * receiver.disk_y.y - receiver.disk_x.y * receiver.disk_y.x;
    vec2 along = vec2(receiver.disk_y.y * pattern.axis.x - receiver.disk_y.x * pattern.axis.y,
                      receiver.disk_x.x * pattern.axis.y - receiver.disk_x.y * pattern.axis.x);
    float inverse_size = inversesqrt(max(dot(along, along), 1e-30));
    pattern.radius = abs(area) * inverse_size;
    pattern.stride = max(min(pattern.radius, float(crease_axes_reach)) / float(crease_axes_steps), 1.0);
    return along * (area < 0.0 ? -inverse_size : inverse_size);
}

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    float texels = floor(float(step + 1) * pattern.stride + 0.5);
    vec2 texel = floor(receiver.texel + pattern.axis * texels + 0.5);
    bool inside = crease_inside(texel) && texels <= max(pattern.radius, 1.0) + 0.5;
    // The steps within the radius stand for all of it that they reach.
    float weight = pattern.stride * float(crease_axes_steps) / max(pattern.radius, 1.0);
    return crease_tap(clamp(texel, vec2(0.0), crease_depth_size() - 1.0), inside, weight,
                      texels / max(pattern.radius, 1e-20), 1.0 / float(step + 1));
}

float crease_tap_spacing(crease_pattern pattern, crease_receiver receiver, int step) { return pattern.stride; }
#ifdef __cplusplus
")glsl"
#endif
