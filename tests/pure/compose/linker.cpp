// SPDX-License-Identifier: MIT
#include <crease/compose/linker.hpp>

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace crease;

constexpr glsl_file part_file{"host/part.glsl", R"(float crease_weigh() { return crease_shared() + 1.0; }
float crease_unused() { return crease_only_unused(); }
)"};
constexpr glsl_file default_file{"core/default.glsl", R"(float crease_weigh() { return 0.0; }
float crease_shared() { return crease_host_given * 2.0; }
float crease_only_unused() { return 3.0; }
void main() { crease_weigh(); crease_shared(); }
)"};
constexpr symbol_table of_part = read_symbols(part_file), of_default = read_symbols(default_file);

/// The texts that are linked, files being searched in the order given.
template <class Found>
std::string linked_text(const Found& found) {
    std::string all;
    for (const linker::linked& each : found.order()) {
        const definition& own = each.from->definitions[each.index];
        all += each.from->file->text.substr(own.begin, own.end - own.begin);
    }
    return all;
}

constexpr auto is_whole = [] {
    linker found;
    found.add(of_part);
    found.add(of_default);
    found.use(main_symbol);
    return found.order().size() == 3 && !found.is_cut();
}();
static_assert(is_whole);

std::string function(const std::string& name, const std::string& callee) {
    return "int crease_" + name + "() { return " + callee + "; }\n";
}

}

TEST_CASE("callees stand first, the first file's definitions count, and what is not called is left out") {
    linker found;
    found.add(of_part);
    found.add(of_default);
    found.use(main_symbol);
    CHECK(linked_text(found) == "float crease_shared() { return crease_host_given * 2.0; }\n"
                                "float crease_weigh() { return crease_shared() + 1.0; }\n"
                                "void main() { crease_weigh(); crease_shared(); }\n");
}

TEST_CASE("the default counts where no file before it defines the name") {
    linker found;
    found.add(of_default);
    found.add(of_part);
    found.use(symbol_of("crease_weigh"));
    CHECK(linked_text(found) == "float crease_weigh() { return 0.0; }\n");
}

TEST_CASE("names that are used are known, also those that no file defines") {
    linker found;
    found.add(of_part);
    found.add(of_default);
    found.use(main_symbol);
    CHECK(found.is_used(symbol_of("crease_host_given")));
    CHECK(found.is_used(symbol_of("crease_weigh")));
    CHECK_FALSE(found.is_used(symbol_of("crease_unused")));
    CHECK_FALSE(found.is_used(symbol_of("crease_only_unused")));
    CHECK_FALSE(found.is_used(symbol_of("crease_never_heard_of")));
}

TEST_CASE("what is used twice stands once") {
    linker found;
    found.add(of_default);
    found.use(symbol_of("crease_shared"));
    found.use(main_symbol);
    found.use(symbol_of("crease_shared"));
    CHECK(found.order().size() == 3);
}

TEST_CASE("definitions that call each other do not go round for ever") {
    const std::string text = function("a", "crease_b()") + function("b", "crease_a()");
    const glsl_file file{"host/round.glsl", text};
    const symbol_table table = read_symbols(file);
    linker found;
    found.add(table);
    found.use(symbol_of("crease_a"));
    CHECK(found.order().size() == 2);
}

TEST_CASE("too many names or functions are said to be too many") {
    std::vector<std::string> texts;
    std::vector<glsl_file> files;
    std::vector<symbol_table> tables;
    texts.reserve(20);
    files.reserve(20);
    tables.reserve(20);
    linker found;
    for (int f = 0; f < 13; ++f) { // of 40 functions each
        CHECK_FALSE(found.is_cut());
        std::string& text = texts.emplace_back();
        for (int i = 0; i < 40; ++i)
            text += function(std::to_string(f) + "_" + std::to_string(i), "1");
        found.add(tables.emplace_back(read_symbols(files.emplace_back("host/many.glsl", text))));
    }
    CHECK(found.is_cut());

    linker calling;
    for (std::size_t f = 0; f < 5; ++f)
        calling.add(tables[f]);
    for (std::size_t f = 0; f < 5; ++f)
        for (const definition& each : tables[f].definitions)
            calling.use(each.name);
    CHECK(calling.order().size() == 192);
    CHECK(calling.is_cut());
}

TEST_CASE("a file with too much in it is said to be so") {
    std::string text;
    for (int i = 0; i < 41; ++i)
        text += function(std::to_string(i), "1");
    const glsl_file file{"host/long.glsl", text};
    const symbol_table table = read_symbols(file);
    linker found;
    found.add(table);
    CHECK(found.is_cut());
}
