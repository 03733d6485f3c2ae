// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "a_buffer.inc"

#include <doctest/doctest.h>

TEST_CASE("a-buffer.md: the capture is a text for the host's fragment shader") {
    CHECK(a_buffer_page::capture_text.find("void crease_capture(vec3 anchor)") != std::string_view::npos);
    CHECK(a_buffer_page::capture_text.find("gl_FrontFacing") != std::string_view::npos);
    CHECK(a_buffer_page::surface_text.find("void crease_capture(vec3 anchor, vec3 normal, vec4 color)") !=
          std::string_view::npos);
}
