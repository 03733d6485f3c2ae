// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_stored_normal(vec2 texel);
vec3 crease_unit_normal(vec3 normal, vec3 position);
#else
__LINE__, R"glsl("
#endif

// The image holds normals in world space, which the host's rotation brings to view space.
vec3 crease_normal_at(vec2 texel, vec3 position) {
    vec3 normal = crease_stored_normal(texel);
    return crease_unit_normal(vec3(dot(vec3(crease_world_xx, crease_world_xy, crease_world_xz), normal),
                                   dot(vec3(crease_world_yx, crease_world_yy, crease_world_yz), normal),
                                   dot(vec3(crease_world_zx, crease_world_zy, crease_world_zz), normal)),
                              position);
}
#ifdef __cplusplus
")glsl"
#endif
