// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
void crease_texel_ray(crease_receiver receiver, vec2 texel, out vec3 start, out vec3 ray);
vec2 crease_disk_texel(inout crease_pattern pattern, crease_receiver receiver, int step, out float share);
vec3 crease_line_chord(vec2 chord, vec2 over); // which part of a chord counts, and what of that is not over the plane
#else
__LINE__, R"glsl("
#endif

// Lines spread evenly over the disk of the radius, each the ray of the texel that it falls into.
crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    float share;
    vec2 texel = crease_disk_texel(pattern, receiver, step, share);
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
