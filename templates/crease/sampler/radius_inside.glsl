// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
mat2 crease_disk_of(crease_receiver receiver);
#else
__LINE__, R"glsl("
#endif

// The radius in which a sampler looks for points: no larger than half the picture's diagonal at the receiver's depth,
// so that a radius that is larger than the picture still finds what is there.
float crease_radius_inside(crease_receiver receiver) {
    float texels = sqrt(abs(determinant(crease_disk_of(receiver)))); // of the radius
    return crease_radius * min(1.0, 0.5 * length(crease_depth_size()) / texels);
}
#ifdef __cplusplus
")glsl"
#endif
