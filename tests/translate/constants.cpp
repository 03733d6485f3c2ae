// SPDX-License-Identifier: MIT
// Specialization constants as each language has them.
#include <crease/translate/constants.hpp>

#include "spirv/little_effect.hpp"
#include "spirv/sentence.hpp"

#include <crease/translate.hpp>

#include <doctest/doctest.h>

namespace {

using namespace crease;
using translate::language;
using translate::target;

translate::translation scale(const target& to) {
    translate::translation made = translate::shader(little::effect, little::scale, to);
    translate::check(made);
    return made;
}

}

TEST_CASE("HLSL and GLSL have macros that a host may define") {
    for (const target& to :
         {target{.to = language::hlsl, .version = 50}, target{.to = language::glsl, .version = 430},
          target{.to = language::glsl_es, .version = 310}}) {
        const translate::translation made = scale(to);
        CAPTURE(made.text);
        CHECK(contains(made.text, "#ifndef CREASE_SCALE_GAIN\n#define CREASE_SCALE_GAIN 2\n#endif\n"));
        CHECK(contains(made.text, "crease_scale_gain = CREASE_SCALE_GAIN;"));
        CHECK_FALSE(contains(made.text, "SPIRV_CROSS_CONSTANT_ID"));
        REQUIRE(made.constants.size() == 3);
        CHECK(made.constants[2].part == "scale");
        CHECK(made.constants[2].number == "gain");
        CHECK(made.constants[2].macro == "CREASE_SCALE_GAIN");
        CHECK(made.constants[2].value == 2);
        translate::translation defined = made;
        const std::size_t line = made.text.starts_with("#version") ? made.text.find('\n') + 1 : 0;
        defined.text.insert(line, "#define CREASE_SCALE_GAIN 3\n#define CREASE_COMPUTE_WIDTH 4u\n");
        CHECK_NOTHROW(translate::check(defined));
    }
    CHECK(contains(scale({.to = language::hlsl, .version = 50}).text,
                   "[numthreads(CREASE_COMPUTE_WIDTH, CREASE_COMPUTE_HEIGHT, 1)]"));
}

TEST_CASE("MSL has function constants of the same index") {
    const translate::translation made = scale({.to = language::msl, .version = 21});
    CHECK(contains(made.text, "[[function_constant(2)]]"));
    CHECK(contains(made.text, " : 2;\n"));
    REQUIRE(made.constants.size() == 3);
    CHECK(made.constants[2].id == 2);
    CHECK(made.constants[2].macro.empty());
}

TEST_CASE("a host gives other defaults, or literals") {
    for (const target& language :
         {target{.to = language::hlsl, .version = 50}, target{.to = language::msl, .version = 21},
          target{.to = language::glsl_es, .version = 310}}) {
        target to = language;
        to.constants = {{"scale.gain", 5}, {"compute.width", 32}};
        const translate::translation open = scale(to);
        CAPTURE(open.text);
        CHECK(open.group_width == 32);
        CHECK(open.group_height == 4);
        CHECK(open.constants[2].value == 5);
        CHECK(contains(open.text, to.to == language::msl ? " : 5;\n" : "#define CREASE_SCALE_GAIN 5\n"));

        to.frozen = true;
        const translate::translation frozen = scale(to);
        CAPTURE(frozen.text);
        CHECK(frozen.constants.empty());
        CHECK_FALSE(contains(frozen.text, "#ifndef CREASE"));
        CHECK_FALSE(contains(frozen.text, "function_constant"));
        CHECK(contains(frozen.text, "float(5)"));
        if (to.to == language::hlsl)
            CHECK(contains(frozen.text, "[numthreads(32, 4, 1)]"));
        else if (to.to == language::glsl_es)
            CHECK(contains(frozen.text, "layout(local_size_x = 32, local_size_y = 4, local_size_z = 1) in;"));
        CHECK(frozen.group_width == 32);
    }
}

TEST_CASE("a macro whose number begins another's is left alone") {
    std::string text = "SPIRV_CROSS_CONSTANT_ID_1 SPIRV_CROSS_CONSTANT_ID_12";
    translate::detail::name_constants(text, {{.part = "a", .number = "b", .id = 1, .macro = "CREASE_A_B"}});
    CHECK(text == "CREASE_A_B SPIRV_CROSS_CONSTANT_ID_12");
}

TEST_CASE("a constant that the effect has not is refused") {
    CHECK(sentence_of([] {
              scale({.to = language::hlsl, .version = 50, .constants = {{"scale.gian", 3}}});
          }) == "the effect has no constant 'scale.gian'; it has compute.height, compute.width, scale.gain");
}
