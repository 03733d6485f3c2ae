// SPDX-License-Identifier: MIT
// The stage `functions`, in a host's own shader that runs.
#include <crease/prefix.hpp>
#include <crease/vulkan/runner.hpp>

#include "hosted_effect.hpp"
#include "small_corner.hpp"
#include "validated_device.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

using namespace crease;

namespace {

constexpr piece host{"host", R"(#version 450
layout(local_size_x = 8, local_size_y = 4, local_size_x_id = 0, local_size_y_id = 1) in;
layout(set = 0, binding = 0, r8) writeonly uniform image2D crease_output;
)"};

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
            const hosted_effect hosted(text + places, host);
            CHECK(small_corner::largest_difference(run(hosted.view()), expected) <= small_corner::a_step);
        }
    }
    CHECK_NOTHROW(validated_device().check_messages());
}

namespace {

/// Two effects, each with its main pass and those of a filter, in one shader, whose main calls one of them.
class one_shader {
public:
    one_shader(const composition& near, const composition& far)
        : resources_(near.view().resources.begin(), near.view().resources.end()) {
        resources_.push_back(resources_.back());
        resources_.back().name = "visibility_far";
        for (const composition* each : {&near, &far})
            for (const pass& p : each->view().passes) {
                REQUIRE(p.stage == stage_kind::functions);
                const std::string prefix = "host_" + std::to_string(passes_.size()) + "_";
                functions_ += with_prefix(p.pieces, prefix);
                passes_.push_back(p);
                bindings_.emplace_back();
                for (const binding& b : p.bindings) {
                    if (b.how == access::uniform)
                        blocks_.push_back(b); // what stands outside functions reads those of all
                    else if (b.how != access::result)
                        bindings_.back().push_back(b);
                    else if (p.name == each->view().passes.back().name)
                        bindings_.back().push_back(
                            {"output", each == &near ? b.resource : b.resource + 1, access::store, 0, 1});
                    else
                        bindings_.back().push_back({"between", b.resource, access::store, 0, 0});
                }
                const bool is_last = p.name == each->view().passes.back().name;
                mains_.push_back(
                    is_last ? "imageStore(host_output, pixel, vec4(" + prefix + "visibility(pixel)));"
                            : "imageStore(host_between, pixel, " + prefix + "handed_on(pixel));");
            }
        for (std::size_t i = 0; i < passes_.size(); ++i) {
            texts_.push_back(
                "#version 450\n"
                "layout(local_size_x = 8, local_size_y = 4, local_size_x_id = 0, local_size_y_id = 1) in;\n"
                "layout(set = 0, binding = 0, rg32ui) writeonly uniform uimage2D host_between;\n"
                "layout(set = 0, binding = 1, r8) writeonly uniform image2D host_output;\n" +
                functions_ +
                "void main() {\n    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);\n"
                "    if (pixel.x < 96 && pixel.y < 54)\n        " +
                mains_[i] + "\n}\n");
            bindings_[i].insert(bindings_[i].begin(), blocks_.begin(), blocks_.end());
            constants_.push_back({{"compute", "width", 0, 8}, {"compute", "height", 1, 4}});
            constants_.back().insert(constants_.back().end(), passes_[i].constants.begin(),
                                     passes_[i].constants.end());
        }
        for (std::size_t i = 0; i < passes_.size(); ++i) {
            pieces_.push_back({{{"host", texts_[i]}}});
            passes_[i].stage = stage_kind::compute;
        }
        for (std::size_t i = 0; i < passes_.size(); ++i) {
            passes_[i].pieces = pieces_[i];
            passes_[i].bindings = bindings_[i];
            passes_[i].constants = constants_[i];
        }
        whole_ = near.view();
        whole_.passes = passes_;
        whole_.resources = resources_;
    }
    one_shader(const one_shader&) = delete;
    one_shader& operator=(const one_shader&) = delete;

    const effect_view& view() const { return whole_; }

private:
    std::vector<resource> resources_;
    std::vector<pass> passes_;
    std::vector<binding> blocks_;
    std::vector<std::vector<binding>> bindings_;
    std::vector<std::vector<constant>> constants_;
    std::string functions_;
    std::vector<std::string> mains_, texts_;
    std::vector<std::array<piece, 1>> pieces_;
    effect_view whole_;
};

}

TEST_CASE("two effects with a filter stand in one shader under prefixes of the host") {
    const std::string near = "directions:6x4/single_layer/hbao/reconstructed_normals/upsample:2",
                      far = "directions:3x5x1/single_layer/hbao/reconstructed_normals/upsample:2";
    const composition hosted_near{recipe(near + "/functions:1x0x40")},
        hosted_far{recipe(far + "/functions:4x2x200")};
    const composition plain_near{recipe(std::string_view(near))}, plain_far{recipe(std::string_view(far))};
    const one_shader both(hosted_near, hosted_far);
    vulkan::runner runner(validated_device(), both.view(), small_corner::width, small_corner::height);
    runner.upload("depth", small_corner::device_depth());
    runner.run(small_corner::parameters_for(both.view()));
    const std::vector<float> seen_near = runner.download("visibility"),
                             seen_far = runner.download("visibility_far");
    CHECK(small_corner::largest_difference(seen_near, run(plain_near.view())) <= small_corner::a_step);
    CHECK(small_corner::largest_difference(seen_far, run(plain_far.view())) <= small_corner::a_step);
    CHECK(seen_near != seen_far);
    CHECK_NOTHROW(validated_device().check_messages());
}
