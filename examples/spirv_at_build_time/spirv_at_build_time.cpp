// SPDX-License-Identifier: MIT
#include "ao.hpp" // made by the build from the recipe in CMakeLists.txt: an array for each pass

#include <iostream>
#include <span>

namespace {

constexpr std::uint32_t spirv_magic = 0x07230203;
static_assert(ao::visibility[0] == spirv_magic);

void print(const char* pass, std::span<const std::uint32_t> module) {
    // A renderer would hand the same two values to vkCreateShaderModule.
    std::cout << pass << ": " << module.size_bytes() << " bytes of SPIR-V\n";
}

}

int main() {
    print("visibility", ao::visibility);
    print("bilateral_x", ao::bilateral_x);
    print("bilateral_y", ao::bilateral_y);
}
