// SPDX-License-Identifier: MIT
#pragma once

#include <crease/plan.hpp>
#include <crease/stage/fragment.hpp>

namespace crease {

using file_list = fixed_list<const glsl_file*, 32>;
using binding_list = fixed_list<binding, 16>;
using constant_list = fixed_list<constant, 24>;
using interface_text = fixed_text<3072>;

inline constexpr piece fullscreen_vulkan[] = {
    {"interface", "#version 450\n#define CREASE_VERTEX_INDEX gl_VertexIndex\n"}, fullscreen_glsl};
inline constexpr piece fullscreen_opengl[] = {
    {"interface", "#version 430\n#define CREASE_VERTEX_INDEX gl_VertexID\n"}, fullscreen_glsl};

/// Writes the programs of a plan, one pass at a time: compile time and run time alike.
class program_writer {
public:
    constexpr program_writer(const plan& of, std::size_t pass)
        : plan_(of), pass_(of.passes[pass]), stage_(of.chosen(role::stage)),
          dialect_(of.chosen(role::dialect).what->dialect_of) {}

    /// The files of the program after its interface, in order.
    constexpr file_list files() const {
        file_list list;
        const auto add = [&list](const glsl_file* file) {
            for (const glsl_file* before : list)
                if (before == file)
                    return;
            if (file)
                list.add(file);
        };
        add(&parameters_glsl);
        add(&types_glsl);
        for (role r : pass_.what->includes) {
            const part& p = *plan_.chosen(r).what;
            for (const glsl_file* helper : p.helpers)
                add(helper);
            add(p.glsl);
        }
        if (is_main())
            add(fold());
        if (pass_.what->input)
            add(pass_.what->input->glsl);
        if (!is_functions())
            add(pass_.result->glsl);
        add(pass_.what->body);
        add(stage_.what->glsl);
        return list;
    }

    constexpr binding_list bindings() const {
        binding_list list;
        list.add({.name = "parameters", .resource = 0, .how = access::uniform});
        for (role r : pass_.what->includes)
            for (const resource& used : plan_.chosen(r).what->resources)
                add_sampled(list, used.name, plan_.index_of(used.name));
        for (std::string_view name : pass_.what->reads)
            add_sampled(list, name, plan_.index_of(name));
        if (pass_.input >= 0)
            add_sampled(list, "input", static_cast<unsigned>(pass_.input));
        list.add({.name = "output", .resource = pass_.output, .how = output_access()});
        number_bindings(list);
        return list;
    }

    constexpr constant_list constants() const {
        constant_list list;
        unsigned id = is_functions() ? static_cast<unsigned>(stage_.numbers[2]) : 0;
        const auto add = [&](const choice& c) {
            for (const constant& before : list)
                if (before.part == c.what->name)
                    return;
            for (std::size_t i = 0; i < c.what->numbers.size(); ++i)
                list.add({c.what->name, c.what->numbers[i].name, id++, c.numbers[i]});
        };
        if (stage_.what->stage_of == stage_kind::compute)
            add(stage_);
        for (role r : pass_.what->includes)
            add(plan_.chosen(r));
        add(pass_.owner);
        return list;
    }

    /// What stands before the files: version, constants and bindings.
    constexpr interface_text interface() const {
        interface_text out;
        if (!is_functions())
            out << (dialect_ == dialect_kind::vulkan ? "#version 450\n" : "#version 430\n");
        const constant_list numbers = constants();
        std::size_t first = 0;
        if (stage_.what->stage_of == stage_kind::compute) {
            out << "layout(local_size_x = " << numbers[0].value << ", local_size_y = " << numbers[1].value;
            if (dialect_ == dialect_kind::vulkan)
                out << ", local_size_x_id = 0, local_size_y_id = 1";
            out << ") in;\n";
            first = 2;
        }
        for (std::size_t i = first; i < numbers.size(); ++i) {
            if (dialect_ == dialect_kind::vulkan)
                out << "layout(constant_id = " << numbers[i].id << ") ";
            write_constant(out, numbers[i].part, numbers[i].number, numbers[i].value);
        }
        for (const step_constant& c : pass_.what->constants)
            write_constant(out, pass_.owner.what->name, c.name, c.value);
        write_constant(out, "", "divisor", static_cast<int>(pass_.divisor));
        if (pass_.what->input) {
            write_constant(out, "", "input_divisor", static_cast<int>(pass_.input_divisor));
            out << "#define crease_decode crease_decode_" << pass_.what->input->name << "\n";
        }
        if (!is_functions())
            out << "#define crease_encode crease_encode_" << pass_.result->name << "\n";
        const binding_list list = bindings();
        for (std::size_t i = 1; i < list.size(); ++i)
            write_declaration(out, list[i]);
        out << "layout(std140"; // goes on in core/parameters.glsl
        write_place(out, list[0]);
        out << ")\n";
        return out;
    }

    /// The vertex shader of a fragment pass; empty for the other stages.
    constexpr std::span<const piece> vertex_pieces() const {
        if (stage_.what->stage_of != stage_kind::fragment)
            return {};
        return dialect_ == dialect_kind::vulkan ? fullscreen_vulkan : fullscreen_opengl;
    }

    /// The pass without its lists.
    constexpr pass describe() const {
        return {.name = pass_.what->name,
                .stage = stage_.what->stage_of,
                .dialect = dialect_,
                .pieces = {},
                .vertex_pieces = {},
                .bindings = {},
                .constants = {},
                .size = {pass_.divisor}};
    }

private:
    constexpr bool is_main() const { return pass_.what == &main_step; }
    constexpr bool is_functions() const { return stage_.what->stage_of == stage_kind::functions; }

    constexpr const glsl_file* fold() const {
        const glsl_file* of_source = plan_.chosen(role::depth_source).what->fold;
        return of_source ? of_source : plan_.chosen(role::estimator).what->fold;
    }

    constexpr access output_access() const {
        constexpr access of_stage[] = {access::store, access::attachment, access::result};
        return of_stage[static_cast<unsigned>(stage_.what->stage_of)];
    }

    static constexpr void add_sampled(binding_list& list, std::string_view name, unsigned resource) {
        for (const binding& before : list)
            if (before.resource == resource)
                return;
        list.add({.name = name, .resource = resource, .how = access::sample});
    }

    static constexpr bool has_slot(const binding& b) {
        return b.how != access::attachment && b.how != access::result;
    }

    // Vulkan counts all bindings of a set; OpenGL counts blocks, textures and images apart.
    constexpr void number_bindings(binding_list& list) const {
        const unsigned first = is_functions() ? static_cast<unsigned>(stage_.numbers[1]) : 0;
        const bool sets = dialect_ == dialect_kind::vulkan;
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (!has_slot(list[i]))
                continue;
            unsigned before = 0;
            for (std::size_t j = 0; j < i; ++j)
                before += has_slot(list[j]) && (sets || list[j].how == list[i].how);
            list[i].slot = first + before;
            list[i].set = is_functions() && sets ? static_cast<unsigned>(stage_.numbers[0]) : 0;
        }
    }

    static constexpr void write_constant(interface_text& out, std::string_view part, std::string_view name,
                                         int value) {
        out << "const int crease_" << part << (part.empty() ? "" : "_") << name << " = " << value << ";\n";
    }

    constexpr void write_place(interface_text& out, const binding& b) const {
        if (dialect_ == dialect_kind::vulkan)
            out << ", set = " << b.set;
        out << ", binding = " << b.slot;
    }

    constexpr void write_declaration(interface_text& out, const binding& b) const {
        const format texels = plan_.resources[b.resource].texels;
        const std::string_view prefix = texels == format::r32_uint ? "u" : "";
        if (b.how == access::sample) {
            out << "layout(" << (dialect_ == dialect_kind::vulkan ? "set = " : "binding = ");
            if (dialect_ == dialect_kind::vulkan)
                out << b.set << ", binding = ";
            out << b.slot << ") uniform " << prefix << "sampler2D crease_" << b.name << ";\n";
        } else if (b.how == access::store) {
            out << "layout(" << glsl_format(texels);
            write_place(out, b);
            out << ") uniform writeonly " << prefix << "image2D crease_" << b.name << ";\n";
        } else if (b.how == access::attachment) {
            out << "layout(location = 0) out " << prefix << "vec4 crease_" << b.name << ";\n";
        }
    }

    const plan& plan_;
    const planned_pass& pass_;
    const choice& stage_;
    dialect_kind dialect_;
};

}
