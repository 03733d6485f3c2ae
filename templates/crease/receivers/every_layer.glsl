// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_result crease_result_of(crease_receiver receiver);
#else
__LINE__, R"glsl("
#endif

// Of a solid's surface the side that is seen.
crease_result crease_result_of_surface(crease_receiver receiver, float opacity) { return crease_result_of(receiver); }
#ifdef __cplusplus
")glsl"
#endif
