// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using namespace crease;

// A view of a composition that is gone would dangle.
template <class Composition>
constexpr bool can_be_viewed = requires(Composition&& of) {
    static_cast<Composition&&>(of).view();
};
static_assert(can_be_viewed<composition&> && !can_be_viewed<composition>);
static_assert(std::is_convertible_v<const composition&, effect_view> &&
              !std::is_convertible_v<composition, effect_view>);

/// Parts of a host whose passes do not fit.
namespace host {

constexpr glsl_file noise_glsl{"host/noise.glsl", R"(
vec3 crease_noise(ivec2 pixel) { return crease_load_numbers(pixel).xyz; }
)"};
constexpr glsl_file make_glsl{"host/make.glsl", R"(
void crease_build(ivec2 texel) { imageStore(crease_numbers, texel, vec4(0.5)); }
)"};
constexpr const glsl_file* files[] = {&noise_glsl};
constexpr const glsl_file* making[] = {&make_glsl};
constexpr resource numbers[] = {
    {.name = "numbers", .texels = format::rgba32_float, .life = lifetime::transient}};
constexpr resource cleared_numbers[] = {
    {.name = "numbers", .texels = format::rgba32_float, .life = lifetime::transient, .cleared = true}};
constexpr std::string_view filled[] = {"numbers"}, unknown[] = {"letters"};
constexpr std::string_view nine[] = {"numbers", "numbers", "numbers", "numbers", "numbers",
                                     "numbers", "numbers", "numbers", "numbers"};

constexpr step make{.name = "make", .files = making, .kind = step_kind::texels, .writes = filled};
constexpr step make_after[] = {
    {.name = "make", .files = making, .kind = step_kind::texels, .after = true, .writes = filled}};
constexpr step make_before[] = {make};
constexpr step make_unknown[] = {
    {.name = "make", .files = making, .kind = step_kind::texels, .writes = unknown}};
constexpr step make_nine[] = {{.name = "make", .files = making, .kind = step_kind::texels, .writes = nine}};
constexpr step make_often[] = {
    {.name = "make", .files = making, .kind = step_kind::texels, .writes = filled, .times = 32}};
constexpr step make_just_often_enough[] = {
    {.name = "make", .files = making, .kind = step_kind::texels, .writes = filled, .times = 31}};

constexpr part noise(array_view<const resource> resources, array_view<const step> steps) {
    return {.kind = role::noise,
            .name = "host_noise",
            .summary = "",
            .source = "",
            .files = files,
            .resources = resources,
            .steps = steps};
}

}

/// Why the recipe "directions/single_layer/hbao/host_noise" with this noise is refused.
std::string error_with(const part& noise) {
    const part* known[] = {&directions_part::description, &single_layer::description, &hbao::description,
                           &noise};
    const auto composed = std::make_unique<composition>(
        recipe(std::string_view("directions/single_layer/hbao/host_noise"), known));
    CHECK(composed->view().passes.empty() == !composed->error().empty());
    CHECK(static_cast<bool>(*composed) == composed->error().empty());
    return std::string(composed->error());
}

}

TEST_CASE("a recipe that is refused composes to nothing, for the same reason") {
    const recipe none("hbao");
    const auto composed = std::make_unique<composition>(none);
    CHECK_FALSE(*composed);
    CHECK(composed->error() == none.error());
    CHECK(composed->view().passes.empty());
    CHECK(composed->view().resources.empty());
    CHECK(composed->view().settings.empty());
}

TEST_CASE("what composes has no error") {
    const auto composed = std::make_unique<composition>(recipe("directions/single_layer/hbao/bilateral"));
    CHECK(*composed);
    CHECK(composed->error().empty());
    CHECK(composed->view().passes.size() == 3);
    const effect_view view = *composed;
    CHECK(view.settings.size() == 5);
}

TEST_CASE("a pass that reads what none before it fills is refused") {
    const part early = host::noise(host::numbers, host::make_before),
               late = host::noise(host::numbers, host::make_after), never = host::noise(host::numbers, {});
    CHECK(error_with(early).empty());
    const std::string sentence =
        "crease::effect: a pass reads a resource that no pass before it fills (visibility, numbers)";
    CHECK(error_with(late) == sentence);
    CHECK(error_with(never) == sentence);
}

TEST_CASE("what is cleared, an input or the frame before's need not be filled first") {
    CHECK(error_with(host::noise(host::cleared_numbers, {})).empty());
    static constexpr resource given[] = {{.name = "numbers", .texels = format::rgba32_float}};
    CHECK(error_with(host::noise(given, {})).empty());
}

TEST_CASE("a step that fills what no part describes is refused") {
    CHECK(
        error_with(host::noise(host::numbers, host::make_unknown)) ==
        "crease::effect: a step fills a resource that no part of the effect describes (host_noise, letters)");
}

TEST_CASE("too many passes, and too many outputs of one, are refused") {
    const std::string few_passes =
        "crease::effect: an effect has 32 passes at the most, each with 8 outputs, "
        "16 bindings and 32 constants ";
    CHECK(error_with(host::noise(host::numbers, host::make_just_often_enough)).empty());
    CHECK(error_with(host::noise(host::numbers, host::make_often)).starts_with(few_passes));
    CHECK(error_with(host::noise(host::numbers, host::make_nine)).starts_with(few_passes));
}

TEST_CASE("too many resources, settings or cameras are refused") {
    const std::string few_resources =
        "crease::effect: an effect has 48 resources, 24 settings and 4 views at the most ";
    // Beside the block of parameters, depth, normal, numbers and visibility.
    static const auto names = [] {
        std::vector<std::string> all;
        for (int i = 0; i < 44; ++i)
            all.push_back("image_" + std::to_string(i));
        return all;
    }();
    std::vector<resource> images{host::numbers[0]};
    for (std::size_t i = 0; i < 43; ++i)
        images.push_back({.name = names[i], .texels = format::r32_float});
    CHECK(error_with(host::noise(images, host::make_before)).empty());
    images.push_back({.name = names[43], .texels = format::r32_float});
    CHECK(error_with(host::noise(images, host::make_before)).starts_with(few_resources));

    std::vector<setting> settings;
    for (std::size_t i = 0; i < 20; ++i) // beside four of hbao
        settings.push_back({names[i], 0, 0, 1, ""});
    part many = host::noise(host::numbers, host::make_before);
    many.settings = settings;
    CHECK(error_with(many).empty());
    settings.push_back({names[20], 0, 0, 1, ""});
    many.settings = settings;
    CHECK(error_with(many).starts_with(few_resources));

    part views = host::noise(host::numbers, host::make_before);
    views.further_views.count = 3;
    CHECK(error_with(views).empty());
    views.further_views.count = 4;
    CHECK(error_with(views).starts_with(few_resources));
}

TEST_CASE("a program that is too long is refused") {
    std::string text;
    for (int i = 0; i < 41; ++i)
        text += "int crease_host_" + std::to_string(i) + "() { return 1; }\n";
    const glsl_file file{"host/long.glsl", text};
    const glsl_file* files[] = {&host::noise_glsl, &file};
    part longer = host::noise(host::numbers, host::make_before);
    longer.files = files;
    CHECK(error_with(longer).starts_with("crease::effect: a program has 500 names, 190 functions and 6000 "
                                         "characters of interface at the most (make"));
}
