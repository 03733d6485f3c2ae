#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Which camera the functions work for: the picture's first, and then the second.
crease_view_parameters crease_view;
int crease_view_index;
#ifdef __cplusplus
")glsl"
#endif
