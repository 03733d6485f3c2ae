// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_noise(ivec2 pixel);
void crease_texel_ray(crease_receiver receiver, vec2 texel, out vec3 start, out vec3 ray);
float crease_share_inside(vec2 from, vec2 way);
int crease_step_count();
vec3 crease_line_chord(vec2 chord, vec2 over); // which part of a chord counts, and what of that is not over the plane
mat2 crease_disk_of(crease_receiver receiver);
#else
__LINE__, R"glsl("
#endif

// Lines spread evenly over the disk of the radius, each the ray of the texel that it falls into: a spiral of golden
// angles, turned and its radii shifted by the noise of the pixel.
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

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    const vec2 golden_angle = vec2(-0.73736888, 0.67549029);
    pattern.direction = vec2(golden_angle.x * pattern.direction.x - golden_angle.y * pattern.direction.y,
                             golden_angle.y * pattern.direction.x + golden_angle.x * pattern.direction.y);
    float distance = sqrt((float(step) + pattern.offset) / float(crease_step_count()));
    vec2 radius = crease_disk_of(receiver) * pattern.direction;
    float share = crease_share_inside(receiver.texel + 0.5, radius);
    vec2 texel = floor(receiver.texel + 0.5 + radius * (share * distance));
    vec3 start, ray;
    crease_texel_ray(receiver, texel, start, ray);
    float middle = -dot(start, ray) / dot(ray, ray);
    vec3 nearest = start + ray * middle;
    float half_chord = sqrt(max(crease_radius * crease_radius - dot(nearest, nearest), 0.0) / dot(ray, ray));
    vec2 chord = vec2(middle - half_chord, middle + half_chord);
    // The part of the chord over the tangent plane: before where the ray meets it, or behind where the ray rises
    // through it.
    float rise = dot(ray, receiver.normal);
    float plane = -dot(start, receiver.normal) / (abs(rise) < 1e-6 ? (rise < 0.0 ? -1e-6 : 1e-6) : rise);
    plane = clamp(plane, chord.x, chord.y);
    vec3 counts = crease_line_chord(chord, rise < 0.0 ? vec2(chord.x, plane) : vec2(plane, chord.y));
    return crease_tap(texel, crease_inside(texel), counts.x, counts.y, counts.z, share * share);
}
#ifdef __cplusplus
")glsl"
#endif
