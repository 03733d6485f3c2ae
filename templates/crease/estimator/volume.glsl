// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// What estimators of volume share.

// How much a surface that is by so much nearer to the eye than the receiver counts: less where it is further before the
// volume than its radius, so that a silhouette casts no halo: statistical-volumetric-obscurance A.2.
float crease_volume_reach(float before, float falloff) {
    return clamp(1.0 - (before - crease_radius) / (falloff * max(crease_radius, 1e-20)), 0.0, 1.0);
}

// The share that is filled, where both count from what a plane through the receiver fills; edges that stick out fill
// less than that.
float crease_volume_occlusion(float filled, float whole) { return whole > 0.0 ? max(filled / whole, 0.0) : 0.0; }
#ifdef __cplusplus
")glsl"
#endif
