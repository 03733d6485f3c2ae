// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_noise(ivec2 pixel);
vec2 crease_texel_at(vec3 position);
float crease_radius_inside(crease_receiver receiver);
void crease_texel_ray(crease_receiver receiver, vec2 texel, out vec3 start, out vec3 ray);
#else
__LINE__, R"glsl("
#endif

// Points spread evenly through the sphere around the receiver, turned about the direction to the eye and their
// distances shifted by the noise of the pixel: statistical-volumetric-obscurance 2.2 and (4.1).
struct crease_pattern {
    vec2 direction; // unit, on the disk that faces the eye
    float radius;   // view space
    float volume;   // of the sphere through the point, as a share
};

crease_pattern crease_pattern_begin(crease_receiver receiver) {
    vec2 noise = crease_noise(receiver.pixel).xy;
    float angle = 6.28318531 * noise.x;
    return crease_pattern(vec2(cos(angle), sin(angle)), crease_radius_inside(receiver), noise.y);
}

int crease_direction_count() { return 1; }

int crease_step_count() { return crease_sphere_points_count; }

vec2 crease_pattern_direction(inout crease_pattern pattern, crease_receiver receiver, int direction) { return vec2(0.0); }

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    const vec2 golden_angle = vec2(-0.73736888, 0.67549029);
    pattern.direction = vec2(golden_angle.x * pattern.direction.x - golden_angle.y * pattern.direction.y,
                             golden_angle.y * pattern.direction.x + golden_angle.x * pattern.direction.y);
    pattern.volume = fract(pattern.volume + 0.75487767);
    float height = 1.0 - (2.0 * float(step) + 1.0) / float(crease_sphere_points_count);
    vec2 sideways = pattern.direction * sqrt(1.0 - height * height);
    vec3 offset = (pattern.radius * pow(pattern.volume, 1.0 / 3.0)) *
        (receiver.tangent * sideways.x + receiver.bitangent * sideways.y + receiver.to_eye * height);
    vec3 point = receiver.position + offset;
    vec2 texel = floor(crease_texel_at(point) + 0.5);
    vec3 start, ray;
    crease_texel_ray(receiver, texel, start, ray);
    return crease_tap(texel, point.z < 0.0 && crease_inside(texel), start - ray * offset.z);
}
#ifdef __cplusplus
")glsl"
#endif
