// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_pattern crease_pattern_begin(crease_receiver receiver);
int crease_direction_count();
int crease_step_count();
vec2 crease_pattern_direction(inout crease_pattern pattern, crease_receiver receiver, int direction);
crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step);
crease_fetched crease_fetch(vec2 texel); // of any texel: beside the depth image what does not count
void crease_traverse(inout crease_march march, crease_receiver receiver, crease_tap tap, crease_fetched fetched);
crease_gathered crease_begin_gathering(crease_receiver receiver);
crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction);
void crease_close_direction(inout crease_gathered gathered, crease_march march, crease_receiver receiver, vec2 direction);
mat2 crease_disk_of(crease_receiver receiver);
#else
__LINE__, R"glsl("
#endif

// Unroll fully up to this many layer fetches; otherwise unroll one direction if it fits.
const int crease_most_unrolled = 128;
const int crease_batch_size = 4;

// A source that holds several sizes of texels chooses among them here, and moves the tap to the one it takes.
crease_fetched crease_fetch_tap(crease_pattern pattern, crease_receiver receiver, int step, inout crease_tap tap) {
    return crease_fetch(tap.texel);
}

// Texels between a tap and its neighbours, were all spread evenly over the disk of the radius.
float crease_tap_spacing(crease_pattern pattern, crease_receiver receiver, int step) {
    return sqrt(3.14159265 * abs(determinant(crease_disk_of(receiver))) / float(crease_direction_count() * crease_step_count()));
}

// Fetches a batch of taps before any is weighed, so that their latencies overlap.
void crease_gather_taps(inout crease_march march, inout crease_pattern pattern, crease_receiver receiver, int first) {
    crease_tap taps[crease_batch_size];
    crease_fetched fetched[crease_batch_size];
    int count = crease_step_count() % crease_batch_size == 0 ? crease_batch_size : crease_step_count() - first;
    crease_unroll for (int i = 0; i < crease_batch_size; ++i)
        if (i < count) {
            taps[i] = crease_pattern_tap(pattern, receiver, first + i);
            fetched[i] = crease_fetch_tap(pattern, receiver, first + i, taps[i]);
        }
    crease_unroll for (int i = 0; i < crease_batch_size; ++i)
        if (i < count)
            crease_traverse(march, receiver, taps[i], fetched[i]);
}

void crease_gather_direction(inout crease_gathered gathered, inout crease_pattern pattern, crease_receiver receiver,
                             int i) {
    vec2 direction = crease_pattern_direction(pattern, receiver, i);
    crease_march march = crease_begin_direction(gathered.estimate, receiver, direction);
    if (crease_step_count() * crease_most_layers <= crease_most_unrolled) {
        crease_unroll for (int step = 0; step < crease_step_count(); step += crease_batch_size)
            crease_gather_taps(march, pattern, receiver, step);
    } else {
        for (int step = 0; step < crease_step_count(); step += crease_batch_size)
            crease_gather_taps(march, pattern, receiver, step);
    }
    crease_close_direction(gathered, march, receiver, direction);
}

// Every technique: for each direction and tap of the sampler, each layer of the depth source, weighed by the estimator.
crease_gathered crease_gather(crease_receiver receiver) {
    crease_pattern pattern = crease_pattern_begin(receiver);
    crease_gathered gathered = crease_begin_gathering(receiver);
    if (crease_direction_count() * crease_step_count() * crease_most_layers <= crease_most_unrolled) {
        crease_unroll for (int i = 0; i < crease_direction_count(); ++i)
            crease_gather_direction(gathered, pattern, receiver, i);
    } else {
        for (int i = 0; i < crease_direction_count(); ++i)
            crease_gather_direction(gathered, pattern, receiver, i);
    }
    return gathered;
}
#ifdef __cplusplus
")glsl"
#endif
