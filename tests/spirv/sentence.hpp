// SPDX-License-Identifier: MIT
#pragma once

#include <doctest/doctest.h>

#include <exception>
#include <string>
#include <vector>

/// What `action` throws says; empty where it throws nothing.
template <class Action>
std::string sentence_of(Action action) {
    try {
        action();
    } catch (const std::exception& thrown) {
        return thrown.what();
    }
    return {};
}

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != text.npos;
}

/// How doctest writes several sentences.
template <>
struct doctest::StringMaker<std::vector<std::string>> {
    static String convert(const std::vector<std::string>& sentences) {
        std::string all;
        for (const std::string& each : sentences)
            all += "\n    " + each;
        return all.c_str();
    }
};
