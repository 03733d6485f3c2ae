// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec2 crease_texel_at(vec3 position);
crease_receiver crease_make_receiver(ivec2 pixel, vec2 texel, vec3 position, vec3 normal);
crease_gathered crease_gather(crease_receiver receiver);
float crease_estimate_occlusion(crease_estimate estimate);
crease_result crease_turned_back(crease_result result, mat3 turn);
crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver);
#else
__LINE__, R"glsl("
#endif

// The result by what two cameras see: the greater occlusion counts: stochastic-depth-ao 7.2, Algorithm 12.
crease_result crease_result_of(crease_receiver receiver) {
    crease_gathered gathered = crease_gather(receiver);

    crease_view = crease_view_of(1);
    crease_view_index = 1;
    mat4 from_first = crease_given.from_first[0];
    vec3 position = (from_first * vec4(receiver.position, 1.0)).xyz;
    vec3 normal = mat3(from_first) * receiver.normal;
    // What stands behind the second camera looks around from elsewhere, in vain: a branch around all that costs more.
    bool in_front = position.z < 0.0;
    vec3 there = in_front ? position : receiver.position;
    crease_receiver second = crease_make_receiver(receiver.pixel, crease_texel_at(there), there, normal);
    crease_gathered other = crease_gather(second);
    if (in_front &&
        crease_estimate_occlusion(other.estimate) > crease_estimate_occlusion(gathered.estimate)) {
        crease_result result = crease_turned_back(crease_conclude(other, second), mat3(from_first));
        result.depth = -receiver.position.z;
        return result;
    }
    return crease_conclude(gathered, receiver);
}
#ifdef __cplusplus
")glsl"
#endif
