// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/effect_view.hpp>

#include <string_view>
#include <vector>

/// An effect whose captured layers are inputs: a test gives them, and nothing is drawn.
class given_layers {
public:
    explicit given_layers(const crease::effect_view& effect)
        : effect_(effect), resources_(effect.resources.begin(), effect.resources.end()) {
        for (const crease::pass& each : effect.passes)
            if (each.stage != crease::stage_kind::geometry)
                passes_.push_back(each);
        for (crease::resource& each : resources_)
            if (each.name.starts_with("captured_layers")) {
                each.life = crease::lifetime::input;
                each.cleared = false;
            }
    }
    given_layers(const given_layers&) = delete;
    given_layers& operator=(const given_layers&) = delete;

    operator crease::effect_view() const {
        crease::effect_view whole = effect_;
        whole.passes = passes_;
        whole.resources = resources_;
        return whole;
    }

private:
    crease::effect_view effect_;
    std::vector<crease::pass> passes_;
    std::vector<crease::resource> resources_;
};
