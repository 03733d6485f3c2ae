// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
ivec2 crease_areas_size();
int crease_areas_divisor();
#else
__LINE__, R"glsl("
#endif

// The texels of the tables whose centres lie in an area of the picture: to interpolate between texels would take four
// times as many reads.

// An area of the depth image in texels of the tables, clamped to them; the guard bands of both have the same number of
// texels.
vec4 crease_areas_edges(vec4 area) {
    vec4 edges = (area - crease_view.guard) / float(crease_areas_divisor()) + crease_view.guard;
    return clamp(edges, vec4(0.0), vec4(crease_areas_size().xyxy));
}

// The same, rounded to whole texels.
ivec4 crease_areas_box(vec4 area) { return ivec4(crease_areas_edges(area) + 0.5); }
#ifdef __cplusplus
")glsl"
#endif
