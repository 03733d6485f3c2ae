// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_tap_spacing(crease_pattern pattern, crease_receiver receiver, int step);
crease_fetched crease_fetch(vec2 texel);
#else
__LINE__, R"glsl("
#endif

int crease_depth_pyramid_level = 0; // of the tap that is fetched

// A level whose texels are at most a quarter of the spacing of taps, and half of the way from the receiver. A texel of it
// lies where the depth was that it took over; one with the nearest of many in their middle.
crease_fetched crease_fetch_tap(crease_pattern pattern, crease_receiver receiver, int step, inout crease_tap tap) {
    vec2 way = abs(tap.texel - receiver.texel);
    float spacing = min(crease_tap_spacing(pattern, receiver, step), 2.0 * max(way.x, way.y));
    int level = clamp(findMSB(int(clamp(spacing, 0.0, 1e6)) / 4), 0, crease_levels_of_depth_pyramid() - 1);
    bool nearest = crease_depth_pyramid_nearest != 0;
    int size = 1 << level;
    ivec2 last = max(ivec2(crease_depth_size()) >> level, 1) - 1;
    ivec2 at = clamp((ivec2(tap.texel) + (nearest ? 0 : size / 2)) >> level, ivec2(0), last);
    tap.texel = vec2(at << level) + (nearest ? 0.5 * float(size - 1) : 0.0);
    crease_depth_pyramid_level = level;
    return crease_fetch(tap.texel);
}

crease_layers crease_fetch_layers(vec2 texel) {
    int level = crease_depth_pyramid_level;
    return crease_layers(texel, crease_load_depth_pyramid(ivec2(texel) >> level, level).x);
}
#ifdef __cplusplus
")glsl"
#endif
