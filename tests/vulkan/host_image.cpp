// SPDX-License-Identifier: MIT
// An engine's images are read and written where they lie, in its own command buffers.
#include <crease/crease.hpp>
#include <crease/vulkan/runner.hpp>

#include "little_effect.hpp"
#include "own_host.hpp"
#include "sentence.hpp"
#include "sized.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace crease;

namespace {

constexpr VkImageAspectFlags depth_aspect = VK_IMAGE_ASPECT_DEPTH_BIT,
                             colour_aspect = VK_IMAGE_ASPECT_COLOR_BIT;

/// What the host's commands do before those of crease: they fill the depth, stencil too, and tell.
void fill(VkCommandBuffer commands, vulkan::image& image, float depth) {
    const VkClearDepthStencilValue value{depth, 7};
    const VkImageSubresourceRange all = image.range();
    image.transition(commands, vulkan::copied_to);
    vkCmdClearDepthStencilImage(commands, image.handle(), vulkan::copied_to.layout, &value, 1, &all);
}

/// What they do after it.
void copy(VkCommandBuffer commands, vulkan::image& from, vulkan::image& to) {
    VkImageCopy all{};
    all.srcSubresource = all.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    all.extent = {from.description().width, from.description().height, 1};
    from.transition(commands, vulkan::copied_from);
    to.transition(commands, vulkan::copied_to);
    vkCmdCopyImage(commands, from.handle(), vulkan::copied_from.layout, to.handle(), vulkan::copied_to.layout,
                   1, &all);
}

constexpr VkImageUsageFlags copy_usage =
    VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
constexpr VkImageUsageFlags depth_usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                            colour_usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT |
                                           VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_STORAGE_BIT;

bool all_are(const std::vector<float>& texels, float wanted) {
    return std::ranges::all_of(texels,
                               [&](float each) { return std::abs(each - wanted) < 0.5f / 255 + 1e-4f; });
}

}

TEST_CASE(
    "an engine's depth, with stencil, is read and its visibility written, in command buffers of its own") {
    own_host host;
    vulkan::device device(host.described());
    vulkan::image depth(host.make_image(VK_FORMAT_D32_SFLOAT_S8_UINT, 11, 8, depth_usage, depth_aspect));
    vulkan::image visibility(host.make_image(VK_FORMAT_R8_UNORM, 11, 8, colour_usage, colour_aspect));
    vulkan::runner runner(device, little::effect, 11, 8);
    runner.bind("depth", depth);
    runner.bind("visibility", visibility);
    CHECK(runner.image_of("visibility").handle() == visibility.handle());
    parameters p = sized(11, 8);
    p.radius = 0.5f; // with a gain of 2 the visibility is the depth
    vulkan::image kept(host.make_image(VK_FORMAT_R8_UNORM, 11, 8, copy_usage, colour_aspect));
    const VkCommandBuffer first = host.recorded([&](VkCommandBuffer commands) {
        fill(commands, depth, 0.25f);
        runner.record(commands, p);
        CHECK(depth.last_use().layout == VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        CHECK(visibility.last_use().layout == VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
        copy(commands, visibility, kept);
    });
    p.radius = 1; // each command buffer holds the parameters that it was recorded with
    const VkCommandBuffer second =
        host.recorded([&](VkCommandBuffer commands) { runner.record(commands, p); });
    host.submit({first, second});
    CHECK(all_are(vulkan::download(device, kept), 0.25f));
    CHECK(all_are(runner.download("visibility"), 0.5f));
    for (const std::string& message : host.messages())
        FAIL_CHECK(message);
}

TEST_CASE("two frames are in flight: each reads what the one before wrote") {
    own_host host;
    vulkan::device device(host.described());
    vulkan::image depth(host.make_image(VK_FORMAT_D32_SFLOAT, 8, 8, depth_usage, depth_aspect));
    vulkan::runner runner(device, little::effect, 8, 8);
    runner.bind("depth", depth);
    parameters p = sized(8, 8);
    p.radius = 0.5f;
    const auto frame = [&](float filled) {
        return host.recorded([&](VkCommandBuffer commands) {
            fill(commands, depth, filled);
            runner.record(commands, p);
        });
    };
    host.submit({frame(0.25f), frame(0.75f)});
    CHECK(all_are(runner.download("visibility"), 0.75f));
    runner.run(p);
    CHECK(all_are(runner.download("visibility"), 0.75f));
    for (const std::string& message : host.messages())
        FAIL_CHECK(message);
}

TEST_CASE("the runner goes on from the layout that the host says it left") {
    own_host host;
    vulkan::device device(host.described());
    const vulkan::host_image made = host.make_image(VK_FORMAT_D32_SFLOAT, 8, 8, depth_usage, depth_aspect);
    constexpr vulkan::image_use left{VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_ACCESS_MEMORY_WRITE_BIT,
                                     VK_IMAGE_LAYOUT_GENERAL, true};
    vulkan::image depth(made);
    vulkan::runner runner(device, little::effect, 8, 8);
    runner.bind("depth", depth);
    parameters p = sized(8, 8);
    p.radius = 0.5f;
    host.submit({host.recorded([&](VkCommandBuffer commands) {
        vulkan::image engines(made); // that of the engine's own records
        fill(commands, engines, 0.5f);
        engines.transition(commands, left);
        depth.used(left);
        runner.record(commands, p);
    })});
    CHECK(all_are(runner.download("visibility"), 0.5f));
    for (const std::string& message : host.messages())
        FAIL_CHECK(message);
}

TEST_CASE("an effect of parts draws to and stores in a host's image alike") {
    own_host host;
    vulkan::device device(host.described());
    for (const char* text : {"directions:2x2/single_layer/hbao/reconstructed_normals/fragment/bilateral",
                             "directions:2x2/single_layer/hbao/reconstructed_normals/bilateral"}) {
        CAPTURE(text);
        const auto composed = std::make_unique<composition>(recipe(text));
        vulkan::image depth(host.make_image(VK_FORMAT_D16_UNORM, 16, 8, depth_usage, depth_aspect));
        vulkan::image visibility(host.make_image(VK_FORMAT_R8_UNORM, 16, 8, colour_usage, colour_aspect));
        vulkan::runner runner(device, composed->view(), 16, 8);
        runner.bind("depth", depth);
        runner.bind("visibility", visibility);
        parameters p = composed->view().defaults;
        constexpr float projection[16] = {1, 0, 0, 0, 0, -2, 0, 0, 0, 0, 0, -1, 0, 0, 0.1f, 0};
        REQUIRE(set_projection(p.view, projection, 16, 8));
        host.submit({host.recorded([&](VkCommandBuffer commands) {
            fill(commands, depth, 0.05f);
            runner.record(commands, p);
        })});
        CHECK(all_are(vulkan::download(device, visibility), 1)); // a plane that faces the camera is open
    }
    for (const std::string& message : host.messages())
        FAIL_CHECK(message);
}

TEST_CASE("a host's image that is not whole is refused, and what crease does not copy") {
    own_host host;
    vulkan::device device(host.described());
    const vulkan::host_image whole =
        host.make_image(VK_FORMAT_D32_SFLOAT_S8_UINT, 4, 4, depth_usage, depth_aspect);
    const auto said = [](const vulkan::host_image& of) { return sentence_of([&] { vulkan::image{of}; }); };
    CHECK(said(whole) == "");
    vulkan::host_image other = whole;
    other.view = VK_NULL_HANDLE;
    CHECK(said(other) == "the host's image 'the host's' has no VkImageView");
    other = whole;
    other.height = 0;
    CHECK(contains(said(other), "has no size"));
    CHECK(contains(said({}), "has no VkImage"));
    vulkan::image depth(whole);
    vulkan::image narrow(
        host.make_image(VK_FORMAT_R8_UNORM, 4, 4, VK_IMAGE_USAGE_SAMPLED_BIT, colour_aspect));
    CHECK(sentence_of([&] { vulkan::download(device, narrow); }) ==
          "the image 'the host's' was not made for copying from");
    CHECK(sentence_of([&] { vulkan::upload(device, depth, std::vector<float>(16, 1.0f)); }) ==
          "the image 'the host's' holds VkFormat 130, which crease does not copy");
}
