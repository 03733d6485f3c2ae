// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec2 crease_disk_texel(inout crease_pattern pattern, crease_receiver receiver, int step, out float share);
#else
__LINE__, R"glsl("
#endif

// A disk of points that keep apart.
int crease_step_count() { return crease_poisson_disk_count; }

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    float share;
    vec2 texel = crease_disk_texel(pattern, receiver, step, share);
    return crease_tap(texel, texel != receiver.texel && crease_inside(texel), share * share);
}
#ifdef __cplusplus
")glsl"
#endif
