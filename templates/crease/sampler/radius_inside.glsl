// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The radius in which a sampler looks for points: no larger than half the picture's diagonal at the receiver's depth,
// so that a radius that is larger than the picture still finds what is there.
float crease_radius_inside(crease_receiver receiver) {
    float texels = sqrt(abs(determinant(receiver.disk))); // of the radius
    return crease_radius * min(1.0, 0.5 * length(crease_depth_size()) / texels);
}
#ifdef __cplusplus
")glsl"
#endif
