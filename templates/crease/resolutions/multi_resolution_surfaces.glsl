// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_to_eye(vec3 position);
vec3 crease_view_position(vec2 texel, float depth);
crease_surface crease_surface_at(ivec2 texel, int i);
crease_layer crease_layer_of(vec3 position);
uint crease_pack_surface_normal(vec3 normal);
crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer);
crease_contribution crease_fade(crease_march march, crease_receiver receiver, crease_tap tap, crease_contribution contribution, float opacity);
#else
__LINE__, R"glsl("
#endif

// Layers with their normals, of the side that is seen, and opacities.
const int crease_most_coarse_layers = crease_kept_surfaces;

uvec4 crease_layer_to_halve(vec2 texel, int i) {
    crease_surface surface = crease_surface_at(ivec2(texel), i);
    vec3 position = crease_view_position(texel, surface.depth);
    vec3 normal = dot(surface.normal, crease_to_eye(position)) < 0.0 ? -surface.normal : surface.normal;
    uint opacity = uint(surface.color.a * 255.0 + 0.5);
    return uvec4(floatBitsToUint(position), crease_pack_surface_normal(normal) | opacity << 24u);
}

// A transparent surface is one alone, as rays meet it.
crease_contribution crease_weigh_coarse_layer(crease_march march, crease_receiver receiver, crease_tap tap, uvec4 layer) {
    crease_layer coarse = crease_layer_of(uintBitsToFloat(layer.xyz));
    coarse.opacity = float(layer.w >> 24u) / 255.0;
    coarse.thickness = coarse.opacity < 1.0 ? 0.0 : coarse.thickness;
    return crease_fade(march, receiver, tap, crease_weigh(march, receiver, tap, coarse), coarse.opacity);
}
#ifdef __cplusplus
")glsl"
#endif
