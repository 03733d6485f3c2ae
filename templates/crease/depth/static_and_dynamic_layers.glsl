// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

const int crease_most_layers = 2;

const int crease_most_surfaces = 2;
#ifdef __cplusplus
")glsl"
#endif
