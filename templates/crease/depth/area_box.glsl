#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The texels of the tables whose centres are in an area of the picture: a read between texels takes four times as many
// places.

ivec2 crease_areas_size();
int crease_areas_divisor();

// From edges in the depth image to those in the tables, whole and within them: both have a band of as many texels.
ivec4 crease_areas_box(vec4 area) {
    vec4 box = floor((area - crease_view.guard) / float(crease_areas_divisor()) + crease_view.guard + 0.5);
    return ivec4(clamp(box, vec4(0.0), vec4(crease_areas_size().xyxy)));
}
#ifdef __cplusplus
")glsl"
#endif
