// SPDX-License-Identifier: MIT
#include <crease/spirv/compile.hpp>

#include "little_effect.hpp"
#include "sentence.hpp"

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("each stage of an effect compiles") {
    CHECK(!spirv::compile(little::scale).empty());
    CHECK(!spirv::compile(little::spread).empty());
    CHECK(!spirv::compile_vertex(little::spread).empty());
}

TEST_CASE("what was compiled beforehand is given as it is, without text") {
    constexpr std::uint32_t words[] = {1, 2, 3}, vertex_words[] = {4, 5};
    pass beforehand;
    beforehand.stage = stage_kind::fragment;
    beforehand.spirv = words;
    beforehand.vertex_spirv = vertex_words;
    CHECK(spirv::compile(beforehand) == spirv::words{1, 2, 3});
    CHECK(spirv::compile_vertex(beforehand) == spirv::words{4, 5});
}

TEST_CASE("an error names the pass, the file and the line in that file") {
    const piece pieces[] = {little::version, {"estimator/wrong.glsl", "void main() {\n    x = 1;\n}\n", 4}};
    pass wrong = little::spread;
    wrong.pieces = pieces;
    const std::string said = sentence_of([&] { spirv::compile(wrong); });
    CHECK(said == "pass 'spread' does not compile:\nestimator/wrong.glsl:5: 'x' : undeclared identifier");
}

TEST_CASE("a piece counts from line 1 where nothing else is said") {
    const piece pieces[] = {little::version, {"plain.glsl", "void main() { x = 1; }\n"}};
    const std::string said = sentence_of([&] { spirv::compile(pieces, spirv::shader_stage::compute); });
    CHECK(contains(said, "plain.glsl:1: "));
}

TEST_CASE("a function without a body is named at link time") {
    const piece pieces[] = {little::version, {"half.glsl", "float missing(); void main() { missing(); }\n"}};
    const std::string said = sentence_of([&] { spirv::compile(pieces, spirv::shader_stage::compute); });
    CHECK(contains(said, "missing("));
}

TEST_CASE("what is no program for Vulkan is refused") {
    pass functions = little::spread;
    functions.stage = stage_kind::functions;
    CHECK(sentence_of([&] { spirv::compile(functions); }) ==
          "pass 'spread' is functions for an engine's own shader: it has no main to compile");
    pass opengl = little::spread;
    opengl.dialect = dialect_kind::opengl;
    CHECK(contains(sentence_of([&] { spirv::compile(opengl); }), "is GLSL for OpenGL"));
    CHECK(sentence_of([] { spirv::compile_vertex(little::scale); }) == "pass 'scale' has no vertex shader");
}

TEST_CASE("OpenGL GLSL parses and links as its stages") {
    const piece version{"version", "#version 430\n"};
    const piece vertex[] = {version,
                            {"triangle.glsl", "out vec2 uv; void main() { uv = vec2(gl_VertexID); "
                                              "gl_Position = vec4(uv, 0, 1); }\n"}};
    const piece fragment[] = {version,
                              {"show.glsl", "in vec2 uv; out vec4 colour; uniform sampler2D image; "
                                            "void main() { colour = texture(image, uv); }\n"}};
    pass good = little::spread;
    good.dialect = dialect_kind::opengl;
    good.pieces = fragment;
    good.vertex_pieces = vertex;
    CHECK_NOTHROW(spirv::check_opengl(good));

    const piece other[] = {version,
                           {"show.glsl", "in vec3 uv; out vec4 colour; void main() { colour = uv.xyzz; }\n"}};
    pass unlinked = good;
    unlinked.pieces = other;
    CHECK(contains(sentence_of([&] { spirv::check_opengl(unlinked); }), "does not link"));
    CHECK(contains(sentence_of([] { spirv::check_opengl(little::scale); }), "is GLSL for Vulkan"));
}

TEST_CASE("each of several pieces of one file is named with its own line") {
    const piece pieces[] = {little::version,
                            {"host/a.glsl", "float one() { return 1.0; }\n", 10},
                            {"host/b.glsl", "float two() { return one(); }\n", 3},
                            {"host/a.glsl", "void main() {\n    two(x);\n}\n", 20}};
    CHECK(contains(sentence_of([&] { spirv::compile(pieces, spirv::shader_stage::compute); }),
                   "host/a.glsl:21: 'x'"));
}

TEST_CASE("functions for the host's geometry are no program") {
    pass geometry = little::spread;
    geometry.stage = stage_kind::geometry;
    CHECK(sentence_of([&] { spirv::compile(geometry); }) ==
          "pass 'spread' is functions for the host's geometry: it has no main to compile");
}
