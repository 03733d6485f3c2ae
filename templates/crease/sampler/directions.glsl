// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_noise(ivec2 pixel);
float crease_share_inside(vec2 from, vec2 way);
mat2 crease_disk_of(crease_receiver receiver);
#else
__LINE__, R"glsl("
#endif

// Directions that divide the circle evenly, and steps that grow by a power of their index; both start at a random
// offset per pixel: stochastic-depth-ao, Algorithms 2 and 3.
struct crease_pattern {
    vec2 direction; // unit, on the disk that faces the eye
    vec2 first;     // texels: where the march begins; rounded down it is the texel
    vec2 march;     // texels at one step; all steps together reach the radius or the picture's edge
    float share;    // of the radius, that the march covers
    float offset;   // of step 0, in steps
    float nearest;  // radii that make a texel, in the root mean square over the directions on the screen
};

float crease_directions_angle() { return 6.28318531 / float(crease_directions_count); }

crease_pattern crease_pattern_begin(crease_receiver receiver) {
    vec2 noise = crease_noise(receiver.pixel).xy;
    float angle = noise.x * crease_directions_angle();
    // A texel in the root mean square over all directions is at least 1 / sqrt(2) of a texel in each, so no tap falls
    // on the receiver itself.
    float texels = abs(determinant(crease_disk_of(receiver))) *
        inversesqrt(0.5 * (dot(receiver.disk_x, receiver.disk_x) + dot(receiver.disk_y, receiver.disk_y)));
    return crease_pattern(vec2(cos(angle), sin(angle)), vec2(0.0), vec2(0.0), 1.0, noise.y, 1.0 / texels);
}

int crease_direction_count() { return crease_directions_count; }

int crease_step_count() { return crease_directions_steps; }

vec2 crease_pattern_direction(inout crease_pattern pattern, crease_receiver receiver, int direction) {
    vec2 turn = vec2(cos(crease_directions_angle()), sin(crease_directions_angle()));
    // With an even count each second direction is the opposite of the one before, with which it shares arithmetic.
    bool opposite = crease_directions_count % 2 == 0 && direction % 2 == 1;
    pattern.direction = opposite ? -pattern.direction
                                 : vec2(turn.x * pattern.direction.x - turn.y * pattern.direction.y,
                                        turn.y * pattern.direction.x + turn.x * pattern.direction.y);
    pattern.offset = fract(pattern.offset + 0.61803399); // another first step in each direction
    vec2 radius = crease_disk_of(receiver) * pattern.direction;
    pattern.first = receiver.texel + 0.5 + radius * pattern.nearest;
    pattern.share = crease_share_inside(pattern.first, radius);
    pattern.march = radius * (pattern.share * pow(float(crease_directions_steps), -float(crease_directions_power)));
    return pattern.direction;
}

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    float along = float(step) + pattern.offset, density = 1.0; // by how much the steps grow there
    for (int i = 1; i < crease_directions_power; ++i)
        density *= along;
    vec2 texel = floor(pattern.first + pattern.march * (along * density));
    float distance = pattern.share * pow(along / float(crease_directions_steps), float(crease_directions_power));
    return crease_tap(texel, crease_inside(texel), pattern.share * density, distance,
                      float(crease_directions_power) / max(along, 1e-4));
}

float crease_tap_spacing(crease_pattern pattern, crease_receiver receiver, int step) {
    float along = float(step) + pattern.offset, spacing = length(pattern.march) * float(crease_directions_power);
    for (int i = 1; i < crease_directions_power; ++i)
        spacing *= along;
    return spacing;
}
#ifdef __cplusplus
")glsl"
#endif
