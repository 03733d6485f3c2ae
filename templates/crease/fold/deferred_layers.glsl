#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The loop of every technique in two: the front surface of each tap, and then the layers behind those where they may
// matter, tap after tap. Lanes that run together go through the second loop as often as the one of them with the most
// such taps; where each tap is done at once, all lanes wait at a tap for which any of them looks behind the front.

crease_pattern crease_pattern_begin(crease_receiver receiver);
int crease_direction_count();
int crease_step_count();
vec2 crease_pattern_turn(inout crease_pattern pattern, crease_receiver receiver, int direction);
crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step);
vec3 crease_view_position(vec2 texel, float depth);
crease_estimate crease_estimate_begin(crease_receiver receiver);
void crease_estimate_turn(inout crease_estimate estimate, vec2 direction);
crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);
void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution);
float crease_estimate_occlusion(crease_estimate estimate);
crease_layers crease_fetch_layers(vec2 texel);
float crease_front_of(crease_layers layers);
bool crease_look_behind(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 front, bool by_angle);
crease_contribution crease_fold_groups(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                       crease_contribution most, int first, bool look);
void crease_estimate_resume(inout crease_estimate estimate, crease_estimate there);
crease_contribution crease_front_again(crease_estimate estimate, crease_receiver receiver, crease_tap tap);
void crease_estimate_raise(inout crease_estimate estimate, crease_contribution front, crease_contribution most);
crease_gathered crease_gathered_begin();

const int crease_batch = 4; // taps whose fronts are fetched before any is weighed, so that the waits overlap
const int crease_most_kept = 8; // directions whose state is kept until the second loop
const int crease_most_wanted = 32; // taps, a bit each

// The fronts of `count` taps of a direction, and as bits those behind which to look.
uint crease_take_fronts(inout crease_estimate estimate, inout crease_pattern pattern, crease_receiver receiver,
                        int first, int count) {
    crease_tap taps[crease_batch];
    crease_layers layers[crease_batch];
    crease_unroll for (int i = 0; i < count; ++i) {
        taps[i] = crease_pattern_tap(pattern, receiver, first + i);
        layers[i] = crease_fetch_layers(taps[i].inside ? taps[i].texel : receiver.texel);
    }
    uint wanted = 0u;
    crease_unroll for (int i = 0; i < count; ++i) {
        vec3 front = crease_view_position(taps[i].texel, crease_front_of(layers[i]));
        crease_contribution contribution = crease_weigh(estimate, receiver, taps[i], front);
        bool look = taps[i].inside &&
            crease_look_behind(estimate, receiver, taps[i], front, crease_deferred_layers_angle != 0);
        wanted |= look ? 1u << uint(i) : 0u;
        if (taps[i].inside)
            crease_estimate_add(estimate, contribution);
    }
    return wanted;
}

// The same of up to 32 taps.
uint crease_march_fronts(inout crease_estimate estimate, inout crease_pattern pattern, crease_receiver receiver,
                         int first, int count) {
    int rest = count % crease_batch, whole = count - rest;
    uint wanted = 0u;
    crease_unroll for (int step = 0; step < whole; step += crease_batch)
        wanted |= crease_take_fronts(estimate, pattern, receiver, first + step, crease_batch) << uint(step);
    return wanted | crease_take_fronts(estimate, pattern, receiver, first + whole, rest) << uint(whole);
}

void crease_take_behind(inout crease_estimate estimate, inout crease_pattern pattern, crease_receiver receiver,
                        int step) {
    crease_tap tap = crease_pattern_tap(pattern, receiver, step);
    crease_contribution front = crease_front_again(estimate, receiver, tap);
    crease_estimate_raise(estimate, front, crease_fold_groups(estimate, receiver, tap, front, 0, true));
}

// One second loop for all directions.
void crease_gather_kept(inout crease_estimate estimate, inout crease_pattern pattern, crease_receiver receiver) {
    crease_pattern patterns[crease_most_kept];
    crease_estimate estimates[crease_most_kept];
    uint wanted = 0u;
    crease_unroll for (int i = 0; i < crease_direction_count(); ++i) {
        crease_estimate_turn(estimate, crease_pattern_turn(pattern, receiver, i));
        wanted |= crease_march_fronts(estimate, pattern, receiver, 0, crease_step_count())
            << uint(i * crease_step_count());
        patterns[i] = pattern;
        estimates[i] = estimate;
    }
    while (wanted != 0u) {
        int next = findLSB(wanted);
        wanted &= wanted - 1u;
        int direction = next / crease_step_count();
        crease_estimate there = estimates[0];
        pattern = patterns[0];
        crease_unroll for (int i = 1; i < crease_direction_count(); ++i)
            if (i == direction) {
                there = estimates[i];
                pattern = patterns[i];
            }
        crease_estimate_resume(estimate, there);
        crease_take_behind(estimate, pattern, receiver, next - direction * crease_step_count());
        crease_unroll for (int i = 0; i < crease_direction_count(); ++i)
            if (i == direction)
                estimates[i] = estimate;
    }
}

// A second loop for up to 32 taps of a direction.
void crease_gather_steps(inout crease_estimate estimate, inout crease_pattern pattern, crease_receiver receiver,
                         int first, int count) {
    uint wanted = crease_march_fronts(estimate, pattern, receiver, first, count);
    while (wanted != 0u) {
        crease_take_behind(estimate, pattern, receiver, first + findLSB(wanted));
        wanted &= wanted - 1u;
    }
}

void crease_gather_direction(inout crease_estimate estimate, inout crease_pattern pattern, crease_receiver receiver,
                             int i) {
    crease_estimate_turn(estimate, crease_pattern_turn(pattern, receiver, i));
    int rest = crease_step_count() % crease_most_wanted, whole = crease_step_count() - rest;
    for (int first = 0; first < whole; first += crease_most_wanted)
        crease_gather_steps(estimate, pattern, receiver, first, crease_most_wanted);
    crease_gather_steps(estimate, pattern, receiver, whole, rest);
}

crease_gathered crease_gather(crease_receiver receiver) {
    crease_pattern pattern = crease_pattern_begin(receiver);
    crease_estimate estimate = crease_estimate_begin(receiver);
    if (crease_direction_count() <= crease_most_kept &&
        crease_direction_count() * crease_step_count() <= crease_most_wanted) {
        crease_gather_kept(estimate, pattern, receiver);
    } else {
        for (int i = 0; i < crease_direction_count(); ++i)
            crease_gather_direction(estimate, pattern, receiver, i);
    }
    crease_gathered gathered = crease_gathered_begin();
    gathered.occlusion = crease_estimate_occlusion(estimate);
    return gathered;
}
#ifdef __cplusplus
")glsl"
#endif
