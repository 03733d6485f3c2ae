// SPDX-License-Identifier: MIT
#include <crease/glsl_file.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace {

constexpr crease::glsl_file fenced{"a.glsl", "\"\n#endif\nint a;\n#ifdef __cplusplus\n\""};
static_assert(fenced.text == "int a;\n");
static_assert(fenced.first_line == 4);

constexpr crease::glsl_file plain{"b.glsl", "int b;\n"};
static_assert(plain.text == "int b;\n");
static_assert(plain.first_line == 1);

std::string content_of(const std::filesystem::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

}

TEST_CASE("each GLSL file has its fence, its licence and a size that every compiler takes") {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(CREASE_TEMPLATES)) {
        if (entry.path().extension() != ".glsl")
            continue;
        CAPTURE(entry.path().string());
        const std::string text = content_of(entry.path());
        CHECK(text.starts_with("#ifdef __cplusplus\nR\"glsl(\"\n#endif\n// SPDX-License-Identifier: MIT\n"));
        CHECK(text.ends_with("\n#ifdef __cplusplus\n\")glsl\"\n#endif\n"));
        CHECK(text.size() <= crease::glsl_file::longest);
        CHECK(text.find('\r') == std::string::npos);
        ++files;
    }
    CHECK(files >= 20);
}
