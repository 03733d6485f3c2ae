/* SPDX-License-Identifier: MIT */
// What a renderer in C learns of an effect: resources to make, passes to run, the uniform block of a frame.
#include <crease_c.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { width = 1920, height = 1080 };

static void print_resource(const crease_resource* r) {
    static const char* const lifetimes[] = {"input",   "constant", "transient", "handed on",
                                            "history", "report",   "output"};
    if (r->kind == CREASE_RESOURCE_IMAGE)
        printf("image %s, %s, %u x %u\n", r->name, lifetimes[r->lifetime],
               (unsigned)crease_width_of(&r->size, width, 0),
               (unsigned)crease_height_of(&r->size, height, 0));
}

static void print_pass(const crease_effect* effect, const crease_pass* p) {
    printf("pass %s: %u bytes of GLSL\n", p->name, (unsigned)strlen(p->text));
    for (uint32_t i = 0; i < p->binding_count; ++i)
        printf("  set %u, binding %u: %s\n", (unsigned)p->bindings[i]->set, (unsigned)p->bindings[i]->slot,
               effect->resources[p->bindings[i]->resource]->name);
}

/// The uniform block of a frame, to be freed; NULL, with a sentence on stderr, where there is none.
static void* block_of(const crease_effect* effect) {
    const float near_plane = 0.1f, cotangent = 1 / tanf(0.5f), radius = 0.75f;
    const float aspect = (float)width / height;
    // Depth runs from 1 at the near plane to 0 at infinity.
    const float projection[16] = {cotangent / aspect, 0, 0, 0, 0, -cotangent, 0, 0, 0, 0, 0, -1, 0, 0,
                                  near_plane,         0};
    crease_view view;
    char* block = malloc(effect->block_size);
    const char* error = crease_write_defaults(effect, block, effect->block_size);
    if (!error)
        error = crease_set(effect, block, "strength", 1.2f);
    if (!error)
        error = crease_set_projection(&view, projection, width, height, 0, 0);
    if (error) {
        fprintf(stderr, "%s\n", error);
        free(block);
        return NULL;
    }
    memcpy(block, &view, sizeof view);
    memcpy(block + effect->radius_offset, &radius, sizeof radius);
    return block;
}

int main(int argc, char** argv) {
    crease_composition* composition =
        crease_compose(argc > 1 ? argv[1] : "directions:8x4/single_layer/hbao/bilateral");
    const crease_effect* effect = crease_effect_of(composition);
    if (!effect) {
        fprintf(stderr, "%s\n", crease_error(composition));
        crease_destroy(composition);
        return 1;
    }
    printf("%s\n", effect->recipe);
    for (uint32_t i = 0; i < effect->resource_count; ++i)
        print_resource(effect->resources[i]);
    for (uint32_t i = 0; i < effect->pass_count; ++i)
        print_pass(effect, effect->passes[i]);
    void* block = block_of(effect);
    if (block)
        printf("uniform block: %u bytes\n", (unsigned)effect->block_size);
    const int failed = !block || ferror(stdout);
    free(block);
    crease_destroy(composition);
    return failed;
}
