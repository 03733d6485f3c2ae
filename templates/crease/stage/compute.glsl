#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
crease_result crease_evaluate(ivec2 pixel);

// The workgroup's place: in rows, or in columns that are so many wide, as a texel has left the cache when a row of a large
// picture comes to it again. Quotients are of floats, as many devices have none of whole numbers.
uvec2 crease_workgroup() {
    uvec2 place = gl_WorkGroupID.xy;
    if (crease_workgroup_columns > 0) {
        const float width = float(crease_workgroup_columns);
        vec2 groups = vec2(uvec2(crease_size(crease_divisor) - 1) / gl_WorkGroupSize.xy + 1u);
        float index = float(place.y) * groups.x + float(place.x);
        float column = floor((index + 0.5) / (width * groups.y)), within = index - column * width * groups.y;
        float here = min(width, groups.x - column * width), row = floor((within + 0.5) / here);
        place = uvec2(column * width + within - row * here, row);
    }
    return place;
}

void main() {
    ivec2 pixel = ivec2(crease_workgroup() * gl_WorkGroupSize.xy + gl_LocalInvocationID.xy);
    if (all(lessThan(pixel, crease_size(crease_divisor)))) {
        crease_result result = crease_evaluate(pixel);
        crease_write(pixel, result)
    }
}
#ifdef __cplusplus
")glsl"
#endif
