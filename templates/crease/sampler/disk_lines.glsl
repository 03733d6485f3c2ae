#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Lines spread evenly over the disk of the radius, each the ray of the texel that it falls into: a spiral of golden
// angles, turned and its radii shifted by the noise of the pixel.

vec2 crease_noise(ivec2 pixel);
vec3 crease_view_position(vec2 texel, float depth);
int crease_step_count();
void crease_line_clip(crease_receiver receiver, vec3 start, vec3 ray, inout vec2 chord);

struct crease_pattern {
    vec2 direction; // unit, on the disk that faces the eye
    float offset;   // of the first radius
};

crease_pattern crease_pattern_begin(crease_receiver receiver) {
    vec2 noise = crease_noise(receiver.pixel);
    float angle = 6.28318531 * noise.x;
    return crease_pattern(vec2(cos(angle), sin(angle)), noise.y);
}

int crease_direction_count() { return 1; }

vec2 crease_pattern_turn(inout crease_pattern pattern, crease_receiver receiver, int direction) { return vec2(0.0); }

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    const vec2 golden_angle = vec2(-0.73736888, 0.67549029);
    pattern.direction = vec2(golden_angle.x * pattern.direction.x - golden_angle.y * pattern.direction.y,
                             golden_angle.y * pattern.direction.x + golden_angle.x * pattern.direction.y);
    float distance = sqrt((float(step) + pattern.offset) / float(crease_step_count()));
    vec2 texel = floor(receiver.texel + 0.5 + receiver.disk * (pattern.direction * distance));
    // The ray as start + t * ray from the receiver: at t = 0 it is as deep as the receiver, and t counts depth.
    float depth = -receiver.position.z;
    vec3 at_depth = crease_view_position(texel, depth);
    vec3 start = at_depth - receiver.position;
    vec3 ray = crease_view_position(texel, depth + 1.0) - at_depth;
    float middle = -dot(start, ray) / dot(ray, ray);
    vec3 nearest = start + ray * middle;
    float half_chord = sqrt(max(crease_radius * crease_radius - dot(nearest, nearest), 0.0) / dot(ray, ray));
    vec2 chord = vec2(middle - half_chord, middle + half_chord);
    crease_line_clip(receiver, start, ray, chord);
    return crease_tap(texel, crease_inside(texel), depth + chord.x, depth + chord.y);
}
#ifdef __cplusplus
")glsl"
#endif
