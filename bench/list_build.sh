#!/bin/sh
# SPDX-License-Identifier: MIT
# What building the lists of an A-buffer costs a fragment, from one that covers the picture to 10 million: a-buffer-ssao
# 2013, IV.A and B. Usage: bench/list_build.sh CREASE; CREASE is the command. Prints a Markdown table; the times are medians,
# drawing and clears included. `chrt -r 10` before it keeps other work away.
set -eu
crease=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
width=640 height=360

# scene LAYERS: so many squares one behind another, each of which fills the picture.
scene() {
    awk -v layers="$1" 'BEGIN {
        for (i = 0; i < layers; ++i) {
            z = -0.01 * i
            printf "v -9 -9 %f\nv 9 -9 %f\nv 9 9 %f\nv -9 9 %f\n", z, z, z, z
            printf "f %d %d %d\nf %d %d %d\n", 4 * i + 1, 4 * i + 2, 4 * i + 3, 4 * i + 1, 4 * i + 3, 4 * i + 4
        }
    }' >"$scratch/squares.obj"
    printf '%s%s\n' '[{"name": "before", "eye": [0, 0, 3], "target": [0, 0, 0], "up": [0, 1, 0], "vfov_deg": 40, ' \
        '"near": 0.1, "far": 20, "width": 640, "height": 360, "ao_radius": 0.5}]' >"$scratch/squares.cameras.json"
}

echo '| fragments | `linked_lists`: store | pack | ns a fragment | `linear_lists`: count | prefix sums | store | pack | ns a fragment |'
echo '| --- | --- | --- | --- | --- | --- | --- | --- | --- |'
for layers in 1 2 4 8 16 32 44; do
    scene "$layers"
    "$crease" bench "$scratch/squares.obj" --width "$width" --height "$height" --rays 1 --repeats 5 \
        --recipes directions:1x1/linked_lists:8x64/hbao --recipes directions:1x1/linear_lists:8x64/hbao |
        awk -v fragments="$((layers * width * height))" '
            /^directions/ { list = $1 ~ /linked/ ? "linked" : "linear" }
            / ms/ { time[list, $1] = $2 }
            END {
                store = time["linked", "capture_layers"]
                count = time["linear", "count_fragments"]
                sums = time["linear", "sum_columns"] + time["linear", "sum_row"]
                again = time["linear", "capture_layers"]
                printf "| %.2f million | %.1f | %.1f | %.0f |", fragments / 1e6, store, time["linked", "pack_layers"], \
                    1e6 * store / fragments
                printf " %.1f | %.1f | %.1f | %.1f | %.0f |\n", count, sums, again, time["linear", "pack_layers"], \
                    1e6 * (count + sums + again) / fragments
            }'
done
