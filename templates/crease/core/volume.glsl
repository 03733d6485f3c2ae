#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// What estimators of volume share.

float crease_volume_behind();

// How much a surface at this depth fills of what lies behind it: less where it is further before the volume than its
// radius, so that a silhouette casts no halo: statistical-volumetric-obscurance A.2.
float crease_volume_reach(crease_receiver receiver, float depth) {
    float before = -receiver.position.z - depth - crease_radius;
    return clamp(1.0 - before / (crease_falloff * max(crease_radius, 1e-20)), 0.0, 1.0);
}

// Filled beyond what a plane through the receiver fills, so that a plane is unoccluded.
float crease_volume_occlusion(float filled, float whole) {
    float share = whole > 0.0 ? filled / whole : 0.0;
    return max((share - crease_volume_behind()) / (1.0 - crease_volume_behind()), 0.0);
}
#ifdef __cplusplus
")glsl"
#endif
