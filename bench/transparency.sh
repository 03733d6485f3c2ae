#!/bin/sh
# SPDX-License-Identifier: MIT
# Ambient occlusion of a transparent scene, of which a single layer knows nothing, and how the ways to keep layers differ:
# figures 3, 4, 6 and 8 of a-buffer-ssao 2013.
#
#     bench/transparency.sh CREASE DIR SCENE CAMERA [OPTION...]
#
# CREASE is the command, SCENE a scene file or glass, OPTION what `crease reference` and `render` both take, such as
# --width 640. RAYS, GUARD and LAYERS are those of the truth, the guard band and the lists. Leaves the pictures in DIR, and the
# truth for another run, and prints a Markdown table: RMSE to the linear truth and to the layers that are kept whole, and the
# time of all passes in milliseconds.
set -eu
[ $# -ge 4 ] || { sed -n 's/^#     //p' "$0" >&2; exit 2; }
crease=$1 out=$2 scene=$3 camera=$4
shift 4
taps=half_directions:1x8
weighed=cosine_bitmask:1
filtered=interleaved_gradient_noise/plane_filter:2
lists=linked_lists:${LAYERS:-16x16}

[ -f "$out/truth/ao_linear.pfm" ] ||
    "$crease" reference "$scene" --camera "$camera" "$@" --rays "${RAYS:-256}" -o "$out/truth" >/dev/null

# render NAME RECIPE OPTION...: leaves its pictures in DIR/NAME, and prints what it says.
render() {
    name=$1 recipe=$2
    shift 2
    "$crease" render "$scene" --camera "$camera" "$@" --recipe "$recipe" --guard "${GUARD:-64}" -o "$out/$name"
}

# measure WHAT FILE FILE: a line of the comparison, such as rmse.
measure() { "$crease" compare "$2" "$3" | awk -v what="$1" '$1 == what { printf "%.4f", $2 }'; }

echo '| recipe | to the truth | to the whole lists | ms |'
echo '| --- | --- | --- | --- |'
while read -r name layers; do
    recipe=$taps/$layers/$filtered
    took=$(render "$name" "$recipe" "$@" | sed 's/.* in \([0-9.]*\) ms.*/\1/')
    printf "| \`%s\` | %s | %s | %s |\n" "$recipe" "$(measure rmse "$out/$name/ao.pfm" "$out/truth/ao_linear.pfm")" \
        "$(measure rmse "$out/$name/ao.pfm" "$out/whole/ao.pfm")" "$took"
done <<END
whole $lists/$weighed/every_layer
single single_layer/$weighed
first $lists/$weighed
nearest linked_lists:4x16/$weighed/every_layer
compressed $lists/$weighed/every_layer/compressed:4
compressed_half $lists/$weighed/every_layer/compressed:4x1
compressed_eight $lists/$weighed/every_layer/compressed:8
compressed_occluders $lists/$weighed/every_layer/compressed_occluders:4
END
# Without filters, which only one of the two has of its colours.
render integrated "half_directions:4x8/$lists/$weighed/every_layer/composite" "$@" >/dev/null
render separated "half_directions:4x8/$lists/$weighed/every_layer/composite:1" "$@" >/dev/null
printf 'Colours, integrated and separated: RMSE %s\n' \
    "$(measure rmse "$out/separated/color.pfm" "$out/integrated/color.pfm")"
