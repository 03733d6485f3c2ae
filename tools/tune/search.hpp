// SPDX-License-Identifier: MIT
#pragma once

#include "tune/trial.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace crease::tools {

/// What a search may pay or must reach; nothing: the whole front is asked for.
struct budget {
    std::optional<double> milliseconds, instructions, error;

    /// What a trial costs: milliseconds where these are the budget, else instructions.
    double cost_of(const trial& of) const { return milliseconds ? of.milliseconds : of.instructions; }

    /// Whether a trial keeps to it.
    bool allows(const trial& of) const;
};

/// The places of the trials that no other beats in both cost and error, from the cheapest on.
std::vector<std::size_t> front_of(std::span<const trial> trials, const budget& limits);

/// The place of the best trial within the budget: of a budget of error the cheapest, else that of the least
/// error; none where no trial keeps to it, or there is no budget.
std::optional<std::size_t> best_of(std::span<const trial> trials, const budget& limits);

/// The text of a candidate that was not tried: one of those on the front, of them often the best within the
/// budget, with one change: a number, a setting, a part for another of its role, a filter more or less. The
/// same for the same trials and seed. None where a hundred changes lead to nothing new.
std::optional<std::string> next_candidate(std::span<const trial> trials, const budget& limits,
                                          std::uint64_t seed);

}
