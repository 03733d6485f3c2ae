// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_gathered crease_gather(crease_receiver receiver);
crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver);
#else
__LINE__, R"glsl("
#endif

crease_result crease_result_of(crease_receiver receiver) {
    return crease_conclude(crease_gather(receiver), receiver);
}

// A result in the view space of a further camera, turned back to that of the first; `turn` leads from the first.
crease_result crease_turned_back(crease_result result, mat3 turn) { return result; }
#ifdef __cplusplus
")glsl"
#endif
