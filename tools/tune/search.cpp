// SPDX-License-Identifier: MIT
#include "tune/search.hpp"

#include "command/candidate.hpp"

#include <crease/parts/all_parts.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace crease::tools {

namespace {

/// The roles whose parts a search may exchange: what they make is the same picture, better or worse. The
/// others are the host's to choose: its projection, its depth, its outputs.
constexpr role searched[] = {role::noise,     role::coverage,        role::depth_source, role::sampler,
                             role::estimator, role::layer_traversal, role::filter};

bool is_searched(role r) {
    return std::ranges::find(searched, r) != std::end(searched);
}

/// Random numbers that are the same with every library.
class dice {
public:
    explicit dice(std::uint64_t seed) : engine_(seed) {}

    /// A whole number below `count`, > 0.
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }

    template <class List>
    auto& one_of(List& list) {
        return list[below(std::size(list))];
    }

private:
    std::mt19937_64 engine_;
};

/// A candidate in the course of changes.
struct draft {
    std::vector<choice> choices;
    std::map<std::string, float> settings;

    std::string text() const {
        std::string whole(recipe_text({choices.data(), choices.size()}).view());
        char before = '@';
        for (const auto& [name, value] : settings) {
            whole += fmt::format("{}{}={}", before, name, value);
            before = ',';
        }
        return whole;
    }
};

choice with_defaults(const part& p) {
    choice c{&p};
    for (std::size_t i = 0; i < p.numbers.size(); ++i)
        c.numbers[i] = p.numbers[i].fallback;
    return c;
}

std::vector<const part*> parts_of(role kind) {
    std::vector<const part*> all;
    for (const part* p : all_parts)
        if (p->kind == kind)
            all.push_back(p);
    return all;
}

void change_number(draft& of, dice& random) {
    choice& c = random.one_of(of.choices);
    if (c.what->numbers.empty() || !is_searched(c.what->kind))
        return;
    const std::size_t i = random.below(c.what->numbers.size());
    const number& n = c.what->numbers[i];
    const int now = c.numbers[i],
              candidates[] = {now - 1, now + 1, now * 2 / 3, now * 3 / 2, now / 2, now * 2};
    c.numbers[i] = std::clamp(random.one_of(candidates), n.least, n.most);
}

void change_setting(draft& of, dice& random) {
    const std::vector<effect_setting> known = settings_of(recipe({of.choices.data(), of.choices.size()}));
    if (known.empty())
        return;
    const effect_setting& s = known[random.below(known.size())];
    const auto found = of.settings.find(name_of(s));
    const float now = found == of.settings.end() ? s.fallback : found->second;
    constexpr float factors[] = {0.7f, 0.9f, 1.1f, 1.4f};
    const float next = now == 0 ? 0.1f : now * random.one_of(factors);
    // Three digits, as more are noise and make the same candidate twice.
    of.settings[name_of(s)] = std::clamp(std::stof(fmt::format("{:.3g}", next)), s.least, s.most);
}

void change_part(draft& of, dice& random) {
    const role kind = random.one_of(searched);
    std::vector<const part*> others = parts_of(kind);
    const part& chosen = *random.one_of(others);
    const auto there =
        std::ranges::find_if(of.choices, [kind](const choice& c) { return c.what->kind == kind; });
    if (there == of.choices.end())
        of.choices.push_back(with_defaults(chosen));
    else if (kind == role::filter && random.below(2) == 0)
        of.choices.insert(there + static_cast<std::ptrdiff_t>(random.below(2)), with_defaults(chosen));
    else
        *there = with_defaults(chosen);
}

void remove_part(draft& of, dice& random) {
    const std::size_t at = random.below(of.choices.size());
    if (at >= 3 && is_searched(of.choices[at].what->kind))
        of.choices.erase(of.choices.begin() + static_cast<std::ptrdiff_t>(at));
}

/// Drops settings that no part has any more.
void tidy(draft& of) {
    const std::vector<effect_setting> known = settings_of(recipe({of.choices.data(), of.choices.size()}));
    std::erase_if(of.settings, [&](const auto& own) {
        return std::ranges::none_of(known, [&](const effect_setting& s) { return s.is(own.first); });
    });
}

/// One change, or none where it leads to no effect.
draft changed(draft of, dice& random) {
    draft next = of;
    constexpr void (*changes[])(draft&, dice&) = {change_number, change_number, change_setting, change_part,
                                                  remove_part};
    random.one_of(changes)(next, random);
    if (check({next.choices.data(), next.choices.size()}))
        return of;
    tidy(next);
    return next;
}

draft draft_of(const std::string& text) {
    const candidate read = parse_candidate(text);
    const array_view<const choice> choices = read.chosen.choices();
    draft whole{{choices.begin(), choices.end()}, read.settings};
    for (const choice& c : choices) // those of a preset are not in its text
        for (const setting_value& own : c.settings)
            whole.settings.try_emplace(fmt::format("{}.{}", c.what->name, own.name), own.value);
    return whole;
}

}

bool budget::allows(const trial& of) const {
    return of.refused.empty() && !(milliseconds && of.milliseconds > *milliseconds) &&
           !(instructions && of.instructions > *instructions) && !(error && of.error > *error);
}

std::vector<std::size_t> front_of(std::span<const trial> trials, const budget& limits) {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < trials.size(); ++i)
        if (trials[i].refused.empty() && std::isfinite(limits.cost_of(trials[i])))
            all.push_back(i);
    std::ranges::stable_sort(all, [&](std::size_t a, std::size_t b) {
        const double cost_a = limits.cost_of(trials[a]), cost_b = limits.cost_of(trials[b]);
        return cost_a < cost_b || (cost_a == cost_b && trials[a].error < trials[b].error);
    });
    std::vector<std::size_t> front;
    for (std::size_t i : all)
        if (front.empty() || trials[i].error < trials[front.back()].error)
            front.push_back(i);
    return front;
}

std::optional<std::size_t> best_of(std::span<const trial> trials, const budget& limits) {
    std::optional<std::size_t> best;
    if (!limits.milliseconds && !limits.instructions && !limits.error)
        return best;
    for (std::size_t i : front_of(trials, limits))
        if (limits.allows(trials[i]) && !(best && limits.error)) // from the cheapest to the least error
            best = i;
    return best;
}

std::optional<std::string> next_candidate(std::span<const trial> trials, const budget& limits,
                                          std::uint64_t seed) {
    const std::vector<std::size_t> front = front_of(trials, limits);
    if (front.empty())
        return {};
    // Each trial has dice of its own, so that a search that goes on throws as one that was never interrupted.
    dice random(seed * 0x9e3779b97f4a7c15u + trials.size());
    const std::optional<std::size_t> best = best_of(trials, limits);
    std::set<std::string> known; // with all their numbers
    for (const trial& t : trials)
        known.insert(draft_of(t.candidate).text());
    for (int attempt = 0; attempt < 100; ++attempt) {
        const std::size_t parent = best && random.below(2) == 0 ? *best : random.one_of(front);
        const std::string text = changed(draft_of(trials[parent].candidate), random).text();
        if (!known.contains(text))
            return text;
    }
    return {};
}

}
