// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_fragment_depth(uint key);
#else
__LINE__, R"glsl("
#endif

// As far behind it, and no nearer: Mara et al. 2016.
bool crease_lies_behind(uint key, uint layer) {
    float least = abs(crease_fragment_depth(layer)) + crease_separated_layers_separation * crease_radius;
    return key > layer && abs(crease_fragment_depth(key)) >= least;
}
#ifdef __cplusplus
")glsl"
#endif
