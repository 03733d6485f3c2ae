// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_pattern crease_pattern_begin(crease_receiver receiver);
vec2 crease_pattern_direction(inout crease_pattern pattern, crease_receiver receiver, int direction);
int crease_direction_count();
int crease_step_count();
crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step);
crease_fetched crease_fetch(vec2 texel);
crease_gathered crease_begin_gathering(crease_receiver receiver);
crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction);
void crease_close_direction(inout crease_gathered gathered, crease_march march, crease_receiver receiver, vec2 direction);
crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer);
void crease_add(inout crease_march march, crease_contribution contribution);
void crease_add_behind(inout crease_march march, crease_contribution front, crease_contribution behind);
crease_layer crease_front_layer(crease_tap tap, crease_fetched fetched);
bool crease_behind_matters(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer front, float reach, bool by_angle);
crease_layers crease_fetch_layers(vec2 texel);
crease_contribution crease_combine_layers(crease_march march, crease_receiver receiver, crease_tap tap, crease_layers layers, bool wanted);
#else
__LINE__, R"glsl("
#endif

// Gathers in two rounds: all front surfaces first, then for each batch of taps the layers behind the first few fronts that
// may hide some. No branch depends on the picture, so lanes do not diverge.
const int crease_most_batches = 16; // kept together: those of the most steps of a direction
const int crease_most_looks = crease_most_batches * crease_batch_size;
const int crease_most_layers_kept = 128; // of all looks, where all directions are kept together

// Taps that are fetched before any is weighed, so that the waits overlap.
struct crease_batch {
    crease_tap taps[crease_batch_size];
    crease_fetched fetched[crease_batch_size];
};

crease_batch crease_fetch_batch(inout crease_pattern pattern, crease_receiver receiver, int first, int count) {
    crease_batch batch;
    crease_unroll for (int i = 0; i < crease_batch_size; ++i)
        if (i < count) {
            batch.taps[i] = crease_pattern_tap(pattern, receiver, first + i);
            batch.fetched[i] = crease_fetch(batch.taps[i].texel);
        }
    return batch;
}

// A batch of the directions, counted through all of them: where it begins in its direction, and how many taps it has.
int crease_batches() { return (crease_step_count() + crease_batch_size - 1) / crease_batch_size; }
int crease_first_of(int batch) { return batch % crease_batches() * crease_batch_size; }
int crease_count_of(int batch) { return min(crease_batch_size, crease_step_count() - crease_first_of(batch)); }

// A tap behind whose front surface to look.
struct crease_look {
    crease_tap tap;
    crease_contribution front;
    bool wanted;
};

// The first taps of a batch behind which to look.
struct crease_looks {
    crease_look of_batch[crease_batch_size];
};

void crease_look_for(inout crease_looks looks, crease_look look) {
    crease_unroll for (int i = 0; i < crease_deferred_layers_looks; ++i) {
        bool here = look.wanted && !looks.of_batch[i].wanted;
        if (here)
            looks.of_batch[i] = look;
        look.wanted = look.wanted && !here;
    }
}

crease_looks crease_take_fronts(inout crease_march march, crease_receiver receiver, crease_batch batch, int count) {
    crease_looks looks;
    crease_unroll for (int i = 0; i < crease_batch_size; ++i)
        looks.of_batch[i].wanted = false;
    crease_unroll for (int i = 0; i < crease_batch_size; ++i)
        if (i < count) {
            crease_tap tap = batch.taps[i];
            crease_layer layer = crease_front_layer(tap, batch.fetched[i]);
            crease_contribution front = crease_weigh(march, receiver, tap, layer);
            bool matters = crease_behind_matters(march, receiver, tap, layer, crease_deferred_layers_reach,
                                                 crease_deferred_layers_angle != 0);
            crease_look_for(looks, crease_look(tap, front, tap.inside && matters));
            crease_add(march, front);
        }
    return looks;
}

// Batches are counted through all directions; each direction of which there are any is whole.
void crease_gather_batches(inout crease_gathered gathered, inout crease_pattern pattern, crease_receiver receiver,
                           int first, int count) {
    int each = crease_deferred_layers_looks;
    crease_look looks[crease_most_looks];
    crease_layers behind[crease_most_looks];
    crease_march marches[crease_most_batches]; // of the directions
    vec2 directions[crease_most_batches];
    crease_unroll for (int i = 0; i < count; ++i) {
        int batch = first + i, at = i / crease_batches();
        if (crease_first_of(batch) == 0) {
            directions[at] = crease_pattern_direction(pattern, receiver, batch / crease_batches());
            marches[at] = crease_begin_direction(gathered.estimate, receiver, directions[at]);
        }
        int taps = crease_count_of(batch);
        crease_batch fetched = crease_fetch_batch(pattern, receiver, crease_first_of(batch), taps);
        crease_looks found = crease_take_fronts(marches[at], receiver, fetched, taps);
        crease_unroll for (int j = 0; j < each; ++j)
            looks[i * each + j] = found.of_batch[j];
    }
    crease_unroll for (int i = 0; i < count * each; ++i)
        behind[i] = crease_fetch_layers(looks[i].wanted ? looks[i].tap.texel : crease_first_texel);
    crease_unroll for (int i = 0; i < count * each; ++i) {
        int at = i / (crease_batches() * each);
        crease_contribution all =
            crease_combine_layers(marches[at], receiver, looks[i].tap, behind[i], looks[i].wanted);
        if (looks[i].wanted)
            crease_add_behind(marches[at], looks[i].front, all);
    }
    crease_unroll for (int i = 0; i < count; i += crease_batches())
        crease_close_direction(gathered, marches[i / crease_batches()], receiver, directions[i / crease_batches()]);
}

crease_gathered crease_gather(crease_receiver receiver) {
    crease_pattern pattern = crease_pattern_begin(receiver);
    crease_gathered gathered = crease_begin_gathering(receiver);
    int all = crease_direction_count() * crease_batches();
    if (all <= crease_most_batches &&
        all * crease_deferred_layers_looks * ((crease_most_layers + 3) / 4 * 4) <= crease_most_layers_kept) {
        crease_gather_batches(gathered, pattern, receiver, 0, all);
    } else {
        for (int batch = 0; batch < all; batch += crease_batches())
            crease_gather_batches(gathered, pattern, receiver, batch, crease_batches());
    }
    return gathered;
}
#ifdef __cplusplus
")glsl"
#endif
