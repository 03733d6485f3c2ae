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
crease_batch crease_ask(inout crease_pattern pattern, crease_receiver receiver, int first, int count);
crease_estimate crease_estimate_begin(crease_receiver receiver);
void crease_estimate_turn(inout crease_estimate estimate, vec2 direction);
crease_contribution crease_fold(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                crease_layers layers);
void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution);
float crease_estimate_occlusion(crease_estimate estimate);
crease_gathered crease_gathered_begin();
void crease_gathered_tap(inout crease_gathered gathered, crease_receiver receiver, crease_tap tap,
                         crease_contribution contribution);
void crease_gathered_turn(inout crease_gathered gathered, crease_receiver receiver, crease_estimate estimate,
                          vec2 direction);
void crease_gathered_end(inout crease_gathered gathered, crease_receiver receiver);

// No loop is left where it is short, as a loop costs some drivers dearly: of all directions or else of one, up to so many
// layers of the taps.
const int crease_written_out = 128;

int crease_layers_of_direction() { return crease_step_count() * crease_layer_count(); }

void crease_gather_batch(inout crease_estimate estimate, inout crease_gathered gathered, inout crease_pattern pattern,
                         crease_receiver receiver, int first, int count) {
    crease_batch batch = crease_ask(pattern, receiver, first, count);
    crease_unroll for (int i = 0; i < crease_batch_size; ++i)
        if (i < count) {
            crease_contribution contribution = crease_fold(estimate, receiver, batch.taps[i], batch.layers[i]);
            crease_estimate_add(estimate, contribution);
            crease_gathered_tap(gathered, receiver, batch.taps[i], contribution);
        }
}

void crease_gather_direction(inout crease_estimate estimate, inout crease_gathered gathered,
                             inout crease_pattern pattern, crease_receiver receiver, int i) {
    vec2 direction = crease_pattern_turn(pattern, receiver, i);
    crease_estimate_turn(estimate, direction);
    int rest = crease_step_count() % crease_batch_size, whole = crease_step_count() - rest;
    if (crease_layers_of_direction() <= crease_written_out) {
        crease_unroll for (int step = 0; step < whole; step += crease_batch_size)
            crease_gather_batch(estimate, gathered, pattern, receiver, step, crease_batch_size);
    } else {
        for (int step = 0; step < whole; step += crease_batch_size)
            crease_gather_batch(estimate, gathered, pattern, receiver, step, crease_batch_size);
    }
    if (rest > 0)
        crease_gather_batch(estimate, gathered, pattern, receiver, whole, rest);
    crease_gathered_turn(gathered, receiver, estimate, direction);
}

crease_gathered crease_gather(crease_receiver receiver) {
    crease_pattern pattern = crease_pattern_begin(receiver);
    crease_estimate estimate = crease_estimate_begin(receiver);
    crease_gathered gathered = crease_gathered_begin();
    if (crease_direction_count() * crease_layers_of_direction() <= crease_written_out) {
        crease_unroll for (int i = 0; i < crease_direction_count(); ++i)
            crease_gather_direction(estimate, gathered, pattern, receiver, i);
    } else {
        for (int i = 0; i < crease_direction_count(); ++i)
            crease_gather_direction(estimate, gathered, pattern, receiver, i);
    }
    gathered.occlusion = crease_estimate_occlusion(estimate);
    crease_gathered_end(gathered, receiver);
    return gathered;
}
#ifdef __cplusplus
")glsl"
#endif
