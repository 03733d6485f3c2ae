// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Greater than the key of every fragment.
const uint crease_no_fragment = 0xffffffffu;

// The nearest of a texel, nearest first.
struct crease_fragments {
    uint keys[32];
};
#ifdef __cplusplus
")glsl"
#endif
