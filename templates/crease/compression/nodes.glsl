// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
int crease_group_count();
float crease_fragment_depth(uint key);
uvec2 crease_fragment_surface(ivec2 texel, uint place);
#else
__LINE__, R"glsl("
#endif

// The layers of a texel that matter most, nearest first: a-buffer-ssao 2013, III.B. A texel of four has their depths in radii
// as halves, which of back faces are negative, their opacities in a byte each, and for receivers that read them their
// normals in 24 bits each.
struct crease_nodes {
    float depths[8];
    uvec2 surfaces[8]; // color and normal, packed
    float weights[8];
    int count;
};

// One more of them, which lies behind all. Of too many goes the one whose opacity times (1 - z) is the least: equation (5),
// where z is the depth of a depth buffer without a far plane, so that 1 - z is 1 / depth but for a factor.
void crease_add_node(inout crease_nodes nodes, float depth, uvec2 surface) {
    float weight = float(surface.x >> 24u) / abs(depth), least_weight = weight;
    int least = crease_most_layers; // the new one
    if (nodes.count == crease_most_layers) {
        crease_unroll for (int i = crease_most_layers - 1; i >= crease_first_to_go; --i)
            if (nodes.weights[i] <= least_weight) {
                least = i;
                least_weight = nodes.weights[i];
            }
        crease_unroll for (int i = 0; i + 1 < crease_most_layers; ++i)
            if (i >= least) {
                nodes.depths[i] = nodes.depths[i + 1];
                nodes.surfaces[i] = nodes.surfaces[i + 1];
                nodes.weights[i] = nodes.weights[i + 1];
            }
        nodes.count -= least < crease_most_layers ? 1 : 0;
    }
    crease_unroll for (int i = 0; i < crease_most_layers; ++i)
        if (i == nodes.count) {
            nodes.depths[i] = depth;
            nodes.surfaces[i] = surface;
            nodes.weights[i] = weight;
        }
    nodes.count = min(nodes.count + 1, crease_most_layers);
}

crease_nodes crease_begin_nodes() {
    crease_nodes nodes;
    crease_unroll for (int i = 0; i < 8; ++i) {
        nodes.depths[i] = crease_background;
        nodes.surfaces[i] = uvec2(0xff000000u, 0u);
    }
    nodes.count = 0;
    return nodes;
}

crease_nodes crease_compress(ivec2 texel, crease_fragments sorted) {
    crease_nodes nodes = crease_begin_nodes();
    crease_unroll for (int i = 0; i < crease_most_surfaces; ++i) {
        float depth = crease_fragment_depth(sorted.keys[i]);
        if (depth < crease_background)
            crease_add_node(nodes, depth, crease_fragment_surface(texel, sorted.places[i]));
    }
    return nodes;
}

// What taps read of them.
void crease_store_nodes(ivec2 texel, crease_nodes nodes) {
    float radii = 1.0 / max(crease_radius, 1e-20);
    crease_unroll for (int i = 0; i < 4 * crease_group_count(); i += 4) {
        uvec4 opacities = uvec4(nodes.surfaces[i].x, nodes.surfaces[i + 1].x, nodes.surfaces[i + 2].x,
                                nodes.surfaces[i + 3].x) >> 24u;
        uvec4 words = uvec4(packHalf2x16(vec2(nodes.depths[i], nodes.depths[i + 1]) * radii),
                            packHalf2x16(vec2(nodes.depths[i + 2], nodes.depths[i + 3]) * radii),
                            opacities.x | opacities.y << 8u | opacities.z << 16u | opacities.w << 24u,
                            nodes.surfaces[i].y | nodes.surfaces[i + 1].y << 24u);
        imageStore(crease_compressed_layers, ivec3(texel, i / 4), words);
    }
}

// In place of all layers.
crease_group crease_load_group(vec2 texel, int group) {
    uvec4 words = crease_load_compressed_layers(ivec3(texel, group));
    vec4 radii = vec4(unpackHalf2x16(words.x), unpackHalf2x16(words.y));
    const float most = 65504.0; // of a half; what is farther is infinite
    return crease_group(mix(vec4(crease_background), radii * crease_radius, lessThanEqual(abs(radii), vec4(most))),
                        words.z);
}
#ifdef __cplusplus
")glsl"
#endif
