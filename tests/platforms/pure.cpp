// SPDX-License-Identifier: MIT
// A host that includes the pure headers, composes at compile time and fills a uniform block.
#include <crease/crease.hpp>
#include <crease/second_camera.hpp>

using ao = crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::bilateral<>>;
using layered = crease::effect<crease::directions<>, crease::stochastic_layers<8>, crease::hbao,
                               crease::deferred_layers<>, crease::packed_bent_cone, crease::fragment>;
using area = crease::effect<crease::sample_box, crease::summed_area_adaptive<4, 2>, crease::mean_height<>,
                            crease::opengl_glsl>;

static_assert(ao::passes.size() == 3 && layered::passes.size() > 1 && area::passes.size() > 4);
static_assert(
    ao::passes[0].pieces[0].text.starts_with("// directions:8x4x2/single_layer/hbao/bilateral:3, pass "));
static_assert(crease::recipe("directions:8x4/single_layer/hbao/bilateral/upsample/fragment/opengl"));
static_assert(!crease::recipe("directions:8x4/hbao"));

int main() {
    crease::parameters p = ao::defaults;
    const float projection[16] = {1, 0, 0, 0, 0, -1.5f, 0, 0, 0, 0, 0, -1, 0, 0, 0.1f, 0};
    if (!crease::set_projection(p.view, projection, 1280, 720) || !ao::set<"strength">(p, 1))
        return 1;
    crease::place_second_camera(p, 1.5f, 0.5f, 5);
    return ao::block(p).empty() || ao::source<0>().empty() || layered::source<0>().empty();
}
