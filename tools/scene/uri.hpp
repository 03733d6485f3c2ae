// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace crease::tools {

/// A URI's text with each %XX as the byte that it stands for (RFC 3986).
/// @throws scene_error where two hexadecimal digits do not follow a %
std::string percent_decoded(std::string_view text);

/// The bytes that base64 text stands for (RFC 4648), padded or not.
/// @throws scene_error where it is not base64
std::string base64_decoded(std::string_view text);

}
