// SPDX-License-Identifier: MIT
#include "scenes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    read_scene(text_of(data, size), "obj");
    return 0;
}
