// SPDX-License-Identifier: MIT
#include <crease/vulkan/usage.hpp>

#include "little_effect.hpp"

using namespace crease;

using vulkan::detail::usage_by_passes;

static_assert(usage_by_passes(little::effect, 1) == VK_IMAGE_USAGE_SAMPLED_BIT);
static_assert(usage_by_passes(little::effect, 2) ==
              (VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT));
static_assert(usage_by_passes(little::effect, 3) == VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);

static_assert(vulkan::detail::usage_of(access::attachment, stage_kind::geometry) ==
              VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
static_assert(vulkan::detail::usage_of(access::modify, stage_kind::geometry) == VK_IMAGE_USAGE_STORAGE_BIT);

namespace {

// A pair that changes places is used as both are, and what is cleared is copied to.
constexpr binding bindings[] = {{"kept", 0, access::store}, {"kept_before", 1, access::sample}};
constexpr pass passes[] = {
    {.name = "keep", .pieces = {}, .vertex_pieces = {}, .bindings = bindings, .constants = {}, .size = {}}};
constexpr resource resources[] = {{.name = "kept", .life = lifetime::history, .cleared = true},
                                  {.name = "kept_before", .life = lifetime::history, .previous_of = "kept"}};
constexpr effect_view pair{
    .passes = passes, .resources = resources, .settings = {}, .views = 1, .features = {}, .defaults = {}};
constexpr VkImageUsageFlags both = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
static_assert(usage_by_passes(pair, 0) == (both | VK_IMAGE_USAGE_TRANSFER_DST_BIT));
static_assert(usage_by_passes(pair, 1) == both);

}
