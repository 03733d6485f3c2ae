// SPDX-License-Identifier: MIT
#include <crease/second_camera.hpp>

#include <doctest/doctest.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

namespace {

glm::mat4 placed(float right, float forward, float focus) {
    crease::parameters p;
    crease::place_second_camera(p, right, forward, focus);
    return glm::make_mat4(p.further_views[0].from_first);
}

void check_near(glm::vec3 found, glm::vec3 expected) {
    for (int axis = 0; axis < 3; ++axis)
        CHECK(found[axis] == doctest::Approx(expected[axis]).epsilon(1e-6).scale(1));
}

}

TEST_CASE("the second camera stands to the right and in front, and looks at the focus") {
    const glm::mat4 from_first = placed(3, 1, 5); // 3, 4, 5
    check_near(glm::vec3(from_first * glm::vec4(3, 0, -1, 1)), {0, 0, 0});
    check_near(glm::vec3(from_first * glm::vec4(0, 0, -5, 1)), {0, 0, -5});
    check_near(glm::vec3(from_first * glm::vec4(0, 1, 0, 0)), {0, 1, 0});
}

TEST_CASE("placing it turns and moves, and leaves distances as they are") {
    const glm::mat4 from_first = placed(0.5f, 0.25f, 4);
    const glm::mat3 turn(from_first);
    const glm::mat3 whole = glm::transpose(turn) * turn;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            CHECK(whole[i][j] == doctest::Approx(i == j ? 1 : 0).epsilon(1e-6).scale(1));
    CHECK(glm::determinant(turn) == doctest::Approx(1));
    for (int column = 0; column < 4; ++column)
        CHECK(from_first[column][3] == (column == 3 ? 1 : 0));
}
