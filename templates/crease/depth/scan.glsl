// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec4 crease_scan_read(ivec3 at);
void crease_scan_write(ivec3 at, vec4 sum);
vec4 crease_scan_before(vec4 own, int along, int pieces, int stride);
#else
__LINE__, R"glsl("
#endif

// Makes the prefix sums of the lines of some tables, from one image to another; rows and then columns make a summed-area
// table: statistical-volumetric-obscurance 3.4 and A.1. A line of any length is cut into as many pieces as there are
// invocations for it: each sums its piece, a scan of these sums gives what stands before it, and then each writes its
// piece. The number of pieces is a power of 2.

// Compensated (Kahan) summation, so that the sum of a long piece is as exact as that of a short one.
void crease_scan_add(inout vec4 sum, inout vec4 lost, vec4 more) {
    crease_precise vec4 own = more - lost;
    crease_precise vec4 next = sum + own;
    crease_precise vec4 rounded = (next - sum) - own;
    lost = rounded;
    sum = next;
}

void crease_build_line(int line) {
    const bool down = crease_scan_axis == 1;
    ivec2 size = crease_build_size;
    ivec2 step = down ? ivec2(0, 1) : ivec2(1, 0), start = line * step.yx;
    int length = down ? size.y : size.x;
    int along = int(down ? gl_LocalInvocationID.y : gl_LocalInvocationID.x);
    int pieces = int(down ? crease_group_size.y : crease_group_size.x);
    int stride = down ? int(crease_group_size.x) : 1;
    int share = (length + pieces - 1) / pieces;
    int first = min(along * share, length);
    int last = line < (down ? size.x : size.y) ? min(first + share, length) : first;
    for (int table = crease_scan_first; table < min(crease_scan_end, crease_most_layers); ++table) {
        vec4 sum = vec4(0.0), lost = vec4(0.0);
        for (int i = first; i < last; ++i)
            crease_scan_add(sum, lost, crease_scan_read(ivec3(start + i * step, table)));
        sum = crease_scan_before(sum, along, pieces, stride);
        lost = vec4(0.0);
        for (int i = first; i < last; ++i) {
            ivec3 at = ivec3(start + i * step, table);
            crease_scan_add(sum, lost, crease_scan_read(at));
            crease_scan_write(at, sum);
        }
    }
}
#ifdef __cplusplus
")glsl"
#endif
