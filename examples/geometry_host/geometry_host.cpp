// SPDX-License-Identifier: MIT
// An engine with its own Vulkan renderer whose geometry pass captures layers, so that what a screen hides
// darkens the wall beside it.
#include "camera.hpp"
#include "geometry_pass.hpp"

#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>

using front_alone = crease::effect<crease::directions<4, 4>, crease::single_layer, crease::hbao,
                                   crease::reconstructed_normals>;
using layered = crease::effect<crease::directions<4, 4>, crease::stochastic_layers<8>, crease::hbao,
                               crease::atomic_minimum<>, crease::reconstructed_normals>;

namespace {

template <class Effect>
crease::parameters parameters_of() {
    crease::parameters values = camera::parameters_for(Effect::view());
    values.radius = shaders::radius;
    return values;
}

struct pictures {
    std::vector<std::uint8_t> with_layers, front;
};

pictures render(renderer& gpu) {
    image& depth = gpu.make_image({picture::width, picture::height}, VK_FORMAT_D32_SFLOAT,
                                  VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
                                  VK_IMAGE_ASPECT_DEPTH_BIT);
    occlusion with_layers(gpu, layered::view(), parameters_of<layered>(), depth);
    occlusion front(gpu, front_alone::view(), parameters_of<front_alone>(), depth);

    constexpr const crease::pass& captures = layered::passes[0];
    static_assert(captures.stage == crease::stage_kind::geometry && captures.name == "capture_layers");
    static_assert(!captures.to_attachment()); // so that it is drawn without attachments and depth test
    const occlusion::bound bindings =
        with_layers.bind(captures.bindings, VK_SHADER_STAGE_FRAGMENT_BIT, {&geometry_pass::camera, 1});
    geometry_pass seen(gpu, &depth, shaders::captures_nothing, bindings);
    geometry_pass captured(gpu, nullptr, layered::source<0>(), bindings);

    gpu.run([&](VkCommandBuffer commands) {
        seen.record(commands, camera::projection);
        with_layers.record(commands,
                           [&](const crease::pass&) { captured.record(commands, camera::projection); });
        front.record(commands);
    });
    return {gpu.download(with_layers.visibility()), gpu.download(front.visibility())};
}

/// Whether the layers darken the wall beside the screen, and not in the open; says by how much.
bool plausible(const pictures& made) {
    const auto say = [&](const char* place, float x) {
        const float front = picture::mean_around(made.front, camera::projection, x, 0, 5);
        const float layers = picture::mean_around(made.with_layers, camera::projection, x, 0, 5);
        std::cout << "visibility of the wall " << place << ": " << front << " by the front layer, " << layers
                  << " with what the screen hides, darker by " << front - layers << '\n';
        return front - layers;
    };
    const float beside = say("beside the screen", 1.25f), open = say("in the open", 3);
    return beside > 0.05f && std::abs(open) < 0.01f;
}

}

/// @param arguments  optionally the path of a PGM picture to write
int main(int count, char** arguments) {
    try {
        renderer gpu({.fragmentStoresAndAtomics = layered::features.fragment_stores_and_atomics,
                      .shaderStorageImageExtendedFormats = layered::features.extended_storage_formats});
        const pictures made = render(gpu);
        if (count > 1)
            picture::write_pgm(arguments[1], made.with_layers, true);
        if (!plausible(made))
            throw std::runtime_error(
                "the layers should darken the wall by 0.05 beside the screen and nowhere "
                "else: see that the image of layers is cleared, drawn to and waited for");
        return 0;
    } catch (const std::exception& failure) {
        std::cerr << "geometry_host: " << failure.what() << '\n';
        return 1;
    }
}
