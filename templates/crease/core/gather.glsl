#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The loop of every technique: each tap of the sampler, each layer of the depth source, weighed by the estimator.

crease_pattern crease_pattern_begin(crease_receiver receiver);
int crease_direction_count();
int crease_step_count();
int crease_layer_count();
vec2 crease_pattern_turn(inout crease_pattern pattern, crease_receiver receiver, int direction);
crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step);
crease_estimate crease_estimate_begin(crease_receiver receiver);
void crease_estimate_turn(inout crease_estimate estimate, vec2 direction);
crease_layers crease_fetch_layers(vec2 texel);
crease_contribution crease_fold(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                crease_layers layers);
void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution);
float crease_estimate_occlusion(crease_estimate estimate);
crease_gathered crease_gathered_begin();
void crease_gathered_tap(inout crease_gathered gathered, crease_receiver receiver, crease_tap tap,
                         crease_contribution contribution);
void crease_gathered_turn(inout crease_gathered gathered, crease_receiver receiver, crease_estimate estimate,
                          vec2 direction);

const int crease_batch = 4; // taps whose layers are fetched before any is weighed, so that the waits overlap
// No loop is left where it is short, as a loop costs some drivers dearly: up to so many taps of a direction, and so
// many layers of all taps.
const int crease_written_out = 8, crease_all_written_out = 128;

void crease_take(inout crease_estimate estimate, inout crease_gathered gathered, inout crease_pattern pattern,
                 crease_receiver receiver, int first, int count) {
    crease_tap taps[crease_batch];
    crease_layers layers[crease_batch];
    crease_unroll for (int i = 0; i < count; ++i) {
        taps[i] = crease_pattern_tap(pattern, receiver, first + i);
        layers[i] = crease_fetch_layers(taps[i].inside ? taps[i].texel : receiver.texel);
    }
    crease_unroll for (int i = 0; i < count; ++i) {
        crease_contribution contribution = crease_fold(estimate, receiver, taps[i], layers[i]);
        if (taps[i].inside)
            crease_estimate_add(estimate, contribution);
        crease_gathered_tap(gathered, receiver, taps[i], contribution);
    }
}

bool crease_all_is_short() {
    return crease_direction_count() * crease_step_count() * crease_layer_count() <= crease_all_written_out;
}

void crease_march(inout crease_estimate estimate, inout crease_gathered gathered, inout crease_pattern pattern,
                  crease_receiver receiver, int i) {
    vec2 direction = crease_pattern_turn(pattern, receiver, i);
    crease_estimate_turn(estimate, direction);
    int rest = crease_step_count() % crease_batch, whole = crease_step_count() - rest;
    if (whole <= crease_written_out || crease_all_is_short()) {
        crease_unroll for (int step = 0; step < whole; step += crease_batch)
            crease_take(estimate, gathered, pattern, receiver, step, crease_batch);
    } else {
        for (int step = 0; step < whole; step += crease_batch)
            crease_take(estimate, gathered, pattern, receiver, step, crease_batch);
    }
    crease_take(estimate, gathered, pattern, receiver, whole, rest);
    crease_gathered_turn(gathered, receiver, estimate, direction);
}

crease_gathered crease_gather(crease_receiver receiver) {
    crease_pattern pattern = crease_pattern_begin(receiver);
    crease_estimate estimate = crease_estimate_begin(receiver);
    crease_gathered gathered = crease_gathered_begin();
    if (crease_all_is_short()) {
        crease_unroll for (int i = 0; i < crease_direction_count(); ++i)
            crease_march(estimate, gathered, pattern, receiver, i);
    } else {
        for (int i = 0; i < crease_direction_count(); ++i)
            crease_march(estimate, gathered, pattern, receiver, i);
    }
    gathered.occlusion = crease_estimate_occlusion(estimate);
    return gathered;
}
#ifdef __cplusplus
")glsl"
#endif
