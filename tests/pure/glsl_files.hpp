// SPDX-License-Identifier: MIT
#pragma once

#include <crease/crease.hpp>

#include <set>

/// Every GLSL file that a program may be made of: those of all parts and of their steps, and those of the
/// core.
inline std::set<const crease::glsl_file*> all_glsl_files() {
    std::set<const crease::glsl_file*> all;
    const auto add = [&all](crease::array_view<const crease::glsl_file* const> files) {
        all.insert(files.begin(), files.end());
    };
    for (const crease::part* each : crease::all_parts) {
        add(each->files);
        add(each->main_files);
        for (const crease::files_where& widened : each->widened)
            add(widened.files);
        for (const crease::step& step : each->steps) {
            add(step.files);
            add(step.widened.files);
        }
    }
    add(crease::core_files);
    for (const crease::glsl_file* file :
         {&crease::build_glsl, &crease::build_rows_glsl, &crease::build_columns_glsl,
          &crease::fullscreen_glsl, &crease::glsl_es_300_glsl})
        all.insert(file);
    return all;
}
