// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_noise(ivec2 pixel);
float crease_share_inside(vec2 from, vec2 way);
int crease_step_count();
mat2 crease_disk_of(crease_receiver receiver);
#else
__LINE__, R"glsl("
#endif

// Points spread evenly over the disk of the radius: a spiral of golden angles, on which no two of N points are nearer to
// each other than 1 / sqrt(N) of the radius, for every N. It is turned, and its radii are shifted, at random per pixel.
struct crease_pattern {
    vec2 direction; // unit, on the disk that faces the eye
    float offset;   // of the first radius
};

crease_pattern crease_pattern_begin(crease_receiver receiver) {
    vec2 noise = crease_noise(receiver.pixel).xy;
    float angle = 6.28318531 * noise.x;
    return crease_pattern(vec2(cos(angle), sin(angle)), noise.y);
}

int crease_direction_count() { return 1; }

vec2 crease_pattern_direction(inout crease_pattern pattern, crease_receiver receiver, int direction) { return vec2(0.0); }

// The texel of the next point, and the share of the disk in its direction that is in the depth image.
vec2 crease_disk_texel(inout crease_pattern pattern, crease_receiver receiver, int step, out float share) {
    const vec2 golden_angle = vec2(-0.73736888, 0.67549029);
    pattern.direction = vec2(golden_angle.x * pattern.direction.x - golden_angle.y * pattern.direction.y,
                             golden_angle.y * pattern.direction.x + golden_angle.x * pattern.direction.y);
    float distance = sqrt((float(step) + pattern.offset) / float(crease_step_count()));
    vec2 radius = crease_disk_of(receiver) * pattern.direction;
    share = crease_share_inside(receiver.texel + 0.5, radius);
    return floor(receiver.texel + 0.5 + radius * (share * distance));
}
#ifdef __cplusplus
")glsl"
#endif
