// SPDX-License-Identifier: MIT
#include <crease/compose/glsl_file.hpp>
#include <crease/parts/estimator/hbao.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace {

// The line of the opening fence is followed by that which ends the group for GLSL.
constexpr crease::glsl_file fenced{"a.glsl", 7, "\"\n#endif\nint a;\n#ifdef __cplusplus\n\""};
static_assert(fenced.name == "a.glsl");
static_assert(fenced.text == "int a;\n");
static_assert(fenced.first_line == 9);

constexpr crease::glsl_file plain{"b.glsl", "int b;\n"};
static_assert(plain.text == "int b;\n");
static_assert(plain.first_line == 1);

std::string content_of(const std::filesystem::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

}

TEST_CASE("each GLSL file has its fences, its licence and a size that every compiler takes") {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(CREASE_TEMPLATES)) {
        if (entry.path().extension() != ".glsl")
            continue;
        CAPTURE(entry.path().string());
        const std::string text = content_of(entry.path());
        const std::string licence = "// SPDX-License-Identifier: MIT-0\n",
                          fence = "__LINE__, R\"glsl(\"\n#endif\n";
        const bool has_contract = text.starts_with(licence + "#ifndef __cplusplus\n");
        const std::size_t body = text.find((has_contract ? "#else\n" : "#ifdef __cplusplus\n") + fence);
        REQUIRE(body != text.npos);
        CHECK((has_contract || body == licence.size()));
        CHECK(text.find(fence, body + fence.size()) == text.npos);
        CHECK(text.ends_with("\n#ifdef __cplusplus\n\")glsl\"\n#endif\n"));
        CHECK(text.size() <= crease::glsl_file::longest);
        CHECK(text.find('\r') == std::string::npos);
        ++files;
    }
    CHECK(files >= 100);
}

TEST_CASE("a file that is included begins at the line of its text") {
    const std::string whole = content_of(std::filesystem::path(CREASE_TEMPLATES) / crease::hbao_glsl.name);
    std::size_t at = 0;
    for (unsigned line = 1; line < crease::hbao_glsl.first_line; ++line)
        at = whole.find('\n', at) + 1;
    CHECK(whole.substr(at).starts_with(crease::hbao_glsl.text));
}
