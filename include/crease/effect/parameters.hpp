// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/array_view.hpp>
#include <crease/effect/projection.hpp>
#include <crease/effect/view_parameters.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace crease {

/// The most cameras of an effect beside that of the picture.
inline constexpr std::size_t most_further_views = 3,
                             most_settings = 24; ///< of the parts of an effect, together

/// A camera beside that of the picture.
struct further_view {
    view_parameters view; ///< of this camera, whose picture may be smaller than the first's
    float from_first[16] = {1, 0, 0, 0, 0, 1, 0, 0,
                            0, 0, 1, 0, 0, 0, 0, 1}; ///< column-major, from the view space of the picture's
                                                     ///< camera to that of this one

    /// Member by member.
    constexpr bool operator==(const further_view&) const = default;
};

/// What a host gives an effect each frame; `write_block` turns it into the bytes of the uniform block.
struct parameters {
    view_parameters view;                           ///< of the picture
    further_view further_views[most_further_views]; ///< the first `effect_view::views` - 1 count
    float radius = 1;                               ///< AO radius R, view-space units, >= 0
    std::uint32_t frame = 0;                        ///< of the picture; another gives other noise
    float settings[most_settings]{};                ///< in the order of `effect_view::settings`; see `set`

    /// Member by member.
    constexpr bool operator==(const parameters&) const = default;
};

/// A setting of an effect, as its parts describe it.
struct effect_setting {
    std::string_view part;    ///< that owns it
    std::string_view name;    ///< e.g. "bias"
    float fallback;           ///< what the part recommends
    float least;              ///< the least value allowed
    float most;               ///< the greatest value allowed
    std::string_view meaning; ///< in a few words, with the unit
    bool shared;              ///< by all parts of the effect that name it

    /// Whether `wanted` names it: `name` or `part.name`.
    constexpr bool is(std::string_view wanted) const {
        return wanted == name ||
               (wanted.size() == part.size() + 1 + name.size() && wanted.starts_with(part) &&
                wanted[part.size()] == '.' && wanted.ends_with(name));
    }
};

/// Sets each setting that `name` names, e.g. "strength" or "hbao.bias".
/// @return false, with `p` unchanged, where there is none or the value is out of its range
constexpr bool set(parameters& p, array_view<const effect_setting> settings, std::string_view name,
                   float value) {
    bool found = false;
    for (const effect_setting& s : settings)
        if (s.is(name)) {
            if (!(value >= s.least && value <= s.most))
                return false;
            found = true;
        }
    for (std::size_t i = 0; i < settings.size(); ++i)
        if (settings[i].is(name))
            p.settings[i] = value;
    return found;
}

/// The value of the first setting that `name` names; 0 where there is none.
constexpr float get(const parameters& p, array_view<const effect_setting> settings, std::string_view name) {
    for (std::size_t i = 0; i < settings.size(); ++i)
        if (settings[i].is(name))
            return p.settings[i];
    return 0;
}

/// The parameters with each part's recommended settings, and no view yet.
constexpr parameters default_parameters(array_view<const effect_setting> settings) {
    parameters p;
    for (std::size_t i = 0; i < settings.size(); ++i)
        p.settings[i] = settings[i].fallback;
    return p;
}

/// Where in the uniform block the radius lies, in bytes; the frame and then the settings follow, 4 bytes
/// each.
/// @param views  cameras, that of the picture included, > 0
constexpr std::size_t radius_offset(std::size_t views) {
    return views * sizeof(view_parameters) + (views - 1) * sizeof(further_view::from_first);
}

/// Where in the uniform block a setting lies, in bytes.
/// @param index  of `effect_view::settings`
constexpr std::size_t setting_offset(std::size_t views, std::size_t index) {
    return radius_offset(views) + 8 + index * sizeof(float);
}

/// Bytes of the uniform block, std140: the cameras, the matrices of those beside the picture's, the radius,
/// the frame and the settings; a multiple of 16.
/// @param views  cameras, that of the picture included, > 0
constexpr std::size_t block_size(std::size_t views, std::size_t settings) {
    return (setting_offset(views, settings) + 15) / 16 * 16;
}

/// Writes the uniform block.
/// @param to  of block_size(views, settings) bytes
inline void write_block(const parameters& p, std::size_t views, std::size_t settings, std::byte* to) {
    const auto write = [&to](const void* from, std::size_t bytes) {
        std::memcpy(to, from, bytes);
        to += bytes;
    };
    write(&p.view, sizeof p.view);
    for (std::size_t i = 0; i + 1 < views; ++i)
        write(&p.further_views[i].view, sizeof(view_parameters));
    for (std::size_t i = 0; i + 1 < views; ++i)
        write(p.further_views[i].from_first, sizeof(further_view::from_first));
    write(&p.radius, sizeof p.radius);
    write(&p.frame, sizeof p.frame);
    write(p.settings, settings * sizeof(float));
}

}
