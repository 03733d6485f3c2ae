#!/bin/sh
# SPDX-License-Identifier: MIT
# What composing costs the compiler: seconds to include the header, to compile 64 different programs with it, and one more
# of them.
# Usage: bench/compose.sh [COMPILER]. Each figure is the least of five runs, in user and system time of the compiler.
set -eu
cd "$(dirname "$0")/.."
compiler=${1:-g++}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# programs COUNT: a source that names the text of COUNT distinct programs.
programs() {
    awk -v count="$1" 'BEGIN {
        split("directions<%d, 5>, single_layer, hbao|directions<%d, 5>, single_layer, hbao_plus|" \
              "hemisphere_points<%d>, single_layer, ssao|poisson_disk<%d>, single_layer, hbao_plus", three, "|")
        split("perspective orthographic", projection); split("device_depth linear_depth", depth)
        split("given_normals reconstructed_normals", normals); split("compute<> fragment", stage)
        print "#include <crease/crease.hpp>\nusing namespace crease;"
        for (i = 0; i < count; ++i) {
            n = i
            parts = sprintf(three[1 + n % 4], 4 + int(i / 64)); n = int(n / 4)
            parts = parts ", " projection[1 + n % 2]; n = int(n / 2)
            parts = parts ", " depth[1 + n % 2]; n = int(n / 2)
            parts = parts ", " normals[1 + n % 2]; n = int(n / 2)
            parts = parts ", " stage[1 + n % 2]
            printf "const char* program_%d() { return effect<%s>::source<0>().data(); }\n", i, parts
        }
    }'
}

# seconds SOURCE: least CPU seconds of five compilations.
seconds() {
    for _ in 1 2 3 4 5; do
        bash -c 'TIMEFORMAT="%U %S"; time "$@"' - \
            "$compiler" -std=c++20 -Iinclude -Itemplates -c "$1" -o "$scratch/object.o" 2>&1
    done | awk '{ s = $1 + $2; if (NR == 1 || s < least) least = s } END { print least }'
}

programs 0 >"$scratch/none.cpp"
programs 1 >"$scratch/one.cpp"
programs 64 >"$scratch/all.cpp"
header=$(seconds "$scratch/none.cpp")
one=$(seconds "$scratch/one.cpp")
all=$(seconds "$scratch/all.cpp")
"$compiler" --version | head -n 1
awk -v header="$header" -v one="$one" -v all="$all" 'BEGIN {
    printf "including the header   %.2f s\n", header
    printf "64 different programs  %.2f s, the header included\n", all
    printf "one more program       %.1f ms\n", (all - one) / 63 * 1000
}'
