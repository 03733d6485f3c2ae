// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec4 crease_scan_before(vec4 own, int along, int pieces, int stride);
#else
__LINE__, R"glsl("
#endif

// The sum of the counts of all invocations of a line before this one. A scan is of floats, which are exact up to 2^24, so
// the 14 lowest bits are summed apart from the others: as many as leave room for 1024 invocations.
uint crease_count_before(uint own, int along, int pieces, int stride) {
    vec4 before = crease_scan_before(vec4(own & 0x3fffu, own >> 14, 0.0, 0.0), along, pieces, stride);
    return uint(before.x) + (uint(before.y) << 14);
}
#ifdef __cplusplus
")glsl"
#endif
