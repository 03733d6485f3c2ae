// SPDX-License-Identifier: MIT
// The same engine at half the resolution: filters and the images between are more passes and more resources,
// and the code that runs them is the same.
#include "camera.hpp"
#include "screen.hpp"

using ao = crease::effect<crease::directions<4, 4>, crease::single_layer, crease::hbao,
                          crease::reconstructed_normals, crease::bilateral<>, crease::upsample<2>>;

static_assert(ao::passes.size() > 1 && ao::passes[0].size.divisor == 2);

namespace {

void describe(const crease::effect_view& effect) {
    for (const crease::pass& pass : effect.passes) {
        const auto written = effect.resources[pass.bindings.back().resource];
        std::cout << pass.name << " writes '" << written.name << "', "
                  << written.size.width_of(picture::width) << " x " << written.size.height_of(picture::height)
                  << " texels of " << crease::facts_of(written.texels).name << '\n';
    }
}

}

/// @param arguments  optionally the path of a PGM picture to write
int main(int count, char** arguments) {
    try {
        describe(ao::view());
        renderer gpu({.shaderStorageImageExtendedFormats = ao::features.extended_storage_formats});
        const auto visibility = render(gpu, ao::view(), camera::parameters_for(ao::view()), camera::depth());
        if (count > 1)
            picture::write_pgm(arguments[1], visibility, true);
        return corner::plausible(visibility, camera::projection) ? 0 : 1;
    } catch (const std::exception& failure) {
        std::cerr << "half_resolution: " << failure.what() << '\n';
        return 1;
    }
}
