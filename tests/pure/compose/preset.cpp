// SPDX-License-Identifier: MIT
#include "same_effect.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;
using compared::check_equal_to;

/// HBAO with a bias of its own, as a host's preset recommends it.
struct careful_hbao : hbao {
    static constexpr setting_value recommended[] = {{"bias", 0.3f}};
};

struct own_preset {
    using parts = part_list<directions<4, 4>, single_layer, careful_hbao, bilateral<>, tiled_noise<>>;
    static constexpr preset_description description{"own", "of a host", choices_in<parts>};
};
constexpr const preset_description* own_presets[] = {&own_preset::description};

using own = effect<own_preset>;
using spelled = effect<directions<4, 4>, single_layer, hbao, bilateral<>, tiled_noise<>>;

static_assert(get(own::defaults, own::settings, "bias") == 0.3f);
static_assert(get(own::defaults, own::settings, "strength") ==
              get(spelled::defaults, spelled::settings, "strength"));
static_assert(get(spelled::defaults, spelled::settings, "bias") != 0.3f);

std::string text_of(std::string_view text) {
    return std::string(recipe(text, all_parts, own_presets).text().view());
}

}

TEST_CASE("an effect of a preset is that of its parts, and sets what the preset recommends") {
    REQUIRE(own::passes.size() == spelled::passes.size());
    CHECK(own::source<0>() == spelled::source<0>());
    CHECK(own::view().recipe == spelled::view().recipe);
    const composition composed(recipe("preset:own", all_parts, own_presets));
    CHECK(composed.view().defaults == own::defaults);
    CHECK(recipe(own::choices).text().view() == own::view().recipe);
}

TEST_CASE("a part behind a preset takes the place of those of its role, and is added where there is none") {
    CHECK(text_of("preset:own/bent_cone") ==
          "directions:4x4x2/single_layer/hbao/bilateral:3/tiled_noise:4/bent_cone");
    CHECK(text_of("preset:own/hashed_noise") ==
          "directions:4x4x2/single_layer/hbao/bilateral:3/hashed_noise");
    CHECK(text_of("preset:own/directions:2x2") ==
          "directions:2x2x2/single_layer/hbao/bilateral:3/tiled_noise:4");
    CHECK(text_of("preset:own/hbao_plus/fragment/directions:2x2") ==
          "directions:2x2x2/single_layer/hbao_plus/bilateral:3/tiled_noise:4/fragment");
    CHECK(text_of("preset:own/upsample/bilateral:1") ==
          "directions:4x4x2/single_layer/hbao/upsample:2/bilateral:1/tiled_noise:4");
    CHECK(effect<own_preset, upsample<>, fragment, hbao_plus>::view().recipe ==
          text_of("preset:own/upsample/fragment/hbao_plus"));
}

TEST_CASE("an estimator named behind a preset has its own recommendations") {
    using other = effect<own_preset, hbao>;
    CHECK(get(other::defaults, other::settings, "bias") == get(spelled::defaults, spelled::settings, "bias"));
}

TEST_CASE("a recipe names a preset first, and one that is there") {
    const auto error = [](std::string_view text) { return std::string(recipe(text).error()); };
    CHECK(error("preset:mediun") == "crease::recipe: there is no preset of the name 'mediun'");
    CHECK(error("preset:") == "crease::recipe: there is no preset of the name ''");
    CHECK(error("bent_cone/preset:medium") == "crease::recipe: there is no part of the name 'preset'");
    CHECK(
        error("preset:medium/") ==
        "crease::recipe: a part's name is missing before or after a '/' in 'SAMPLER/DEPTH/ESTIMATOR[/...]'");
    CHECK(error("preset:medium/bent_cone/packed_bent_cone") ==
          "crease::effect: two parts have the same role, and only filters may be more than one (bent_cone, "
          "packed_bent_cone)");
}
