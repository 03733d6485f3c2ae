#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The layers of a tap count as the one that occludes the most: stochastic-depth-ao 6.2, a-buffer-ssao III A.

int crease_layer_count();
float crease_layer_depth(crease_layers layers, int layer);
vec3 crease_view_position(vec2 texel, float depth);
crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);

crease_contribution crease_fold(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                crease_layers layers) {
    crease_contribution most = crease_weigh(
        estimate, receiver, tap, crease_view_position(tap.texel, crease_layer_depth(layers, 0)));
    crease_unroll for (int layer = 1; layer < crease_layer_count(); ++layer) {
        crease_contribution other = crease_weigh(
            estimate, receiver, tap, crease_view_position(tap.texel, crease_layer_depth(layers, layer)));
        if (other.occlusion > most.occlusion)
            most = other;
    }
    return most;
}
#ifdef __cplusplus
")glsl"
#endif
