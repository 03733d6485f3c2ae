// SPDX-License-Identifier: MIT
#include "tune/trial.hpp"

#include "image/file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace crease::tools {

namespace {

constexpr int state_version = 1;

/// JSON has no infinity.
nlohmann::ordered_json finite_or_null(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

double or_infinite(const nlohmann::ordered_json& value) {
    return value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
}

trial trial_of(const nlohmann::ordered_json& told) {
    return {.candidate = told.at("candidate"),
            .error = told.at("error"),
            .milliseconds = told.at("milliseconds"),
            .instructions = or_infinite(told.at("instructions")),
            .fetches = or_infinite(told.at("fetches")),
            .refused = told.value("refused", "")};
}

}

nlohmann::ordered_json described(const trial& of) {
    nlohmann::ordered_json told{{"candidate", of.candidate},
                                {"error", of.error},
                                {"milliseconds", of.milliseconds},
                                {"instructions", finite_or_null(of.instructions)},
                                {"fetches", finite_or_null(of.fetches)}};
    if (!of.refused.empty())
        told["refused"] = of.refused;
    return told;
}

search_state read_state(const std::filesystem::path& file, const nlohmann::ordered_json& setup) {
    if (!std::filesystem::exists(file))
        return {setup, {}};
    search_state state;
    try {
        const auto told = nlohmann::ordered_json::parse(read_file(file));
        if (told.at("version") != state_version)
            throw std::runtime_error("is of another version");
        state.setup = told.at("setup");
        for (const nlohmann::ordered_json& each : told.at("trials"))
            state.trials.push_back(trial_of(each));
    } catch (const nlohmann::json::exception&) {
        throw std::runtime_error(fmt::format(
            "{}: is not the state of a search; remove it, or name another directory", file.string()));
    }
    if (state.setup != setup)
        throw std::runtime_error(
            fmt::format("{}: is of a search over other views, with another truth, budget, "
                        "seed or recipes; remove it, or name another directory",
                        file.string()));
    return state;
}

void write_state(const std::filesystem::path& file, const search_state& state) {
    nlohmann::ordered_json told{
        {"version", state_version}, {"setup", state.setup}, {"trials", nlohmann::ordered_json::array()}};
    for (const trial& each : state.trials)
        told["trials"].push_back(described(each));
    write_atomically(file, told.dump(2) + "\n");
}

}
