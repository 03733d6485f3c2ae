// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_layer crease_layer_of(vec3 position);
float crease_cosine_bitmask_thickness_of(crease_layer layer);
uvec2 crease_cosine_bitmask_ends_of(crease_march march, crease_cosine_bitmask_slab slab, float thickness, out float nearest);
void crease_cosine_bitmask_hide(inout crease_march march, uint hidden, float nearness);
float crease_cosine_bitmask_thickness_of_last(crease_march march, float depth_after);
#else
__LINE__, R"glsl("
#endif

float crease_cosine_bitmask_least_thickness() {
    crease_layer thin = crease_layer_of(vec3(0.0));
    thin.thickness = 0.0;
    return crease_cosine_bitmask_thickness_of(thin);
}

// As without opacity, but that a receiver may be looked at from behind. There slabs reach to the eye, or a surface would hide
// what its own other side sees: that of a solid from its back on.
uint crease_cosine_bitmask_sectors_of(crease_march march, crease_cosine_bitmask_slab slab, float thickness,
                                      out float nearest) {
    bool from_behind = slab.ray_height * march.towards.x > slab.ray_along * march.towards.y; // the way on leads to the eye
    bool solid = thickness > crease_cosine_bitmask_least_thickness();
    float to_back = from_behind && solid ? thickness : 0.0;
    slab.height += slab.ray_height * to_back;
    slab.along += slab.ray_along * to_back;
    uvec2 bit = crease_cosine_bitmask_ends_of(march, slab, from_behind ? -thickness : thickness, nearest);
    uint hidden = bit.x - min(bit.x, bit.y);
    return nearest > march.reach ? hidden : 0u;
}

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
