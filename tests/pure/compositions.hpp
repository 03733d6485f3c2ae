// SPDX-License-Identifier: MIT
#pragma once

#include <crease/crease.hpp>

#include <string>
#include <vector>

/// The names of all parts of a role.
inline std::vector<std::string> names_of(crease::role wanted) {
    std::vector<std::string> names;
    for (const crease::part* each : crease::all_parts)
        if (each->kind == wanted)
            names.emplace_back(each->name);
    return names;
}

/// Each text with each of the words added as a further part.
inline std::vector<std::string> times(const std::vector<std::string>& texts,
                                      const std::vector<std::string>& words) {
    std::vector<std::string> all;
    for (const std::string& text : texts)
        for (const std::string& word : words)
            all.push_back(text + (text.empty() || word.empty() ? "" : "/") + word);
    return all;
}

/// The filters by themselves, in either order, and none.
inline std::vector<std::string> filter_chains() {
    const std::vector<std::string> filters = names_of(crease::role::filter);
    std::vector<std::string> chains = times(filters, filters);
    chains.insert(chains.end(), filters.begin(), filters.end());
    chains.emplace_back("");
    return chains;
}

/// The recipe of every legal composition of the parts of crease, the numbers left at their defaults. Those
/// that only say how a geometry pass captures layers, which the other passes do not depend on, are varied by
/// themselves.
inline std::vector<std::string> every_recipe() {
    const auto legal = [](std::vector<std::string> texts) {
        std::erase_if(texts, [](const std::string& text) { return !crease::recipe(text); });
        return texts;
    };
    const auto optional = [](crease::role wanted) {
        std::vector<std::string> names = names_of(wanted);
        names.emplace_back("");
        return names;
    };
    std::vector<std::string> three =
        times(names_of(crease::role::sampler), names_of(crease::role::depth_source));
    three = legal(times(three, names_of(crease::role::estimator)));
    const std::vector<std::string> captures = legal(
        times(times(three, names_of(crease::role::layer_carrier)), names_of(crease::role::layer_sampling)));
    three = legal(times(three, optional(crease::role::fold)));
    three = legal(times(three, optional(crease::role::second_view)));
    three = legal(times(three, names_of(crease::role::output)));
    std::vector<std::string> all = times(three, filter_chains());
    for (crease::role each : {crease::role::projection, crease::role::depth_encoding, crease::role::normals,
                              crease::role::stage, crease::role::dialect})
        all = times(all, names_of(each));
    for (const std::string& text :
         times(times(captures, names_of(crease::role::projection)), names_of(crease::role::dialect)))
        all.push_back(text);
    // Scans touch the passes of tables and nothing else.
    for (const std::string& text :
         times(times(legal(times(three, names_of(crease::role::scan))), names_of(crease::role::dialect)),
               names_of(crease::role::stage)))
        all.push_back(text);
    // Noise touches the three and the filters, and nothing else.
    for (const std::string& text : times(times(three, filter_chains()), names_of(crease::role::noise)))
        all.push_back(text);
    return legal(std::move(all));
}
