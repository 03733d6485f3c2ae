// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
ivec2 crease_pixel();
void crease_keep_in_strips(int place, vec2 texel);
crease_result crease_evaluate(ivec2 pixel);
#else
__LINE__, R"glsl("
#endif

// What a workgroup keeps in shared memory: the texels of its pixels with an apron along their rows, and once more with
// one along their columns.
const int crease_strips_width = int(crease_group_size.x) * crease_divisor; // texels that the pixels stand for
const int crease_strips_height = int(crease_group_size.y) * crease_divisor;
const int crease_strips_row = crease_strips_width + 2 * crease_compute_strips_apron; // texels
const int crease_strips_column = crease_strips_height + 2 * crease_compute_strips_apron;
const int crease_strips_in_rows = crease_strips_row * crease_strips_height;
const int crease_strips_texels = crease_strips_in_rows + crease_strips_column * crease_strips_width;

// The first texel that the pixels of the workgroup stand for.
vec2 crease_strips_first() {
    return vec2(gl_WorkGroupID.xy * crease_group_size.xy) * float(crease_divisor) + crease_view.guard;
}

// The texel that is kept at a place; beside the depth image the nearest one that there is.
vec2 crease_strips_texel(int place) {
    ivec2 at = ivec2(place % crease_strips_row - crease_compute_strips_apron, place / crease_strips_row);
    if (place >= crease_strips_in_rows) {
        place -= crease_strips_in_rows;
        at = ivec2(place % crease_strips_width, place / crease_strips_width - crease_compute_strips_apron);
    }
    return clamp(crease_strips_first() + vec2(at), vec2(0.0), crease_depth_size() - 1.0);
}

// Whether 0 <= at < size. Compares bits: those of negative numbers and NaN exceed any size's.
bool crease_strips_hold(vec2 at, vec2 size) { return all(lessThan(floatBitsToUint(at), floatBitsToUint(size))); }

// Where a texel is kept; negative where it is not, or is of another camera.
int crease_strips_place(vec2 texel) {
    if (crease_view_index != 0)
        return -1;
    vec2 at = texel - crease_strips_first();
    vec2 in_row = at + vec2(crease_compute_strips_apron, 0.0), in_column = at + vec2(0.0, crease_compute_strips_apron);
    if (crease_strips_hold(in_row, vec2(crease_strips_row, crease_strips_height)))
        return int(in_row.y) * crease_strips_row + int(in_row.x);
    if (crease_strips_hold(in_column, vec2(crease_strips_width, crease_strips_column)))
        return crease_strips_in_rows + int(in_column.y) * crease_strips_width + int(in_column.x);
    return -1;
}

// All invocations keep texels and wait, those beside the picture too.
void main() {
    int stride = int(crease_group_size.x * crease_group_size.y);
    for (int place = int(gl_LocalInvocationIndex); place < crease_strips_texels; place += stride)
        crease_keep_in_strips(place, crease_strips_texel(place));
    barrier();
    ivec2 pixel = crease_pixel();
    if (any(greaterThanEqual(pixel, crease_size(crease_divisor))))
        return;
    crease_result result = crease_evaluate(pixel);
    crease_write(pixel, result)
}
#ifdef __cplusplus
")glsl"
#endif
