// SPDX-License-Identifier: MIT
#include "arena.hpp"
#include "described.hpp"

#include <crease_c.h>

#include <crease/compose/composition.hpp>
#include <crease/effect/version.hpp>

#include <cstring>
#include <memory>

struct crease_composition {
    crease::c::arena memory;
    const crease_effect* effect = nullptr;
    const char* error = nullptr;

    explicit crease_composition(const char* text) {
        const crease::recipe chosen{std::string_view(text)};
        const auto composed = std::make_unique<crease::composition>(chosen);
        if (*composed)
            effect = crease::c::described(memory, composed->view(), chosen);
        else
            error = memory.text(composed->error());
    }
};

namespace {

constexpr const char* no_recipe = "crease_c: the recipe is NULL";
constexpr const char* no_composition =
    "crease_c: the composition is NULL: memory ran out, or none was composed";

/// Writes as much of a sentence as there is room for.
std::size_t give(std::string_view sentence, char* to, std::size_t capacity) {
    if (to && capacity > 0) {
        const std::size_t size = sentence.size() < capacity ? sentence.size() : capacity - 1;
        if (size > 0)
            std::memcpy(to, sentence.data(), size);
        to[size] = '\0';
    }
    return sentence.size();
}

}

std::uint32_t crease_c_version() {
    return CREASE_VERSION;
}

const char* crease_c_version_text() {
    return crease::version.data(); // a literal
}

crease_composition* crease_compose(const char* recipe) {
    try {
        auto made = std::make_unique<crease_composition>(recipe ? recipe : "");
        if (!recipe)
            made->error = no_recipe;
        return made.release();
    } catch (...) {
        return nullptr;
    }
}

const char* crease_error(const crease_composition* composition) {
    return composition ? composition->error : no_composition;
}

const crease_effect* crease_effect_of(const crease_composition* composition) {
    return composition ? composition->effect : nullptr;
}

void crease_destroy(crease_composition* composition) {
    delete composition;
}

std::size_t crease_check(const char* recipe, char* sentence, std::size_t capacity) {
    if (!recipe)
        return give(no_recipe, sentence, capacity);
    const crease::recipe chosen{std::string_view(recipe)};
    return give(chosen.error(), sentence, capacity);
}
