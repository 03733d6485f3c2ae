// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_at(vec2 texel);
float crease_area_depth(float depth);
vec4 crease_range_empty();
vec4 crease_range_join(vec4 a, vec4 b);
vec4 crease_range_join_all(vec4 own, int along, int count, int stride);
#else
__LINE__, R"glsl("
#endif

// The range of depth of each column of the picture.
void crease_build_line(int line) {
    int along = int(gl_LocalInvocationID.y), count = int(crease_group_size.y);
    vec4 own = crease_range_empty();
    for (int y = along; y < int(crease_view.resolution.y); y += count) {
        float depth = crease_area_depth(crease_depth_at(crease_texel_of_pixel(ivec2(line, y), 1)));
        if (depth > 0.0)
            own = crease_range_join(own, vec4(depth, depth, depth, 1.0));
    }
    own = crease_range_join_all(own, along, count, int(crease_group_size.x));
    if (along == 0 && line < imageSize(crease_range_of_columns).x)
        imageStore(crease_range_of_columns, ivec2(line, 0), own);
}
#ifdef __cplusplus
")glsl"
#endif
