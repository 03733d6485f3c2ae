// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_count_before(uint own, int along, int pieces, int stride);
#else
__LINE__, R"glsl("
#endif

// Where the lists of each column begin in the pool: the sums of all nodes of the columns before it.
uint crease_nodes_of_column(ivec2 size, int column) {
    return crease_load_list_places(ivec3(column, size.y - 1, 0)).x;
}

void crease_build_line(int line) {
    ivec2 size = crease_size_of_list_places();
    int pieces = int(crease_group_size.x), along = int(gl_LocalInvocationID.x);
    int share = (size.x + pieces - 1) / pieces;
    int first = min(along * share, size.x), last = min(first + share, size.x);
    uint nodes = 0u;
    for (int x = first; x < last; ++x)
        nodes += crease_nodes_of_column(size, x);
    uint start = crease_count_before(nodes, along, pieces, 1);
    for (int x = first; x < last; ++x) {
        crease_column_starts[x] = start;
        start += crease_nodes_of_column(size, x);
    }
}
#ifdef __cplusplus
")glsl"
#endif
