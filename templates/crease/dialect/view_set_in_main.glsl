// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Neither GLSL ES nor naga begins a global with what is uniform, so that what runs first sets it.
crease_view_parameters crease_view; // of the camera at work
#ifdef __cplusplus
")glsl"
#endif
