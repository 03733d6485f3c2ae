#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// What a pass computes for a pixel.
struct crease_result {
    float visibility; // 1 open, 0 closed
    float depth;      // positive, linear; crease_background where there is none
    vec3 bent;        // view space: the mean open direction, of any length; to the eye where there is background
    float cone;       // half angle of the bent cone, radians
};

// What an estimator gathers of the open directions.
struct crease_bend {
    vec3 sum;      // of open directions, as the estimator defines it
    float weight;  // of those in the sum
    float turned;  // sum of the angles by which the directions turn the normal, radians
    float highest; // of this direction: what the taps have in common, as the estimator defines it
};

crease_result crease_open() { return crease_result(1.0, crease_background, vec3(0.0, 0.0, 1.0), 1.57079633); }

crease_result crease_weighted(crease_result result, float weight) {
    return crease_result(result.visibility * weight, result.depth, result.bent * weight, result.cone * weight);
}

crease_result crease_sum(crease_result a, crease_result b) {
    return crease_result(a.visibility + b.visibility, a.depth, a.bent + b.bent, a.cone + b.cone);
}

// The mean out of a sum of weighted results and the sum of their weights.
crease_result crease_mean(crease_result sum, float weights, float depth) {
    return crease_result(sum.visibility / weights, depth, sum.bent, sum.cone / weights);
}
#ifdef __cplusplus
")glsl"
#endif
