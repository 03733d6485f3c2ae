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

// The result by what all cameras see: the greatest occlusion counts: stochastic-depth-ao 7.2, Algorithm 12.
crease_result crease_result_of(crease_receiver receiver) {
    crease_gathered gathered = crease_gather(receiver);
    crease_receiver seen = receiver; // by the camera of which that is
    mat3 turn = mat3(1.0);           // to its space
    for (int i = 0; i < crease_given.from_first.length(); ++i) {
        crease_view = crease_view_of(1 + i);
        crease_view_index = 1 + i;
        mat4 from_first = crease_given.from_first[i];
        vec3 position = (from_first * vec4(receiver.position, 1.0)).xyz;
        vec3 normal = mat3(from_first) * receiver.normal;
        // What stands behind a camera looks around from elsewhere, in vain: a branch around all that costs more.
        bool in_front = position.z < 0.0;
        vec3 there = in_front ? position : receiver.position;
        crease_receiver further = crease_make_receiver(receiver.pixel, crease_texel_at(there), there, normal);
        crease_gathered other = crease_gather(further);
        if (in_front && crease_estimate_occlusion(other.estimate) > crease_estimate_occlusion(gathered.estimate)) {
            gathered = other;
            seen = further;
            turn = mat3(from_first);
        }
    }
    crease_result result = crease_turned_back(crease_conclude(gathered, seen), turn);
    result.depth = -receiver.position.z;
    return result;
}
#ifdef __cplusplus
")glsl"
#endif
