/* SPDX-License-Identifier: MIT */
// A host in C of the installed library.
#include <crease_c.h>

#include <stdio.h>

int main(void) {
    crease_composition* composition = crease_compose("directions:4x4/single_layer/hbao");
    const crease_effect* effect = crease_effect_of(composition);
    const char* error = crease_error(composition);
    puts(effect ? effect->passes[0]->text : error);
    crease_destroy(composition);
    return effect == NULL;
}
