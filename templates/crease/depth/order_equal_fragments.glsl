// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uvec2 crease_fragment_surface(ivec2 texel, uint place);
#else
__LINE__, R"glsl("
#endif

bool crease_is_another(uint key, uint before) { return key != before || key == crease_no_fragment; }

bool crease_surface_goes_first(uvec2 own, uvec2 other) { return own.x < other.x || (own.x == other.x && own.y < other.y); }

// Fragments of one depth and side came in any order. The less opaque goes first, as a decal does, and of one opacity the
// bits of color and normal decide, so that the picture is the same in each frame.
void crease_order_equal_fragments(ivec2 texel, inout crease_fragments sorted) {
    bool in_order = true;
    crease_unroll for (int i = 1; i < crease_most_surfaces; ++i)
        in_order = in_order && crease_is_another(sorted.keys[i], sorted.keys[i - 1]);
    while (!in_order) {
        in_order = true;
        crease_unroll for (int i = 1; i < crease_most_surfaces; ++i)
            if (!crease_is_another(sorted.keys[i], sorted.keys[i - 1]) &&
                crease_surface_goes_first(crease_fragment_surface(texel, sorted.places[i]),
                                          crease_fragment_surface(texel, sorted.places[i - 1]))) {
                uint place = sorted.places[i];
                sorted.places[i] = sorted.places[i - 1];
                sorted.places[i - 1] = place;
                in_order = false;
            }
    }
}
#ifdef __cplusplus
")glsl"
#endif
