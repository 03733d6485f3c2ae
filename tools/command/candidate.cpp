// SPDX-License-Identifier: MIT
#include "candidate.hpp"

#include <crease/spirv.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace crease::tools {

candidate parse_candidate(const std::string& whole, const std::vector<std::string>& given) {
    const std::string_view text = whole;
    const std::size_t at = std::min(text.find('@'), text.size());
    std::vector<std::string> settings = given;
    for (std::string_view rest = text.substr(at); !rest.empty();) {
        rest.remove_prefix(1);
        const std::size_t comma = std::min(rest.find(','), rest.size());
        settings.emplace_back(rest.substr(0, comma));
        rest.remove_prefix(comma);
    }
    const candidate read{whole, parse_recipe(text.substr(0, at)), parse_settings(settings)};
    settle(read.chosen, {.radius = 1, .settings = read.settings}); // which refuses what does not fit
    return read;
}

std::vector<pass_work> work_of(const recipe& run) {
    const auto composed = std::make_unique<composition>(run);
    std::vector<pass_work> all;
    for (const pass& p : composed->view().passes) {
        if (p.stage == stage_kind::geometry)
            continue;
        const double side = std::ldexp(1.0 / p.size.divisor, -static_cast<int>(p.size.level));
        all.push_back({std::string(p.name), count_work(spirv::compile(p)), side * side});
    }
    return all;
}

}
