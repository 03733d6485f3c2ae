// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_estimate crease_estimate_begin(crease_receiver receiver);
void crease_end_direction(inout crease_estimate estimate, crease_march march);
#else
__LINE__, R"glsl("
#endif

// What the directions of a receiver sum up to.
struct crease_gathered {
    crease_estimate estimate;
};

crease_gathered crease_begin_gathering(crease_receiver receiver) {
    return crease_gathered(crease_estimate_begin(receiver));
}

void crease_close_direction(inout crease_gathered gathered, crease_march march, crease_receiver receiver,
                            vec2 direction) {
    crease_end_direction(gathered.estimate, march);
}
#ifdef __cplusplus
")glsl"
#endif
