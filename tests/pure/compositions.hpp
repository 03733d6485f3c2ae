// SPDX-License-Identifier: MIT
#pragma once

#include <crease/crease.hpp>

#include <algorithm>
#include <set>
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

/// Each text as it is, and with each part of the roles added.
inline std::vector<std::string> one_by_one(const std::vector<std::string>& texts,
                                           std::initializer_list<crease::role> roles) {
    std::vector<std::string> words{""};
    for (crease::role each : roles)
        for (const std::string& name : names_of(each))
            words.push_back(name);
    return times(texts, words);
}

/// Of recipes of three parts those in which one stands for the first time: each part is in at least one.
inline std::vector<std::string> first_of_each(const std::vector<std::string>& texts) {
    std::set<std::string> seen;
    std::vector<std::string> firsts;
    for (const std::string& text : texts) {
        bool is_first = false;
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = std::min(text.find('/', at), text.size());
            is_first = seen.insert(text.substr(at, end - at)).second || is_first;
            at = end + 1;
        }
        if (is_first)
            firsts.push_back(text);
    }
    return firsts;
}

/// The recipes of legal compositions of the parts of crease, the numbers left at their defaults. Every
/// sampler, depth source and estimator meets every layer traversal and output, and with every traversal the
/// parts of each other role one by one, as roles call each other in pairs. A choice of them, in which each
/// part stands, meets every further view and output with every filter, and with them the parts of each other
/// role one by one; every projection and encoding of depth with all normals and with every stage and dialect;
/// and all chains of filters, storages, coverages, compressions, resolutions and scans.
inline std::vector<std::string> every_recipe() {
    using enum crease::role;
    const auto legal = [](std::vector<std::string> texts) {
        std::erase_if(texts, [](const std::string& text) { return !crease::recipe(text); });
        return texts;
    };
    const auto optional = [](crease::role wanted) {
        std::vector<std::string> names = names_of(wanted);
        names.emplace_back("");
        return names;
    };
    const std::vector<std::string> three =
        legal(times(times(names_of(sampler), names_of(depth_source)), names_of(estimator)));
    const std::vector<std::string> traversed = legal(times(three, optional(layer_traversal)));
    const std::vector<std::string> more = legal(times(traversed, names_of(output)));
    const std::vector<std::string> views = times(more, names_of(further_views));

    const std::vector<std::string> firsts = first_of_each(three);
    const std::vector<std::string> views_of_firsts =
        times(times(firsts, names_of(projection)), names_of(depth_encoding));
    std::vector<std::string> all = times(views_of_firsts, names_of(normals));
    const std::vector<std::string> outputs_of_firsts =
        legal(times(legal(times(firsts, optional(further_views))), names_of(output)));
    const std::vector<std::string> captures =
        times(legal(times(times(firsts, names_of(layer_storage)), names_of(coverage))), names_of(projection));
    const std::vector<std::string> compressed =
        times(legal(times(legal(times(firsts, names_of(layer_compression))), names_of(receivers))),
              names_of(output));
    const std::vector<std::string> resolved = times(
        legal(times(legal(times(legal(times(firsts, names_of(resolutions))), optional(layer_compression))),
                    names_of(receivers))),
        names_of(output));
    const std::vector<std::string> scans = times(legal(times(firsts, names_of(scan))), names_of(stage));
    const std::vector<std::string> reads =
        times(legal(times(times(firsts, names_of(image_reads)), names_of(depth_encoding))), optional(filter));
    for (const auto& each :
         {more, views, times(times(views_of_firsts, names_of(stage)), names_of(dialect)),
          times(outputs_of_firsts, filter_chains()),
          one_by_one(traversed, {projection, depth_encoding, normals, noise, receivers, layer_compression,
                                 resolutions, output_format, image_reads, filter, stage, dialect}),
          one_by_one(legal(times(outputs_of_firsts, optional(filter))),
                     {projection, depth_encoding, normals, noise, receivers, layer_compression, resolutions,
                      output_format, image_reads, stage, dialect}),
          times(captures, names_of(dialect)), times(compressed, names_of(dialect)),
          times(resolved, names_of(dialect)), times(scans, names_of(dialect)),
          times(reads, names_of(dialect))})
        all.insert(all.end(), each.begin(), each.end());
    return legal(std::move(all));
}
