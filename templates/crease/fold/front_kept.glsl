#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Whether a captured depth is packed, where the depth image has `front`.
bool crease_is_packed(float depth, float front) { return true; }
#ifdef __cplusplus
")glsl"
#endif
