// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_cosine_bitmask_sectors_of(crease_march march, crease_cosine_bitmask_slab slab, float thickness, out float nearest);
void crease_cosine_bitmask_hide(inout crease_march march, uint hidden, float nearness);
float crease_cosine_bitmask_thickness_of_last(crease_march march, float depth_after);
#else
__LINE__, R"glsl("
#endif

// Layers with an opacity: the slab that waits for the next tap hides some of its sectors.
struct crease_march {
    vec3 height, along;
    float bias;
    float reach;
    vec2 constant, linear, square, cubic;
    float weight;
    vec2 towards;
    uint hidden;
    float occlusion;
    int taps;
    crease_cosine_bitmask_slab last;
    float before_last;
    uint of_last; // sectors that the last slab may hide
};

void crease_cosine_bitmask_hide_last(inout crease_march march, float thickness) {
    float nearest;
    uint hidden = crease_cosine_bitmask_sectors_of(march, march.last, thickness, nearest) & march.of_last;
    crease_cosine_bitmask_hide(march, hidden, 1.0 - march.reach / nearest);
}

void crease_add(inout crease_march march, crease_contribution contribution) {
    if (march.taps > 0)
        crease_cosine_bitmask_hide_last(march,
                                        crease_cosine_bitmask_thickness_of_last(march, contribution.slab.depth));
    if (crease_most_layers > 1)
        crease_cosine_bitmask_hide(march, contribution.behind, contribution.behind_nearness);
    march.before_last = march.last.depth;
    march.last = contribution.slab;
    march.of_last = contribution.own;
    ++march.taps;
}
#ifdef __cplusplus
")glsl"
#endif
