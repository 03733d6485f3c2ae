#!/bin/sh
# SPDX-License-Identifier: MIT
# What each stage of occlusion over exact layers takes, by depth source, in the form of a-buffer-ssao 2013, tables I and III.
# Usage: bench/layer_stages.sh CREASE SCENE CAMERA SAMPLER ESTIMATOR SOURCE..., e.g. bench/layer_stages.sh crease sponza.glb
# nave directions:4x8 hbao single_layer layer_array:16. Prints a Markdown table of milliseconds at 1280 x 720, medians of 5 runs
# in which the sources take turns. `chrt -r 10` before it keeps other work away.
set -eu
crease=$1 scene=$2 camera=$3 sampler=$4 estimator=$5
shift 5
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
recipes=$(for source in "$@"; do echo "--recipes $sampler/$source/$estimator"; done)

# The clears stand before the first pass and are timed with it: alone where nothing is drawn.
printf 'v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n' >"$scratch/speck.obj"
printf '%s%s\n' '[{"name": "before", "eye": [0, 0, 9], "target": [0, 0, 0], "up": [0, 1, 0], "vfov_deg": 40, ' \
    '"near": 0.1, "far": 20, "width": 1280, "height": 720, "ao_radius": 0.5}]' >"$scratch/speck.cameras.json"

# shellcheck disable=SC2086 # an option for each recipe
for each in "$scratch/speck.obj --cameras before" "$scene --cameras $camera"; do
    echo "scene"
    "$crease" bench $each --width 1280 --height 720 --rays 1 --repeats 5 $recipes
done | awk -v sources="$*" '
    /^scene/ { ++scene }
    / ms +RMSE/ { source = $1; sub(/^[^\/]*\//, "", source); sub(/\/.*/, "", source); next }
    / ms/ {
        time[scene, source, $1] = $2
        if (scene == 1 && ($1 ~ /^count|^capture|^peel/) && !((source) in clear))
            clear[source] = $2
    }
    function put(title, row, i) {
        printf "| %s |", title
        for (i = 1; i <= count; ++i)
            printf (row[i] > 0 ? " %.1f |" : " |"), row[i]
        print ""
    }
    END {
        count = split(sources, name, " ")
        printf "| stage |"
        for (i = 1; i <= count; ++i)
            printf " `%s` |", name[i]
        printf "\n| --- |"
        for (i = 1; i <= count; ++i)
            printf " --- |"
        print ""
        for (i = 1; i <= count; ++i) {
            s = name[i]
            cleared[i] = clear[s]
            counted[i] = time[2, s, "count_fragments"]
            drawn[i] = time[2, s, "capture_layers"]
            for (l = 0; l < 8; ++l)
                drawn[i] += time[2, s, "peel_layer_" l]
            if (counted[i] > 0)
                counted[i] -= cleared[i]
            else if (drawn[i] > 0)
                drawn[i] -= cleared[i]
            sums[i] = time[2, s, "sum_columns"] + time[2, s, "sum_row"]
            resolved[i] = time[2, s, "pack_layers"] + time[2, s, "compress_layers"]
            occlusion[i] = time[2, s, "visibility"]
            total[i] = cleared[i] + counted[i] + drawn[i] + sums[i] + resolved[i] + occlusion[i]
        }
        put("clear", cleared); put("count", counted); put("prefix sum", sums); put("draw", drawn); put("resolve", resolved)
        put("AO", occlusion); put("total", total)
    }'
