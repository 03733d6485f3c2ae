// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_linear_depth(float device);
#else
__LINE__, R"glsl("
#endif

// A fragment as a whole number: ordered by depth, as positive floats are ordered as their bits are, and at one depth a
// front face before a back face.
uint crease_fragment_key() {
    return floatBitsToUint(crease_linear_depth(gl_FragCoord.z)) << 1 | (gl_FrontFacing ? 0u : 1u);
}
#ifdef __cplusplus
")glsl"
#endif
