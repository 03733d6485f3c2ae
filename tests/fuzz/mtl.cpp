// SPDX-License-Identifier: MIT
#include "scenes.hpp"

#include "scene/mtl.hpp"

/// A library is either refused in one line, or has colours that are.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        crease::tools::mesh scene{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .indices = {0, 1, 2}};
        for (const auto& [name, each] : crease::tools::read_mtl(text_of(data, size)))
            scene.materials.push_back(each);
        check_mesh(scene, "input");
    } catch (const crease::tools::scene_error& error) {
        const std::string_view sentence = error.what();
        if (sentence.starts_with("input: ") || sentence.size() > 400 || sentence.find('\n') != sentence.npos)
            std::abort();
    }
    return 0;
}
