// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_visibility_of(float occlusion);
float crease_estimate_occlusion(crease_estimate estimate);
#else
__LINE__, R"glsl("
#endif

// What a pass computes for a pixel: visibility, and the colors of its layers, blended in order.
struct crease_result {
    float visibility; // 1 open, 0 closed
    float depth;      // positive, linear; crease_background where there is none
    vec3 normal;      // view space, unit; filters that weigh by it have it handed on
    vec4 color;       // linear, times the opacity, which is the last component
};

crease_result crease_open_result() { return crease_result(1.0, crease_background, vec3(0.0, 0.0, 1.0), vec4(0.0)); }

crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver) {
    return crease_result(crease_visibility_of(crease_estimate_occlusion(gathered.estimate)), -receiver.position.z,
                         receiver.normal, vec4(0.0));
}

crease_result crease_turned_back(crease_result result, mat3 turn) {
    result.normal = result.normal * turn;
    return result;
}

// Colors stay as they are where results are weighed, as depths do: filters are for visibility.
crease_result crease_weighted(crease_result result, float weight) {
    result.visibility *= weight;
    return result;
}

crease_result crease_sum(crease_result a, crease_result b) {
    a.visibility += b.visibility;
    return a;
}

crease_result crease_mean(crease_result sum, float weights, float depth) {
    return crease_result(sum.visibility / weights, depth, sum.normal, sum.color);
}

// Integrated, each layer's color is darkened by its own visibility before it is blended: a-buffer-ssao 2013, III, figure 4.
crease_result crease_blend(crease_result before, crease_result own, vec3 color, float share) {
    before.visibility += own.visibility * share;
    before.color += vec4(crease_composite_separated != 0 ? color : color * own.visibility, 1.0) * share;
    return before;
}

// Separated, all colors are darkened by the blended visibility.
vec4 crease_encode_color(crease_result result) {
    float visible = crease_composite_separated != 0 ? result.visibility : 1.0;
    return vec4(result.color.rgb * visible, result.color.a);
}
#ifdef __cplusplus
")glsl"
#endif
