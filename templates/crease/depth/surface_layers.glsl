// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_layer crease_packed_layer(vec2 texel, float depth, float behind, float opacity);
int crease_group_count();
crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer);
crease_contribution crease_combine(crease_contribution a, crease_contribution b);
crease_contribution crease_fade(crease_march march, crease_receiver receiver, crease_tap tap, crease_contribution contribution, float opacity);
vec3 crease_unpack_surface_normal(uint word);
#else
__LINE__, R"glsl("
#endif

// Packed in groups of four, one per component: depths, which of back faces are negative, and opacities. A group is stored
// where the one before it is full.
struct crease_group {
    vec4 depths;
    uint opacities;
};

crease_group crease_load_group(vec2 texel, int group) {
    ivec3 at = ivec3(texel, group);
    return crease_group(crease_load_packed_layers(at), crease_load_packed_opacities(at).x);
}

// The first group; the others are fetched on demand.
struct crease_layers {
    vec2 texel;
    crease_group first;
};

crease_layers crease_fetch_layers(vec2 texel) {
    texel = crease_inside(texel) ? texel : crease_first_texel;
    return crease_layers(texel, crease_load_group(texel, 0));
}

crease_layers crease_fetch_first_layers(vec2 texel) { return crease_fetch_layers(texel); }

const crease_group crease_no_group = crease_group(vec4(crease_background), 0xffffffffu);

crease_group crease_group_at(crease_layers layers, int group) {
    if (group == 0)
        return layers.first;
    return group < crease_group_count() ? crease_load_group(layers.texel, group) : crease_no_group;
}

crease_layer crease_layer_of_group(vec2 texel, crease_group group, int i, float behind) {
    return crease_packed_layer(texel, group.depths[i], behind, float(group.opacities >> uint(8 * i) & 255u) / 255.0);
}

int crease_layer_count(crease_layers layers) {
    int count = 0;
    while (count < crease_most_layers && crease_group_at(layers, count / 4).depths[count % 4] < crease_background)
        ++count;
    return max(count, 1);
}

crease_layer crease_layer_at(crease_layers layers, int i) {
    crease_group group = crease_group_at(layers, i / 4);
    float behind = i % 4 < 3 ? group.depths[i % 4 + 1] : crease_group_at(layers, i / 4 + 1).depths.x;
    return crease_layer_of_group(layers.texel, group, i % 4, behind);
}

crease_contribution crease_weigh_faded(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    return crease_fade(march, receiver, tap, crease_weigh(march, receiver, tap, layer), layer.opacity);
}

crease_contribution crease_combine_faded(crease_march march, crease_receiver receiver, crease_tap tap,
                                         crease_contribution all, crease_group group, int i, float behind) {
    crease_layer layer = crease_layer_of_group(tap.texel, group, i, behind);
    return crease_combine(all, crease_weigh_faded(march, receiver, tap, layer));
}

// The layers of a group are written out, which keeps it in registers, and weighed without a branch.
crease_contribution crease_combine_faded_rest(crease_march march, crease_receiver receiver, crease_tap tap,
                                              crease_contribution all, crease_group group, float behind) {
    all = crease_combine_faded(march, receiver, tap, all, group, 1, group.depths.z);
    all = crease_combine_faded(march, receiver, tap, all, group, 2, group.depths.w);
    return crease_combine_faded(march, receiver, tap, all, group, 3, behind);
}

crease_group crease_group_behind(crease_layers layers, crease_group group, int i) {
    return group.depths.w < crease_background ? crease_group_at(layers, i) : crease_no_group;
}

crease_contribution crease_combine_first_layers(crease_march march, crease_receiver receiver, crease_tap tap,
                                                crease_layers layers) {
    crease_group group = layers.first, next = crease_group_behind(layers, group, 1);
    crease_contribution all = crease_weigh_faded(
        march, receiver, tap, crease_layer_of_group(tap.texel, group, 0, group.depths.y));
    all = crease_combine_faded_rest(march, receiver, tap, all, group, next.depths.x);
    // Without a loop, or some drivers keep the layers in memory for it, even where it never runs.
    if (crease_group_count() == 2) {
        all = crease_combine_faded(march, receiver, tap, all, next, 0, next.depths.y);
        all = crease_combine_faded_rest(march, receiver, tap, all, next, crease_background);
    }
    if (crease_group_count() > 2)
        for (int i = 2; i <= crease_group_count() && next.depths.x < crease_background; ++i) {
            group = next;
            next = crease_group_behind(layers, group, i);
            all = crease_combine_faded(march, receiver, tap, all, group, 0, group.depths.y);
            all = crease_combine_faded_rest(march, receiver, tap, all, group, next.depths.x);
        }
    return all;
}

const int crease_kept_surfaces = crease_most_surfaces; // for receivers

// A surface whose visibility is asked for.
struct crease_surface {
    float depth;  // crease_background: there is none, nor any behind it
    vec3 normal;  // view space, unit, as the triangle faces
    vec4 color;   // linear, its alpha the opacity
};

crease_surface crease_surface_at(ivec2 texel, int i) {
    uvec4 own = crease_load_layer_surfaces(ivec3(texel, i));
    return crease_surface(abs(uintBitsToFloat(own.x)), crease_unpack_surface_normal(own.z), unpackUnorm4x8(own.y));
}
#ifdef __cplusplus
")glsl"
#endif
