// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_normal_at(vec2 texel, vec3 position);
vec3 crease_view_position(vec2 texel, float depth);
crease_layers crease_fetch_layers(vec2 texel);
crease_layer crease_layer_at(crease_layers layers, int i);
crease_layer crease_layer_of(vec3 position);
uint crease_pack_surface_normal(vec3 normal);
crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer);
#else
__LINE__, R"glsl("
#endif

// Layers of which depths are known, and of the first the normal, as that one receives.
const int crease_most_coarse_layers = crease_most_layers;

uint crease_opacity_byte(crease_layer layer) { return 255u; }

uvec4 crease_layer_to_halve(vec2 texel, int i) {
    crease_layer layer = crease_layer_at(crease_fetch_layers(texel), i);
    vec3 position = layer.position;
    if (!(position.z < 0.0 && position.z > -crease_background))
        position = crease_view_position(texel, crease_background);
    vec3 normal = i == 0 ? crease_normal_at(texel, position) : vec3(0.0, 0.0, 1.0);
    return uvec4(floatBitsToUint(position), crease_pack_surface_normal(normal) | crease_opacity_byte(layer) << 24u);
}

crease_contribution crease_weigh_coarse_layer(crease_march march, crease_receiver receiver, crease_tap tap, uvec4 layer) {
    return crease_weigh(march, receiver, tap, crease_layer_of(uintBitsToFloat(layer.xyz)));
}
#ifdef __cplusplus
")glsl"
#endif
