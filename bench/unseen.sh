#!/bin/sh
# SPDX-License-Identifier: MIT
# The presets on scenes that no search has seen: the built-in one, thin rails and foliage of cards, beside HBAO.
# Usage: bench/unseen.sh CREASE [DIR]; CREASE is the command, DIR keeps the scenes and the truths.
set -eu
crease=$1
if [ $# -gt 1 ]; then
    scratch=$2
    mkdir -p "$scratch"
else
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
fi

# A floor and a wall; before it rows of upright and lying rails, a hundredth to a thirtieth of the radius thick.
rails() {
    awk '
        function corner(x, y, z) { printf "v %f %f %f\n", x, y, z; ++n }
        function bar(x0, y0, z0, x1, y1, z1,   i) {
            for (i = 0; i < 8; ++i)
                corner(i % 2 ? x1 : x0, int(i / 2) % 2 ? y1 : y0, i > 3 ? z1 : z0)
            split("1 3 4 2 5 6 8 7 1 2 6 5 3 7 8 4 1 5 7 3 2 4 8 6", f)
            for (i = 1; i < 24; i += 4)
                print "f", n - 8 + f[i], n - 8 + f[i + 1], n - 8 + f[i + 2], n - 8 + f[i + 3]
        }
        BEGIN {
            bar(-8, -0.1, -8, 8, 0, 8)
            bar(-8, 0, -2.2, 8, 5, -2)
            for (r = 0; r < 3; ++r) {
                t = 0.01 + 0.012 * r
                z = -1.7 + 0.9 * r
                for (x = -4; x <= 4; x += 0.22 + 0.06 * r)
                    bar(x, 0, z, x + t, 1, z + t)
                for (y = 0.25; y <= 1; y += 0.375)
                    bar(-4, y, z, 4.1, y + t, z + t)
            }
        }' >"$scratch/rails.obj"
    cameras rails '0.5, 1.4, 3.4' '0, 0.5, -1' '2.6, 0.7, 1.9' '-1, 0.5, -1'
}

# A floor, a trunk and 3000 leaves, cards that lie at random in a ball.
foliage() {
    awk '
        function corner(x, y, z) { printf "v %f %f %f\n", x, y, z; ++n }
        BEGIN {
            srand(7)
            corner(-8, 0, -8); corner(-8, 0, 8); corner(8, 0, 8); corner(8, 0, -8)
            print "f 1 2 3 4"
            for (i = 0; i < 12; ++i) {
                corner(0.15 * cos(i * 0.5236), 0, 0.15 * sin(i * 0.5236))
                corner(0.1 * cos(i * 0.5236), 1.6, 0.1 * sin(i * 0.5236))
            }
            for (i = 0; i < 12; ++i)
                print "f", 5 + 2 * i, 6 + 2 * i, 6 + 2 * ((i + 1) % 12), 5 + 2 * ((i + 1) % 12)
            while (leaves < 3000) {
                x = 2 * rand() - 1; y = 2 * rand() - 1; z = 2 * rand() - 1
                if (x * x + y * y + z * z > 1)
                    continue
                ++leaves
                for (c = 0; c < 3; ++c) { a[c] = 0.12 * (rand() - 0.5); b[c] = 0.12 * (rand() - 0.5) }
                corner(x - a[0] - b[0], 1.8 + y - a[1] - b[1], z - a[2] - b[2])
                corner(x + a[0] - b[0], 1.8 + y + a[1] - b[1], z + a[2] - b[2])
                corner(x + a[0] + b[0], 1.8 + y + a[1] + b[1], z + a[2] + b[2])
                corner(x - a[0] + b[0], 1.8 + y - a[1] + b[1], z - a[2] + b[2])
                print "f", n - 3, n - 2, n - 1, n
            }
        }' >"$scratch/foliage.obj"
    cameras foliage '0, 1.8, 3.6' '0, 1.5, 0' '1.6, 2.2, 1.6' '0, 1.6, 0'
}

# cameras SCENE EYE TARGET EYE TARGET
cameras() {
    printf '[%s,\n%s]\n' "$(camera far "$2" "$3")" "$(camera near "$4" "$5")" >"$scratch/$1.cameras.json"
}

camera() {
    printf '{"name": "%s", "eye": [%s], "target": [%s], "up": [0, 1, 0], "vfov_deg": 45, "near": 0.1, "far": 40, ' \
        "$1" "$2" "$3"
    printf '"width": 640, "height": 360, "ao_radius": 0.6}'
}

rails
foliage
for scene in built-in "$scratch/rails.obj" "$scratch/foliage.obj"; do
    # To the hard truth with the estimator that aims at it.
    "$crease" bench "$scene" --width 640 --height 360 --rays 256 --repeats 1 --truths "$scratch/truths" \
        --recipes preset:low --recipes preset:medium --recipes preset:high --recipes preset:ultra \
        --recipes preset:low/cosine_bitmask --recipes preset:medium/cosine_bitmask \
        --recipes preset:high/cosine_bitmask --recipes preset:ultra/cosine_bitmask \
        --recipes directions:8x4/single_layer/hbao/bilateral | grep -v '^  '
done
