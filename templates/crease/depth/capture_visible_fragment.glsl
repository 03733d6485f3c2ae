// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_fragment_key();
void crease_keep_fragment(uint key);
#else
__LINE__, R"glsl("
#endif

// Called by the host's fragment shader, after its own alpha test. `anchor`: the position on the surface, as other
// captures take it; `normal`: view space, unit, as the triangle faces; `color`: linear, its alpha the opacity. What has
// none is not stored.
void crease_capture(vec3 anchor, vec3 normal, vec4 color) {
    if (packUnorm4x8(color) >> 24u != 0u)
        crease_keep_fragment(crease_fragment_key());
}
#ifdef __cplusplus
")glsl"
#endif
