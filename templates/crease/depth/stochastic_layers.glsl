// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_view_position(vec2 texel, float depth);
crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer);
crease_contribution crease_combine(crease_contribution a, crease_contribution b);
#else
__LINE__, R"glsl("
#endif

// Samples of a texel, each of which keeps a layer.
int crease_sample_count() { return crease_stochastic_layers_count; }

// Layers are packed in groups of four, one per component, the groups of each camera in a row; unused ones are background.
int crease_group_count() { return (crease_stochastic_layers_count + 3) / 4; }

const int crease_most_layers = crease_stochastic_layers_count;
const int crease_most_groups = 8; // of 32 layers

struct crease_layers {
    vec2 texel;
    vec4 groups[crease_most_groups];
};

// Fetches groups [first, end) before any is weighed, so that their latencies overlap.
void crease_fetch_groups(inout crease_layers layers, int first, int end) {
    crease_unroll for (int group = first; group < end; ++group)
        layers.groups[group] = crease_load_packed_layers(
            ivec3(layers.texel, crease_view_index * crease_group_count() + group));
}

crease_layers crease_fetch_layers(vec2 texel) {
    crease_layers layers;
    layers.texel = texel;
    crease_fetch_groups(layers, 0, crease_group_count());
    return layers;
}

int crease_layer_count(crease_layers layers) {
    int count = 0;
    for (int i = 0; i < crease_stochastic_layers_count; ++i)
        count += layers.groups[i / 4][i % 4] < crease_background ? 1 : 0;
    return max(count, 1);
}

crease_layer crease_layer_at(crease_layers layers, int i) {
    return crease_layer(crease_view_position(layers.texel, layers.groups[i / 4][i % 4]), 1.0);
}

// The layers of a group are written out, which keeps it in registers.
crease_contribution crease_combine_layer(crease_march march, crease_receiver receiver, crease_tap tap,
                                         crease_contribution all, float depth) {
    crease_layer layer = crease_layer(crease_view_position(tap.texel, depth), 1.0);
    return crease_combine(all, crease_weigh(march, receiver, tap, layer));
}

crease_contribution crease_combine_rest_of_group(crease_march march, crease_receiver receiver, crease_tap tap,
                                                 crease_contribution all, vec4 depths) {
    if (crease_stochastic_layers_count > 1)
        all = crease_combine_layer(march, receiver, tap, all, depths.y);
    if (crease_stochastic_layers_count > 2)
        all = crease_combine_layer(march, receiver, tap, all, depths.z);
    if (crease_stochastic_layers_count > 3)
        all = crease_combine_layer(march, receiver, tap, all, depths.w);
    return all;
}

crease_contribution crease_combine_group(crease_march march, crease_receiver receiver, crease_tap tap,
                                         crease_contribution all, vec4 depths) {
    all = crease_combine_layer(march, receiver, tap, all, depths.x);
    return crease_combine_rest_of_group(march, receiver, tap, all, depths);
}

// Combines groups [first, end); `more` says whether the first may hold layers, and then whether one after the last may.
// The first is weighed without a branch, as neighbouring taps mostly have it too.
crease_contribution crease_combine_groups(crease_march march, crease_receiver receiver, crease_tap tap,
                                          crease_contribution all, crease_layers layers, int first, int end,
                                          inout bool more) {
    crease_unroll for (int group = first; group < end; ++group) {
        vec4 depths = more ? layers.groups[group] : vec4(crease_background);
        if (group == first || more)
            all = crease_combine_group(march, receiver, tap, all, depths);
        more = depths.w < crease_background;
    }
    return all;
}

crease_contribution crease_combine_first_group(crease_march march, crease_receiver receiver, crease_tap tap,
                                               vec4 depths) {
    crease_layer first = crease_layer(crease_view_position(tap.texel, depths.x), 1.0);
    return crease_combine_rest_of_group(march, receiver, tap, crease_weigh(march, receiver, tap, first), depths);
}

crease_contribution crease_combine_layers(crease_march march, crease_receiver receiver, crease_tap tap,
                                          crease_layers layers, bool wanted) {
    vec4 depths = wanted ? layers.groups[0] : vec4(crease_background);
    bool more = depths.w < crease_background;
    crease_contribution all = crease_combine_first_group(march, receiver, tap, depths);
    crease_unroll for (int group = 1; group < crease_group_count(); ++group) {
        depths = more ? layers.groups[group] : vec4(crease_background);
        if (more)
            all = crease_combine_group(march, receiver, tap, all, depths);
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

crease_contribution crease_combine_first_layers(crease_march march, crease_receiver receiver, crease_tap tap,
                                                crease_layers layers) {
    crease_contribution all = crease_combine_first_group(march, receiver, tap, layers.groups[0]);
    bool more = layers.groups[0].w < crease_background;
    all = crease_combine_groups(march, receiver, tap, all, layers, 1, crease_asked(), more);
    if (more) {
        crease_fetch_groups(layers, crease_most_asked, crease_group_count());
        all = crease_combine_groups(march, receiver, tap, all, layers, crease_most_asked, crease_group_count(), more);
    }
    return all;
}
#ifdef __cplusplus
")glsl"
#endif
