// SPDX-License-Identifier: MIT
#include "described.hpp"

#include "parts.hpp"

#include <cstdint>

namespace crease::c {

namespace {

// The enumerators of C are those of C++; where these are ever moved, this maps them.
#define CREASE_SAME(c_, cpp_) static_assert(static_cast<int>(c_) == static_cast<int>(cpp_))
CREASE_SAME(CREASE_STAGE_COMPUTE, stage_kind::compute);
CREASE_SAME(CREASE_STAGE_FRAGMENT, stage_kind::fragment);
CREASE_SAME(CREASE_STAGE_FUNCTIONS, stage_kind::functions);
CREASE_SAME(CREASE_STAGE_GEOMETRY, stage_kind::geometry);
CREASE_SAME(CREASE_DIALECT_VULKAN, dialect_kind::vulkan);
CREASE_SAME(CREASE_DIALECT_OPENGL, dialect_kind::opengl);
CREASE_SAME(CREASE_DIALECT_GLSL_ES, dialect_kind::glsl_es);
CREASE_SAME(CREASE_DIALECT_WEBGPU, dialect_kind::webgpu);
CREASE_SAME(CREASE_DISPATCH_TEXELS, dispatch::texels);
CREASE_SAME(CREASE_DISPATCH_ROWS, dispatch::rows);
CREASE_SAME(CREASE_DISPATCH_COLUMNS, dispatch::columns);
CREASE_SAME(CREASE_ACCESS_UNIFORM, access::uniform);
CREASE_SAME(CREASE_ACCESS_SAMPLE, access::sample);
CREASE_SAME(CREASE_ACCESS_LOAD, access::load);
CREASE_SAME(CREASE_ACCESS_STORE, access::store);
CREASE_SAME(CREASE_ACCESS_MODIFY, access::modify);
CREASE_SAME(CREASE_ACCESS_ATTACHMENT, access::attachment);
CREASE_SAME(CREASE_ACCESS_RESULT, access::result);
CREASE_SAME(CREASE_RESOURCE_IMAGE, resource_kind::image);
CREASE_SAME(CREASE_RESOURCE_BUFFER, resource_kind::buffer);
CREASE_SAME(CREASE_RESOURCE_BLOCK, resource_kind::block);
CREASE_SAME(CREASE_LIFETIME_INPUT, lifetime::input);
CREASE_SAME(CREASE_LIFETIME_CONSTANT, lifetime::constant);
CREASE_SAME(CREASE_LIFETIME_TRANSIENT, lifetime::transient);
CREASE_SAME(CREASE_LIFETIME_HANDED_ON, lifetime::handed_on);
CREASE_SAME(CREASE_LIFETIME_HISTORY, lifetime::history);
CREASE_SAME(CREASE_LIFETIME_REPORT, lifetime::report);
CREASE_SAME(CREASE_LIFETIME_OUTPUT, lifetime::output);
CREASE_SAME(CREASE_FORMAT_NONE, format::none);
CREASE_SAME(CREASE_FORMAT_R8_UNORM, format::r8_unorm);
CREASE_SAME(CREASE_FORMAT_RGBA8_UNORM, format::rgba8_unorm);
CREASE_SAME(CREASE_FORMAT_R32_UINT, format::r32_uint);
CREASE_SAME(CREASE_FORMAT_RG32_UINT, format::rg32_uint);
CREASE_SAME(CREASE_FORMAT_RGBA32_UINT, format::rgba32_uint);
CREASE_SAME(CREASE_FORMAT_R32_FLOAT, format::r32_float);
CREASE_SAME(CREASE_FORMAT_RG32_FLOAT, format::rg32_float);
CREASE_SAME(CREASE_FORMAT_RGBA16_FLOAT, format::rgba16_float);
CREASE_SAME(CREASE_FORMAT_RGBA32_FLOAT, format::rgba32_float);
CREASE_SAME(CREASE_FORMAT_D32_FLOAT, format::d32_float);
CREASE_SAME(CREASE_ALL_LEVELS, binding::all_levels);
#undef CREASE_SAME

template <class C, class Cpp>
constexpr C as(Cpp enumerator) {
    return static_cast<C>(enumerator);
}

std::uint32_t count_of(std::size_t size) {
    return static_cast<std::uint32_t>(size);
}

crease_extent described(const extent& e) {
    return {e.divisor, e.guarded, e.fixed_width, e.fixed_height, e.level};
}

const char* joined(arena& memory, array_view<const piece> pieces) {
    std::size_t size = 0;
    for (const piece& each : pieces)
        size += each.text.size();
    char* text = memory.allocate<char>(size + 1);
    char* to = text;
    for (const piece& each : pieces) {
        std::memcpy(to, each.text.data(), each.text.size());
        to += each.text.size();
    }
    return text;
}

crease_pass described(arena& memory, const pass& p) {
    const auto binding_of = [&](const binding& b) {
        return crease_binding{
            memory.text(b.name), b.resource, as<crease_access>(b.how), b.set, b.slot, b.level};
    };
    const auto constant_of = [&](const constant& c) {
        return crease_constant{memory.text(c.part), memory.text(c.number), c.id, c.value};
    };
    return {memory.text(p.name),
            as<crease_stage>(p.stage),
            as<crease_dialect>(p.dialect),
            joined(memory, p.pieces),
            p.vertex_pieces.empty() ? nullptr : joined(memory, p.vertex_pieces),
            memory.list(p.bindings, binding_of),
            memory.list(p.constants, constant_of),
            count_of(p.bindings.size()),
            count_of(p.constants.size()),
            described(p.size),
            as<crease_dispatch>(p.covers),
            p.group_width(),
            p.group_height(),
            p.view};
}

crease_resource described(arena& memory, const resource& r) {
    crease_resource made{memory.text(r.name),
                         as<crease_resource_kind>(r.kind),
                         as<crease_format>(r.texels),
                         memory.text(r.element),
                         as<crease_lifetime>(r.life),
                         described(r.size),
                         memory.text(r.meaning),
                         r.layers,
                         r.levels,
                         r.samples,
                         r.arrayed,
                         r.centred,
                         memory.text(r.previous_of),
                         r.cleared,
                         r.clear,
                         nullptr,
                         0,
                         memory.text(r.content)};
    if (r.fill) { // a constant is of a fixed size
        made.texel_count = r.size.fixed_width * r.size.fixed_height * r.layers;
        auto* texels = memory.allocate<std::uint32_t>(made.texel_count);
        r.fill({texels, made.texel_count});
        made.texels = texels;
    }
    return made;
}

crease_choice described(arena& memory, const choice& c, bool named) {
    auto* numbers = memory.allocate<std::int32_t>(most_numbers);
    for (std::size_t i = 0; i < c.what->numbers.size(); ++i)
        numbers[i] = c.numbers[i];
    return {part_of(c.what), numbers, named};
}

const crease_choice* const* described(arena& memory, const choice_list& all, std::size_t named) {
    return memory.list(all, [&](const choice& c) {
        return described(memory, c, static_cast<std::size_t>(&c - all.begin()) < named);
    });
}

}

const crease_effect* described(arena& memory, const effect_view& effect, const recipe& chosen) {
    const choice_list parts = complete(chosen.choices());
    const auto pass_of = [&](const pass& p) { return described(memory, p); };
    const auto resource_of = [&](const resource& r) { return described(memory, r); };
    const auto setting_of = [&](const effect_setting& s) {
        const auto index = static_cast<std::size_t>(&s - effect.settings.begin());
        return described(s, memory.text(s.part), memory.text(s.name), memory.text(s.meaning),
                         count_of(setting_offset(effect.views, index)));
    };
    crease_effect made{memory.text(effect.recipe),
                       described(memory, parts, chosen.choices().size()),
                       memory.list(effect.passes, pass_of),
                       memory.list(effect.resources, resource_of),
                       memory.list(effect.settings, setting_of),
                       count_of(parts.size()),
                       count_of(effect.passes.size()),
                       count_of(effect.resources.size()),
                       count_of(effect.settings.size()),
                       effect.views,
                       count_of(effect.block_size()),
                       count_of(effect.views * sizeof(view_parameters)),
                       count_of(radius_offset(effect.views)),
                       count_of(radius_offset(effect.views) + sizeof(float)),
                       {effect.features.extended_storage_formats, effect.features.fragment_stores_and_atomics,
                        effect.features.subgroup_arithmetic, effect.features.depth_samples,
                        effect.features.centred_depth_samples}};
    return memory.keep(made);
}

}
