// SPDX-License-Identifier: MIT
// Writes the triangles of a scene for the browser: the three corners of each, 32-bit floats, little-endian.
#include "scene/scene.hpp"

#include <cstdio>
#include <exception>
#include <string>

int main(int argc, char** argv) {
    using namespace crease::tools;
    if (argc != 3) {
        std::fprintf(stderr, "usage: %s built-in|SCENE FILE\n", argv[0]);
        return 2;
    }
    try {
        const mesh scene = std::string(argv[1]) == "built-in" ? built_in_scene() : load_mesh(argv[1]);
        std::FILE* file = std::fopen(argv[2], "wb");
        bool written = file != nullptr;
        for (std::size_t i = 0; i < scene.indices.size() && written; ++i) {
            const glm::vec3 corner(scene.positions[scene.indices[i]]);
            written = std::fwrite(&corner, sizeof corner, 1, file) == 1;
        }
        if (!file || std::fclose(file) != 0 || !written) {
            std::fprintf(stderr, "%s: cannot be written\n", argv[2]);
            return 1;
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
