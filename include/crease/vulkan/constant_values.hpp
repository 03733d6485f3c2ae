// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/effect_view.hpp>
#include <crease/vulkan/error.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace crease::vulkan::detail {

/// Values of the specialization constants of an effect: their defaults, but for those that are given by
/// "part.number".
class constant_values {
public:
    /// @throws error  where the effect has no constant of a name that is given
    constant_values(const effect_view& effect, const std::map<std::string, int>& given) : given_(given) {
        std::map<std::string, int> known;
        std::string names;
        for (const pass& each : effect.passes)
            for (const constant& c : each.constants)
                if (known.emplace(key_of(c), c.value).second)
                    names += (names.empty() ? "" : ", ") + key_of(c);
        for (const auto& [key, value] : given)
            if (!known.contains(key))
                throw error("the effect has no constant '" + key + "'; it has " +
                            (names.empty() ? "none" : names));
    }

    /// Of a pass's constants, in their order.
    std::vector<std::int32_t> of(const pass& which) const {
        std::vector<std::int32_t> values;
        for (const constant& c : which.constants) {
            const auto other = given_.find(key_of(c));
            values.push_back(other == given_.end() ? c.value : other->second);
        }
        return values;
    }

private:
    std::map<std::string, int> given_;

    static std::string key_of(const constant& c) { return std::string(c.part) + "." + std::string(c.number); }
};

}
