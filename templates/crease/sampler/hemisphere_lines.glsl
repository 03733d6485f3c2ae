#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Lines through the hemisphere over the receiver's tangent plane.

int crease_step_count() { return crease_hemisphere_lines_count; }

float crease_volume_behind() { return 0.0; }

// Keeps the side of the plane that the normal points to: in front of where the ray meets it, or behind where the ray
// comes from under it.
void crease_line_clip(crease_receiver receiver, vec3 start, vec3 ray, inout vec2 chord) {
    float height = dot(start, receiver.normal);
    float rise = dot(ray, receiver.normal);
    float plane = -height / (abs(rise) < 1e-6 ? 1e-6 : rise);
    if (rise < 0.0)
        chord.y = min(chord.y, plane);
    else
        chord.x = max(chord.x, plane);
}
#ifdef __cplusplus
")glsl"
#endif
