// SPDX-License-Identifier: MIT
// An engine with its own Vulkan renderer whose geometry pass fills linked lists of all fragments, and that
// takes a larger pool where fragments found the first one full.
#include "camera.hpp"
#include "geometry_pass.hpp"

#include <iostream>
#include <stdexcept>

namespace {

/// An effect with so many nodes in its pool for each texel.
template <int Nodes>
using listed = crease::effect<crease::directions<4, 4>, crease::linked_lists<4, Nodes>, crease::hbao,
                              crease::reconstructed_normals>;

struct frame {
    std::vector<std::uint8_t> visibility;
    std::uint32_t dropped; ///< fragments that found the pool full
};

template <class Effect>
frame render(renderer& gpu) {
    image& depth = gpu.make_image({picture::width, picture::height}, VK_FORMAT_D32_SFLOAT,
                                  VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
                                  VK_IMAGE_ASPECT_DEPTH_BIT);
    crease::parameters values = camera::parameters_for(Effect::view());
    values.radius = shaders::radius;
    occlusion effect(gpu, Effect::view(), values, depth);

    constexpr const crease::pass& captures = Effect::passes[0];
    static_assert(captures.stage == crease::stage_kind::geometry && captures.name == "capture_layers");
    const occlusion::bound bindings =
        effect.bind(captures.bindings, VK_SHADER_STAGE_FRAGMENT_BIT, {&geometry_pass::camera, 1});
    geometry_pass seen(gpu, &depth, shaders::captures_nothing, bindings);
    geometry_pass captured(gpu, nullptr, Effect::template source<0>(), bindings);
    gpu.run([&](VkCommandBuffer commands) {
        seen.record(commands, camera::projection);
        effect.record(commands, [&](const crease::pass&) { captured.record(commands, camera::projection); });
    });
    return {gpu.download(effect.visibility()), effect.report("fragments_beyond_pool")};
}

float beside_the_screen(const frame& made) {
    return picture::mean_around(made.visibility, camera::projection, 1.25f, 0, 5);
}

void expect(bool holds, const char* sentence) {
    if (!holds)
        throw std::runtime_error(sentence);
}

}

/// @param arguments  optionally the path of a PGM picture to write
int main(int count, char** arguments) {
    try {
        using small = listed<1>;
        using large = listed<6>;
        renderer gpu({.fragmentStoresAndAtomics = small::features.fragment_stores_and_atomics,
                      .shaderStorageImageExtendedFormats = small::features.extended_storage_formats});
        frame made = render<small>(gpu);
        std::cout << made.dropped << " fragments found no node of " << picture::width * picture::height
                  << '\n';
        expect(made.dropped > 0,
               "one node for each texel should be too few: see that the counter is read after "
               "the frame is done");
        const float before = beside_the_screen(made);
        made = render<large>(gpu);
        const float after = beside_the_screen(made);
        std::cout << made.dropped << " of six times as many; visibility of the wall beside the screen "
                  << before << ", then " << after << '\n';
        expect(made.dropped == 0,
               "six nodes for each texel should be enough: see that the counters and the heads "
               "are cleared before each frame");
        expect(after < 0.95f,
               "what the screen hides should darken the wall: see that the lists are waited for");
        if (count > 1)
            picture::write_pgm(arguments[1], made.visibility, true);
        return 0;
    } catch (const std::exception& failure) {
        std::cerr << "list_host: " << failure.what() << '\n';
        return 1;
    }
}
