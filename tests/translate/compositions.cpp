// SPDX-License-Identifier: MIT
// Programs in which each part meets every other that it goes with, in each language: they translate and
// compile, bind by the numbers told and keep their names, but for what a language cannot, which is refused.
#include "pure/compositions.hpp"
#include "text/host_program.hpp"
#include "translate/declared.hpp"

#include <memory>
#include <set>

namespace {

using namespace crease;
using translate::language;
using translate::target;

bool has_any(const std::string& text, std::initializer_list<const char*> words) {
    return std::ranges::any_of(words, [&text](const char* word) { return contains(text, word); });
}

/// Whether a line of the text declares an image that is both read and written, other than r32f and r32ui.
bool changes_wide_image(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("layout(r") && contains(line, "image2D") &&
            !has_any(line, {"readonly", "writeonly", "layout(r32ui", "layout(r32f"}))
            return true;
    return false;
}

/// Whether a language has no counterpart of a program, read from its GLSL.
bool is_beyond(const std::string& glsl, const pass& p, const target& to) {
    if (to.to == language::msl)
        return contains(glsl, "imageAtomic");
    if (contains(glsl, "subgroup"))
        return true;
    if (to.to != language::glsl_es)
        return false;
    if (has_any(glsl, {"layout(r8,", "layout(rg32f,", "layout(rg32ui,", "textureQueryLevels("}) ||
        changes_wide_image(glsl))
        return true;
    return to.version < 310 &&
           (p.stage == stage_kind::compute || p.stage == stage_kind::functions ||
            has_any(glsl, {"image2D", "buffer crease_", "sampler2DMS", "gl_SampleMask", "bitCount(",
                           "findMSB(", "findLSB(", "packUnorm4x8(", "unpackUnorm4x8("}));
}

/// The names in the text of all members of the block of parameters that hosts set.
void expect_settings(const effect_view& effect, const translate::translation& made) {
    const bool is_hlsl = made.made_for.to == language::hlsl;
    for (const effect_setting& s : effect.settings) {
        const std::string name = (s.shared ? "" : std::string(s.part) + "_") + std::string(s.name);
        CHECK(contains(made.text,
                       is_hlsl ? "float crease_given_" + name + " : packoffset" : "float " + name + ";"));
    }
}

/// How often a language has been asked for programs.
struct count {
    int translated = 0, refused = 0;
};

/// A program in one language.
void check_translation(const effect_view& effect, const pass& p, const spirv::words& module, const target& to,
                       count& counted) {
    const std::string title = "pass '" + std::string(p.name) + "' cannot be " + name_of(to) + ": it ";
    CAPTURE(title);
    const bool is_beyond_language = is_beyond(text_of(p), p, to);
    try {
        const translate::translation made = translate::module(effect, p, module, to);
        CHECK_FALSE(is_beyond_language);
        CHECK_NOTHROW(translate::check(made));
        CHECK(declared_numbers(made).all == told_numbers(made));
        CHECK(made.buffer_sizes.has_value() == contains(made.text, "spvBufferSizeConstants"));
        CHECK(contains(made.text, " " + made.entry_point + "("));
        if (p.bindings.size() > 0 && p.bindings[0].how == access::uniform)
            expect_settings(effect, made);
        ++counted.translated;
    } catch (const spirv::error& refused) {
        CHECK_MESSAGE(is_beyond_language, refused.what());
        CHECK(std::string(refused.what()).starts_with(title));
        ++counted.refused;
    }
}

spirv::words module_of(const pass& p) {
    const bool is_compute = p.stage == stage_kind::compute || p.stage == stage_kind::functions;
    return spirv::compile(whole_program(p),
                          is_compute ? spirv::shader_stage::compute : spirv::shader_stage::fragment, p.name);
}

/// The legal compositions for Vulkan that bring one or more pairs of parts that no other before them did.
std::vector<std::string> pairwise_recipes() {
    std::set<std::string> seen;
    std::vector<std::string> chosen;
    for (const std::string& text : every_recipe()) {
        if (contains(text, "opengl") || contains(text, "glsl_es") || contains(text, "webgpu"))
            continue;
        const recipe read{std::string_view(text)};
        bool is_new = false;
        for (const choice& a : read.choices())
            for (const choice& b : read.choices())
                is_new |= seen.insert(std::string(a.what->name) + " " + std::string(b.what->name)).second;
        if (is_new)
            chosen.push_back(text);
    }
    return chosen;
}

/// Checks one of `shares` parts of the different programs. In the least version of each language, which has
/// all that later ones have, and GLSL ES 3.10; each tenth in all versions.
void check_share(std::size_t share, std::size_t shares) {
    std::set<std::string> seen;
    std::map<std::string, count> counts;
    std::size_t checked = 0;
    for (const std::string& text : pairwise_recipes()) {
        CAPTURE(text);
        const auto composed = std::make_unique<composition>(recipe(std::string_view(text)));
        const effect_view effect = composed->view();
        for (const pass& p : effect.passes) {
            const bool is_ours = seen.size() % shares == share;
            if (!seen.insert(without_recipe(text_of(p))).second || !is_ours)
                continue;
            const spirv::words module = module_of(p);
            for (const language to : {language::hlsl, language::msl, language::glsl_es, language::glsl})
                for (const unsigned version : translate::versions_of(to))
                    if (checked % 10 == 0 || version == translate::versions_of(to)[0] || version == 310) {
                        const target chosen{.to = to, .version = version};
                        check_translation(effect, p, module, chosen, counts[name_of(chosen)]);
                    }
            ++checked;
        }
    }
    MESSAGE(seen.size() << " different programs, of which " << checked << " are checked here");
    CHECK(seen.size() > 1000);
    for (const auto& [name, c] : counts) {
        MESSAGE(name << ": " << c.translated << " translated, " << c.refused << " refused by name");
        CHECK(c.translated > 0);
    }
}

}

TEST_CASE("translated compositions 1 of 2") {
    check_share(0, 2);
}
TEST_CASE("translated compositions 2 of 2") {
    check_share(1, 2);
}
