#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// What a pass computes for a pixel.
struct crease_result {
    float visibility; // 1 open, 0 closed
    float shade;      // to subtract from a colour
    float depth;      // positive, linear; crease_background where there is none
};

crease_result crease_shade_result(float shade, float depth) {
    return crease_result(pow(clamp(1.0 - shade, 0.0, 1.0), crease_exponent), shade, depth);
}

crease_result crease_open() { return crease_shade_result(0.0, crease_background); }

crease_result crease_weighted(crease_result result, float weight) {
    return crease_result(result.visibility * weight, result.shade * weight, result.depth);
}

crease_result crease_sum(crease_result a, crease_result b) {
    return crease_result(a.visibility + b.visibility, a.shade + b.shade, a.depth);
}

// The mean out of a sum of weighted results and the sum of their weights.
crease_result crease_mean(crease_result sum, float weights, float depth) {
    return crease_shade_result(sum.shade / weights, depth);
}
#ifdef __cplusplus
")glsl"
#endif
