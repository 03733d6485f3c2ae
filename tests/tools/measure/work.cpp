// SPDX-License-Identifier: MIT
#include "measure/work.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace crease;

namespace {

tools::shader_work work_of(const std::string& body) {
    const std::string text = "#version 450\n"
                             "layout(local_size_x = 8) in;\n"
                             "layout(constant_id = 0) const int turns = 40;\n"
                             "layout(set = 0, binding = 0, r32f) uniform image2D picture;\n"
                             "float read(int x, int y) { return imageLoad(picture, ivec2(x, y)).x; }\n"
                             "void main() { float sum = 0.0;\n" +
                             body + "imageStore(picture, ivec2(0), vec4(sum)); }\n";
    const piece pieces[] = {{"test", text}};
    return tools::count_work(spirv::compile(pieces, spirv::shader_stage::compute, "test"));
}

}

TEST_CASE("a loop counts as often as its body runs, also where it is too long to be written out") {
    for (const auto& [head, turns] : {std::pair{"int i = 0; i < 3; ++i", 3u},
                                      {"int i = 2; i <= 20; i += 3", 7u},
                                      {"int i = 9; i >= 0; --i", 10u},
                                      {"int i = 0; i < turns; ++i", 40u},
                                      {"int i = 0; i < 100000; ++i", 100000u},
                                      {"uint i = 0u; i < 50000u; i += 2u", 25000u},
                                      {"int i = 5; i < 5; ++i", 0u}}) {
        const std::string loop =
            "for (" + std::string(head) + ") sum += read(int(i), int(gl_LocalInvocationIndex));\n";
        CAPTURE(loop);
        const tools::shader_work work = work_of(loop);
        CHECK(work.fetches == turns);
        CHECK(work.instructions >= 2 * turns);
        CHECK(work.counted_whole);
    }
}

TEST_CASE("loops in loops count by the product of their turns") {
    const std::string inner = "for (int j = 0; j < 500; ++j) sum += read(i, j);\n";
    const tools::shader_work work = work_of("for (int i = 0; i < 400; ++i) { sum += read(i, 1); " + inner +
                                            "}\n" + "sum += read(1, 2);\n");
    CHECK(work.fetches == 400 * 501 + 1);
    CHECK(work.counted_whole);
}

TEST_CASE("a loop whose turns are no constant counts once, and is said to") {
    const tools::shader_work work = work_of("for (int i = int(gl_LocalInvocationIndex); i < 9; ++i) sum += "
                                            "read(i, 0);\n");
    CHECK(work.fetches == 1);
    CHECK_FALSE(work.counted_whole);
}
