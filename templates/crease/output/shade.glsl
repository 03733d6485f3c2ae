// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_estimate_occlusion(crease_estimate estimate);
#else
__LINE__, R"glsl("
#endif

// What a pass computes for a pixel.
struct crease_result {
    float visibility; // 1 open, 0 closed
    float shade;      // to subtract from a colour
    float depth;      // positive, linear; crease_background where there is none
    vec3 normal;      // view space, unit; filters that weigh by it have it handed on
};

crease_result crease_shade_result(float shade, float depth, vec3 normal) {
    return crease_result(pow(clamp(1.0 - shade, 0.0, 1.0), crease_exponent), shade, depth, normal);
}

crease_result crease_open_result() { return crease_shade_result(0.0, crease_background, vec3(0.0, 0.0, 1.0)); }

// Of the shade: unsharp-mask-ssao's listing. Without highlights it is never negative.
crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver) {
    float shade = crease_strength * crease_estimate_occlusion(gathered.estimate);
    return crease_shade_result(crease_shade_highlight != 0 ? shade : max(shade, 0.0), -receiver.position.z,
                               receiver.normal);
}

crease_result crease_turned_back(crease_result result, mat3 turn) {
    result.normal = result.normal * turn;
    return result;
}

crease_result crease_weighted(crease_result result, float weight) {
    return crease_result(result.visibility * weight, result.shade * weight, result.depth, result.normal);
}

crease_result crease_sum(crease_result a, crease_result b) {
    return crease_result(a.visibility + b.visibility, a.shade + b.shade, a.depth, a.normal);
}

// The mean out of a sum of weighted results and the sum of their weights.
crease_result crease_mean(crease_result sum, float weights, float depth) {
    return crease_shade_result(sum.shade / weights, depth, sum.normal);
}
#ifdef __cplusplus
")glsl"
#endif
