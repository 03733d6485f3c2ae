// SPDX-License-Identifier: MIT
#include "same_effect.hpp"

#include <doctest/doctest.h>

#include <set>

namespace {

using namespace crease;
using compared::check_equal_to;

}

TEST_CASE("each preset is the same effect at compile time and by name") {
    check_equal_to<effect<preset::low>>("preset:low");
    check_equal_to<effect<preset::medium>>("preset:medium");
    check_equal_to<effect<preset::medium, bent_cone>>("preset:medium/bent_cone");
    check_equal_to<effect<preset::high, fragment>>("preset:high/fragment");
    check_equal_to<effect<preset::ultra, reconstructed_normals>>("preset:ultra/reconstructed_normals");
    check_equal_to<effect<preset::ultra_layers>>("preset:ultra_layers");
}

TEST_CASE("presets have names and summaries of their own") {
    std::set<std::string_view> names, summaries;
    for (const preset_description* p : all_presets) {
        CAPTURE(std::string(p->name));
        CHECK(names.insert(p->name).second);
        CHECK(summaries.insert(p->summary).second);
        CHECK(recipe(p->parts));
    }
}

TEST_CASE("with each output, projection and stage a preset makes an effect") {
    for (const preset_description* p : all_presets)
        for (const char* more : {"", "/bent_cone", "/orthographic", "/fragment", "/opengl",
                                 "/linearised_depth/reconstructed_normals", "/cosine_bitmask"}) {
            const std::string text = "preset:" + std::string(p->name) + more;
            CAPTURE(text);
            CHECK(recipe(std::string_view(text)));
        }
}
