// SPDX-License-Identifier: MIT
#pragma once

#include <doctest/doctest.h>

#include <string>

/// Checks that `action` throws an Error whose message has `part` in it.
template <typename Error, typename Action>
void expect_error(const std::string& part, Action action) {
    try {
        action();
        FAIL_CHECK("no error; expected one with: " << part);
    } catch (const Error& error) {
        const std::string message = error.what();
        CAPTURE(message);
        CAPTURE(part);
        CHECK(message.find(part) != std::string::npos);
    }
}
