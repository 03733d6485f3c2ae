// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_layer crease_packed_layer(vec2 texel, float depth, float behind);
crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer);
crease_contribution crease_combine(crease_contribution a, crease_contribution b);
#else
__LINE__, R"glsl("
#endif

// Layers are packed in groups of four, one per component, the groups of each camera in a row; unused ones are background.
// A group is stored where the one before it is full.
int crease_group_count() { return (crease_most_layers + 3) / 4; }

const int crease_most_groups = 8; // of 32 layers

struct crease_layers {
    vec2 texel;
    vec4 groups[crease_most_groups];
};

// A group as it was packed; an image of one or two layers has no more components.
vec4 crease_whole_group(vec4 group) {
    return crease_most_layers == 1 ? vec4(group.x, vec3(crease_background))
        : crease_most_layers == 2 ? vec4(group.xy, vec2(crease_background))
                                  : group;
}

// Fetches groups [first, end) before any is weighed, so that their latencies overlap.
void crease_fetch_groups(inout crease_layers layers, int first, int end) {
    crease_unroll for (int group = first; group < end; ++group)
        layers.groups[group] = crease_whole_group(crease_load_packed_layers(
            ivec3(layers.texel, crease_view_index * crease_group_count() + group)));
}

crease_layers crease_fetch_layers(vec2 texel) {
    crease_layers layers;
    layers.texel = texel;
    crease_fetch_groups(layers, 0, crease_group_count());
    return layers;
}

int crease_layer_count(crease_layers layers) {
    int count = 0;
    while (count < crease_most_layers && layers.groups[count / 4][count % 4] < crease_background)
        ++count;
    return max(count, 1);
}

float crease_depth_of_packed(crease_layers layers, int i) {
    return i < crease_most_layers ? layers.groups[min(i / 4, crease_most_groups - 1)][i % 4] : crease_background;
}

crease_layer crease_layer_at(crease_layers layers, int i) {
    float depth = crease_depth_of_packed(layers, i);
    float behind = depth < crease_background ? crease_depth_of_packed(layers, i + 1) : crease_background;
    return crease_packed_layer(layers.texel, depth, behind);
}

// The layers of a group are written out, which keeps it in registers.
crease_contribution crease_combine_layer(crease_march march, crease_receiver receiver, crease_tap tap,
                                         crease_contribution all, float depth, float behind) {
    crease_layer layer = crease_packed_layer(tap.texel, depth, behind);
    return crease_combine(all, crease_weigh(march, receiver, tap, layer));
}

// `behind`: the depth of the first layer of the next group, where this one is full.
crease_contribution crease_combine_rest_of_group(crease_march march, crease_receiver receiver, crease_tap tap,
                                                 crease_contribution all, vec4 depths, float behind) {
    if (crease_most_layers > 1)
        all = crease_combine_layer(march, receiver, tap, all, depths.y, depths.z);
    if (crease_most_layers > 2)
        all = crease_combine_layer(march, receiver, tap, all, depths.z, depths.w);
    if (crease_most_layers > 3)
        all = crease_combine_layer(march, receiver, tap, all, depths.w, behind);
    return all;
}

crease_contribution crease_combine_group(crease_march march, crease_receiver receiver, crease_tap tap,
                                         crease_contribution all, vec4 depths, float behind) {
    all = crease_combine_layer(march, receiver, tap, all, depths.x, depths.y);
    return crease_combine_rest_of_group(march, receiver, tap, all, depths, behind);
}

float crease_first_of_group(crease_layers layers, int group) {
    return group < crease_group_count() ? layers.groups[min(group, crease_most_groups - 1)].x : crease_background;
}

crease_contribution crease_combine_first_group(crease_march march, crease_receiver receiver, crease_tap tap,
                                               vec4 depths, float behind) {
    crease_layer first = crease_packed_layer(tap.texel, depths.x, depths.y);
    crease_contribution all = crease_weigh(march, receiver, tap, first);
    return crease_combine_rest_of_group(march, receiver, tap, all, depths, behind);
}

crease_contribution crease_combine_layers(crease_march march, crease_receiver receiver, crease_tap tap,
                                          crease_layers layers, bool wanted) {
    vec4 depths = wanted ? layers.groups[0] : vec4(crease_background);
    bool more = depths.w < crease_background;
    crease_contribution all =
        crease_combine_first_group(march, receiver, tap, depths, crease_first_of_group(layers, 1));
    crease_unroll for (int group = 1; group < crease_group_count(); ++group) {
        depths = more ? layers.groups[group] : vec4(crease_background);
        if (more)
            all = crease_combine_group(march, receiver, tap, all, depths, crease_first_of_group(layers, group + 1));
        more = depths.w < crease_background;
    }
    return all;
}

// Groups fetched unconditionally; the rest are fetched on demand.
const int crease_most_asked = 4;

int crease_asked() { return min(crease_group_count(), crease_most_asked); }

crease_layers crease_fetch_first_layers(vec2 texel) {
    crease_layers layers;
    layers.texel = crease_inside(texel) ? texel : crease_first_texel;
    crease_fetch_groups(layers, 0, crease_asked());
    return layers;
}

// The first group after the first is weighed without a branch, as neighbouring taps mostly have it too.
crease_contribution crease_combine_first_layers(crease_march march, crease_receiver receiver, crease_tap tap,
                                                crease_layers layers) {
    bool beyond = crease_group_count() > crease_most_asked;
    crease_unroll for (int group = 0; group < crease_asked(); ++group)
        beyond = beyond && layers.groups[group].w < crease_background;
    if (beyond)
        crease_fetch_groups(layers, crease_most_asked, crease_group_count());
    bool more = layers.groups[0].w < crease_background;
    crease_contribution all =
        crease_combine_first_group(march, receiver, tap, layers.groups[0], crease_first_of_group(layers, 1));
    crease_unroll for (int group = 1; group < crease_group_count(); ++group) {
        vec4 depths = more ? layers.groups[group] : vec4(crease_background);
        if (group == 1 || more)
            all = crease_combine_group(march, receiver, tap, all, depths, crease_first_of_group(layers, group + 1));
        more = depths.w < crease_background;
    }
    return all;
}
#ifdef __cplusplus
")glsl"
#endif
