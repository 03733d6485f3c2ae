#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The loop of every technique in two: the front surface of each tap, and then, of each batch of taps, the layers behind
// the first front surfaces where they may matter. Nothing branches on what is found, so no lane waits for another.

crease_pattern crease_pattern_begin(crease_receiver receiver);
vec2 crease_pattern_turn(inout crease_pattern pattern, crease_receiver receiver, int direction);
int crease_direction_count();
int crease_step_count();
int crease_group_count();
crease_batch crease_ask(inout crease_pattern pattern, crease_receiver receiver, int first, int count);
vec3 crease_view_position(vec2 texel, float depth);
crease_estimate crease_estimate_begin(crease_receiver receiver);
void crease_estimate_turn(inout crease_estimate estimate, vec2 direction);
crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);
void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution);
float crease_estimate_occlusion(crease_estimate estimate);
float crease_front_of(crease_layers layers);
bool crease_look_behind(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 front, bool by_angle);
crease_groups crease_fetch_groups(vec2 texel, int first, int end);
crease_contribution crease_fold_fetched(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                        crease_contribution most, crease_groups groups, int first, int end,
                                        inout bool look);
void crease_estimate_resume(inout crease_estimate estimate, crease_estimate there);
crease_contribution crease_estimate_least(crease_estimate estimate, crease_contribution front);
void crease_estimate_raise(inout crease_estimate estimate, crease_contribution front, crease_contribution most);
crease_gathered crease_gathered_begin();

const int crease_most_batches = 16; // together: those of the most steps of a direction
const int crease_most_looks = crease_most_batches * crease_batch_size;
const int crease_most_groups_kept = 32; // of all looks, where all directions are together

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

crease_looks crease_take_fronts(inout crease_estimate estimate, crease_receiver receiver, crease_batch batch,
                                int count) {
    crease_looks looks;
    crease_unroll for (int i = 0; i < crease_batch_size; ++i)
        looks.of_batch[i].wanted = false;
    crease_unroll for (int i = 0; i < crease_batch_size; ++i)
        if (i < count) {
            crease_tap tap = batch.taps[i];
            vec3 position = crease_view_position(tap.texel, crease_front_of(batch.layers[i]));
            crease_contribution front = crease_weigh(estimate, receiver, tap, position);
            bool behind =
                crease_look_behind(estimate, receiver, tap, position, crease_deferred_layers_angle != 0);
            crease_look_for(looks, crease_look(tap, front, tap.inside && behind));
            crease_estimate_add(estimate, front);
        }
    return looks;
}

void crease_take_behind(inout crease_estimate estimate, crease_receiver receiver, crease_look look,
                        crease_groups groups) {
    crease_contribution least = crease_estimate_least(estimate, look.front);
    bool more = look.wanted;
    crease_contribution most =
        crease_fold_fetched(estimate, receiver, look.tap, least, groups, 0, crease_group_count(), more);
    if (look.wanted)
        crease_estimate_raise(estimate, look.front, most);
}

// Batches are counted through all directions; here each direction of which there are any is whole, unless it has more
// than are kept together.
void crease_gather_batches(inout crease_estimate estimate, inout crease_pattern pattern, crease_receiver receiver,
                           int first, int count) {
    int each = crease_deferred_layers_looks;
    crease_look looks[crease_most_looks];
    crease_groups groups[crease_most_looks];
    crease_estimate estimates[crease_most_batches]; // of the directions, after their fronts
    crease_unroll for (int i = 0; i < count; ++i) {
        int batch = first + i, step = crease_first_of(batch), taps = crease_count_of(batch);
        if (step == 0)
            crease_estimate_turn(estimate, crease_pattern_turn(pattern, receiver, batch / crease_batches()));
        crease_looks found =
            crease_take_fronts(estimate, receiver, crease_ask(pattern, receiver, step, taps), taps);
        crease_unroll for (int j = 0; j < each; ++j)
            looks[i * each + j] = found.of_batch[j];
        estimates[i / crease_batches()] = estimate;
    }
    crease_unroll for (int i = 0; i < count * each; ++i) {
        vec2 texel = looks[i].wanted ? looks[i].tap.texel : crease_first_texel;
        groups[i] = crease_fetch_groups(texel, 0, crease_group_count());
    }
    crease_unroll for (int i = 0; i < count * each; ++i) {
        if (i % (crease_batches() * each) == 0)
            crease_estimate_resume(estimate, estimates[i / (crease_batches() * each)]);
        crease_take_behind(estimate, receiver, looks[i], groups[i]);
    }
}

crease_gathered crease_gather(crease_receiver receiver) {
    crease_pattern pattern = crease_pattern_begin(receiver);
    crease_estimate estimate = crease_estimate_begin(receiver);
    int all = crease_direction_count() * crease_batches();
    if (all <= crease_most_batches &&
        all * crease_deferred_layers_looks * crease_group_count() <= crease_most_groups_kept) {
        crease_gather_batches(estimate, pattern, receiver, 0, all);
    } else {
        int together = min(crease_batches(), crease_most_batches), rest = all % together;
        for (int batch = 0; batch < all - rest; batch += together)
            crease_gather_batches(estimate, pattern, receiver, batch, together);
        if (rest > 0)
            crease_gather_batches(estimate, pattern, receiver, all - rest, rest);
    }
    crease_gathered gathered = crease_gathered_begin();
    gathered.occlusion = crease_estimate_occlusion(estimate);
    return gathered;
}
#ifdef __cplusplus
")glsl"
#endif
