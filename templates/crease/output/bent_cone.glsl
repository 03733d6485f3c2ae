// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_estimate crease_estimate_begin(crease_receiver receiver);
void crease_end_direction(inout crease_estimate estimate, crease_march march);
float crease_visibility_of(float occlusion);
float crease_estimate_occlusion(crease_estimate estimate);
crease_open crease_open_direction(crease_march march, crease_receiver receiver, vec2 direction);
vec3 crease_open_mean(crease_open open, crease_receiver receiver);
float crease_open_cone(crease_open open);
#else
__LINE__, R"glsl("
#endif

// What a pass computes for a pixel: visibility, and the cone of open directions: stochastic-depth-ao 7.1.
struct crease_result {
    float visibility; // 1 open, 0 closed
    float depth;      // positive, linear; crease_background where there is none
    vec3 normal;      // view space, unit; filters that weigh by it have it handed on
    vec3 bent;        // view space: the mean open direction, of any length; to the eye where there is background
    float cone;       // half angle of the bent cone, radians
};

struct crease_gathered {
    crease_estimate estimate;
    crease_open open;
};

crease_gathered crease_begin_gathering(crease_receiver receiver) {
    return crease_gathered(crease_estimate_begin(receiver), crease_open(vec3(0.0), 0.0, 0.0));
}

void crease_close_direction(inout crease_gathered gathered, crease_march march, crease_receiver receiver,
                            vec2 direction) {
    crease_end_direction(gathered.estimate, march);
    crease_open open = crease_open_direction(march, receiver, direction);
    gathered.open.sum += open.sum;
    gathered.open.weight += open.weight;
    gathered.open.turned += open.turned;
}

crease_result crease_open_result() {
    return crease_result(1.0, crease_background, vec3(0.0, 0.0, 1.0), vec3(0.0, 0.0, 1.0), 1.57079633);
}

crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver) {
    return crease_result(crease_visibility_of(crease_estimate_occlusion(gathered.estimate)), -receiver.position.z,
                         receiver.normal, crease_open_mean(gathered.open, receiver), crease_open_cone(gathered.open));
}

crease_result crease_turned_back(crease_result result, mat3 turn) {
    result.normal = result.normal * turn;
    result.bent = result.bent * turn;
    return result;
}

crease_result crease_weighted(crease_result result, float weight) {
    return crease_result(result.visibility * weight, result.depth, result.normal, result.bent * weight,
                         result.cone * weight);
}

crease_result crease_sum(crease_result a, crease_result b) {
    return crease_result(a.visibility + b.visibility, a.depth, a.normal, a.bent + b.bent, a.cone + b.cone);
}

// The mean out of a sum of weighted results and the sum of their weights.
crease_result crease_mean(crease_result sum, float weights, float depth) {
    return crease_result(sum.visibility / weights, depth, sum.normal, sum.bent, sum.cone / weights);
}
#ifdef __cplusplus
")glsl"
#endif
