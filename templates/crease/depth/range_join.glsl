// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Ranges of depth: nearest, farthest, sum and count.
shared vec4 crease_range_ranges[crease_group_size.x * crease_group_size.y];

vec4 crease_range_empty() { return vec4(crease_background, 0.0, 0.0, 0.0); }

vec4 crease_range_join(vec4 a, vec4 b) { return vec4(min(a.x, b.x), max(a.y, b.y), a.zw + b.zw); }

// The range of all invocations that differ in `along` alone; in the first of them.
vec4 crease_range_join_all(vec4 own, int along, int count, int stride) {
    int at = int(gl_LocalInvocationIndex);
    crease_range_ranges[at] = own;
    barrier();
    for (int reach = 1; reach < count; reach *= 2) {
        if (along % (2 * reach) == 0 && along + reach < count)
            crease_range_ranges[at] = crease_range_join(crease_range_ranges[at],
                                                        crease_range_ranges[at + reach * stride]);
        barrier();
    }
    return crease_range_ranges[at];
}
#ifdef __cplusplus
")glsl"
#endif
