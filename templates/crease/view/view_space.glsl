// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_stored_normal(vec2 texel);
vec3 crease_unit_normal(vec3 normal, vec3 position);
#else
__LINE__, R"glsl("
#endif

vec3 crease_normal_at(vec2 texel, vec3 position) {
    return crease_unit_normal(crease_stored_normal(texel), position);
}
#ifdef __cplusplus
")glsl"
#endif
