// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/check.hpp>
#include <crease/translate/translation.hpp>

#include <algorithm>
#include <set>
#include <tuple>

namespace crease::translate::detail {

using spirv::binding_kind;
using spirv::error;

/// As in "pass 'visibility' cannot be HLSL 5.0".
inline std::string title_of(const pass& which, const target& to) {
    return "pass '" + std::string(which.name) + "' cannot be " + name_of(to);
}

/// What a shader binds, before it has numbers.
struct wanted_binding {
    std::string name;       ///< by which the host names its place
    std::string identifier; ///< of what has no name in the SPIR-V
    unsigned set = 0;       ///< in the SPIR-V
    unsigned slot = 0;
    binding_kind kind = binding_kind::other;
    bool is_written = false;
};

/// By which the host names the place of the array that tells MSL how long buffers are.
inline constexpr const char* buffer_sizes_name = "buffer_sizes";

/// The bindings of a pass in its order, and then those that the module has beside them, which are a host's.
inline std::vector<wanted_binding> bindings_of(const effect_view& effect, const pass& which,
                                               const spirv::reflection& module) {
    std::vector<wanted_binding> all;
    for (const binding& b : which.bindings)
        if (has_descriptor(b.how))
            all.push_back({std::string(b.name), "crease_" + std::string(b.name), b.set, b.slot,
                           spirv::detail::kind_of(b.how, effect.resources[b.resource].kind), writes(b.how)});
    const std::size_t declared = all.size();
    for (const spirv::bound_resource& found : module.bindings) {
        const auto own = all.begin() + static_cast<std::ptrdiff_t>(declared);
        if (std::none_of(all.begin(), own,
                         [&](const wanted_binding& w) { return w.set == found.set && w.slot == found.slot; }))
            all.push_back({found.name, found.name, found.set, found.slot, found.kind, found.writable});
    }
    return all;
}

inline number_kind kind_in(language to, const wanted_binding& b) {
    const bool is_block = b.kind == binding_kind::uniform_block,
               is_buffer = b.kind == binding_kind::storage_block;
    switch (to) {
    case language::hlsl:
        return is_block       ? number_kind::b_register
               : b.is_written ? number_kind::u_register
                              : number_kind::t_register;
    case language::msl:
        return is_block || is_buffer ? number_kind::buffer_index : number_kind::texture_index;
    default:
        return is_block                                ? number_kind::uniform_block
               : is_buffer                             ? number_kind::shader_storage
               : b.kind == binding_kind::sampled_image ? number_kind::texture_unit
                                                       : number_kind::image_unit;
    }
}

/// Gives bindings the numbers of a language: those that the host wants, and to the others in their order the
/// least that are left, each kind counted apart. Samplers are another kind.
class numbering {
public:
    numbering(const pass& which, const target& to) : title_(title_of(which, to)), to_(to) {}

    /// @throws error  where the host gives one number to two
    std::vector<placed_binding> place(const std::vector<wanted_binding>& wanted) {
        std::vector<placed_binding> placed(wanted.size());
        for (const bool is_asked_for : {true, false})
            for (std::size_t i = 0; i < wanted.size(); ++i)
                place(placed[i], wanted[i], is_asked_for);
        return placed;
    }

private:
    static constexpr int sampler_kind = -1; // beside those of number_kind

    std::string title_;
    const target& to_;
    std::map<std::tuple<int, unsigned, unsigned>, std::string> taken_; // kind, space, number

    /// Sets the numbers that are asked for, or those that are not.
    void place(placed_binding& placed, const wanted_binding& wanted, bool is_asked_for) {
        const auto found = to_.places.find(wanted.name);
        const auto asked = found == to_.places.end() ? translate::place{} : found->second;
        const bool has_sampler = (to_.to == language::hlsl || to_.to == language::msl) &&
                                 wanted.kind == binding_kind::sampled_image;
        placed.name = wanted.name;
        placed.kind = kind_in(to_.to, wanted);
        placed.space = asked.space;
        if (asked.number.has_value() == is_asked_for)
            placed.number = take(static_cast<int>(placed.kind), asked.space, asked.number, wanted.name);
        if (has_sampler && asked.sampler.has_value() == is_asked_for)
            placed.sampler = take(sampler_kind, asked.space, asked.sampler, wanted.name);
        if (asked.space != 0 && (to_.to != language::hlsl || to_.version < 51))
            throw error(title_ + ": '" + wanted.name +
                        "' is given a register space, which HLSL has from 5.1 on");
    }

    unsigned take(int kind, unsigned space, std::optional<unsigned> asked, const std::string& name) {
        unsigned number = asked.value_or(0);
        while (!asked && taken_.contains({kind, space, number}))
            ++number;
        const auto [other, is_free] = taken_.emplace(std::tuple(kind, space, number), name);
        if (!is_free)
            throw error(
                title_ + ": '" + other->second + "' and '" + name + "' are both given " +
                (kind == sampler_kind ? "sampler" : std::string(name_of(static_cast<number_kind>(kind)))) +
                " " + std::to_string(number));
        return number;
    }
};

/// @throws error  where a host names bindings or constants that the effect has not
inline void expect_known(const effect_view& effect, const std::vector<wanted_binding>& bindings,
                         const target& to) {
    std::set<std::string> names, numbers;
    if (to.to == language::msl)
        names.insert(buffer_sizes_name);
    for (const wanted_binding& b : bindings)
        names.insert(b.name);
    for (const pass& each : effect.passes) {
        for (const binding& b : each.bindings)
            if (has_descriptor(b.how))
                names.insert(std::string(b.name));
        for (const constant& c : each.constants)
            numbers.insert(std::string(c.part) + "." + std::string(c.number));
    }
    const auto refuse = [](const char* what, const std::string& name, const std::set<std::string>& all) {
        std::string list;
        for (const std::string& each : all)
            list += (list.empty() ? "" : ", ") + each;
        throw error("the effect has no " + (what + (" '" + name)) + "'; it has " +
                    (list.empty() ? "none" : list));
    };
    for (const auto& [name, place] : to.places)
        if (!names.contains(name))
            refuse("binding", name, names);
    for (const auto& [name, value] : to.constants)
        if (!numbers.contains(name))
            refuse("constant", name, numbers);
}

}
