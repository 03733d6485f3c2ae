// SPDX-License-Identifier: MIT
#include "header.hpp"

#include "enumerators.hpp"

#include <crease/effect/version.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace crease::tools {

namespace {

std::string quoted(std::string_view text) {
    std::string escaped = "\"";
    for (char c : text)
        escaped += c == '\n' ? "\\n" : c == '"' ? "\\\"" : c == '\\' ? "\\\\" : std::string(1, c);
    return escaped + '"';
}

std::string word_array(std::string_view name, const std::vector<std::uint32_t>& words) {
    std::string text = fmt::format("inline constexpr std::uint32_t {}[] = {{", name);
    for (std::size_t i = 0; i < words.size(); ++i)
        text += fmt::format("{}0x{:08x},", i % 8 == 0 ? "\n    " : " ", words[i]);
    return text + "\n};\n";
}

std::string text_constant(std::string_view name, std::string_view glsl) {
    // Adjacent literals, as a compiler may refuse one as long as a program.
    std::string text = fmt::format("inline constexpr char {}[] =", name);
    while (!glsl.empty()) {
        const std::size_t line = glsl.find('\n') + 1;
        const std::size_t end = line == 0 ? glsl.size() : line;
        text += "\n    " + quoted(glsl.substr(0, end));
        glsl.remove_prefix(end);
    }
    return text + ";\n";
}

/// A namespace within the header's, or nothing where it is empty.
std::string nested(std::string_view name, const std::string& content) {
    return content.empty() ? "" : fmt::format("namespace {} {{\n{}}}\n\n", name, content);
}

/// A view of an array that is missing where it would be empty.
std::string view_of(std::string_view list, std::size_t pass, bool is_empty) {
    return is_empty ? "{}" : fmt::format("lists::{}_{}", list, pass);
}

std::string extent_of(const extent& size) {
    return fmt::format("{{{}, {}, {}, {}}}", size.divisor, size.guarded, size.fixed_width, size.fixed_height);
}

/// The arrays that passes and resources view.
class view_writer {
public:
    explicit view_writer(emission& of) : of_(of), effect_(of.effect) {}

    std::string write() {
        for (std::size_t i = 0; i < effect_.passes.size(); ++i)
            write_pass(i);
        for (const resource& r : effect_.resources)
            write_resource(r);
        for (const effect_setting& s : effect_.settings)
            settings_ +=
                fmt::format("    {{{}, {}, {:#}f, {:#}f, {:#}f,\n     {}, {}}},\n", quoted(s.part),
                            quoted(s.name), s.fallback, s.least, s.most, quoted(s.meaning), s.shared);
        const device_features& f = effect_.features;
        return nested("spirv", spirv_) + nested("glsl", glsl_) + nested("texels", texels_) +
               nested("lists", lists_) +
               fmt::format(R"(/// What it is made of, with all numbers.
inline constexpr std::string_view recipe = {};

/// The same members as those of the C++ type of these parts.
inline constexpr std::array<::crease::pass, {}> passes{{{{
{}}}}};

inline constexpr std::array<::crease::resource, {}> resources{{{{
{}}}}};

inline constexpr std::array<::crease::effect_setting, {}> settings{{{{
{}}}}};

inline constexpr ::crease::device_features features{{{}, {}, {}, {}, {}}};

inline constexpr ::crease::parameters defaults = ::crease::default_parameters(settings);

constexpr ::crease::effect_view view() {{
    return {{passes, resources, settings, {}, features, defaults, recipe}};
}}

/// The bytes of the uniform block.
inline auto block(const ::crease::parameters& p) {{
    std::array<std::byte, view().block_size()> bytes{{}};
    ::crease::write_block(p, view().views, settings.size(), bytes.data());
    return bytes;
}}

/// Whether a `crease::effect` has these parts with these numbers, in this order: its constants are then those of
/// these passes.
template <class Effect>
inline constexpr bool matches = Effect::view().recipe == recipe;

)",
                           quoted(effect_.recipe), effect_.passes.size(), passes_, effect_.resources.size(),
                           resources_, effect_.settings.size(), settings_, f.extended_storage_formats,
                           f.fragment_stores_and_atomics, f.subgroup_arithmetic, f.depth_samples,
                           f.centred_depth_samples, effect_.views);
    }

private:
    struct shader_place {
        std::string pieces, words; ///< what views the text, and what the SPIR-V
    };

    /// Writes a shader of a pass, once where several passes share it.
    shader_place write_shader(std::size_t pass, std::string_view stage, const std::string& name,
                              array_view<const piece> pieces, const spirv::words& words) {
        if (pieces.empty())
            return {"{}", "{}"};
        const bool is_spirv = !words.empty();
        const std::string symbol = (is_spirv ? "spirv::" : "glsl::") + name;
        if (std::ranges::find(written_, symbol) == written_.end()) {
            written_.push_back(symbol);
            if (is_spirv)
                spirv_ += word_array(name, words);
            else
                glsl_ += text_constant(name, joined(pieces));
            if (!is_spirv)
                lists_ += fmt::format("inline constexpr ::crease::piece {}_pieces[] = {{{{{}, {}}}}};\n",
                                      name, quoted(of_.name + ".hpp"), symbol);
        }
        of_.passes[pass].shaders.push_back(
            {stage, is_spirv ? "spirv" : "glsl", of_.name + ".hpp", fmt::format("{}::{}", of_.name, symbol)});
        return is_spirv ? shader_place{"{}", symbol}
                        : shader_place{fmt::format("lists::{}_pieces", name), "{}"};
    }

    void write_pass(std::size_t i) {
        const pass& p = effect_.passes[i];
        const shader_place main =
            write_shader(i, name_of(p.stage), of_.passes[i].name, p.pieces, of_.passes[i].main);
        const shader_place vertex =
            write_shader(i, "vertex", "fullscreen", p.vertex_pieces, of_.passes[i].vertex);
        std::string bindings, constants;
        for (const binding& b : p.bindings)
            bindings += fmt::format("    {{{}, {}, ::crease::access::{}, {}, {}}},\n", quoted(b.name),
                                    b.resource, name_of(b.how), b.set, b.slot);
        for (const constant& c : p.constants)
            constants +=
                fmt::format("    {{{}, {}, {}, {}}},\n", quoted(c.part), quoted(c.number), c.id, c.value);
        write_list("binding", "bindings", i, bindings);
        write_list("constant", "constants", i, constants);
        passes_ += fmt::format("    {{{},\n     ::crease::stage_kind::{},\n     ::crease::dialect_kind::{},\n"
                               "     {},\n     {},\n     {},\n     {},\n     {},\n"
                               "     ::crease::dispatch::{},\n     {},\n     {},\n     {},\n     {}}},\n",
                               quoted(p.name), name_of(p.stage), name_of(p.dialect), main.pieces,
                               vertex.pieces, view_of("bindings", i, p.bindings.empty()),
                               view_of("constants", i, p.constants.empty()), extent_of(p.size),
                               name_of(p.covers), p.view, p.takes_surfaces, main.words, vertex.words);
    }

    void write_list(std::string_view item, std::string_view name, std::size_t pass,
                    const std::string& content) {
        if (!content.empty())
            lists_ +=
                fmt::format("inline constexpr ::crease::{} {}_{}[] = {{\n{}}};\n", item, name, pass, content);
    }

    void write_resource(const resource& r) {
        std::string fill = "nullptr";
        if (r.fill) {
            fill = fmt::format("texels::fill_{}", r.name);
            texels_ += word_array(r.name, texels_of(r)) +
                       fmt::format("inline void fill_{0}(::crease::array_view<std::uint32_t> all) {{\n"
                                   "    for (std::size_t i = 0; i < all.size(); ++i)\n"
                                   "        all[i] = {0}[i];\n}}\n",
                                   r.name);
        }
        resources_ += fmt::format(
            "    {{.name = {}, .kind = ::crease::resource_kind::{}, .texels = ::crease::format::{},\n"
            "     .element = {}, .life = ::crease::lifetime::{}, .size = {}, .meaning = {}, .layers = {},\n"
            "     .samples = {}, .arrayed = {}, .centred = {}, .read = ::crease::access::{},\n"
            "     .previous_of = {}, .cleared = {}, .clear = {}, .fill = {}, .content = {}}},\n",
            quoted(r.name), name_of(r.kind), facts_of(r.texels).name, quoted(r.element), name_of(r.life),
            extent_of(r.size), quoted(r.meaning), r.layers, r.samples, r.arrayed, r.centred, name_of(r.read),
            quoted(r.previous_of), r.cleared, r.clear, fill, quoted(r.content));
    }

    emission& of_;
    const effect_view& effect_;
    std::string spirv_, glsl_, texels_, lists_, passes_, resources_, settings_;
    std::vector<std::string> written_;
};

}

std::string header(emission& of) {
    return fmt::format(R"(// Made by crease {1} from {2}: do not edit.
#pragma once

#include <crease/effect/effect_view.hpp>
#include <crease/effect/version.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace {0} {{

static_assert(::crease::version == "{1}",
              "{0}.hpp was made by crease {1}, and the headers of crease are of another version: make it anew");

)",
                       of.name, version, of.effect.recipe) +
           view_writer(of).write() + "}\n";
}

}
