#!/bin/sh
# SPDX-License-Identifier: MIT
# Ambient occlusion of a transparent scene, of which a single layer knows nothing, and how the ways to keep layers differ:
# figures 3, 4, 6 and 8 of a-buffer-ssao 2013.
#
#     bench/transparency.sh CREASE DIR SCENE CAMERA [OPTION...]
#
# CREASE is the command, SCENE a scene file or glass, OPTION what `crease reference` and `render` both take, such as
# --width 640. Leaves the pictures in DIR and prints a Markdown table: RMSE to the linear truth and to the layers that are
# kept whole, and the time of all passes in milliseconds.
set -eu
crease=$1 out=$2 scene=$3 camera=$4
shift 4
taps=half_directions:1x8
weighed=cosine_bitmask:1
filtered=interleaved_gradient_noise/plane_filter:2

[ -f "$out/truth/ao_linear.pfm" ] ||
    "$crease" reference "$scene" --camera "$camera" "$@" --rays "${RAYS:-256}" -o "$out/truth" >/dev/null

# difference FILE FILE: the RMSE.
difference() { "$crease" compare "$1" "$2" | awk '/^rmse/ { printf "%.4f", $2 }'; }

# row NAME RECIPE: renders, and prints a line of the table.
row() {
    "$crease" render "$scene" --camera "$camera" "$@" -o "$out/$name" --recipe "$recipe" --guard "${GUARD:-64}" >"$out/said" 2>/dev/null
    printf "| \`%s\` | %s | %s | %s |\n" "$recipe" "$(difference "$out/$name/ao.pfm" "$out/truth/ao_linear.pfm")" \
        "$(difference "$out/$name/ao.pfm" "$out/whole/ao.pfm")" "$(sed 's/.* in \([0-9.]*\) ms.*/\1/' "$out/said")"
}

echo '| recipe | to the truth | to the whole lists | ms |'
echo '| --- | --- | --- | --- |'
lists=linked_lists:${LAYERS:-16x16}
while read -r name layers; do
    recipe=$taps/$(echo "$layers" | sed "s/LISTS/$lists/; s,ESTIMATOR,$weighed,")/$filtered
    row "$@"
done <<END
whole LISTS/ESTIMATOR/every_layer
single single_layer/ESTIMATOR
first LISTS/ESTIMATOR
nearest linked_lists:4x16/ESTIMATOR/every_layer
compressed LISTS/ESTIMATOR/every_layer/compressed:4
compressed_half LISTS/ESTIMATOR/every_layer/compressed:4x1
compressed_eight LISTS/ESTIMATOR/every_layer/compressed:8
compressed_occluders LISTS/ESTIMATOR/every_layer/compressed_occluders:4
END
# Without filters, which only one of the two has of its colours.
for merged in composite composite:1; do
    "$crease" render "$scene" --camera "$camera" "$@" -o "$out/$merged" --guard "${GUARD:-64}" >/dev/null 2>&1 \
        --recipe "half_directions:4x8/$lists/$weighed/every_layer/$merged"
done
printf 'Colours, integrated and separated: RMSE %s\n' "$(difference "$out/composite:1/color.pfm" "$out/composite/color.pfm")"
