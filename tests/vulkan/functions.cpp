// SPDX-License-Identifier: MIT
// The stage `functions`, in a host's own shader that runs.
#include <crease/crease.hpp>
#include <crease/vulkan/runner.hpp>

#include "small_corner.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>

using namespace crease;

namespace {

constexpr piece host_interface{"host", R"(#version 450
layout(local_size_x = 8, local_size_y = 4, local_size_x_id = 0, local_size_y_id = 1) in;
layout(set = 0, binding = 0, r8) writeonly uniform image2D crease_output;
)"};
constexpr piece host_main{"host", R"(
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, imageSize(crease_output))))
        imageStore(crease_output, pixel, vec4(crease_visibility(pixel)));
}
)"};

/// An effect whose last pass is a host's compute shader around functions.
class hosted {
public:
    explicit hosted(const std::string& recipe_text)
        : composed_(std::make_unique<composition>(recipe(std::string_view(recipe_text)))) {
        const effect_view view = composed_->view();
        passes_.assign(view.passes.begin(), view.passes.end());
        pass& last = passes_.back();
        REQUIRE(last.stage == stage_kind::functions);
        pieces_ = {host_interface};
        pieces_.insert(pieces_.end(), last.pieces.begin(), last.pieces.end());
        pieces_.push_back(host_main);
        for (const binding& b : last.bindings)
            bindings_.push_back(b.how == access::result ? binding{"output", b.resource, access::store, 0, 0}
                                                        : b);
        constants_ = {{"compute", "width", 0, 8}, {"compute", "height", 1, 4}};
        constants_.insert(constants_.end(), last.constants.begin(), last.constants.end());
        last.stage = stage_kind::compute;
        last.pieces = pieces_;
        last.bindings = bindings_;
        last.constants = constants_;
    }

    effect_view view() const {
        effect_view whole = composed_->view();
        whole.passes = passes_;
        return whole;
    }

private:
    std::unique_ptr<composition> composed_;
    std::vector<pass> passes_;
    std::vector<piece> pieces_;
    std::vector<binding> bindings_;
    std::vector<constant> constants_;
};

std::vector<float> run(const effect_view& effect) {
    vulkan::runner runner(validated_device(), effect, small_corner::width, small_corner::height);
    runner.upload("depth", small_corner::device_depth());
    runner.run(small_corner::parameters_for(effect));
    return runner.download("visibility");
}

}

TEST_CASE("a host's shader around functions gives the picture of the stage compute") {
    for (const char* parts :
         {"directions:6x4/single_layer/hbao", "hemisphere_points:9/single_layer/ssao",
          "poisson_disk:9/single_layer/hbao_plus/linearised_depth", "sample_box/summed_area:2/mean_height"}) {
        CAPTURE(std::string(parts));
        const std::string text = std::string(parts) + "/reconstructed_normals";
        const composition computed{recipe(std::string_view(text))};
        const std::vector<float> expected = run(computed.view());
        CHECK(std::ranges::min(expected) < 0.8f); // the corner is dark, and the open floor is not
        CHECK(std::ranges::max(expected) > 0.98f);
        for (const char* places : {"/functions:0x1x2", "/functions:2x5x40"}) {
            CAPTURE(std::string(places));
            const hosted host(text + places);
            CHECK(small_corner::largest_difference(run(host.view()), expected) <= small_corner::a_step);
        }
    }
    CHECK_NOTHROW(validated_device().check_messages());
}
