// SPDX-License-Identifier: MIT
#include "manifest.hpp"

#include "enumerators.hpp"
#include "image/file.hpp"

#include <crease/effect/version.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace crease::tools {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr int manifest_version = 1;

/// As short as a float can be read back.
double number_of(float value) {
    return std::strtod(fmt::format("{}", value).c_str(), nullptr);
}

ordered_json size_of(const extent& size) {
    ordered_json told = {{"divisor", size.divisor}, {"guarded", size.guarded}};
    if (size.fixed_width)
        told = {{"width", size.fixed_width}, {"height", size.fixed_height}};
    if (size.level)
        told["level"] = size.level;
    return told;
}

ordered_json binding_of(const binding& b, const effect_view& effect) {
    ordered_json told{{"name", b.name},
                      {"resource", effect.resources[b.resource].name},
                      {"access", name_of(b.how)},
                      {"set", b.set},
                      {"slot", b.slot}};
    if (b.level != binding::all_levels)
        told["level"] = b.level;
    return told;
}

/// What a translation places otherwise than the pass says.
void add_translation(ordered_json& told, const translate::translation& made) {
    told["version"] = made.made_for.version;
    told["entry_point"] = made.entry_point;
    told["bindings"] = ordered_json::array();
    for (const translate::placed_binding& b : made.bindings) {
        ordered_json& placed = told["bindings"].emplace_back(ordered_json{
            {"name", b.name}, {"identifier", b.identifier}, {"kind", name_of(b.kind)}, {"number", b.number}});
        if (b.sampler)
            placed["sampler"] = *b.sampler;
    }
    if (made.buffer_sizes)
        told["buffer_sizes"] = *made.buffer_sizes;
    told["constants"] = ordered_json::array();
    for (const translate::placed_constant& c : made.constants) {
        ordered_json& placed = told["constants"].emplace_back(
            ordered_json{{"id", c.id}, {"part", c.part}, {"number", c.number}, {"value", c.value}});
        if (!c.macro.empty())
            placed["macro"] = c.macro;
    }
}

ordered_json shader_of(const emitted_shader& shader, const emission& of) {
    ordered_json told{{"format", shader.format}, {"stage", shader.stage}, {"file", shader.file}};
    if (!shader.symbol.empty())
        told["symbol"] = shader.symbol;
    if (shader.translation)
        add_translation(told, *shader.translation);
    else if (shader.format != "glsl")
        told["environment"] = fmt::format("vulkan{}", spirv::name_of(of.spirv.version()));
    return told;
}

ordered_json pass_of(const emission& of, std::size_t i) {
    const pass& p = of.effect.passes[i];
    ordered_json told{{"name", p.name},
                      {"stage", name_of(p.stage)},
                      {"dialect", name_of(p.dialect)},
                      {"view", p.view},
                      {"size", size_of(p.size)}};
    if (p.stage == stage_kind::compute) {
        told["dispatch"] = name_of(p.covers);
        told["workgroup"] = {p.group_width(), p.group_height()};
    }
    told["shaders"] = ordered_json::array();
    for (const emitted_shader& shader : of.passes[i].shaders)
        told["shaders"].push_back(shader_of(shader, of));
    told["bindings"] = ordered_json::array();
    for (const binding& b : p.bindings)
        told["bindings"].push_back(binding_of(b, of.effect));
    told["constants"] = ordered_json::array();
    for (const constant& c : p.constants)
        told["constants"].push_back(
            {{"id", c.id}, {"part", c.part}, {"number", c.number}, {"value", c.value}});
    return told;
}

ordered_json resource_of(const resource& r, const std::vector<std::string>& files) {
    ordered_json told{{"name", r.name}, {"kind", name_of(r.kind)}, {"lifetime", name_of(r.life)}};
    if (r.kind == resource_kind::block)
        return told;
    if (r.kind == resource_kind::image)
        told["format"] = facts_of(r.texels).name;
    else
        told["element"] = r.element;
    told["size"] = size_of(r.size);
    told["layers"] = r.layers;
    if (r.kind == resource_kind::image) {
        told["arrayed"] = r.arrayed;
        told["samples"] = r.samples;
        told["centred"] = r.centred;
    }
    if (r.levels > 1)
        told["levels"] = r.levels;
    if (!r.content.empty())
        told["content"] = r.content;
    if (!r.meaning.empty())
        told["meaning"] = r.meaning;
    if (!r.previous_of.empty())
        told["previous_of"] = r.previous_of;
    if (r.cleared)
        told["clear"] = r.clear;
    if (r.fill && std::ranges::find(files, texel_file(r)) != files.end())
        told["texels"] = texel_file(r);
    return told;
}

ordered_json member(std::string name, const char* type, std::size_t offset) {
    return {{"name", std::move(name)}, {"type", type}, {"offset", offset}};
}

ordered_json block_of(const effect_view& effect) {
    ordered_json members = ordered_json::array();
    for (std::size_t v = 0; v < effect.views; ++v) {
        const auto add = [&](const char* name, const char* type, std::size_t offset) {
            members.push_back(
                member(fmt::format("views[{}].{}", v, name), type, v * sizeof(view_parameters) + offset));
        };
        add("from_texel", "vec4", offsetof(view_parameters, from_texel));
        add("depth_unpack", "vec2", offsetof(view_parameters, depth_unpack));
        add("far_depth", "float", offsetof(view_parameters, far_depth));
        add("guard", "float", offsetof(view_parameters, guard));
        add("resolution", "vec2", offsetof(view_parameters, resolution));
        add("texel_size", "vec2", offsetof(view_parameters, texel_size));
    }
    for (std::size_t v = 1; v < effect.views; ++v)
        members.push_back(
            member(fmt::format("from_first[{}]", v - 1), "mat4",
                   effect.views * sizeof(view_parameters) + (v - 1) * sizeof(further_view::from_first)));
    members.push_back(member("radius", "float", radius_offset(effect.views)));
    members.push_back(member("frame", "uint", radius_offset(effect.views) + sizeof(float)));
    for (std::size_t i = 0; i < effect.settings.size(); ++i) {
        const effect_setting& s = effect.settings[i];
        ordered_json told = member(s.shared ? std::string(s.name) : fmt::format("{}.{}", s.part, s.name),
                                   "float", setting_offset(effect.views, i));
        told["default"] = number_of(s.fallback);
        told["least"] = number_of(s.least);
        told["most"] = number_of(s.most);
        told["meaning"] = s.meaning;
        members.push_back(told);
    }
    return {{"size", effect.block_size()}, {"members", members}};
}

ordered_json features_of(const device_features& features) {
    return {{"extended_storage_formats", features.extended_storage_formats},
            {"fragment_stores_and_atomics", features.fragment_stores_and_atomics},
            {"subgroup_arithmetic", features.subgroup_arithmetic},
            {"depth_samples", features.depth_samples},
            {"centred_depth_samples", features.centred_depth_samples}};
}

bool is_plain_name(const json& file) {
    return file.is_string() && !file.get_ref<const std::string&>().empty() &&
           file.get_ref<const std::string&>().find_first_of("/\\:") == std::string::npos && file != "." &&
           file != "..";
}

}

std::string manifest(const emission& of, const std::vector<std::string>& files) {
    ordered_json told{
        {"manifest", manifest_version}, {"crease", version}, {"recipe", of.effect.recipe}, {"files", files}};
    told["passes"] = ordered_json::array();
    for (std::size_t i = 0; i < of.passes.size(); ++i)
        told["passes"].push_back(pass_of(of, i));
    told["resources"] = ordered_json::array();
    for (const resource& r : of.effect.resources)
        told["resources"].push_back(resource_of(r, files));
    told["uniform_block"] = block_of(of.effect);
    told["features"] = features_of(of.effect.features);
    return told.dump(2) + "\n";
}

std::vector<std::string> files_of_manifest(const std::filesystem::path& path) {
    if (!std::filesystem::exists(path))
        return {};
    const json told = json::parse(read_file(path), nullptr, false);
    const bool is_ours = told.is_object() && told.contains("manifest") && told.contains("crease") &&
                         told.contains("files") && told["files"].is_array();
    if (!is_ours || !std::ranges::all_of(told["files"], is_plain_name))
        throw std::runtime_error(
            fmt::format("{}: stands where the manifest goes, and is none of crease's: choose "
                        "another name or directory, or remove it",
                        path.string()));
    return told["files"].get<std::vector<std::string>>();
}

std::string texel_file(const resource& constant) {
    return fmt::format("{}.{}.bin", constant.name, facts_of(constant.texels).name);
}

}
