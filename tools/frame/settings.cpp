// SPDX-License-Identifier: MIT
#include "frame/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

namespace crease::tools {

namespace {

std::string names_of(const std::vector<effect_setting>& settings) {
    std::string names;
    for (const effect_setting& s : settings)
        names += (names.empty() ? "" : ", ") + name_of(s);
    return names;
}

}

std::string name_of(const effect_setting& s) {
    return s.shared ? std::string(s.name) : fmt::format("{}.{}", s.part, s.name);
}

std::vector<effect_setting> settings_of(const recipe& chosen) {
    const auto planned = std::make_unique<plan>(make_plan(chosen.choices()));
    return {planned->settings.begin(), planned->settings.end()};
}

recipe parse_recipe(std::string_view text) {
    recipe read(text);
    if (!read)
        throw recipe_error(std::string(read.error()));
    return read;
}

std::map<std::string, float> parse_settings(const std::vector<std::string>& texts) {
    std::map<std::string, float> settings;
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        float value = 0;
        const char* end = text.data() + text.size();
        const auto read = equals == std::string::npos
                              ? std::from_chars_result{end, std::errc::invalid_argument}
                              : std::from_chars(text.data() + equals + 1, end, value);
        if (read.ec != std::errc{} || read.ptr != end)
            throw recipe_error(fmt::format("--set {}: it must read name=number", text));
        settings[text.substr(0, equals)] = value;
    }
    return settings;
}

parameters settle(const recipe& chosen, const frame_options& options) {
    if (!(options.radius >= 0) || std::isinf(options.radius))
        throw recipe_error(
            fmt::format("the radius is {}; it must be finite and not negative", options.radius));
    const std::vector<effect_setting> known = settings_of(chosen);
    parameters settled = default_parameters(known);
    settled.radius = options.radius;
    settled.frame = options.frame;
    for (const auto& [name, value] : options.settings) {
        const auto found =
            std::ranges::find_if(known, [&name = name](const effect_setting& s) { return s.is(name); });
        if (found == known.end())
            throw recipe_error(fmt::format("no part of this recipe has the setting '{}'; there are {}", name,
                                           names_of(known)));
        if (!set(settled, known, name, value))
            throw recipe_error(
                fmt::format("{}={} is out of its range, {} to {}", name, value, found->least, found->most));
    }
    return settled;
}

}
