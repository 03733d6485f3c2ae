// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// What the estimators of volumes share.

// The weight of a surface that is `before` nearer to the eye than the receiver: it falls beyond one radius, so that a
// silhouette casts no halo: statistical-volumetric-obscurance A.2.
float crease_volume_reach(float before, float falloff) {
    return clamp(1.0 - (before - crease_radius) / (falloff * max(crease_radius, 1e-20)), 0.0, 1.0);
}

// The filled share of the volume beyond what a plane through the receiver fills; convex edges fill less than the plane,
// and count as open.
float crease_volume_occlusion(float filled, float whole) { return whole > 0.0 ? max(filled / whole, 0.0) : 0.0; }
#ifdef __cplusplus
")glsl"
#endif
