// SPDX-License-Identifier: MIT
#include "emit.hpp"

#include "enumerators.hpp"
#include "header.hpp"
#include "image/file.hpp"
#include "image/file_set.hpp"
#include "manifest.hpp"
#include "name.hpp"
#include "recipe_error.hpp"
#include "translated.hpp"
#include "wgsl.hpp"

#include <crease/compose/composition.hpp>
#include <crease/spirv/disassemble.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace crease::tools {

namespace {

/// Adds a part that an option names, with or without its numbers, unless the recipe has it already.
/// @throws recipe_error  where the recipe has another of its role
void add_part(std::string& text, const recipe& given, role of, std::string_view option,
              std::string_view part) {
    for (const choice& c : given.choices())
        if (c.what->kind == of && (c.what->name == part || recipe_text({&c, 1}).view() == part))
            return;
        else if (c.what->kind == of)
            throw recipe_error(fmt::format("the recipe says '{}' and the option --{} '{}': leave one out",
                                           c.what->name, option, part));
    text.append("/").append(part);
}

bool says_functions(const recipe& given) {
    return std::ranges::any_of(given.choices(),
                               [](const choice& c) { return stage_of(*c.what) == stage_kind::functions; });
}

const char* extension(const pass& p) {
    constexpr const char* of_stage[] = {"comp", "frag", "glsl", "glsl"};
    return of_stage[static_cast<int>(p.stage)];
}

template <class Word>
std::string bytes_of(const std::vector<Word>& words) {
    return {reinterpret_cast<const char*>(words.data()), words.size() * sizeof(Word)};
}

struct file {
    std::string name, content;
};

/// What a format calls itself in manifests, and what it adds to the names of files.
struct format_words {
    std::string_view name, extension;
};
constexpr format_words words_of(emit_format format) {
    constexpr format_words all[] = {
        {"glsl", ""}, {"spirv", ".spv"}, {"spirv-asm", ".spvasm"}, {"wgsl", ".wgsl"}};
    return all[static_cast<int>(format)];
}

/// What a text was made of, its version of crease and licence.
std::string first_line_of(const std::string& text) {
    return text.substr(0, text.find('\n') + 1);
}

/// Adds a file for each shader in a format; of a pass that has no SPIR-V its GLSL.
void add_shaders(std::vector<file>& files, emission& of, emit_format format) {
    std::vector<const spirv::words*> modules; // of which WGSL is made, all at once as node takes its time
    std::vector<std::size_t> places;          // of their files
    const auto add = [&](std::size_t i, std::string_view stage, const std::string& stem,
                         array_view<const piece> pieces, const spirv::words& words) {
        const emit_format own = words.empty() ? emit_format::glsl : format;
        const std::string name = std::string(stem).append(words_of(own).extension);
        std::vector<emitted_shader>& shaders = of.passes[i].shaders;
        if (std::ranges::find(shaders, name, &emitted_shader::file) == shaders.end())
            shaders.push_back({stage, words_of(own).name, name, {}});
        if (std::ranges::find(files, name, &file::name) != files.end())
            return;
        files.push_back({name, own == emit_format::glsl    ? joined(pieces)
                               : own == emit_format::spirv ? bytes_of(words)
                               : own == emit_format::wgsl  ? first_line_of(joined(of.effect.passes[i].pieces))
                                                           : spirv::disassemble(words)});
        if (own == emit_format::wgsl) {
            modules.push_back(&words);
            places.push_back(files.size() - 1);
        }
    };
    for (std::size_t i = 0; i < of.passes.size(); ++i) {
        const pass& p = of.effect.passes[i];
        add(i, name_of(p.stage), fmt::format("{}_{}.{}", i, p.name, extension(p)), p.pieces,
            of.passes[i].main);
        if (!p.vertex_pieces.empty())
            add(i, "vertex", "fullscreen.vert", p.vertex_pieces, of.passes[i].vertex);
    }
    const std::vector<std::string> texts = wgsl_of(modules);
    for (std::size_t i = 0; i < texts.size(); ++i)
        files[places[i]].content += texts[i];
}

/// Adds a file for each shader in another language; of the functions of a geometry pass its GLSL.
void add_translations(std::vector<file>& files, emission& of, const translate::target& to) {
    constexpr const char* extensions[] = {".hlsl", ".metal", "", ""};
    const char* const extension_of_language = extensions[static_cast<int>(to.to)];
    const auto add = [&](std::size_t i, std::string_view stage, const std::string& name,
                         translate::translation made) {
        if (std::ranges::find(files, name, &file::name) == files.end())
            files.push_back({name, made.text});
        of.passes[i].shaders.push_back({stage, word_of(to.to), name, {}, std::move(made)});
    };
    for (std::size_t i = 0; i < of.passes.size(); ++i) {
        const pass& p = of.effect.passes[i];
        const std::string stem = fmt::format("{}_{}.{}", i, p.name, extension(p));
        if (p.stage == stage_kind::geometry) {
            files.push_back({stem, joined(p.pieces)});
            of.passes[i].shaders.push_back({name_of(p.stage), "glsl", stem});
            continue;
        }
        add(i, name_of(p.stage), stem + extension_of_language, translated(of.effect, p, to));
        if (p.vertex_pieces.empty())
            continue;
        translate::target vertex = to; // one file for all passes, so one name
        if (to.to == translate::language::msl)
            vertex.entry_point = "fullscreen_vertex";
        add(i, "vertex", std::string("fullscreen.vert") + extension_of_language,
            translated_vertex(of.effect, p, vertex));
    }
}

constexpr bool is_without_spirv(const pass& p) {
    return p.stage == stage_kind::functions ||
           (p.dialect != dialect_kind::vulkan && p.dialect != dialect_kind::webgpu);
}
constexpr bool is_for_webgpu(const pass& p) {
    return p.dialect == dialect_kind::webgpu;
}

std::vector<file> files_of(emission& of, const std::set<emit_format>& formats,
                           const std::optional<translate::target>& to) {
    std::vector<file> files;
    if (to)
        add_translations(files, of, *to);
    for (emit_format format : formats)
        if (format == emit_format::header)
            files.push_back({of.name + ".hpp", header(of)});
        else
            add_shaders(files, of, format);
    const bool only_header = formats == std::set{emit_format::header};
    for (const resource& r : of.effect.resources)
        if (r.fill && !only_header)
            files.push_back({texel_file(r), bytes_of(texels_of(r))});
    return files;
}

/// What the options say of another language.
std::optional<translate::target> target_of(const emit_options& options) {
    if (options.target_version && !options.target)
        throw recipe_error("--target-version is of a language: say with --target which");
    if (!options.target)
        return std::nullopt;
    if (!options.formats.empty())
        throw recipe_error("--target and --format exclude each other: leave one out");
    constexpr unsigned least[] = {50, 21, 310, 430};
    return translate::target{.to = *options.target,
                             .version =
                                 options.target_version.value_or(least[static_cast<int>(*options.target)])};
}

void expect_spirv(const emit_options& options, const effect_view& effect) {
    const bool is_asked_for = options.target || options.formats.contains(emit_format::spirv) ||
                              options.formats.contains(emit_format::spirv_asm) ||
                              options.formats.contains(emit_format::wgsl);
    if (is_asked_for && std::ranges::any_of(effect.passes, is_without_spirv))
        throw recipe_error(
            "SPIR-V, and what is made of it, can be emitted of programs in the dialects vulkan and webgpu "
            "only: "
            "functions and the dialects opengl and glsl_es come as GLSL, by --format glsl or header");
    if (options.target && std::ranges::any_of(effect.passes, is_for_webgpu))
        throw recipe_error(
            "the webgpu dialect is for --target wgsl or spirv: for another language leave it out");
    const bool makes_spirv = !options.target && options.formats != std::set{emit_format::glsl} &&
                             std::ranges::any_of(effect.passes, has_spirv);
    if (options.spirv.any() && !makes_spirv)
        throw recipe_error("--optimise, --strip and --target-env are of SPIR-V, and none is made here: take "
                           "--format spirv, spirv-asm or header and the vulkan dialect, or leave them out");
    if (options.formats.contains(emit_format::header) && std::ranges::any_of(effect.passes, is_for_webgpu))
        throw recipe_error("a C++ header is of the dialects vulkan, opengl and glsl_es: of webgpu take "
                           "--format glsl or spirv, or --target wgsl");
}

}

recipe composed_recipe(const emit_options& options) {
    const recipe given{std::string_view(options.recipe)};
    std::string text = options.recipe;
    if (options.stage && options.shape == "functions")
        throw recipe_error("--stage and --shape functions exclude each other: functions run in whatever "
                           "shader of the host's calls them");
    if (options.stage)
        add_part(text, given, role::stage, "stage", *options.stage);
    if (options.shape == "functions")
        add_part(text, given, role::stage, "shape", *options.shape);
    else if (options.shape && says_functions(given))
        throw recipe_error("the recipe says 'functions' and the option --shape 'program': leave one out");
    if (options.dialect)
        add_part(text, given, role::dialect, "dialect", *options.dialect);
    const bool names_dialect =
        std::ranges::any_of(given.choices(), [](const choice& c) { return c.what->kind == role::dialect; });
    if (options.formats.contains(emit_format::wgsl) && !options.dialect && !names_dialect)
        add_part(text, given, role::dialect, "target", webgpu_glsl::description.name);
    const recipe chosen{std::string_view(text)};
    if (!chosen)
        throw recipe_error(std::string(chosen.error()));
    return chosen;
}

std::vector<std::filesystem::path> emit(emit_options options) {
    expect_name(options.name);
    const std::optional<translate::target> to = target_of(options);
    if (options.formats.empty() && !to)
        options.formats = {emit_format::glsl};
    const auto composed = std::make_unique<composition>(composed_recipe(options));
    if (!*composed)
        throw recipe_error(std::string(composed->error()));
    const effect_view effect = composed->view();
    expect_spirv(options, effect);
    const bool with_spirv = !to && options.formats != std::set{emit_format::glsl};
    emission made{effect, options.name, options.spirv, prepare(effect, with_spirv, options.spirv)};
    const std::vector<file> files = files_of(made, options.formats, to);

    std::vector<std::string> names;
    for (const file& each : files)
        names.push_back(each.name);
    const std::string manifest_name = options.name + ".json";
    std::vector<std::string> older = files_of_manifest(options.directory / manifest_name);
    // The manifest goes first and comes last, so that no mixture ever looks whole.
    older.insert(older.begin(), manifest_name);
    {
        file_set pending(options.directory);
        for (const file& each : files)
            write_atomically(pending / each.name, each.content);
        pending.appear(older);
    }
    write_atomically(options.directory / manifest_name, manifest(made, names));

    names.push_back(manifest_name);
    std::vector<std::filesystem::path> written;
    for (const std::string& name : names)
        written.push_back(options.directory / name);
    return written;
}

}
