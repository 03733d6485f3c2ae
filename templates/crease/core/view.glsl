// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Shaders index texels of the whole depth image, guard band included, with texel centres at whole numbers.
crease_view_parameters crease_view_of(int index) {
    crease_view_parameters view = crease_given.views[index];
    view.from_texel.zw += (0.5 - view.guard) * view.from_texel.xy;
    return view;
}

// A copy, as some compilers reload uniforms in every iteration.
crease_view_parameters crease_view = crease_view_of(crease_view_index); // of the camera at work

// crease_view.far_depth over the distance of the far plane: see set_projection.
const float crease_far_share = 0.999;
#ifdef __cplusplus
")glsl"
#endif
