// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uvec4 crease_halved(uvec4 a, uvec4 b, uvec4 c, uvec4 d);
#else
__LINE__, R"glsl("
#endif

// A picture of half the size of the one before.
void crease_build(ivec2 texel) {
    ivec2 first = 2 * texel, last = min(first + 1, crease_size_of_input() - 1);
    imageStore(crease_resolutions, texel,
               crease_halved(crease_load_input(first), crease_load_input(ivec2(last.x, first.y)),
                             crease_load_input(ivec2(first.x, last.y)), crease_load_input(last)));
}
#ifdef __cplusplus
")glsl"
#endif
