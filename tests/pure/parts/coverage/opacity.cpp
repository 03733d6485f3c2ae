// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

namespace {

using namespace crease;

constexpr const part* coverages[] = {&stratified::description, &simple_hash::description,
                                     &hash_4d::description, &isotropic_threshold::description,
                                     &anisotropic_threshold::description};
using layered = effect<directions<4, 4>, stochastic_layers<4>, hbao>;

}

TEST_CASE("every coverage reads the opacity and no other setting, under one name") {
    for (const part* p : coverages) {
        CAPTURE(p->name);
        CHECK(p->kind == role::coverage);
        REQUIRE(p->settings.size() == 1);
        CHECK(p->settings[0].name == "opacity");
        CHECK(p->settings[0].shared);
        CHECK(p->settings[0].fallback == 0.2f);
        CHECK(p->settings[0].least > 0); // else no sample keeps anything
        CHECK(p->settings[0].most == 1);
    }
}

TEST_CASE("an effect of layers has the opacity once, and it is set by its own name or with the part's") {
    unsigned count = 0;
    for (const effect_setting& s : layered::settings)
        count += s.name == "opacity";
    CHECK(count == 1);
    parameters p = layered::defaults;
    CHECK(layered::set<"opacity">(p, 0.5f));
    CHECK(get(p, layered::settings, "stratified.opacity") == 0.5f);
    CHECK_FALSE(layered::set<"opacity">(p, 0));
}
