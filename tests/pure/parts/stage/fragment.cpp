// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

TEST_CASE("fragment brings a vertex shader and writes an attachment") {
    using effect = crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::fragment>;
    CHECK(effect::passes[0].bindings.back().how == crease::access::attachment);
    CHECK(contains(effect::source<0>(), "layout(location = 0) out vec4 crease_output;\n"));
    CHECK(effect::passes[0].group_width() == 0);
    const std::string vertex = joined(effect::passes[0].vertex_pieces);
    CHECK(vertex.starts_with("#version 450\n"));
    CHECK(contains(vertex, "gl_VertexIndex"));
}

TEST_CASE("the vertex shader speaks the dialect of the pass") {
    using effect = crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::fragment,
                                  crease::opengl_glsl>;
    const std::string vertex = joined(effect::passes[0].vertex_pieces);
    CHECK(vertex.starts_with("#version 430\n"));
    CHECK(contains(vertex, "gl_VertexID"));
}
