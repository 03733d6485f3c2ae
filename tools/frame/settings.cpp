// SPDX-License-Identifier: MIT
#include "frame/frame.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace crease::tools {

namespace {

const setting* find_setting(const choice_list& parts, const std::string& name) {
    for (const choice& c : parts)
        for (const setting& s : c.what->settings)
            if (s.name == name)
                return &s;
    return nullptr;
}

std::string names_of(const choice_list& parts) {
    std::string names;
    for (const choice& c : parts)
        for (const setting& s : c.what->settings)
            names += fmt::format("{}{}", names.empty() ? "" : ", ", s.name);
    return names;
}

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
            throw std::runtime_error(fmt::format("--set {}: it must read name=number", text));
        settings[text.substr(0, equals)] = value;
    }
    return settings;
}

parameters settle(const recipe& chosen, const frame_options& options) {
    if (!(options.radius >= 0) || std::isinf(options.radius))
        throw std::runtime_error(
            fmt::format("the radius is {}; it must be finite and not negative", options.radius));
    const choice_list parts = complete(chosen.choices());
    parameters settled = default_parameters(parts);
    settled.radius = options.radius;
    settled.frame = options.frame;
    for (const auto& [name, value] : options.settings) {
        const setting* found = find_setting(parts, name);
        if (!found)
            throw std::runtime_error(fmt::format("no part of this recipe has the setting '{}'; there are {}",
                                                 name, names_of(parts)));
        if (!(value >= found->least && value <= found->most))
            throw std::runtime_error(
                fmt::format("{}={} is out of its range, {} to {}", name, value, found->least, found->most));
        settled.*found->field = value;
    }
    return settled;
}

}
