// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/effect_view.hpp>
#include <crease/spirv/reflection.hpp>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace crease::spirv::detail {

constexpr std::string_view name_of(binding_kind kind) {
    constexpr std::string_view names[] = {"a uniform block", "a storage block", "a sampled image",
                                          "a storage image", "another kind of descriptor"};
    return names[static_cast<unsigned>(kind)];
}

constexpr binding_kind kind_of(access how, resource_kind of) {
    return how == access::uniform        ? binding_kind::uniform_block
           : of == resource_kind::buffer ? binding_kind::storage_block
           : how == access::sample       ? binding_kind::sampled_image
                                         : binding_kind::storage_image;
}

/// Compares one module with one pass, and collects a sentence for each difference.
class comparison {
public:
    comparison(const effect_view& effect, const pass& declared, const reflection& found)
        : effect_(effect), title_("pass '" + std::string(declared.name) + "'"), bindings_(declared.bindings),
          constants_(declared.constants), found_(found) {
        if (declared.stage != stage_kind::geometry)
            compare_entry(declared);
        compare_bindings();
        compare_constants();
        if (declared.stage == stage_kind::compute)
            compare_workgroup(declared);
    }
    std::vector<std::string> sentences;

private:
    const effect_view& effect_;
    std::string title_;
    std::span<const binding> bindings_;
    std::span<const constant> constants_;
    const reflection& found_;

    void say(std::string sentence) { sentences.push_back(title_ + ": " + std::move(sentence)); }
    void differ(const std::string& what, const std::string& declared, const std::string& found) {
        if (declared != found)
            say(what + " is declared as " + declared + ", but the SPIR-V has " + found);
    }

    static std::string place(std::uint32_t set, std::uint32_t slot) {
        return "set " + std::to_string(set) + " binding " + std::to_string(slot);
    }

    void compare_entry(const pass& of) {
        const bool compute = of.stage == stage_kind::compute;
        if (found_.model != (compute ? execution_model::compute : execution_model::fragment))
            say(std::string("the SPIR-V is not a ") + (compute ? "compute" : "fragment") + " shader");
        if (found_.entry_point != "main")
            say("the entry point is '" + found_.entry_point + "', not 'main'");
        std::vector<std::uint32_t> declared, found;
        for (const binding& b : bindings_)
            if (b.how == access::attachment)
                declared.push_back(b.slot);
        for (const colour_output& colour : found_.colours)
            found.push_back(colour.location);
        if (!compute && declared != found)
            say("its attachments want colour outputs of " + locations(declared) + ", but the SPIR-V has " +
                locations(found));
    }

    static std::string locations(const std::vector<std::uint32_t>& all) {
        std::string text = all.empty() ? "no location" : all.size() == 1 ? "location" : "locations";
        for (std::size_t i = 0; i < all.size(); ++i)
            text += (i == 0 ? " " : ", ") + std::to_string(all[i]);
        return text;
    }

    void compare_bindings() {
        std::size_t declared_count = 0;
        for (const binding& b : bindings_) {
            if (!has_descriptor(b.how))
                continue;
            ++declared_count;
            const auto at = std::ranges::find_if(found_.bindings, [&b](const bound_resource& f) {
                return f.set == b.set && f.slot == b.slot;
            });
            if (at == found_.bindings.end())
                say("the SPIR-V has nothing at " + place(b.set, b.slot) + ", where crease_" +
                    std::string(b.name) + " is declared");
            else
                compare_binding(b, *at);
        }
        for (const bound_resource& f : found_.bindings) {
            const bool declared = std::ranges::any_of(bindings_, [&f](const binding& b) {
                return has_descriptor(b.how) && b.set == f.set && b.slot == f.slot;
            });
            if (!declared)
                say("the SPIR-V has " + f.name + " at " + place(f.set, f.slot) +
                    ", where nothing is declared");
        }
    }

    void compare_binding(const binding& b, const bound_resource& f) {
        const resource& r = effect_.resources[b.resource];
        const std::string what = place(b.set, b.slot), name = "crease_" + std::string(b.name);
        const binding_kind kind = kind_of(b.how, r.kind);
        differ(what, kind == binding_kind::storage_block ? name + "_buffer" : name, f.name);
        differ(name, std::string(name_of(kind)), std::string(name_of(f.kind)));
        if (f.kind != kind)
            return;
        if (b.how == access::uniform)
            return compare_block(f);
        if (b.how == access::load && f.writable)
            say(name + " is declared as loaded, but the SPIR-V may store to it");
        if (writes(b.how) && !f.writable)
            say(name + " is declared as stored to, but the SPIR-V only reads it");
        if (r.kind == resource_kind::image)
            compare_image(b, r, f, name);
    }

    void compare_image(const binding& b, const resource& image, const bound_resource& f,
                       const std::string& name) {
        if (writes(b.how) || b.how == access::load)
            differ("the format of " + name, std::string(facts_of(image.texels).name),
                   std::string(facts_of(f.texels).name));
        if (b.how == access::store && f.readable && f.writable)
            say(name + " is declared as stored to, but the SPIR-V may also read it");
        if (b.how == access::modify && !f.readable)
            say(name + " is declared as changed, but the SPIR-V only stores to it");
        const bool whole_numbers = facts_of(image.texels).whole_numbers;
        if (f.component != (whole_numbers ? scalar_kind::unsigned_integer : scalar_kind::floating_point))
            say(name + " holds " + std::string(facts_of(image.texels).name) +
                ", which the SPIR-V accesses as another type");
        if (f.arrayed != image.arrayed)
            say(name + " is declared as " + (image.arrayed ? "an array" : "no array") +
                ", but in the SPIR-V it is " + (f.arrayed ? "one" : "none"));
        if (f.multisampled != (image.samples > 1))
            say(name + " is declared with " + std::to_string(image.samples) +
                (image.samples == 1 ? " sample" : " samples") + ", but in the SPIR-V it is " +
                (f.multisampled ? "multisampled" : "not multisampled"));
    }

    /// A member of the block of parameters, and where `write_block` writes it.
    struct written_member {
        std::string name;
        std::size_t offset;
    };

    std::vector<written_member> written_members() const {
        std::size_t at = effect_.views * sizeof(view_parameters);
        std::vector<written_member> members{{"views", 0}};
        if (effect_.views > 1) {
            members.push_back({"from_first", at});
            at += (effect_.views - 1) * sizeof(further_view::from_first);
        }
        members.push_back({"radius", at});
        members.push_back({"frame", at + 4});
        at += 8;
        for (const effect_setting& s : effect_.settings) {
            members.push_back({(s.shared ? "" : std::string(s.part) + "_") + std::string(s.name), at});
            at += sizeof(float);
        }
        return members;
    }

    void compare_block(const bound_resource& block) {
        const std::vector<written_member> written = written_members();
        for (const written_member& each : written) {
            const auto at = std::ranges::find(block.members, each.name, &block_member::name);
            if (at == block.members.end())
                say("the block of parameters in the SPIR-V lacks " + each.name);
            else
                differ("the offset of " + at->name, std::to_string(each.offset), std::to_string(at->offset));
        }
        for (const block_member& member : block.members)
            if (std::ranges::find(written, member.name, &written_member::name) == written.end())
                say("the effect's parameters lack " + member.name + ", which is in the SPIR-V");
        differ("the size of the block of parameters", std::to_string(effect_.block_size()),
               std::to_string(block.size));
    }

    void compare_constants() {
        for (const constant& c : constants_) {
            const std::string name = "crease_" + std::string(c.part) + "_" + std::string(c.number);
            bool there = false;
            for (const specialization_constant& f : found_.constants) {
                if (f.id != c.id)
                    continue;
                there = true;
                const std::string what = "constant_id " + std::to_string(c.id);
                if (!f.name.empty()) // a workgroup size has none
                    differ(what, name, f.name);
                differ("the default of " + name, std::to_string(c.value),
                       std::to_string(static_cast<std::int32_t>(f.value)));
            }
            if (!there)
                say("the SPIR-V has no constant_id " + std::to_string(c.id) + ", which is declared as " +
                    name);
        }
        for (const specialization_constant& f : found_.constants)
            if (std::ranges::find(constants_, f.id, &constant::id) == constants_.end())
                say("the SPIR-V has constant_id " + std::to_string(f.id) +
                    (f.name.empty() ? "" : " (" + f.name + ")") + ", which is not declared");
    }

    void compare_workgroup(const pass& of) {
        if (constants_.size() < 2)
            return say("a compute pass declares its workgroup's width and height as its first two constants");
        const unsigned sizes[] = {of.group_width(), of.group_height(), 1};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const workgroup_axis& found = found_.workgroup[axis];
            const std::string what = std::string("the workgroup's ") + "xyz"[axis];
            differ(what, std::to_string(sizes[axis]), std::to_string(found.size));
            if (axis < 2 && found.id != constants_[axis].id)
                say(what + " is not set by constant_id " + std::to_string(constants_[axis].id));
        }
    }
};

}

namespace crease::spirv {

/// What a module, as compile() gives it, has otherwise than its effect declares: bindings, their names, kinds
/// and formats, the layout of the block of parameters, specialization constants, workgroup size, colour
/// output.
/// @param declared  a compute, fragment or geometry pass of `effect`; of the last the module is the host's
/// fragment
///                  shader with its functions, whose bindings are all there are
/// @return one sentence for each difference; empty where there is none
inline std::vector<std::string> mismatches(const effect_view& effect, const pass& declared,
                                           const reflection& found) {
    return detail::comparison(effect, declared, found).sentences;
}

}
