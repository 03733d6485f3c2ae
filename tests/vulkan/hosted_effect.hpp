// SPDX-License-Identifier: MIT
#pragma once

#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <vector>

/// An effect whose last pass is a host's compute shader around the functions of a recipe.
class hosted_effect {
public:
    /// @param interface  of the host's shader: version, workgroup and `crease_output` at binding 0
    hosted_effect(const std::string& recipe_text, const crease::piece& interface)
        : composed_(std::make_unique<crease::composition>(crease::recipe(std::string_view(recipe_text)))) {
        const crease::effect_view view = composed_->view();
        REQUIRE(!view.passes.empty());
        passes_.assign(view.passes.begin(), view.passes.end());
        crease::pass& last = passes_.back();
        REQUIRE(last.stage == crease::stage_kind::functions);
        pieces_ = {interface};
        pieces_.insert(pieces_.end(), last.pieces.begin(), last.pieces.end());
        pieces_.push_back(main_);
        for (const crease::binding& b : last.bindings)
            bindings_.push_back(b.how == crease::access::result
                                    ? crease::binding{"output", b.resource, crease::access::store, 0, 0}
                                    : b);
        constants_ = {{"compute", "width", 0, 8}, {"compute", "height", 1, 4}};
        constants_.insert(constants_.end(), last.constants.begin(), last.constants.end());
        last.stage = crease::stage_kind::compute;
        last.pieces = pieces_;
        last.bindings = bindings_;
        last.constants = constants_;
    }

    crease::effect_view view() const {
        crease::effect_view whole = composed_->view();
        whole.passes = passes_;
        return whole;
    }

private:
    static constexpr crease::piece main_{"host", R"(
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, imageSize(crease_output))))
        imageStore(crease_output, pixel, vec4(crease_visibility(pixel)));
}
)"};

    std::unique_ptr<crease::composition> composed_;
    std::vector<crease::pass> passes_;
    std::vector<crease::piece> pieces_;
    std::vector<crease::binding> bindings_;
    std::vector<crease::constant> constants_;
};
