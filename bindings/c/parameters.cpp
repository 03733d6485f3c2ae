// SPDX-License-Identifier: MIT
#include <crease_c.h>

#include <crease/effect/extent.hpp>
#include <crease/effect/parameters.hpp>
#include <crease/effect/projection.hpp>

#include <cstring>
#include <string_view>

namespace {

static_assert(sizeof(crease_view) == sizeof(crease::view_parameters));

constexpr const char* null_argument = "crease_c: an argument is NULL";

void put(void* block, std::uint32_t offset, float value) {
    std::memcpy(static_cast<char*>(block) + offset, &value, sizeof value);
}

crease::effect_setting setting_of(const crease_setting& s) {
    return {s.part, s.name, s.fallback, s.least, s.most, s.meaning, s.shared != 0};
}

crease::extent extent_of(const crease_extent& e) {
    return {e.divisor, e.guarded != 0, e.fixed_width, e.fixed_height, e.level};
}

}

const char* crease_write_defaults(const crease_effect* effect, void* block, std::size_t size) {
    if (!effect || !block)
        return null_argument;
    if (size < effect->block_size)
        return "crease_c: the block has fewer bytes than crease_effect::block_size";
    std::memset(block, 0, effect->block_size);
    put(block, effect->radius_offset, 1);
    for (std::uint32_t i = 0; i < effect->setting_count; ++i)
        put(block, effect->settings[i]->offset, effect->settings[i]->fallback);
    return nullptr;
}

const char* crease_set(const crease_effect* effect, void* block, const char* name, float value) {
    if (!effect || !block || !name)
        return null_argument;
    bool found = false;
    for (std::uint32_t i = 0; i < effect->setting_count; ++i) {
        const crease_setting& s = *effect->settings[i];
        if (!setting_of(s).is(name))
            continue;
        found = true;
        if (!(value >= s.least && value <= s.most))
            return "crease_c: the value is out of the range of the setting, crease_setting::least to most";
    }
    if (!found)
        return "crease_c: the effect has no setting of that name: see crease_effect::settings";
    for (std::uint32_t i = 0; i < effect->setting_count; ++i)
        if (setting_of(*effect->settings[i]).is(name))
            put(block, effect->settings[i]->offset, value);
    return nullptr;
}

const char* crease_set_projection(crease_view* view, const float* matrix, std::uint32_t width,
                                  std::uint32_t height, std::uint32_t convention, std::uint32_t guard) {
    if (!view || !matrix)
        return null_argument;
    const crease::matrix_convention how{.depth_zero_to_one =
                                            !(convention & CREASE_CONVENTION_DEPTH_FROM_MINUS_ONE),
                                        .y_up = (convention & CREASE_CONVENTION_Y_UP) != 0,
                                        .left_handed = (convention & CREASE_CONVENTION_LEFT_HANDED) != 0,
                                        .row_major = (convention & CREASE_CONVENTION_ROW_MAJOR) != 0};
    crease::view_parameters made;
    if (const auto taken = crease::set_projection(made, matrix, width, height, how, guard); !taken)
        return taken.error.data(); // a literal
    std::memcpy(view, &made, sizeof made);
    return nullptr;
}

const char* crease_widen_projection(float* matrix, std::uint32_t width, std::uint32_t height,
                                    std::uint32_t guard) {
    if (!matrix)
        return null_argument;
    float all[16];
    std::memcpy(all, matrix, sizeof all);
    crease::widen_projection(all, width, height, guard);
    std::memcpy(matrix, all, sizeof all);
    return nullptr;
}

std::uint32_t crease_width_of(const crease_extent* size, std::uint32_t picture_width, std::uint32_t guard) {
    return size && size->divisor ? extent_of(*size).width_of(picture_width, guard) : 0;
}

std::uint32_t crease_height_of(const crease_extent* size, std::uint32_t picture_height, std::uint32_t guard) {
    return size && size->divisor ? extent_of(*size).height_of(picture_height, guard) : 0;
}
