// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec4 crease_range_empty();
vec4 crease_range_join(vec4 a, vec4 b);
vec4 crease_range_join_all(vec4 own, int along, int count, int stride);
#else
__LINE__, R"glsl("
#endif

// The range of depth of the picture, and its mean, out of those of its columns.
void crease_build_line(int line) {
    int along = int(gl_LocalInvocationID.x), count = int(crease_group_size.x);
    vec4 own = crease_range_empty();
    for (int x = along; x < int(crease_view.resolution.x); x += count)
        own = crease_range_join(own, crease_load_range_of_columns(ivec2(x, 0)));
    own = crease_range_join_all(own, along, count, 1);
    if (along == 0)
        imageStore(crease_range, ivec2(0), own.w > 0.0 ? vec4(own.xy, own.z / own.w, own.w) : vec4(0.0));
}
#ifdef __cplusplus
")glsl"
#endif
