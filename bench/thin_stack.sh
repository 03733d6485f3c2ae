#!/bin/sh
# SPDX-License-Identifier: MIT
# How much of the occlusion that a stack of thin walls hides comes back, by the number of walls, the samples and the
# opacity: stochastic-depth-ao 9.4. Usage: bench/thin_stack.sh CREASE [DIR]; CREASE is the command, DIR keeps the scenes.
# Prints a Markdown table: of the pixels that hidden geometry darkens, the share of what a single layer lacks in the mean.
set -eu
crease=$1
if [ $# -gt 1 ]; then
    scratch=$2
    mkdir -p "$scratch"
else
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
fi

# scene LAYERS: a floor; a slanted curtain on it; before that the stack, a tenth of a millimetre from wall to wall.
scene() {
    awk -v layers="$1" '
        function quad(x0, z0, x1, z1, height) {
            printf "v %f 0 %f\nv %f 0 %f\nv %f %f %f\nv %f %f %f\n", x0, z0, x1, z1, x1, height, z1, x0, height, z0
            printf "f %d %d %d\nf %d %d %d\n", n + 1, n + 2, n + 3, n + 1, n + 3, n + 4
            n += 4
        }
        BEGIN {
            print "v -4 0 3\nv 4 0 3\nv 4 0 -4\nv -4 0 -4\nf 1 2 3\nf 1 3 4"
            n = 4
            quad(-1.0, -0.6, -0.03, 0.5, 1.2)
            for (i = 0; i < layers; ++i)
                quad(-1.6, 1.0 - 0.0001 * i, 0, 1.0 - 0.0001 * i, 1.6)
        }' >"$scratch/stack_$1.obj"
    printf '%s%s\n' '[{"name": "beside", "eye": [0, 1.2, 3], "target": [0, 0.2, 0], "up": [0, 1, 0], "vfov_deg": 40, ' \
        '"near": 0.1, "far": 20, "width": 640, "height": 360, "ao_radius": 0.6}]' >"$scratch/stack_$1.cameras.json"
}

recipes=$(for samples in 1 2 4 8 16 32; do
    for opacity in 0.2 0.05 0.01; do
        echo "--recipes directions:8x8/stochastic_layers:$samples/hbao/bilateral@opacity=$opacity"
    done
done)
echo '| walls | opacity | 1 sample | 2 | 4 | 8 | 16 | 32 |'
echo '| --- | --- | --- | --- | --- | --- | --- | --- |'
for layers in 1 2 4 8 16 32; do
    scene "$layers"
    # shellcheck disable=SC2086 # an option for each recipe
    "$crease" bench "$scratch/stack_$layers.obj" --hidden --width 640 --height 360 --rays 256 --repeats 1 \
        --truths "$scratch/truths" --recipes directions:8x8/single_layer/hbao/bilateral $recipes |
        awk -v walls="$layers" '
            /^directions/ { recipe = $1 }
            /bias_hidden/ { lacks[recipe] = $NF }
            END {
                split("0.2 0.05 0.01", opacities)
                split("1 2 4 8 16 32", samples)
                for (o = 1; o <= 3; ++o) {
                    printf "| %d | %s |", walls, opacities[o]
                    for (s = 1; s <= 6; ++s)
                        printf " %.0f %% |", 100 * (1 - lacks["directions:8x8/stochastic_layers:" samples[s] \
                            "/hbao/bilateral@opacity=" opacities[o]] / lacks["directions:8x8/single_layer/hbao/bilateral"])
                    print ""
                }
            }'
done
