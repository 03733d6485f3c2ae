// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
int crease_resolution();
float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
crease_layer crease_layer_of(vec3 position);
#else
__LINE__, R"glsl("
#endif

// One layer, of the texel of the resolution in which a pass gathers.
struct crease_layers {
    vec3 position;
};

const int crease_most_layers = 1;

bool crease_multi_resolution_own = false; // whether the tap that is fetched is left out

void crease_multi_resolution_leave_out(bool own) { crease_multi_resolution_own = own; }

crease_layers crease_fetch_layers(vec2 texel) {
    if (crease_multi_resolution_own)
        return crease_layers(crease_view_position(texel, crease_background));
    if (crease_resolution() == 0)
        return crease_layers(crease_view_position(texel, crease_depth_at(texel)));
    ivec2 last = crease_size_of_resolutions(crease_resolution()) - 1;
    ivec2 at = clamp(ivec2(texel) >> crease_resolution(), ivec2(0), last);
    return crease_layers(uintBitsToFloat(crease_load_resolutions(at, crease_resolution()).xyz));
}

int crease_layer_count(crease_layers layers) { return 1; }

crease_layer crease_layer_at(crease_layers layers, int i) { return crease_layer_of(layers.position); }
#ifdef __cplusplus
")glsl"
#endif
