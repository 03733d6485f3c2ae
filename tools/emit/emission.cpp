// SPDX-License-Identifier: MIT
#include "emission.hpp"

#include <crease/spirv/compile.hpp>

#include <fmt/format.h>

#include <map>

namespace crease::tools {

namespace {

/// The names of the passes as identifiers, each once.
std::vector<std::string> unique_names(array_view<const pass> passes) {
    std::vector<std::string> names;
    std::map<std::string_view, int> count;
    for (const pass& p : passes) {
        const int nth = ++count[p.name];
        names.push_back(nth == 1 ? std::string(p.name) : fmt::format("{}_{}", p.name, nth));
    }
    return names;
}

spirv::words finished(spirv::words module, const spirv_options& options) {
    if (options.optimise)
        module = spirv::optimise(module, *options.optimise, options.version());
    if (options.strip)
        module = spirv::strip(module, options.version());
    spirv::validate(module, options.version());
    return module;
}

}

std::vector<emitted_pass> prepare(const effect_view& effect, bool with_spirv, const spirv_options& options) {
    std::vector<emitted_pass> all;
    const std::vector<std::string> names = unique_names(effect.passes);
    for (std::size_t i = 0; i < effect.passes.size(); ++i) {
        const pass& p = effect.passes[i];
        emitted_pass& made = all.emplace_back();
        made.name = names[i];
        if (!with_spirv || !has_spirv(p))
            continue;
        const std::string title = "pass '" + std::string(p.name) + "'";
        const auto stage =
            p.stage == stage_kind::compute ? spirv::shader_stage::compute : spirv::shader_stage::fragment;
        made.main = finished(spirv::compile(p.pieces, stage, title, options.version()), options);
        if (!p.vertex_pieces.empty())
            made.vertex = finished(
                spirv::compile(p.vertex_pieces, spirv::shader_stage::vertex, title, options.version()),
                options);
    }
    return all;
}

std::string joined(array_view<const piece> pieces) {
    std::string text;
    for (const piece& p : pieces)
        text += p.text;
    return text;
}

std::vector<std::uint32_t> texels_of(const resource& constant) {
    std::vector<std::uint32_t> texels(std::size_t{constant.size.fixed_width} * constant.size.fixed_height);
    constant.fill(texels);
    return texels;
}

}
