// SPDX-License-Identifier: MIT
// An engine that asks for the visibility in a shader of its own, here that of the sky's light, so that there
// is no image of visibility between.
#include "camera.hpp"
#include "screen.hpp"

#include <array>

// Its bindings begin at 1 of set 0 and its constants at 2, as the engine has one binding and two constants.
using ao = crease::effect<crease::directions<4, 4>, crease::single_layer, crease::hbao,
                          crease::reconstructed_normals, crease::functions<0, 1, 2>>;

namespace {

constexpr const crease::pass& functions = ao::passes[0];
static_assert(ao::passes.size() == 1 && functions.stage == crease::stage_kind::functions);

constexpr crease::piece before{"sky.comp", R"(#version 450
layout(local_size_x = 8, local_size_y = 8, local_size_x_id = 0, local_size_y_id = 1) in;
layout(set = 0, binding = 0, r8) writeonly uniform image2D lit;
)"};
constexpr crease::piece after{"sky.comp", R"(
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(lit))))
        return;
    float sky = 1.0;
    imageStore(lit, pixel, vec4(sky * crease_visibility(pixel)));
}
)"};

/// The engine's shader as a pass: its text around the functions, its image where they return a result.
class sky_pass {
public:
    sky_pass() : pieces_{before}, constants_{{"sky", "width", 0, 8}, {"sky", "height", 1, 8}} {
        pieces_.insert(pieces_.end(), functions.pieces.begin(), functions.pieces.end());
        pieces_.push_back(after);
        constants_.insert(constants_.end(), functions.constants.begin(), functions.constants.end());
        for (const crease::binding& b : functions.bindings)
            bindings_.push_back(b.how == crease::access::result
                                    ? crease::binding{"lit", b.resource, crease::access::store, 0, 0}
                                    : b);
        pass_ = functions;
        pass_.stage = crease::stage_kind::compute;
        pass_.pieces = pieces_;
        pass_.bindings = bindings_;
        pass_.constants = constants_;
    }
    sky_pass(const sky_pass&) = delete;
    sky_pass& operator=(const sky_pass&) = delete;

    crease::effect_view view() const {
        crease::effect_view effect = ao::view();
        effect.passes = {&pass_, 1};
        return effect;
    }

private:
    std::vector<crease::piece> pieces_;
    std::vector<crease::constant> constants_;
    std::vector<crease::binding> bindings_;
    crease::pass pass_;
};

}

/// @param arguments  optionally the path of a PGM picture to write
int main(int count, char** arguments) {
    try {
        renderer gpu({.shaderStorageImageExtendedFormats = true}); // for the engine's own r8
        const sky_pass sky;
        const auto lit = render(gpu, sky.view(), camera::parameters_for(sky.view()), camera::depth());
        if (count > 1)
            picture::write_pgm(arguments[1], lit, true);
        return corner::plausible(lit, camera::projection) ? 0 : 1;
    } catch (const std::exception& failure) {
        std::cerr << "functions_in_a_shader: " << failure.what() << '\n';
        return 1;
    }
}
