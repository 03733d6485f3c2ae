// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// A scan by subgroup operations: the sums of all lines are laid out one after another in shared memory, and each
// subgroup, all of which are full, scans its share of them: several lines, one by one, or a part of one.
shared vec4 crease_scan_sums[crease_group_size.x * crease_group_size.y];
shared vec4 crease_scan_shares[crease_group_size.x * crease_group_size.y]; // of each subgroup

// The sum of `own` of all invocations of the line before this one; `stride` is from one to the next in the workgroup.
vec4 crease_scan_before(vec4 own, int along, int pieces, int stride) {
    int index = int(gl_LocalInvocationIndex);
    int place = (stride > 1 ? index % stride : index / pieces) * pieces + along;
    crease_scan_sums[place] = own;
    barrier();
    int share = int(gl_SubgroupID), size = int(gl_SubgroupSize);
    int at = share * size + int(gl_SubgroupInvocationID);
    vec4 sum = crease_scan_sums[at], before = vec4(0.0);
    for (int first = share * size; first < (share + 1) * size; first += pieces)
        if (at / pieces == first / pieces)
            before = subgroupExclusiveAdd(sum);
    vec4 whole = subgroupAdd(sum);
    if (subgroupElect())
        crease_scan_shares[share] = whole;
    barrier();
    int of_line = max(pieces / size, 1);
    for (int i = share / of_line * of_line; i < share; ++i)
        before += crease_scan_shares[i];
    crease_scan_sums[at] = before;
    barrier();
    return crease_scan_sums[place];
}
#ifdef __cplusplus
")glsl"
#endif
