// SPDX-License-Identifier: MIT
// The C++ of docs/host.md does what the runner does.
#include "own_host.hpp"
#include "step.hpp"

#include <crease/crease.hpp>
#include <crease/second_camera.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "host.inc"

namespace {

using single =
    crease::effect<crease::directions<4, 4>, crease::single_layer, crease::hbao, crease::bilateral<>>;
using layered = crease::effect<crease::directions<4, 4>, crease::stochastic_layers<8>, crease::hbao_plus,
                               crease::atomic_minimum<>, crease::second_view<>, crease::bent_cone>;
using tables = crease::effect<crease::sample_box, crease::summed_area<>, crease::mean_height<>>;
using drawn = crease::effect<crease::directions<4, 4>, crease::stochastic_layers<4>, crease::hbao,
                             crease::fragment, crease::image_load, crease::bilateral<>>;

using seen = crease::effect<crease::directions<4, 4>, crease::single_layer, crease::hbao,
                            crease::reconstructed_normals, crease::bilateral<>>;

template <class Number>
Number number_at(const std::vector<std::byte>& bytes, std::size_t offset) {
    Number number;
    std::memcpy(&number, bytes.data() + offset, sizeof number);
    return number;
}

std::vector<float> device_depth() {
    std::vector<float> all;
    for (unsigned i = 0; i < step::width * step::height; ++i)
        all.push_back(0.1f / (i % step::width < step::width / 2 ? step::near_wall : step::far_wall));
    return all;
}

}

TEST_CASE("the block has each number where the page says") {
    const crease::effect_view effect = layered::view();
    constexpr std::size_t cameras = 2, rest = 48 * cameras + 64 * (cameras - 1);
    REQUIRE(effect.views == cameras);
    crease::parameters p = step::parameters_for(effect, false);
    p.frame = 9;
    p.further_views[0].view.far_depth = 77;
    p.further_views[0].from_first[12] = 5;
    const std::vector<std::byte> bytes = host_page::bytes_of_block(effect, p);
    CHECK(number_at<float>(bytes, 0) == p.view.from_texel[0]);
    CHECK(number_at<float>(bytes, 16) == p.view.depth_unpack[0]);
    CHECK(number_at<float>(bytes, 24) == p.view.far_depth);
    CHECK(number_at<float>(bytes, 28) == p.view.guard);
    CHECK(number_at<float>(bytes, 32) == step::width);
    CHECK(number_at<float>(bytes, 40) == p.view.texel_size[0]);
    CHECK(number_at<float>(bytes, 48 + 24) == 77);
    CHECK(number_at<float>(bytes, 48 * cameras + 4 * 12) == 5);
    CHECK(number_at<float>(bytes, rest) == step::radius);
    CHECK(number_at<std::uint32_t>(bytes, rest + 4) == 9);
    for (std::size_t i = 0; i < effect.settings.size(); ++i)
        CHECK(number_at<float>(bytes, rest + 8 + 4 * i) ==
              (effect.settings[i].name == "strength" ? 1.2f : effect.settings[i].fallback));
    CHECK(bytes.size() % 16 == 0);
    CHECK(bytes.size() - (rest + 8 + 4 * effect.settings.size()) < 16);
}

TEST_CASE("the page has a row for each format that passes fill") {
    std::ifstream file(CREASE_PAGES "/docs/host.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    for (const crease::format_facts& each : crease::facts_of_formats)
        if (each.name != "none") {
            const std::string row = "\n| `" + std::string(each.name) + "` | `VK_FORMAT_";
            CAPTURE(row);
            CHECK(page.find(row) != std::string::npos);
        }
}

TEST_CASE("the page's formats are the runner's") {
    for (std::size_t i = 1; i < std::size(crease::facts_of_formats); ++i) {
        const auto f = static_cast<crease::format>(i);
        CHECK(host_page::vulkan_format(f) == crease::vulkan::detail::texel_of(f).format);
    }
}

TEST_CASE("a left-handed projection gives the view of the right-handed one") {
    // Direct3D's, from 0.5 to 50, and the same for a camera that looks down -Z.
    constexpr float left[16] = {1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 50 / 49.5f, 1, 0, 0, -25 / 49.5f, 0};
    constexpr float right[16] = {1, 0, 0, 0, 0, 2, 0, 0, 0, 0, -50 / 49.5f, -1, 0, 0, -25 / 49.5f, 0};
    const crease::parameters seen = host_page::look_through(single::view(), left, 64, 32);
    crease::view_parameters expected;
    REQUIRE(crease::set_projection(expected, right, 64, 32, {.depth_zero_to_one = true, .y_up = true}));
    CHECK(seen.view == expected);
    CHECK(std::abs(seen.view.far_depth - 50 * 0.999f) < 1e-3f);
    CHECK(std::abs(1 / (0.5f * seen.view.depth_unpack[0] + seen.view.depth_unpack[1]) - 1 / (1.01f)) < 0.02f);
    crease::view_parameters untouched;
    CHECK(!crease::set_projection(untouched, left, 64, 32)); // as the page says: refused
    CHECK(untouched == crease::view_parameters{});
}

TEST_CASE("a guard band leaves the picture's rays as they are") {
    const host_page::guarded_camera both = host_page::with_guard_band(step::perspective, 48, 32, 8);
    CHECK(both.view.guard == 8);
    CHECK(both.view.resolution[0] == 48);
    CHECK(both.view.texel_size[0] == 1 / 64.0f);
    crease::view_parameters larger;
    REQUIRE(crease::set_projection(larger, both.drawn, 64, 48));
    // Texel 0 of the picture is texel 8 of what is drawn.
    CHECK(std::abs(both.view.from_texel[2] - (8 * larger.from_texel[0] + larger.from_texel[2])) < 1e-6f);
    CHECK(std::abs(both.view.from_texel[3] - (8 * larger.from_texel[1] + larger.from_texel[3])) < 1e-6f);
}

TEST_CASE("a second camera has its own resolution and place") {
    const crease::parameters p =
        host_page::with_second_camera(layered::defaults, step::perspective, step::width, step::height + 1);
    CHECK(p.further_views[0].view.resolution[0] == step::width / 2);
    CHECK(p.further_views[0].view.resolution[1] == step::height / 2 + 1);
    CHECK(p.further_views[0].from_first[15] == 1);
    CHECK(p.further_views[0].from_first[12] != 0);
    for (const crease::pass& each : layered::passes)
        if (each.stage == crease::stage_kind::geometry && each.view == 1)
            CHECK(each.size.width_of(step::width) == step::width / 2);
}

TEST_CASE("descriptors, layouts and uses of images are the runner's") {
    using namespace crease::vulkan;
    for (const crease::effect_view& effect :
         {single::view(), layered::view(), tables::view(), drawn::view()}) {
        for (const crease::pass& each : effect.passes)
            for (const crease::binding& b : each.bindings) {
                CAPTURE(std::string(b.name));
                if (!crease::has_descriptor(b.how))
                    continue;
                CHECK(host_page::descriptor_type(effect, b) ==
                      detail::descriptor_of(b.how, effect.resources[b.resource].kind));
                if (b.how != crease::access::uniform)
                    CHECK(host_page::image_layout(b.how) == detail::shader_use_of(b.how, 0).layout);
            }
        for (unsigned i = 1; i < effect.resources.size(); ++i)
            CHECK(host_page::usage_of(effect, i) != 0);
    }
}

TEST_CASE("workgroups cover each texel, row and column") {
    bool has_rows = false, has_columns = false;
    for (const crease::effect_view& effect : {single::view(), layered::view(), tables::view()})
        for (const crease::pass& each : effect.passes) {
            if (each.stage != crease::stage_kind::compute)
                continue;
            CAPTURE(std::string(each.name));
            constexpr unsigned width = 333, height = 77, guard = 5;
            const host_page::groups all = host_page::workgroups_of(each, width, height, guard);
            const unsigned across = all.across * each.group_width(), down = all.down * each.group_height();
            const unsigned has_across = each.size.width_of(width, guard),
                           has_down = each.size.height_of(height, guard);
            if (each.covers == crease::dispatch::rows)
                CHECK(all.across == 1);
            else
                CHECK((across >= has_across && across - has_across < each.group_width()));
            if (each.covers == crease::dispatch::columns)
                CHECK(all.down == 1);
            else
                CHECK((down >= has_down && down - has_down < each.group_height()));
            has_rows = has_rows || each.covers == crease::dispatch::rows;
            has_columns = has_columns || each.covers == crease::dispatch::columns;
        }
    CHECK(has_rows);
    CHECK(has_columns);
}

TEST_CASE("a specialized constant is the one that is named") {
    const crease::pass& main = single::passes[0];
    const host_page::specialization all = host_page::specialize(main, "directions", "steps", 11);
    REQUIRE(all.values.size() == main.constants.size());
    for (std::size_t i = 0; i < main.constants.size(); ++i) {
        const crease::constant& c = main.constants[i];
        CHECK(all.entries[i].constantID == c.id);
        CHECK(all.values[i] == (c.part == "directions" && c.number == "steps" ? 11 : c.value));
    }
    CHECK(all.info().dataSize == 4 * main.constants.size());
}

TEST_CASE("a host's fragment shader around a geometry pass compiles") {
    for (const crease::pass& each : layered::passes)
        if (each.stage == crease::stage_kind::geometry) {
            const std::string text = host_page::fragment_shader_of(each, step::fragment[0].text);
            const crease::piece whole[] = {{"whole", text}};
            CHECK_NOTHROW(crease::spirv::compile(whole, crease::spirv::shader_stage::fragment));
        }
}

TEST_CASE("the runner finds the step, and what it hides darkens no less") {
    const std::vector<float> depth = device_depth();
    const auto beside = [](const std::vector<float>& visibility) {
        float sum = 0;
        for (unsigned row = 0; row < step::height; ++row)
            sum += visibility.at(row * step::width + step::width / 2) / step::height;
        return sum;
    };
    const float front =
        beside(host_page::visibility_of(step::device(), depth, step::perspective, step::width, step::height));
    CHECK(front < 0.95f);
    const crease::vulkan::mesh walls(step::device(), step::triangles());
    const crease::vulkan::geometry_shaders shaders{.vertex = step::vertex,
                                                   .fragment = step::fragment,
                                                   .push_constant_bytes = sizeof step::perspective,
                                                   .reversed_depth = true};
    const float layers = beside(host_page::visibility_with_layers(
        step::device(), depth, walls, shaders, step::perspective, step::width, step::height));
    CHECK(layers < 0.95f);
    CHECK_NOTHROW(step::device().check_messages());
}

TEST_CASE("a constant holds what fills it, and the page's shaders are the runner's") {
    bool has_constant = false;
    for (const crease::resource& r : layered::resources)
        if (r.life == crease::lifetime::constant) {
            has_constant = true;
            const std::vector<std::uint32_t> texels = host_page::texels_of_constant(r);
            CHECK(texels.size() == std::size_t{r.size.fixed_width} * r.size.fixed_height);
            CHECK(std::ranges::any_of(texels, [&](std::uint32_t each) { return each != texels[0]; }));
        }
    CHECK(has_constant);
    CHECK(host_page::spirv_of(single::passes[0]) == crease::vulkan::compile(single::passes[0]).main);
}

TEST_CASE("an engine's depth and visibility go through the runner as the page says") {
    own_host host;
    constexpr VkImageUsageFlags depth_usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT |
                                              VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                                usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                        VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    const auto depth = host.make_image(VK_FORMAT_D32_SFLOAT, step::width, step::height, depth_usage,
                                       VK_IMAGE_ASPECT_DEPTH_BIT);
    const auto visibility =
        host.make_image(VK_FORMAT_R8_UNORM, step::width, step::height, usage, VK_IMAGE_ASPECT_COLOR_BIT);
    host_page::engine_occlusion occlusion(host.described(), seen::view(), depth, visibility);
    crease::vulkan::device device(host.described());
    crease::vulkan::image filled(depth);
    crease::vulkan::upload(device, filled, std::span<const float>(device_depth()));
    host.submit({host.recorded([&](VkCommandBuffer commands) {
        filled.transition(commands, {VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT,
                                     VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
                                     VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, true});
        occlusion.record(commands, step::parameters_for(seen::view(), false));
    })});
    crease::vulkan::image read(visibility, {VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT,
                                            VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, false});
    crease::vulkan::runner alone(step::device(), seen::view(), step::width, step::height);
    alone.upload("depth", std::span<const float>(device_depth()));
    alone.run(step::parameters_for(seen::view(), false));
    CHECK(crease::vulkan::download(device, read) == alone.download("visibility"));
    for (const std::string& message : host.messages())
        FAIL_CHECK(message);
}
