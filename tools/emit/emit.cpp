// SPDX-License-Identifier: MIT
#include "emit.hpp"

#include "image/file.hpp"

#include <crease/spirv.hpp>

#include <fmt/format.h>

#include <map>
#include <memory>
#include <span>
#include <stdexcept>

namespace crease::tools {

namespace {

std::string joined(std::span<const piece> pieces) {
    std::string text;
    for (const piece& p : pieces)
        text += p.text;
    return text;
}

const char* extension(const pass& p) {
    constexpr const char* of_stage[] = {"comp", "frag", "glsl", "glsl"};
    return of_stage[static_cast<int>(p.stage)];
}

bool has_spirv(const pass& p) {
    return p.stage != stage_kind::functions && p.stage != stage_kind::geometry &&
           p.dialect == dialect_kind::vulkan;
}

spirv::words checked(spirv::words module) {
    spirv::validate(module);
    return module;
}

std::string_view bytes_of(const spirv::words& module) {
    return {reinterpret_cast<const char*>(module.data()), module.size() * sizeof(std::uint32_t)};
}

std::string word_array(std::string_view name, const spirv::words& module) {
    std::string text = fmt::format("inline constexpr std::uint32_t {}[] = {{", name);
    for (std::size_t i = 0; i < module.size(); ++i)
        text += fmt::format("{}0x{:08x},", i % 8 == 0 ? "\n    " : " ", module[i]);
    return text + "\n};\n\n";
}

std::string text_constant(std::string_view name, std::string_view glsl) {
    // Adjacent literals, as a compiler may refuse one as long as a program.
    std::string text = fmt::format("inline constexpr char {}[] =", name);
    while (!glsl.empty()) {
        const std::size_t line = glsl.find('\n') + 1;
        const std::size_t end = line == 0 ? glsl.size() : line;
        std::string escaped;
        for (char c : glsl.substr(0, end))
            escaped += c == '\n' ? "\\n" : c == '"' ? "\\\"" : c == '\\' ? "\\\\" : std::string(1, c);
        text += "\n    \"" + escaped + "\"";
        glsl.remove_prefix(end);
    }
    return text + ";\n\n";
}

/// The names of the passes as identifiers, each once.
std::vector<std::string> unique_names(std::span<const pass> passes) {
    std::vector<std::string> names;
    std::map<std::string, int> count;
    for (const pass& p : passes) {
        const int nth = ++count[std::string(p.name)];
        names.push_back(nth == 1 ? std::string(p.name) : fmt::format("{}_{}", p.name, nth));
    }
    return names;
}

std::string header(const emit_options& options, std::string_view recipe_text, std::span<const pass> passes) {
    std::string text = fmt::format("// Made by crease from {}\n#pragma once\n\n#include <cstdint>\n\n"
                                   "namespace {} {{\n\n",
                                   recipe_text, options.name);
    const std::vector<std::string> names = unique_names(passes);
    for (std::size_t i = 0; i < passes.size(); ++i)
        text += has_spirv(passes[i]) ? word_array(names[i], checked(spirv::compile(passes[i])))
                                     : text_constant(names[i], joined(passes[i].pieces));
    if (!passes.back().vertex_pieces.empty())
        text += has_spirv(passes.back())
                    ? word_array("fullscreen", checked(spirv::compile_vertex(passes.back())))
                    : text_constant("fullscreen", joined(passes.back().vertex_pieces));
    return text + "}\n";
}

bool is_identifier(std::string_view name) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    for (char c : name)
        if (!letter(c) && !(c >= '0' && c <= '9'))
            return false;
    return !name.empty() && letter(name[0]);
}

}

recipe composed_recipe(const emit_options& options) {
    std::string text = options.recipe;
    if (options.shape == "functions")
        text += "/functions";
    else if (options.stage != "compute")
        text += "/" + options.stage;
    if (options.dialect != "vulkan")
        text += "/" + options.dialect;
    const recipe chosen{std::string_view(text)};
    if (!chosen)
        throw std::runtime_error(std::string(chosen.error()));
    return chosen;
}

std::vector<std::filesystem::path> emit(const emit_options& options) {
    const recipe chosen = composed_recipe(options);
    const auto composed = std::make_unique<composition>(chosen);
    const std::span<const pass> passes = composed->view().passes;
    if (options.format == emit_format::header && !is_identifier(options.name))
        throw std::runtime_error(fmt::format("'{}' is no C++ identifier to name a header by", options.name));
    if ((options.format == emit_format::spirv || options.format == emit_format::spirv_asm) &&
        !has_spirv(passes[passes.size() - 1]))
        throw std::runtime_error(
            "SPIR-V can be emitted of programs in the vulkan dialect only: functions and the "
            "opengl dialect come as GLSL, by --format glsl or header");
    make_directory(options.directory);

    std::vector<std::filesystem::path> written;
    const auto write = [&](const std::string& name, std::string_view bytes) {
        written.push_back(options.directory / name);
        write_atomically(written.back(), bytes);
    };
    const auto write_module = [&](const std::string& stem, const spirv::words& module) {
        if (options.format == emit_format::spirv)
            write(stem + ".spv", bytes_of(module));
        else
            write(stem + ".spvasm", spirv::disassemble(module));
    };
    if (options.format == emit_format::header) {
        write(options.name + ".hpp", header(options, chosen.text().view(), passes));
        return written;
    }
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const std::string stem = fmt::format("{}_{}.{}", i, passes[i].name, extension(passes[i]));
        if (options.format == emit_format::glsl || passes[i].stage == stage_kind::geometry)
            write(stem, joined(passes[i].pieces)); // of geometry the host's shader makes a program
        else
            write_module(stem, checked(spirv::compile(passes[i])));
    }
    if (!passes.back().vertex_pieces.empty()) {
        if (options.format == emit_format::glsl)
            write("fullscreen.vert", joined(passes.back().vertex_pieces));
        else
            write_module("fullscreen.vert", checked(spirv::compile_vertex(passes.back())));
    }
    return written;
}

}
