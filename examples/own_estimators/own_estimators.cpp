// SPDX-License-Identifier: MIT
#include "share_above.hpp"

#include <algorithm>
#include <iostream>
#include <memory>
#include <vector>

#ifdef OWN_ESTIMATOR_WITH_SPIRV
#include <crease/spirv.hpp>
#endif

using ao =
    crease::effect<crease::poisson_disk<16>, crease::single_layer, engine::share_above, crease::bilateral<>>;

// The engine's default goes into the block of parameters like those of crease's own parts.
static_assert(ao::defaults.bias == 0.05f);

int main() {
    // The same at run time: a recipe may name the parts that it is told of.
    std::vector<const crease::part*> known(std::begin(crease::all_parts), std::end(crease::all_parts));
    known.push_back(&engine::share_above::description);
    const crease::recipe recipe("poisson_disk:16/single_layer/share_above/bilateral", known);
    if (!recipe) {
        std::cerr << recipe.error() << '\n';
        return 1;
    }
    const auto composed = std::make_unique<crease::composition>(recipe);
    const auto same_text = [](const crease::pass& one, const crease::pass& other) {
        return std::ranges::equal(one.pieces, other.pieces, {}, &crease::piece::text, &crease::piece::text);
    };
    if (!std::ranges::equal(ao::passes, composed->view().passes, same_text)) {
        std::cerr << "the recipe and the effect differ\n";
        return 1;
    }

    std::cout << ao::source<0>;
#ifdef OWN_ESTIMATOR_WITH_SPIRV
    try {
        for (const crease::pass& pass : ao::passes) {
            const crease::spirv::words module = crease::spirv::compile(pass);
            crease::spirv::validate(module);
            std::cout << "// " << pass.name << ": " << module.size() << " words of valid SPIR-V\n";
        }
    } catch (const crease::spirv::error& mistake) { // names engine/share_above.glsl and the line in it
        std::cerr << mistake.what() << '\n';
        return 1;
    }
#endif
}
