// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Greater than the key of every fragment.
const uint crease_no_fragment = 0xffffffffu;

// The depth of a fragment, negative where it is of a back face; crease_background where there is none.
float crease_fragment_depth(uint key) {
    float depth = uintBitsToFloat(key >> 1);
    if (key == crease_no_fragment || !(depth < crease_background))
        return crease_background;
    return (key & 1u) == 0u ? depth : -depth;
}

// The nearest of a texel, nearest first.
struct crease_fragments {
    uint keys[32];
};
#ifdef __cplusplus
")glsl"
#endif
