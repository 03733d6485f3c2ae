// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Up-sweep and down-sweep through shared memory: statistical-volumetric-obscurance 3.4, figure 3.6, and A.1.
shared vec4 crease_scan_sums[crease_group_size.x * crease_group_size.y];

const int crease_scan_levels = 10; // of the largest workgroup

// The sum of `own` of all invocations of the line before this one; `stride` is from one to the next in the workgroup.
vec4 crease_scan_before(vec4 own, int along, int pieces, int stride) {
    int at = int(gl_LocalInvocationIndex);
    crease_scan_sums[at] = own;
    crease_unroll for (int level = 0; level < crease_scan_levels; ++level) {
        int reach = 1 << level;
        if (reach < pieces) {
            barrier();
            if ((along + 1) % (2 * reach) == 0)
                crease_scan_sums[at] += crease_scan_sums[at - reach * stride];
        }
    }
    barrier();
    if (along == pieces - 1)
        crease_scan_sums[at] = vec4(0.0);
    crease_unroll for (int level = crease_scan_levels - 1; level >= 0; --level) {
        int reach = 1 << level;
        if (reach < pieces) {
            barrier();
            if ((along + 1) % (2 * reach) == 0) {
                vec4 before = crease_scan_sums[at];
                vec4 left = crease_scan_sums[at - reach * stride];
                crease_scan_sums[at - reach * stride] = before;
                crease_scan_sums[at] = before + left;
            }
        }
    }
    barrier();
    return crease_scan_sums[at];
}
#ifdef __cplusplus
")glsl"
#endif
