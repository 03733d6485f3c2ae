// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_visibility_of(float occlusion);
float crease_estimate_occlusion(crease_estimate estimate);
#else
__LINE__, R"glsl("
#endif

// What a pass computes for a pixel.
struct crease_result {
    float visibility; // 1 open, 0 closed
    float depth;      // positive, linear; crease_background where there is none
    vec3 normal;      // view space, unit; filters that weigh by it have it handed on
};

crease_result crease_open_result() { return crease_result(1.0, crease_background, vec3(0.0, 0.0, 1.0)); }

crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver) {
    return crease_result(crease_visibility_of(crease_estimate_occlusion(gathered.estimate)), -receiver.position.z,
                         receiver.normal);
}

crease_result crease_turned_back(crease_result result, mat3 turn) {
    result.normal = result.normal * turn;
    return result;
}

crease_result crease_weighted(crease_result result, float weight) {
    return crease_result(result.visibility * weight, result.depth, result.normal);
}

crease_result crease_sum(crease_result a, crease_result b) {
    return crease_result(a.visibility + b.visibility, a.depth, a.normal);
}

// The mean out of a sum of weighted results and the sum of their weights.
crease_result crease_mean(crease_result sum, float weights, float depth) {
    return crease_result(sum.visibility / weights, depth, sum.normal);
}
#ifdef __cplusplus
")glsl"
#endif
