#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Means over areas are of the depth of (1), less that of the picture's mean depth, so that sums stay small; background
// lies at the far plane, and where there is none it is in no mean.
float crease_unsharp_mask_far();
bool crease_unsharp_mask_endless();
float crease_unsharp_mask_scale();
float crease_unsharp_mask_depth(float depth);

float crease_area_depth(float depth) {
    bool counts = depth > 0.0 && (depth < crease_background || !crease_unsharp_mask_endless());
    return counts ? min(depth, crease_unsharp_mask_far()) : 0.0;
}

vec3 crease_area_value(vec3 position, float centre) {
    return vec3(crease_unsharp_mask_depth(centre) - crease_unsharp_mask_depth(-position.z), 0.0, 0.0);
}

vec3 crease_area_position(vec3 value, float centre) {
    float seen = crease_unsharp_mask_depth(centre) - value.x;
    float depth = crease_unsharp_mask_endless() ? 0.5 * crease_unsharp_mask_scale() * seen
                                                : seen * crease_unsharp_mask_far() / (2.0 - seen);
    return vec3(0.0, 0.0, -depth);
}
#ifdef __cplusplus
")glsl"
#endif
