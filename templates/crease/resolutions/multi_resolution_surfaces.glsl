// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_to_eye(vec3 position);
vec3 crease_view_position(vec2 texel, float depth);
crease_surface crease_surface_at(ivec2 texel, int i);
uint crease_pack_surface_normal(vec3 normal);
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
#ifdef __cplusplus
")glsl"
#endif
