// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <string>

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
