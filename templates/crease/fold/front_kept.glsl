#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Whether a captured depth is packed, where the depth image has `front`: what is nearer was drawn to a sample beside the
// centre of the texel.
bool crease_is_packed(float depth, float front) { return depth >= front - 1e-4 * front; }
#ifdef __cplusplus
")glsl"
#endif
