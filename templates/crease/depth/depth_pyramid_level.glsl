// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// One texel of four, or the nearest of them; where the level before has an odd size, of those left over too.
void crease_build(ivec2 texel) {
    ivec2 before = crease_size_of_input() - 1, first = min(2 * texel, before);
    float depth = crease_load_input(first).x;
    if (crease_depth_pyramid_nearest != 0) {
        bvec2 is_last = equal(texel, crease_build_size - 1);
        ivec2 end = ivec2(is_last.x ? before.x : first.x + 1, is_last.y ? before.y : first.y + 1);
        for (int y = first.y; y <= end.y; ++y)
            for (int x = first.x; x <= end.x; ++x)
                depth = min(depth, crease_load_input(ivec2(x, y)).x);
    }
    imageStore(crease_depth_pyramid, texel, vec4(depth));
}
#ifdef __cplusplus
")glsl"
#endif
