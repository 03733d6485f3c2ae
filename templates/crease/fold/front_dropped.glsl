#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Whether a captured depth is packed, where the depth image has `front`: what is the front surface itself is not.
bool crease_is_packed(float depth, float front) { return abs(depth - front) > 1e-4 * front; }
#ifdef __cplusplus
")glsl"
#endif
