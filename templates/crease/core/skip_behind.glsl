// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// True if the layers behind the front one cannot add occlusion.
bool crease_skip_behind(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer front) {
    return false;
}
#ifdef __cplusplus
")glsl"
#endif
