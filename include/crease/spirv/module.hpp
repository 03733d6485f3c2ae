// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace crease::spirv {

/// A SPIR-V module: 32-bit words in the machine's byte order.
using words = std::vector<std::uint32_t>;

/// What crease::spirv throws: a sentence that names the shader, then what the compiler or validator says of
/// it.
class error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}
