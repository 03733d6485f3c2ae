// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/interface_text.hpp>
#include <crease/compose/linker.hpp>
#include <crease/compose/plan.hpp>
#include <crease/effect/version.hpp>
#include <crease/parts/dialect/glsl_es.hpp>
#include <crease/parts/reads/image_load.hpp>
#include <crease/parts/stage/fragment.hpp>

namespace crease {

using file_list = fixed_list<const glsl_file*, 96>;
using binding_list = fixed_list<binding, 16>;
using constant_list = fixed_list<constant, 32>;

/// A program before its pieces are joined. Bindings name resources of the plan.
struct program {
    interface_text head; // no `interface`, which <windows.h> defines
    fixed_list<linker::linked, 192> definitions;
    binding_list bindings;
    constant_list constants;
    bool sets_view = false; ///< whether the last definition begins by setting `crease_view`
    bool cut = false;       ///< whether any of it did not fit
};

/// The GLSL files in which a pass finds what it calls, the first before the others.
constexpr file_list files_of(const plan& p, const planned_pass& pass) {
    file_list files;
    const auto add = [&](array_view<const glsl_file* const> own) {
        for (const glsl_file* file : own)
            files.add(file);
    };
    const auto widen = [&](const files_where& widened) {
        if (widened.needed && p.needs(widened.needed))
            add(widened.files);
    };
    widen(pass.what->widened);
    add(pass.what->files);
    switch (pass.what->kind) {
    case step_kind::texels:
        files.add(&build_glsl);
        break;
    case step_kind::rows:
        files.add(&build_rows_glsl);
        break;
    case step_kind::columns:
        files.add(&build_columns_glsl);
        break;
    default:
        break;
    }
    if (p.is_glsl_es_300())
        files.add(&glsl_es_300_glsl);
    for (const choice& c : p.parts)
        if (c.what->kind != role::stage || pass.what->kind == step_kind::result) {
            if (pass.what == &main_step)
                add(c.what->main_files);
            for (const files_where& widened : c.what->widened)
                widen(widened);
            add(c.what->files);
        }
    for (const glsl_file* file : core_files)
        files.add(file);
    return files;
}

/// Writes the program of one pass of a plan.
class program_writer {
public:
    constexpr program_writer(const plan& of, const planned_pass& pass, linker& found)
        : plan_(of), pass_(pass), found_(found), is_vulkan_(of.is_vulkan()),
          is_es_(of.dialect() == dialect_kind::glsl_es), is_webgpu_(of.dialect() == dialect_kind::webgpu),
          has_sets_(is_vulkan_ || is_webgpu_), sets_globals_(is_es_ || is_webgpu_),
          has_bindings_(!of.is_glsl_es_300()), is_result_(pass.what->kind == step_kind::result),
          has_main_(pass.stage == stage_kind::compute || pass.stage == stage_kind::fragment) {
        const choice* placed = pass.stage == stage_kind::functions  ? of.find(role::stage)
                               : pass.stage == stage_kind::geometry ? &pass.owner
                                                                    : nullptr;
        if (placed) {
            set_ = static_cast<unsigned>(placed->number_of("set"));
            first_binding_ = static_cast<unsigned>(placed->number_of("first_binding"));
            next_id_ = static_cast<unsigned>(placed->number_of("first_constant"));
            // A shader may hold the functions of several passes.
            set_ += pass.in_chain;
            next_id_ += pass.in_chain * static_cast<unsigned>(constant_list::capacity);
        }
    }

    constexpr program write() {
        use_roots();
        if (sets_globals_ && uses("view")) {
            found_.use_in_last(symbol_of("view_index", crease_prefix));
            found_.use_in_last(symbol_of("view_of", crease_prefix));
            out_.sets_view = true;
        }
        collect_bindings();
        collect_constants();
        write_head();
        write_constants();
        for (const binding& b : out_.bindings)
            write_declaration(b);
        if (is_webgpu_)
            write_nearest();
        write_block();
        write_accessors();
        write_results();
        out_.definitions = found_.order();
        out_.cut = found_.is_cut() || out_.head.is_cut() || out_.bindings.cut || out_.constants.cut;
        return out_;
    }

private:
    constexpr void use(std::string_view name) { found_.use(symbol_of(name, crease_prefix)); }
    constexpr bool uses(std::string_view name) const {
        return found_.is_used(symbol_of(name, crease_prefix));
    }
    constexpr bool uses(std::string_view before, std::string_view name) const {
        return found_.is_used(symbol_of(name, symbol_of(before, crease_prefix)));
    }
    constexpr bool uses_number(std::string_view part, std::string_view number) const {
        return found_.is_used(symbol_of(number, symbol_of("_", symbol_of(part, crease_prefix))));
    }

    constexpr void use_roots() {
        switch (pass_.stage) {
        case stage_kind::functions:
            use(pass_.last ? "visibility" : "handed_on");
            return;
        case stage_kind::geometry:
            use("capture");
            return;
        default:
            break;
        }
        if (is_result_) {
            use("evaluate");
            for (std::size_t i = 0; i < pass_.outputs.size(); ++i)
                found_.use(symbol_of(encoded(i), symbol_of("encode_", crease_prefix)));
        }
        found_.use(main_symbol);
    }

    constexpr std::string_view encoded(std::size_t output) const {
        return pass_.last ? plan_.resources[pass_.outputs[output]].name : std::string_view("between");
    }

    constexpr bool is_output(std::size_t resource) const {
        for (unsigned output : pass_.outputs)
            if (output == resource)
                return true;
        return false;
    }

    constexpr void bind(std::string_view name, std::size_t resource, access how) {
        out_.bindings.add({.name = name, .resource = static_cast<unsigned>(resource), .how = how});
    }
    constexpr void bind_level(std::string_view name, std::size_t resource, access how, unsigned level) {
        bind(name, resource, how);
        if (plan_.resources[resource].levels > 1)
            out_.bindings[out_.bindings.size() - 1].level = level;
    }

    constexpr access read_access(const resource& r) const {
        if (r.kind == resource_kind::buffer)
            return access::load;
        const bool loads = has(plan_.chosen(role::image_reads).what->offers, &image_loads::value);
        // A storage image shows one level.
        return r.read == access::load && loads && r.levels == 1 ? access::load : access::sample;
    }

    constexpr bool uses_block() const {
        if (uses("given") || uses("radius") || uses("frame"))
            return true;
        for (const effect_setting& s : plan_.settings)
            if (uses_setting(s))
                return true;
        return false;
    }
    constexpr bool uses_setting(const effect_setting& s) const {
        return s.shared ? uses(s.name) : uses_number(s.part, s.name);
    }

    constexpr void collect_bindings() {
        if (uses_block())
            bind("parameters", 0, access::uniform);
        for (std::size_t i = 1; i < plan_.resources.size(); ++i) {
            const resource& r = plan_.resources[i];
            const bool has_copies = !r.further_names.empty();
            const std::size_t own = has_copies ? i + pass_.view : i;
            if (!is_output(own) && r.life != lifetime::output &&
                (uses(r.name) || uses("load_", r.name) || uses("size_of_", r.name) ||
                 uses("levels_of_", r.name)))
                bind(r.name, own, read_access(r));
            if (has_copies)
                i += plan_.views - 1;
        }
        if (pass_.input >= 0) {
            const auto input = static_cast<std::size_t>(pass_.input);
            bind("input", input, read_access(plan_.resources[input]));
        } else if (pass_.what->further_levels && pass_.level > 0) {
            bind_level("input", pass_.outputs[0], access::sample, pass_.level - 1);
        }
        for (std::size_t i = 0; i < pass_.outputs.size(); ++i) {
            const unsigned at = pass_.outputs[i];
            if (!is_result_) {
                const std::string_view name = pass_.what->writes[i];
                if (pass_.what->how == access::attachment || uses(name) || uses("load_", name))
                    bind_level(name, at, pass_.what->how, pass_.level);
            } else {
                bind(i == 0 ? std::string_view("output") : plan_.resources[at].name, at,
                     pass_.stage == stage_kind::compute    ? access::store
                     : pass_.stage == stage_kind::fragment ? access::attachment
                                                           : access::result);
            }
        }
        number_bindings();
    }

    // Vulkan counts all bindings of a set; OpenGL counts blocks, textures, images and buffers apart.
    constexpr void number_bindings() {
        binding_list& list = out_.bindings;
        for (std::size_t i = 0; i < list.size(); ++i) {
            unsigned before = 0;
            const bool described = has_descriptor(list[i].how);
            for (std::size_t j = 0; j < i; ++j)
                before += described ? has_descriptor(list[j].how) && (has_sets_ || is_like(list[j], list[i]))
                                    : list[j].how == list[i].how;
            list[i].slot = before + (described ? first_binding_ : 0);
            list[i].set = described && has_sets_ ? set_ : 0;
        }
    }
    constexpr bool is_buffer(const binding& b) const {
        return plan_.resources[b.resource].kind == resource_kind::buffer;
    }
    static constexpr bool is_storage(access how) {
        return how == access::load || how == access::store || how == access::modify;
    }
    constexpr bool is_like(const binding& a, const binding& b) const {
        return is_buffer(a) == is_buffer(b) && (a.how == b.how || (is_storage(a.how) && is_storage(b.how)));
    }

    constexpr void collect_constants() {
        if (pass_.stage == stage_kind::compute) {
            const choice& stage = plan_.chosen(role::stage);
            out_.constants.add(
                {"compute", "width", next_id_++, is_result_ ? stage.numbers[0] : pass_.what->group_width});
            out_.constants.add(
                {"compute", "height", next_id_++, is_result_ ? stage.numbers[1] : pass_.what->group_height});
        }
        add_constants_of(pass_.owner);
        for (const choice& c : plan_.parts)
            add_constants_of(c);
    }
    constexpr void add_constants_of(const choice& c) {
        for (const constant& before : out_.constants)
            if (before.part == c.what->name)
                return;
        for (std::size_t i = 0; i < c.what->numbers.size(); ++i)
            if (uses_number(c.what->name, c.what->numbers[i].name))
                out_.constants.add({c.what->name, c.what->numbers[i].name, next_id_++, c.numbers[i]});
    }

    constexpr const char* version_line() const {
        return has_sets_       ? "#version 450\n"
               : !is_es_       ? "#version 430\n"
               : has_bindings_ ? "#version 310 es\n"
                               : "#version 300 es\n";
    }

    constexpr void write_head() {
        interface_text& text = out_.head;
        // Nothing may stand before the version in GLSL ES.
        if (has_main_ && is_es_)
            text << version_line();
        text << "// " << plan_.recipe.view() << ", pass " << pass_.what->name << "; crease " << version
             << ", SPDX-License-Identifier: MIT-0\n";
        if (has_main_ && !is_es_)
            text << version_line();
        if (has_main_ && is_vulkan_ && uses("unroll"))
            text << "#extension GL_EXT_control_flow_attributes : enable\n";
        if (has_main_ && is_webgpu_)
            text << "#extension GL_EXT_samplerless_texture_functions : require\n";
        for (const choice& c : plan_.parts)
            if (has_main_ && !c.what->extension.empty() && is_linked(c))
                text << "#extension " << c.what->extension << " : require\n";
        if (has_main_ && is_es_)
            text << "precision highp float;\nprecision highp int;\n";
        // A host that takes functions writes its own #version, #extension and precision.
        if (uses("unroll"))
            text << "#define crease_unroll" << (has_main_ && is_vulkan_ ? " [[unroll]]\n" : "\n");
        if (uses("precise")) // a word that GLSL ES 3.10 and naga lack
            text << "#define crease_precise" << (is_es_ || is_webgpu_ ? "\n" : " precise\n");
        if (pass_.stage != stage_kind::compute)
            return;
        text << "layout(local_size_x = " << out_.constants[0].value
             << ", local_size_y = " << out_.constants[1].value
             << (is_vulkan_ ? ", local_size_x_id = 0, local_size_y_id = 1) in;\n" : ") in;\n");
        if (uses("group_size") && is_webgpu_) // WGSL does not tell
            text << "#define crease_group_size uvec3(" << out_.constants[0].value << ", "
                 << out_.constants[1].value << ", 1)\n";
        else if (uses("group_size"))
            text << "#define crease_group_size gl_WorkGroupSize\n";
    }
    constexpr bool is_linked(const choice& c) const {
        for (const linker::linked& each : found_.order())
            for (const array_view<const glsl_file* const> files : {c.what->files, c.what->main_files})
                for (const glsl_file* file : files)
                    if (each.from->file == file)
                        return true;
        return false;
    }

    constexpr void write_constant(std::string_view part, std::string_view name, int value) {
        out_.head << "const int crease_" << part << (part.empty() ? "" : "_") << name << " = " << value
                  << ";\n";
    }
    constexpr void write_constants() {
        const std::size_t first = pass_.stage == stage_kind::compute ? 2 : 0;
        for (std::size_t i = first; i < out_.constants.size(); ++i) {
            const constant& c = out_.constants[i];
            if (is_vulkan_)
                out_.head << "layout(constant_id = " << c.id << ") ";
            write_constant(c.part, c.number, c.value);
        }
        for (const step_constant& c : pass_.what->constants) {
            const std::string_view part = c.of.empty() ? pass_.owner.what->name : c.of;
            if (uses_number(part, c.name))
                write_constant(part, c.name, c.value);
        }
        if (uses("divisor"))
            write_constant("", "divisor", static_cast<int>(pass_.size.divisor));
        if (uses("input_divisor"))
            write_constant("", "input_divisor", static_cast<int>(pass_.input_divisor));
        // A program for all cameras begins with the first and turns to the others itself.
        if (uses("view_index"))
            out_.head << (is_result_ && plan_.views > 1 ? "" : "const ")
                      << "int crease_view_index = " << pass_.view << ";\n";
    }

    /// Begins a declaration with its layout.
    /// @param first  what stands in it beside the place
    constexpr void write_layout(std::string_view first, const binding& b) {
        if (first.empty() && !has_bindings_)
            return;
        out_.head << "layout(" << first;
        if (has_bindings_) {
            out_.head << (first.empty() ? "" : ", ");
            if (has_sets_)
                out_.head << "set = " << b.set << ", ";
            out_.head << "binding = " << b.slot;
        }
        out_.head << ") ";
    }

    static constexpr const char* prefix_of(const resource& r) {
        return facts_of(r.texels).whole_numbers ? "u" : "";
    }

    constexpr void write_declaration(const binding& b) {
        const resource& r = plan_.resources[b.resource];
        const char* precision = is_es_ ? "highp " : ""; // else that of samplers is low, and images have none
        const char* prefix = prefix_of(r);
        const char* shape = r.samples > 1 ? "2DMS" : r.arrayed ? "2DArray" : "2D";
        interface_text& text = out_.head;
        if (r.kind == resource_kind::buffer) {
            write_layout("std430", b);
            text << (b.how == access::load ? "readonly buffer crease_" : "buffer crease_") << b.name
                 << "_buffer { " << r.element << " crease_" << b.name << "[]; };\n";
        } else if (b.how == access::sample) {
            write_layout("", b);
            text << "uniform " << precision << prefix << (is_webgpu_ ? "texture" : "sampler") << shape
                 << " crease_" << b.name << ";\n";
        } else if (is_storage(b.how)) {
            write_layout(facts_of(r.texels).glsl, b);
            text << "uniform "
                 << (b.how == access::store  ? "writeonly "
                     : b.how == access::load ? "readonly "
                                             : "")
                 << precision << prefix << "image" << shape << " crease_" << b.name << ";\n";
        } else if (b.how == access::attachment && has_main_) {
            text << "layout(location = " << b.slot << ") out " << prefix << "vec4 crease_" << b.name << ";\n";
        }
    }

    /// The nearest texel, clamped to the edge, of an image that has no sampler.
    constexpr void write_nearest() {
        for (const binding& b : out_.bindings)
            if (b.how == access::sample && plan_.resources[b.resource].life == lifetime::input) {
                out_.head << "#define textureLod(image, at, level) texelFetch(image, clamp(ivec2((at) * "
                             "vec2(textureSize(image, 0))), ivec2(0), textureSize(image, 0) - 1), 0)\n";
                return;
            }
    }

    constexpr void write_block() {
        if (out_.bindings.size() == 0 || out_.bindings[0].how != access::uniform)
            return;
        interface_text& text = out_.head;
        text << "\nstruct crease_view_parameters {\n    vec4 from_texel;\n    vec2 depth_unpack;\n"
                "    float far_depth;\n    float guard;\n    vec2 resolution;\n    vec2 texel_size;\n};\n\n";
        write_layout("std140", out_.bindings[0]);
        text << "uniform crease_parameters {\n    crease_view_parameters views[" << plan_.views << "];\n";
        if (plan_.views > 1)
            text << "    mat4 from_first[" << plan_.views - 1 << "];\n";
        text << "    float radius;\n    uint frame;\n";
        for (const effect_setting& s : plan_.settings) {
            text << "    float " << (s.shared ? std::string_view() : s.part) << (s.shared ? "" : "_")
                 << s.name << ";\n";
        }
        text << "} crease_given;\n\n";
        if (uses("radius"))
            write_given("float", "", "radius");
        if (uses("frame"))
            write_given("uint", "", "frame");
        for (const effect_setting& s : plan_.settings)
            if (uses_setting(s))
                write_given("float", s.shared ? std::string_view() : s.part, s.name);
    }
    /// Gives a member of the block a name of its own.
    constexpr void write_given(std::string_view type, std::string_view part, std::string_view name) {
        const std::string_view between = part.empty() ? "" : "_";
        out_.head << (sets_globals_ ? std::string_view("#define") : type) << " crease_" << part << between
                  << name << (sets_globals_ ? " crease_given." : " = crease_given.") << part << between
                  << name << (sets_globals_ ? "\n" : ";\n");
    }

    // How a program reads what a pass writes: the one place that knows of image loads and texel fetches.
    constexpr void write_accessors() {
        interface_text& text = out_.head;
        for (const binding& b : out_.bindings) {
            const resource& r = plan_.resources[b.resource];
            const bool is_image = b.how != access::sample;
            const bool has_levels = r.levels > 1 && b.level == binding::all_levels;
            const char* texel = r.arrayed ? "ivec3" : "ivec2";
            if (uses("load_", b.name))
                text << "\n"
                     << prefix_of(r) << "vec4 crease_load_" << b.name << "(" << texel
                     << (has_levels ? " texel, int level) { return " : " texel) { return ")
                     << (is_image ? "imageLoad(crease_" : "texelFetch(crease_") << b.name
                     << (is_image     ? ", texel); }\n"
                         : has_levels ? ", texel, level); }\n"
                                      : ", texel, 0); }\n");
            if (uses("size_of_", b.name))
                text << "\nivec2 crease_size_of_" << b.name
                     << (has_levels ? "(int level) { return " : "() { return ")
                     << (is_image ? "imageSize(crease_" : "textureSize(crease_") << b.name
                     << (is_image     ? ").xy; }\n"
                         : has_levels ? ", level).xy; }\n"
                                      : ", 0).xy; }\n");
            if (uses("levels_of_", b.name) && is_es_) // which does not tell
                text << "\nint crease_levels_of_" << b.name << "() {\n    ivec2 size = textureSize(crease_"
                     << b.name << ", 0).xy;\n    return min(" << r.levels
                     << ", 1 + findMSB(max(size.x, size.y)));\n}\n";
            else if (uses("levels_of_", b.name))
                text << "\nint crease_levels_of_" << b.name << "() { return textureQueryLevels(crease_"
                     << b.name << "); }\n";
        }
    }

    constexpr std::string_view first_written_image() const {
        for (const binding& b : out_.bindings)
            if (writes(b.how) && !is_buffer(b))
                return b.name;
        return pass_.what->writes[0];
    }

    constexpr void write_results() {
        interface_text& text = out_.head;
        if (uses("build_size"))
            text << "#define crease_build_size imageSize(crease_" << first_written_image() << ").xy\n";
        if (!uses("write"))
            return;
        text << "\n#define crease_write(pixel, result)";
        for (std::size_t i = 0; i < pass_.outputs.size(); ++i) {
            const std::string_view image =
                i == 0 ? std::string_view("output") : plan_.resources[pass_.outputs[i]].name;
            if (pass_.stage == stage_kind::compute)
                text << " imageStore(crease_" << image << ", pixel, crease_encode_" << encoded(i)
                     << "(result));";
            else
                text << " crease_" << image << " = crease_encode_" << encoded(i) << "(result);";
        }
        text << "\n";
    }

    const plan& plan_;
    const planned_pass& pass_;
    linker& found_;
    bool is_vulkan_, is_es_, is_webgpu_, has_sets_;
    bool sets_globals_; ///< whether `main` sets what is uniform, as no global begins with it
    bool has_bindings_, is_result_, has_main_;
    unsigned set_ = 0, first_binding_ = 0, next_id_ = 0;
    program out_;
};

/// Writes the program of a pass out of the symbols of its files: compile time and run time alike.
/// @param files_are_cut  whether there are more files than `file_list` holds
constexpr program write_program(const plan& p, const planned_pass& pass,
                                array_view<const symbol_table* const> files, bool files_are_cut) {
    linker found;
    for (const symbol_table* file : files)
        found.add(*file);
    program written = program_writer(p, pass, found).write();
    written.cut = written.cut || files_are_cut;
    return written;
}

}
