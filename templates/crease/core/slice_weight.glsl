// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The weight of a direction whose half slice holds this share of the cosine lobe: that share, where directions are
// spread evenly around the eye's.
float crease_slice_weight(float share) { return share; }
#ifdef __cplusplus
")glsl"
#endif
