// SPDX-License-Identifier: MIT
#include <crease/compose/symbols.hpp>
#include <crease/crease.hpp>

#include "glsl_files.hpp"
#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace crease;

constexpr glsl_file several{"host/several.glsl", R"(
// What an estimate is.
struct crease_estimate {
    float occlusion; // crease_unknown is not called
};

const int crease_most = 4; // of something
const vec2 crease_offsets[2] = vec2[](vec2(0.0), vec2(1.0));
shared float crease_sums[16];

// Two lines
// of comment.
float crease_one(int i) {
    for (int k = 0; k < crease_most; ++k) {
        if (k == i)
            return crease_offsets[k].x + crease_offsets[0].y;
    }
    return 0.0;
}
float helper(float x) { return x; }
float crease_two() { return helper(crease_one(crease_most)); }

void main() { crease_estimate own = crease_estimate(crease_two()); }
)"};
constexpr symbol_table table = read_symbols(several);
static_assert(table.file == &several);
static_assert(table.definitions.size() == 7);
static_assert(!table.definitions.cut && !table.references.cut);

constexpr std::string_view text_of(const symbol_table& of, std::size_t which) {
    const definition& own = of.definitions[which];
    return of.file->text.substr(own.begin, own.end - own.begin);
}

bool refers(const symbol_table& of, std::size_t which, std::string_view name) {
    const definition& own = of.definitions[which];
    for (std::size_t i = 0; i < own.references; ++i)
        if (of.references[own.first_reference + i] == symbol_of(name))
            return true;
    return false;
}

/// The names that a text of one line or more defines.
std::vector<symbol> names_in(std::string_view text) {
    const glsl_file file{"host/some.glsl", text};
    const symbol_table of = read_symbols(file);
    std::vector<symbol> names;
    for (const definition& each : of.definitions)
        names.push_back(each.name);
    return names;
}

std::vector<symbol> symbols(std::initializer_list<std::string_view> names) {
    std::vector<symbol> all;
    for (std::string_view each : names)
        all.push_back(symbol_of(each));
    return all;
}

/// The identifiers of a text that begin with `crease_`.
std::vector<std::string> identifiers_of(std::string_view text) {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        while (end < text.size() && reading::is_word(text[end]))
            ++end;
        if (text.substr(i, end - i).starts_with("crease_"))
            all.emplace_back(text.substr(i, end - i));
        i = end == i ? i + 1 : end;
    }
    return all;
}

}

TEST_CASE("a symbol of two texts is that of both after each other") {
    static_assert(symbol_of("") == empty_symbol);
    static_assert(symbol_of("noise", crease_prefix) == symbol_of("crease_noise"));
    static_assert(symbol_of("a") != symbol_of("b"));
    CHECK(symbol_of("foobar") == 0xbf9cf968u); // FNV-1a, as published
}

TEST_CASE("structs, constants, arrays, shared variables and functions are definitions, and so is main") {
    const char* names[] = {"crease_estimate", "crease_most", "crease_offsets", "crease_sums", "crease_one",
                           "crease_two",      "main"};
    for (std::size_t i = 0; i < 7; ++i) {
        CAPTURE(names[i]);
        CHECK(table.definitions[i].name == symbol_of(names[i]));
    }
}

TEST_CASE("a definition is whole lines, with the comments before and behind it") {
    CHECK(text_of(table, 0) == "\n// What an estimate is.\nstruct crease_estimate {\n    float occlusion; // "
                               "crease_unknown is not called\n};\n");
    CHECK(text_of(table, 1) == "\nconst int crease_most = 4; // of something\n");
    CHECK(text_of(table, 4).starts_with("\n// Two lines\n// of comment.\nfloat crease_one(int i) {\n"));
    CHECK(text_of(table, 4).ends_with("    return 0.0;\n}\n"));
    std::string all;
    for (std::size_t i = 0; i < table.definitions.size(); ++i)
        all += text_of(table, i);
    CHECK(all == several.text);
}

TEST_CASE("the line of a definition is that of its first character") {
    for (std::size_t i = 0; i < table.definitions.size(); ++i) {
        CAPTURE(i);
        const std::string_view before = several.text.substr(0, table.definitions[i].begin);
        CHECK(table.definitions[i].line == std::ranges::count(before, '\n'));
    }
}

TEST_CASE("what has another name counts to the definition after it") {
    CHECK(text_of(table, 5) == "float helper(float x) { return x; }\nfloat crease_two() { return "
                               "helper(crease_one(crease_most)); }\n");
}

TEST_CASE("references are the identifiers of crease in a definition, each once, and none of comments") {
    CHECK(refers(table, 4, "crease_most"));
    CHECK(refers(table, 4, "crease_offsets"));
    CHECK_FALSE(refers(table, 4, "crease_estimate"));
    CHECK(table.definitions[4].references == 3); // itself too
    CHECK(refers(table, 6, "crease_estimate"));
    CHECK(refers(table, 6, "crease_two"));
    CHECK_FALSE(refers(table, 6, "crease_one"));
    CHECK_FALSE(refers(table, 0, "crease_unknown"));
}

TEST_CASE("several definitions may stand in a line") {
    CHECK(names_in("const int crease_a = 1; const int crease_b = 2;\nint crease_c() { return crease_b; } // "
                   "both\n") == symbols({"crease_a", "crease_b", "crease_c"}));
}

TEST_CASE("a prototype is no definition, nor is what stands in a comment of several lines") {
    CHECK(names_in("float crease_a(int i);\n/* float crease_b() { return 1.0; }\n */\nfloat crease_c() { "
                   "return 1.0; }\n") == symbols({"crease_c"}));
}

TEST_CASE("the line after a comment of several lines is told") {
    constexpr glsl_file file{"host/lines.glsl", "/* a\nb */\nint crease_a;\nint crease_b;\n"};
    CHECK(read_symbols(file).definitions[1].line == 3);
}

TEST_CASE("a name must begin with crease_ to be a definition") {
    CHECK(names_in("float creased() { return 1.0; }\n").empty());
    CHECK(names_in("float mycrease_x() { return 1.0; }\nfloat crease_y() { return 1.0; }\n") ==
          symbols({"crease_y"}));
    CHECK(names_in("void maintain() {}\nvoid main() {}\n") == symbols({"main"}));
}

TEST_CASE("definitions of every form have the name that is defined") {
    CHECK(names_in("crease_layer crease_at(crease_layers all, int i) { return all.items[i]; }") ==
          symbols({"crease_at"}));
    CHECK(names_in("const mat2 crease_turn = mat2(1.0, 0.0, 0.0, 1.0);") == symbols({"crease_turn"}));
    CHECK(names_in("crease_view crease_now = crease_view_of(0);\n") == symbols({"crease_now"}));
    CHECK(names_in("float crease_value;\n") == symbols({"crease_value"}));
    CHECK(names_in("struct crease_a { int x; };\nstruct crease_b { crease_a a[2]; };") ==
          symbols({"crease_a", "crease_b"}));
    CHECK(names_in("int crease_a() {\n    return 1;\n} // end\nint crease_b() { return 2; }\n") ==
          symbols({"crease_a", "crease_b"}));
    CHECK(names_in("layout(std430, binding = 3) buffer crease_nodes { uint crease_node[]; };\n") ==
          symbols({"crease_nodes"}));
    CHECK(names_in("// nothing\n\n").empty());
    CHECK(names_in("").empty());
}

TEST_CASE("too many definitions or references are said to be too many") {
    std::string text;
    for (int i = 0; i < 41; ++i)
        text += "const int crease_c" + std::to_string(i) + " = 1;\n";
    CHECK(read_symbols(glsl_file{"a", text}).definitions.cut);
    text = "int crease_sum() {\n    return 0";
    for (int i = 0; i < 241; ++i)
        text += " + crease_r" + std::to_string(i);
    CHECK(read_symbols(glsl_file{"a", text + ";\n}\n"}).references.cut);
}

TEST_CASE("no file of crease has too many, and all of its text is in definitions") {
    for (const glsl_file* file : all_glsl_files()) {
        CAPTURE(std::string(file->name));
        const symbol_table of = read_symbols(*file);
        CHECK_FALSE(of.definitions.cut);
        CHECK_FALSE(of.references.cut);
        REQUIRE(of.definitions.size() > 0);
        CHECK(of.definitions[0].begin == 0);
        CHECK(of.definitions[of.definitions.size() - 1].end == file->text.size());
        for (const definition& each : of.definitions)
            CHECK(each.name != 0);
    }
}

TEST_CASE("all identifiers of crease's GLSL have different symbols") {
    std::map<symbol, std::string> known;
    const auto learn = [&known](const std::string& name) {
        CAPTURE(name);
        CHECK(known.emplace(symbol_of(name), name).first->second == name);
    };
    for (const glsl_file* file : all_glsl_files())
        for (const std::string& name : identifiers_of(file->text))
            learn(name);
    for (const part* each : all_parts) {
        for (const number& n : each->numbers)
            learn("crease_" + std::string(each->name) + "_" + std::string(n.name));
        for (const setting& s : each->settings)
            learn("crease_" + (s.shared ? "" : std::string(each->name) + "_") + std::string(s.name));
        for (const resource& r : each->resources)
            for (const char* before : {"crease_", "crease_load_", "crease_size_of_", "crease_encode_"})
                learn(before + std::string(r.name));
    }
    for (const char* name : {"crease_given", "crease_radius", "crease_frame", "crease_view_index",
                             "crease_divisor", "crease_input_divisor", "crease_workgroup_columns",
                             "crease_unroll", "crease_precise", "crease_write", "crease_build_size",
                             "crease_group_size", "crease_load_input", "crease_size_of_input", "main"})
        learn(name);
    CHECK(known.size() > 300);
}
