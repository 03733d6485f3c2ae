// SPDX-License-Identifier: MIT
#include "ao.hpp" // made by the build from the recipe in CMakeLists.txt: SPIR-V, and all that a host must know of it

#include <crease/crease.hpp>

#include <iostream>

namespace {

// Where the engine has the effect as a type too, the two are held together.
static_assert(ao::matches<crease::effect<crease::directions<4, 4>, crease::single_layer, crease::hbao,
                                         crease::reconstructed_normals, crease::bilateral<>>>);

void print(const crease::pass& pass) {
    // A renderer would hand the same two values to vkCreateShaderModule, and make the layout of the bindings.
    std::cout << pass.name << ": " << pass.spirv.size() * sizeof(std::uint32_t)
              << " bytes of SPIR-V, workgroups of " << pass.group_width() << " x " << pass.group_height()
              << '\n';
    for (const crease::binding& binding : pass.bindings)
        std::cout << "  binding " << binding.slot << ": " << ao::resources[binding.resource].name << '\n';
}

}

int main() {
    for (const crease::pass& pass : ao::passes)
        print(pass);
    crease::parameters p = ao::defaults;
    if (!crease::set(p, ao::settings, "strength", 1.2f))
        return 1;
    std::cout << "the uniform block: " << ao::block(p).size() << " bytes\n";
}
