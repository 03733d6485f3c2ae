#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The result of a pixel by what two cameras see: the greater occlusion counts: stochastic-depth-ao 7.2, Algorithm 12.

bool crease_receive(ivec2 pixel, out crease_receiver receiver);
vec2 crease_texel_at(vec3 position);
crease_receiver crease_receiver_at(ivec2 pixel, vec2 texel, vec3 position, vec3 normal);
crease_gathered crease_gather(crease_receiver receiver);
crease_gathered crease_gathered_turned_back(crease_gathered gathered, mat3 turn);
crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver);
crease_result crease_open();

crease_result crease_evaluate(ivec2 pixel) {
    crease_receiver receiver;
    if (!crease_receive(pixel, receiver))
        return crease_open();
    crease_gathered gathered = crease_gather(receiver);

    crease_view = crease_view_of(1);
    crease_view_index = 1;
    mat4 second_from_first = crease_given.crease_second_from_first;
    vec3 position = (second_from_first * vec4(receiver.position, 1.0)).xyz;
    vec3 normal = mat3(second_from_first) * receiver.normal;
    // What stands behind the second camera looks around from elsewhere, in vain: a branch around all that costs more.
    bool in_front = position.z < 0.0;
    vec3 there = in_front ? position : receiver.position;
    crease_receiver second = crease_receiver_at(pixel, crease_texel_at(there), there, normal);
    crease_gathered other = crease_gather(second);
    if (in_front && other.occlusion > gathered.occlusion)
        gathered = crease_gathered_turned_back(other, mat3(second_from_first));
    return crease_conclude(gathered, receiver);
}
#ifdef __cplusplus
")glsl"
#endif
