// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// A camera as shaders use it: in their texel space whole numbers are the centres of the depth image's texels, those of
// the guard band too.
crease_view_parameters crease_view_of(int index) {
    crease_view_parameters view = crease_given.views[index];
    view.from_texel.zw += (0.5 - view.guard) * view.from_texel.xy;
    return view;
}

// Read once, as not every compiler takes the reading out of a loop.
crease_view_parameters crease_view = crease_view_of(crease_view_index); // of the camera at work

// What crease_view.far_depth is of the distance of the far plane: see set_projection.
const float crease_far_share = 0.999;
#ifdef __cplusplus
")glsl"
#endif
