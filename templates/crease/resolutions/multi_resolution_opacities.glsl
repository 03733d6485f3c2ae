// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_layer crease_layer_of(vec3 position);
crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer);
crease_contribution crease_fade(crease_march march, crease_receiver receiver, crease_tap tap, crease_contribution contribution, float opacity);
#else
__LINE__, R"glsl("
#endif

// Layers that occlude by their opacities.
uint crease_opacity_byte(crease_layer layer) { return uint(layer.opacity * 255.0 + 0.5); }

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
