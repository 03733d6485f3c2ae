#!/bin/sh
# SPDX-License-Identifier: MIT
# What each stage of occlusion over exact layers takes, in the form of a-buffer-ssao 2013, tables I to III.
# Usage: bench/layer_stages.sh CREASE SCENE CAMERA RECIPE..., e.g. bench/layer_stages.sh crease sponza.glb nave
# directions:4x8/single_layer/hbao directions:4x8/layer_array:16/hbao. Prints a Markdown table of milliseconds at 1280 x 720,
# medians of 5 runs in which the recipes take turns. `chrt -r 10` before it keeps other work away.
set -eu
crease=$1 scene=$2 camera=$3
shift 3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
recipes=$(printf ' --recipes %s' "$@")

# The clears stand before the first pass and are timed with it: nearly alone where next to nothing is drawn.
printf 'v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n' >"$scratch/speck.obj"
printf '%s%s\n' '[{"name": "before", "eye": [0, 0, 9], "target": [0, 0, 0], "up": [0, 1, 0], "vfov_deg": 40, ' \
    '"near": 0.1, "far": 20, "width": 1280, "height": 720, "ao_radius": 0.5}]' >"$scratch/speck.cameras.json"

# shellcheck disable=SC2086 # an option for each recipe
for each in "$scratch/speck.obj --cameras before" "$scene --cameras $camera"; do
    echo "scene"
    "$crease" bench $each --width 1280 --height 720 --rays 1 --repeats 5 $recipes
done | awk -v recipes="$*" '
    function is_drawing(pass) { return pass ~ /^(count|capture|peel)_/ }
    function put(title, row, i, any) {
        for (i = 1; i <= count; ++i)
            any = any || row[i] > 0
        if (!any)
            return
        printf "| %s |", title
        for (i = 1; i <= count; ++i)
            printf (row[i] > 0 ? " %.1f |" : " |"), row[i]
        print ""
    }
    /^scene/ { ++scene }
    / ms +RMSE/ { recipe = $1; next }
    / ms/ {
        if (scene == 1 && is_drawing($1) && !(recipe in clear))
            clear[recipe] = $2
        if (scene == 2 && $1 ~ /^count_/)
            counted[recipe] = $2
        else if (scene == 2 && is_drawing($1))
            drawn[recipe] += $2
        else if (scene == 2)
            time[recipe, $1] += $2 # the passes that halve a picture again and again have one name
    }
    END {
        count = split(recipes, name, " ")
        printf "| stage |"
        for (i = 1; i <= count; ++i)
            printf " `%s` |", name[i]
        printf "\n| --- |"
        for (i = 1; i <= count; ++i)
            printf " --- |"
        print ""
        for (i = 1; i <= count; ++i) {
            r = name[i]
            cleared[i] = clear[r]
            counts[i] = counted[r] > 0 ? counted[r] - clear[r] : 0
            draws[i] = counted[r] > 0 ? drawn[r] : drawn[r] - clear[r]
            sums[i] = time[r, "sum_columns"] + time[r, "sum_row"]
            resolved[i] = time[r, "pack_layers"]
            halved[i] = time[r, "halve_picture"] + time[r, "halve_again"]
            occlusion[i] = time[r, "visibility"]
            total[i] = cleared[i] + counts[i] + draws[i] + sums[i] + resolved[i] + halved[i] + occlusion[i]
            for (k = 1; k <= 5; ++k)
                total[i] += time[r, "gather_" k]
        }
        put("clear", cleared); put("count", counts); put("prefix sum", sums); put("draw", draws); put("resolve", resolved)
        put("downsample", halved)
        for (k = 5; k >= 1; --k) {
            for (i = 1; i <= count; ++i)
                gathered[i] = time[name[i], "gather_" k]
            put("AO at 1 / " 2 ^ k, gathered)
        }
        put("AO", occlusion); put("total", total)
    }'
