// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_count_before(uint own, int along, int pieces, int stride);
#else
__LINE__, R"glsl("
#endif

// Turns the counts of a column into the ends of its lists, in place. The nearest fragment of a texel needs no node. Each
// invocation sums its piece of the column, and a scan gives what stands before it.
uint crease_nodes_of(ivec2 texel) { return max(crease_load_list_places(ivec3(texel, 0)).x, 1u) - 1u; }

void crease_build_line(int line) {
    ivec2 size = crease_size_of_list_places();
    int pieces = int(crease_group_size.y), along = int(gl_LocalInvocationID.y);
    int share = (size.y + pieces - 1) / pieces;
    int first = min(along * share, size.y);
    int last = line < size.x ? min(first + share, size.y) : first;
    uint nodes = 0u;
    for (int y = first; y < last; ++y)
        nodes += crease_nodes_of(ivec2(line, y));
    uint end = crease_count_before(nodes, along, pieces, int(crease_group_size.x));
    for (int y = first; y < last; ++y) {
        end += crease_nodes_of(ivec2(line, y));
        imageStore(crease_list_places, ivec3(line, y, 0), uvec4(end));
    }
}
#ifdef __cplusplus
")glsl"
#endif
