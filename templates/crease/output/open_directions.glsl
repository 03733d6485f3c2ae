// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The open directions that an estimator finds.
struct crease_open {
    vec3 sum;     // as the estimator defines it
    float weight; // of what is in the sum
    float turned; // sum of the angles by which the directions turn the normal, radians
};
#ifdef __cplusplus
")glsl"
#endif
