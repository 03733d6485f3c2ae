// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

bool crease_lies_behind(uint key, uint layer) { return key > layer; }
#ifdef __cplusplus
")glsl"
#endif
