// SPDX-License-Identifier: MIT
// Texts that a compiler would refuse are seen.
#include <crease/translate/check.hpp>

#include "spirv/little_effect.hpp"
#include "spirv/sentence.hpp"

#include <crease/translate.hpp>

#include <doctest/doctest.h>

TEST_CASE("a mistake in a text is named with its line") {
    using namespace crease;
    using translate::language;
    for (const translate::target& to : {translate::target{.to = language::hlsl, .version = 50},
                                        translate::target{.to = language::hlsl, .version = 60},
                                        translate::target{.to = language::glsl, .version = 430},
                                        translate::target{.to = language::glsl_es, .version = 310}}) {
        translate::translation made = translate::shader(little::effect, little::scale, to);
        CHECK_NOTHROW(translate::check(made));
        const auto lines = std::count(made.text.begin(), made.text.end(), '\n');
        made.text += "float broken = nothing;\n";
        const std::string sentence = sentence_of([&] { translate::check(made, "pass 'scale'"); });
        CAPTURE(sentence);
        CHECK(sentence.starts_with("pass 'scale' does not compile:\n"));
        CHECK(contains(sentence, ":" + std::to_string(lines + 1) + ": "));
        CHECK(contains(sentence, "nothing"));
    }
}
