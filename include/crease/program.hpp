// SPDX-License-Identifier: MIT
#pragma once

#include <crease/interface_text.hpp>
#include <crease/plan.hpp>
#include <crease/stage/fragment.hpp>

namespace crease {

using file_list = fixed_list<const glsl_file*, 40>;
using binding_list = fixed_list<binding, 16>;
using constant_list = fixed_list<constant, 32>;

/// A program before its pieces are joined.
struct program {
    interface_text interface; ///< what stands before the files: version, constants and bindings
    file_list files;
    binding_list bindings;
    constant_list constants;
};

inline constexpr piece fullscreen_vulkan[] = {
    {"interface", "#version 450\n#define CREASE_VERTEX_INDEX gl_VertexIndex\n"}, fullscreen_glsl};
inline constexpr piece fullscreen_opengl[] = {
    {"interface", "#version 430\n#define CREASE_VERTEX_INDEX gl_VertexID\n"}, fullscreen_glsl};

namespace writing {

// A compiler counts the characters of a std::string_view each time that one is made of a literal.
namespace names {
inline constexpr std::string_view none = "", parameters = "parameters", input = "input", output = "output",
                                  compute = "compute", width = "width", height = "height",
                                  divisor = "divisor", input_divisor = "input_divisor",
                                  workgroup = "workgroup", columns = "columns";
}

/// Where the bindings and constants of a program begin: chosen by the host for functions, else 0.
struct places {
    unsigned set = 0, first_binding = 0, first_constant = 0;
};

/// The places that a part's first three numbers give.
constexpr places places_of(const choice& c) {
    return {static_cast<unsigned>(c.numbers[0]), static_cast<unsigned>(c.numbers[1]),
            static_cast<unsigned>(c.numbers[2])};
}

/// Collects what a program is made of, for one plan.
class program_writer {
public:
    /// @param roles  whose parts' functions the program calls
    constexpr program_writer(const plan& of, array_view<const role> roles, bool has_main, places at)
        : plan_(of), has_main_(has_main), at_(at),
          vulkan_(of.chosen(role::dialect).what->dialect_of == dialect_kind::vulkan),
          next_id_(at.first_constant) {
        for (role r : roles)
            if (const choice* c = of.find(r))
                called_[called_count_++] = c;
    }

    program out;

    constexpr void add_file(const glsl_file* file) {
        if (!file)
            return;
        for (const glsl_file* before : out.files)
            if (before == file)
                return;
        out.files.add(file);
    }

    constexpr void add_files(array_view<const glsl_file* const> files) {
        for (const glsl_file* file : files)
            add_file(file);
    }

    constexpr void add_file_of(const encoding& e) {
        add_file(e.helper);
        add_file(e.glsl);
    }

    /// The files of the parts that are called; an extra comes after its part, where another of them needs it.
    constexpr void add_files_of_called() {
        for (std::size_t i = 0; i < called_count_; ++i) {
            const part& p = *called_[i]->what;
            add_files(p.helpers);
            add_file(p.glsl);
            for (std::size_t e = 0; e < p.extras.count; ++e)
                for (std::size_t other = 0; other < called_count_; ++other)
                    if (called_[other]->what->needs.count != 0 &&
                        has(called_[other]->what->needs, p.extras.items[e].on_need))
                        add_file(p.extras.items[e].glsl);
        }
    }

    constexpr void add_constants_of_called() {
        for (std::size_t i = 0; i < called_count_; ++i)
            add_constants_of(*called_[i]);
    }

    constexpr void add_constants_of(const choice& c) {
        for (const constant& before : out.constants)
            if (before.part == c.what->name)
                return;
        for (std::size_t i = 0; i < c.what->numbers.size(); ++i)
            if (c.what->numbers[i].in_glsl)
                out.constants.add({c.what->name, c.what->numbers[i].name, next_id_++, c.numbers[i]});
    }

    constexpr void add_workgroup(int width, int height) {
        out.constants.add({names::compute, names::width, next_id_++, width});
        out.constants.add({names::compute, names::height, next_id_++, height});
    }

    /// @param name  in GLSL
    constexpr void bind(std::string_view name, unsigned resource, access how) {
        out.bindings.add({.name = name, .resource = resource, .how = how});
    }

    /// What is there already is not added again.
    constexpr void bind_read(std::string_view name, unsigned resource) {
        for (const binding& before : out.bindings)
            if (before.resource == resource)
                return;
        bind(name, resource, plan_.resources[resource].read);
    }

    constexpr void bind_resources_of_called(int view) {
        for (std::size_t i = 0; i < called_count_; ++i)
            for (const resource& used : called_[i]->what->resources)
                bind_read(used.name, plan_.index_of(used.name, view));
    }

    // Vulkan counts all bindings of a set; OpenGL counts blocks, textures and images apart.
    constexpr void number_bindings() {
        binding_list& list = out.bindings;
        for (std::size_t i = 0; i < list.size(); ++i) {
            unsigned before = 0;
            const bool described = has_descriptor(list[i].how);
            for (std::size_t j = 0; j < i; ++j)
                before += described
                              ? has_descriptor(list[j].how) && (vulkan_ || kind(list[j]) == kind(list[i]))
                              : list[j].how == list[i].how;
            list[i].slot = before + (described ? at_.first_binding : 0);
            list[i].set = described && vulkan_ ? at_.set : 0;
        }
    }

    constexpr void write_version() {
        if (has_main_)
            out.interface << (vulkan_ ? "#version 450\n#extension GL_EXT_control_flow_attributes : enable\n"
                                      : "#version 430\n");
        for (std::size_t i = 0; has_main_ && i < called_count_; ++i)
            if (!called_[i]->what->extension.empty())
                out.interface << "#extension " << called_[i]->what->extension << " : require\n";
        // A host that takes functions writes its own #version and #extension.
        out.interface << "#define crease_unroll" << (has_main_ && vulkan_ ? " [[unroll]]\n" : "\n");
    }

    constexpr void write_workgroup(std::size_t& first) {
        out.interface << "layout(local_size_x = " << out.constants[0].value
                      << ", local_size_y = " << out.constants[1].value;
        if (vulkan_)
            out.interface << ", local_size_x_id = 0, local_size_y_id = 1";
        out.interface << ") in;\n";
        first = 2;
    }

    constexpr void write_constants(std::size_t first) {
        for (std::size_t i = first; i < out.constants.size(); ++i) {
            const constant& c = out.constants[i];
            if (vulkan_)
                out.interface << "layout(constant_id = " << c.id << ") ";
            write_constant(c.part, c.number, c.value);
        }
    }

    constexpr void write_constant(std::string_view part, std::string_view name, int value) {
        out.interface << "const int crease_" << part << (part.empty() ? "" : "_") << name << " = " << value
                      << ";\n";
    }

    /// Which camera the program works for; one for both begins with the first and turns to the second itself.
    constexpr void write_view(int view) {
        out.interface << (view < 0 ? "" : "const ") << "int crease_view_index = " << (view < 0 ? 0 : view)
                      << ";\n";
    }

    constexpr void write_declarations() {
        for (std::size_t i = 1; i < out.bindings.size(); ++i)
            write_declaration(out.bindings[i]);
        out.interface << "#define crease_parameters_place std140";
        write_place(out.bindings[0]);
        out.interface << "\n";
    }

private:
    // Images that are stored to, changed or loaded share their units.
    static constexpr access kind(const binding& b) {
        return b.how == access::modify || b.how == access::load ? access::store : b.how;
    }

    constexpr void write_place(const binding& b) {
        if (vulkan_)
            out.interface << ", set = " << b.set;
        out.interface << ", binding = " << b.slot;
    }

    constexpr void write_declaration(const binding& b) {
        const resource& r = plan_.resources[b.resource];
        const format_facts& texels = facts_of(r.texels);
        const char* prefix = texels.whole_numbers ? "u" : "";
        const char* shape = r.samples > 1 ? "2DMS" : r.arrayed ? "2DArray" : "2D";
        interface_text& text = out.interface;
        if (b.how == access::sample) {
            text << "layout(" << (vulkan_ ? "set = " : "binding = ");
            if (vulkan_)
                text << b.set << ", binding = ";
            text << b.slot << ") uniform " << prefix << "sampler" << shape << " crease_" << b.name << ";\n";
        } else if (kind(b) == access::store) {
            text << "layout(" << texels.glsl;
            write_place(b);
            text << ") uniform "
                 << (b.how == access::store  ? "writeonly "
                     : b.how == access::load ? "readonly "
                                             : "")
                 << prefix << "image" << shape << " crease_" << b.name << ";\n";
        } else if (b.how == access::attachment && has_main_) {
            text << "layout(location = " << b.slot << ") out " << prefix << "vec4 crease_" << b.name << ";\n";
        }
    }

    const plan& plan_;
    const choice* called_[role_count]{};
    std::size_t called_count_ = 0;
    bool has_main_;
    places at_;
    bool vulkan_;
    unsigned next_id_;
};

/// How a result leaves a pass: `#define crease_write(pixel, result) ...`, a statement for each image.
constexpr void write_results(program_writer& to, const plan& p, const planned_pass& pass, stage_kind stage) {
    const part& output = *p.chosen(role::output).what;
    interface_text& text = to.out.interface;
    text << "#define crease_write(pixel, result)";
    for (std::size_t i = 0; i < pass.outputs.size(); ++i) {
        const encoding& e = pass.last ? *output.final_images[i] : *output.between;
        const std::string_view image = i == 0 ? names::output : e.name;
        if (stage == stage_kind::compute)
            text << " imageStore(crease_" << image << ", pixel, crease_encode_" << e.name << "(result));";
        else
            text << " crease_" << image << " = crease_encode_" << e.name << "(result);";
    }
    text << "\n";
}

constexpr stage_kind stage_of(const plan& p, const planned_pass& pass) {
    return pass.what->kind == step_kind::evaluate ? p.chosen(role::stage).what->stage_of
                                                  : stage_kind::compute;
}

/// A pass of the chain: the main pass or a filter's.
constexpr program write_evaluate(const plan& p, const planned_pass& pass) {
    const choice& stage = p.chosen(role::stage);
    const stage_kind kind = stage.what->stage_of;
    const bool functions = kind == stage_kind::functions;
    const part& output = *p.chosen(role::output).what;
    program_writer to(p, pass.what->includes, !functions, functions ? places_of(stage) : places{});

    to.add_file(&parameters_glsl);
    to.add_file(&types_glsl);
    to.add_file(output.result);
    const bool is_main = pass.what == &main_step;
    if (is_main)
        to.add_file(&receiver_glsl);
    to.add_files_of_called();
    if (is_main) {
        const choice* fold = p.find(role::fold);
        if (!fold) {
            const glsl_file* of_source = p.chosen(role::depth_source).what->fold;
            to.add_file(of_source ? of_source : p.chosen(role::estimator).what->fold);
        }
        to.add_file(&batch_glsl);
        to.add_file(fold && fold->what->gather ? fold->what->gather : &gather_glsl);
        to.add_file(&strength_glsl);
        to.add_file(&receive_glsl);
    }
    if (pass.input >= 0)
        to.add_file_of(*output.between);
    if (!functions) {
        if (!pass.last)
            to.add_file_of(*output.between);
        else
            for (const encoding* image : output.final_images)
                to.add_file_of(*image);
    }
    to.add_file(pass.body);
    to.add_file(stage.what->glsl);

    to.bind(names::parameters, 0, access::uniform);
    to.bind_resources_of_called(0);
    for (std::string_view name : pass.what->reads)
        to.bind_read(name, p.index_of(name));
    if (pass.input >= 0)
        to.bind_read(names::input, static_cast<unsigned>(pass.input));
    constexpr access of_stage[] = {access::store, access::attachment, access::result};
    for (std::size_t i = 0; i < pass.outputs.size(); ++i)
        to.bind(i == 0 ? names::output : p.resources[pass.outputs[i]].name, pass.outputs[i],
                of_stage[static_cast<unsigned>(kind)]);
    to.number_bindings();

    if (kind == stage_kind::compute)
        to.add_workgroup(stage.numbers[0], stage.numbers[1]);
    to.add_constants_of_called();
    to.add_constants_of(pass.owner);

    std::size_t first = 0;
    to.write_version();
    if (kind == stage_kind::compute)
        to.write_workgroup(first);
    to.write_constants(first);
    for (const step_constant& c : pass.what->constants)
        to.write_constant(c.of.empty() ? pass.owner.what->name : c.of, c.name, c.value);
    to.write_constant(names::none, names::divisor, static_cast<int>(pass.size.divisor));
    if (kind == stage_kind::compute)
        to.write_constant(names::workgroup, names::columns, pass.what->columns);
    if (pass.input >= 0)
        to.write_constant(names::none, names::input_divisor, static_cast<int>(pass.input_divisor));
    to.write_view(pass.view);
    if (pass.input >= 0)
        to.out.interface << "#define crease_decode crease_decode_" << output.between->name << "\n";
    if (!functions)
        write_results(to, p, pass, kind);
    to.write_declarations();
    return to.out;
}

constexpr const glsl_file* shell_of(step_kind kind) {
    return kind == step_kind::build  ? &build_glsl
           : kind == step_kind::rows ? &build_rows_glsl
                                     : &build_columns_glsl;
}

/// A pass of the depth source, which fills what the main pass reads: always a compute program.
constexpr program write_build(const plan& p, const planned_pass& pass) {
    const step& s = *pass.what;
    program_writer to(p, s.includes, true, {});
    to.add_file(&parameters_glsl);
    to.add_file(&types_glsl);
    to.add_files_of_called();
    if (const choice* fold = p.find(role::fold))
        to.add_file(fold->what->packs);
    for (const choice& c : p.choices)
        for (const extra& e : c.what->extras)
            if (has(s.needs, e.on_need))
                to.add_file(e.glsl);
    to.add_files(s.helpers);
    to.add_file(s.body);
    to.add_file(shell_of(s.kind));

    to.bind(names::parameters, 0, access::uniform);
    to.bind_resources_of_called(pass.view);
    for (std::string_view name : s.reads)
        to.bind_read(name, p.index_of(name, pass.view));
    for (std::size_t i = 0; i < pass.outputs.size(); ++i)
        to.bind(p.resources[pass.outputs[i]].name, pass.outputs[i], s.how);
    to.number_bindings();

    to.add_workgroup(s.group_width, s.group_height);
    to.add_constants_of_called();
    to.add_constants_of(pass.owner);

    std::size_t first = 0;
    to.write_version();
    to.write_workgroup(first);
    to.write_constants(first);
    for (const step_constant& c : s.constants)
        to.write_constant(c.of.empty() ? pass.owner.what->name : c.of, c.name, c.value);
    to.write_constant(names::none, names::divisor, static_cast<int>(pass.size.divisor));
    to.write_view(pass.view);
    to.out.interface << "#define crease_build_size imageSize(crease_" << p.resources[pass.outputs[0]].name
                     << ").xy\n";
    to.write_declarations();
    return to.out;
}

}

/// Writes the program of a pass: compile time and run time alike.
constexpr program write_program(const plan& p, const planned_pass& pass) {
    return pass.what->kind == step_kind::evaluate ? writing::write_evaluate(p, pass)
                                                  : writing::write_build(p, pass);
}

/// Writes what a host adds to its geometry pass.
constexpr program write_program(const plan& p, const planned_capture& capture) {
    const capture_step& s = *capture.what;
    writing::program_writer to(p, s.includes, false, writing::places_of(capture.owner));
    to.add_file(&parameters_glsl);
    to.add_file(&types_glsl);
    to.add_files_of_called();
    to.add_files(s.helpers);
    to.add_file(s.body);
    to.bind(writing::names::parameters, 0, access::uniform);
    to.bind_resources_of_called(0);
    to.bind(s.writes, capture.output, s.how);
    to.number_bindings();
    to.add_constants_of(p.chosen(role::depth_source));
    to.add_constants_of_called();
    to.write_constants(0);
    to.write_view(capture.view);
    to.write_declarations();
    return to.out;
}

/// The pass without its lists.
constexpr pass describe(const plan& p, const planned_pass& planned) {
    const stage_kind stage = writing::stage_of(p, planned);
    const dialect_kind dialect = p.chosen(role::dialect).what->dialect_of;
    pass described{.name = planned.what->name,
                   .stage = stage,
                   .dialect = dialect,
                   .pieces = {},
                   .vertex_pieces = {},
                   .bindings = {},
                   .constants = {},
                   .size = planned.size,
                   .covers = planned.what->kind == step_kind::rows      ? dispatch::rows
                             : planned.what->kind == step_kind::columns ? dispatch::columns
                                                                        : dispatch::texels};
    if (stage == stage_kind::fragment)
        described.vertex_pieces = dialect == dialect_kind::vulkan ? fullscreen_vulkan : fullscreen_opengl;
    return described;
}

/// The capture without its lists.
constexpr capture describe(const plan& p, const planned_capture& planned) {
    return {.name = planned.view == 0 ? planned.what->name : p.resources[planned.output].name,
            .dialect = p.chosen(role::dialect).what->dialect_of,
            .pieces = {},
            .bindings = {},
            .constants = {},
            .size = p.resources[planned.output].size};
}

}
