#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Taps of a direction that are asked for together.

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step);
crease_layers crease_fetch_layers(vec2 texel); // of any texel: beside the depth image what does not count

const int crease_batch_size = 4;

// Taps whose layers are fetched before any is weighed, so that the waits overlap.
struct crease_batch {
    crease_tap taps[crease_batch_size];
    crease_layers layers[crease_batch_size];
};

crease_batch crease_ask(inout crease_pattern pattern, crease_receiver receiver, int first, int count) {
    crease_batch batch;
    crease_unroll for (int i = 0; i < crease_batch_size; ++i)
        if (i < count) {
            batch.taps[i] = crease_pattern_tap(pattern, receiver, first + i);
            batch.layers[i] = crease_fetch_layers(batch.taps[i].texel);
        }
    return batch;
}
#ifdef __cplusplus
")glsl"
#endif
