// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

/// Sets an environment variable for as long as this lives.
class environment {
public:
    environment(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
    ~environment() { unsetenv(name_); }
    environment(const environment&) = delete;
    environment& operator=(const environment&) = delete;

private:
    const char* name_;
};
