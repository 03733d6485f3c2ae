// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
ivec2 crease_areas_size();
int crease_areas_divisor();
#else
__LINE__, R"glsl("
#endif

// The texels of the tables whose centres are in an area of the picture: a read between texels takes four times as many
// places.

// From edges in the depth image to those in the tables, within them: both have a band of as many texels.
vec4 crease_areas_edges(vec4 area) {
    vec4 edges = (area - crease_view.guard) / float(crease_areas_divisor()) + crease_view.guard;
    return clamp(edges, vec4(0.0), vec4(crease_areas_size().xyxy));
}

// The same, whole.
ivec4 crease_areas_box(vec4 area) { return ivec4(crease_areas_edges(area) + 0.5); }
#ifdef __cplusplus
")glsl"
#endif
