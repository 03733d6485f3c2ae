// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The workgroup's place: workgroups run down the picture in columns, as in whole rows of a large picture a texel has
// left the cache before the next row needs it. Quotients are of floats, as many devices divide whole numbers slowly.
uvec2 crease_workgroup() {
    const float width = float(crease_compute_columns_across);
    vec2 groups = vec2(uvec2(crease_size(crease_divisor) - 1) / crease_group_size.xy + 1u);
    float index = float(gl_WorkGroupID.y) * groups.x + float(gl_WorkGroupID.x);
    float column = floor((index + 0.5) / (width * groups.y)), within = index - column * width * groups.y;
    float here = min(width, groups.x - column * width), row = floor((within + 0.5) / here);
    return uvec2(column * width + within - row * here, row);
}

ivec2 crease_pixel() { return ivec2(crease_workgroup() * crease_group_size.xy + gl_LocalInvocationID.xy); }
#ifdef __cplusplus
")glsl"
#endif
