// SPDX-License-Identifier: MIT
#include <crease/effect/projection.hpp>

#include <doctest/doctest.h>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace crease;

constexpr unsigned width = 640, height = 360;

struct projection {
    const char* name;
    glm::mat4 matrix;
    matrix_convention clip;
    float far_depth; // infinite where there is none
};

constexpr float infinity = std::numeric_limits<float>::infinity();

// z row of an infinite projection with the near plane at device depth `at_near`, the horizon at `at_far`.
glm::mat4 infinite(float near, float at_near, float at_far) {
    glm::mat4 m = glm::perspectiveRH_ZO(1.0f, 16.0f / 9, near, 100.0f);
    m[2][2] = -at_far;
    m[3][2] = (at_near - at_far) * near;
    return m;
}

glm::mat4 flipped(glm::mat4 m) {
    for (int column = 0; column < 4; ++column)
        m[column][1] = -m[column][1];
    return m;
}

std::vector<projection> every_projection() {
    constexpr float near = 0.25f, far = 80;
    constexpr matrix_convention zero_to_one{.depth_zero_to_one = true}, minus_one{.depth_zero_to_one = false};
    std::vector<projection> all{
        {"standard", glm::perspectiveRH_ZO(1.0f, 16.0f / 9, near, far), zero_to_one, far},
        {"reversed", glm::perspectiveRH_ZO(1.0f, 16.0f / 9, far, near), zero_to_one, far},
        {"standard, -1 to 1", glm::perspectiveRH_NO(1.0f, 16.0f / 9, near, far), minus_one, far},
        {"reversed, -1 to 1", glm::perspectiveRH_NO(1.0f, 16.0f / 9, far, near), minus_one, far},
        {"infinite", infinite(near, 0, 1), zero_to_one, infinity},
        {"infinite, reversed", infinite(near, 1, 0), zero_to_one, infinity},
        {"infinite, -1 to 1", infinite(near, -1, 1), minus_one, infinity},
        {"off-centre", glm::frustumRH_ZO(-0.3f, 0.1f, -0.05f, 0.2f, near, far), zero_to_one, far},
        {"orthographic", glm::orthoRH_ZO(-8.0f, 8.0f, -4.5f, 4.5f, near, far), zero_to_one, far},
        {"orthographic, reversed", glm::orthoRH_ZO(-8.0f, 8.0f, -4.5f, 4.5f, far, near), zero_to_one, far},
        {"orthographic, -1 to 1", glm::orthoRH_NO(-8.0f, 8.0f, -4.5f, 4.5f, near, far), minus_one, far},
        {"orthographic, off-centre", glm::orthoRH_ZO(-2.0f, 9.0f, -7.0f, 1.0f, near, far), zero_to_one, far},
    };
    const std::size_t count = all.size();
    for (std::size_t i = 0; i < count; ++i) {
        projection up = all[i];
        up.clip.y_up = true;
        all.push_back(up);
        projection flip = all[i];
        flip.matrix = flipped(flip.matrix);
        all.push_back(flip);
    }
    return all;
}

view_parameters parameters_of(const projection& from) {
    view_parameters p;
    float matrix[16];
    std::copy_n(glm::value_ptr(from.matrix), 16, matrix);
    REQUIRE(set_projection(p, matrix, width, height, from.clip));
    return p;
}

struct texel_and_depth {
    glm::dvec2 texel;
    double device;
};

// What a rasteriser stores for a point: by the matrix and the rules of the API, nothing of crease.
texel_and_depth rasterised(const projection& by, glm::dvec3 position) {
    const glm::dvec4 clip = glm::dmat4(by.matrix) * glm::dvec4(position, 1);
    const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
    const double row = by.clip.y_up ? (1 - ndc.y) / 2 : (1 + ndc.y) / 2;
    return {{(1 + ndc.x) / 2 * width, row * height}, by.clip.depth_zero_to_one ? ndc.z : ndc.z / 2 + 0.5};
}

bool is_perspective(const projection& p) {
    return p.matrix[2][3] == -1;
}

// The formulas of templates/crease/view/perspective.glsl and orthographic.glsl.
double linear_depth_of(const projection& by, const view_parameters& p, double device) {
    const double unpacked = device * double(p.depth_unpack[0]) + double(p.depth_unpack[1]);
    return is_perspective(by) ? 1 / unpacked : unpacked;
}

glm::dvec3 unprojected(const projection& by, const view_parameters& p, const texel_and_depth& seen) {
    const double depth = linear_depth_of(by, p, seen.device);
    const double at = is_perspective(by) ? depth : 1;
    return {(seen.texel.x * double(p.from_texel[0]) + double(p.from_texel[2])) * at,
            (seen.texel.y * double(p.from_texel[1]) + double(p.from_texel[3])) * at, -depth};
}

// The view_parameters are rounded to float, which near the far plane of a perspective costs the depth in the
// square.
double tolerance(const projection& by, const view_parameters& p, double depth) {
    const double rounding = 4.0 * double(std::numeric_limits<float>::epsilon());
    const double sum = std::abs(double(p.depth_unpack[0])) + std::abs(double(p.depth_unpack[1]));
    return rounding * (1 + sum * (is_perspective(by) ? depth * depth : 1) + 10 * depth);
}

float float_depth_of(const projection& by, const view_parameters& p, float device) {
    const float unpacked = device * p.depth_unpack[0] + p.depth_unpack[1];
    return is_perspective(by) ? 1 / std::max(unpacked, 1e-16f) : unpacked;
}

// The same in the floats of a GPU: what the far plane's device depth comes to.
void check_cleared(float near, float far) {
    CAPTURE(near);
    CAPTURE(far);
    const projection standard{"", glm::perspectiveRH_ZO(1.0f, 1.0f, near, far), {}, far};
    const view_parameters s = parameters_of(standard);
    CHECK(float_depth_of(standard, s, 1) >= s.far_depth);
    const projection reversed{"", glm::perspectiveRH_ZO(1.0f, 1.0f, far, near), {}, far};
    const view_parameters r = parameters_of(reversed);
    CHECK(float_depth_of(reversed, r, 0) >= r.far_depth);
}

bool refused(const float (&matrix)[16], unsigned columns = width, unsigned rows = height) {
    view_parameters p;
    return !set_projection(p, matrix, columns, rows) && p == view_parameters{};
}

}

TEST_CASE("a point that a matrix projects is found again by the view_parameters") {
    for (const projection& by : every_projection()) {
        CAPTURE(by.name);
        CAPTURE(by.clip.y_up);
        const view_parameters p = parameters_of(by);
        CHECK(p.resolution[0] == width);
        CHECK(std::abs(p.texel_size[1] * height - 1) <= 1e-6f);
        for (const double depth : {0.3, 1.0, 7.5, 60.0})
            for (const double x : {-0.4, 0.0, 0.7})
                for (const double y : {-0.6, 0.0, 0.2}) {
                    const glm::dvec3 position(x * depth, y * depth, -depth);
                    const glm::dvec3 found = unprojected(by, p, rasterised(by, position));
                    CAPTURE(depth);
                    CHECK(glm::distance(found, position) <= tolerance(by, p, depth));
                }
    }
}

TEST_CASE("a left-handed projection and one stored by rows give the view of the same camera") {
    const glm::vec2 shift(0.1f, -0.2f);
    for (bool is_perspective : {true, false})
        for (bool is_reversed : {false, true}) {
            const float near = is_reversed ? 80.0f : 0.25f, far = is_reversed ? 0.25f : 80.0f;
            glm::mat4 right = is_perspective ? glm::perspectiveRH_ZO(1.0f, 16.0f / 9, near, far)
                                             : glm::orthoRH_ZO(-2.0f, 3.0f, -1.0f, 2.0f, near, far);
            glm::mat4 left = is_perspective ? glm::perspectiveLH_ZO(1.0f, 16.0f / 9, near, far)
                                            : glm::orthoLH_ZO(-2.0f, 3.0f, -1.0f, 2.0f, near, far);
            if (is_perspective)
                for (int row = 0; row < 2; ++row) {
                    right[2][row] = shift[row];
                    left[2][row] = -shift[row];
                }
            CAPTURE(is_perspective);
            CAPTURE(is_reversed);
            view_parameters expected, of_left, of_rows;
            REQUIRE(set_projection(expected, glm::value_ptr(right), width, height));
            REQUIRE(set_projection(of_left, glm::value_ptr(left), width, height, {.left_handed = true}));
            const glm::mat4 rows = glm::transpose(right);
            REQUIRE(set_projection(of_rows, glm::value_ptr(rows), width, height, {.row_major = true}));
            CHECK(of_left == expected);
            CHECK(of_rows == expected);
        }
}

TEST_CASE("a matrix of another convention is refused by name") {
    const auto error_of = [](const glm::mat4& matrix, const matrix_convention& convention = {}) {
        view_parameters p;
        const projection_result result = set_projection(p, glm::value_ptr(matrix), width, height, convention);
        CHECK(p == view_parameters{});
        return std::string(result.error);
    };
    const glm::mat4 right = glm::perspectiveRH_ZO(1.0f, 16.0f / 9, 0.25f, 80.0f);
    const glm::mat4 left = glm::perspectiveLH_ZO(1.0f, 16.0f / 9, 0.25f, 80.0f);
    const std::string handed = "the projection matrix is of a view space of the other handedness: see "
                               "matrix_convention::left_handed";
    CHECK(error_of(left) == handed);
    CHECK(error_of(right, {.left_handed = true}) == handed);
    CHECK(error_of(glm::transpose(right)) ==
          "the projection matrix is transposed: see matrix_convention::row_major");
    CHECK(error_of(right, {.row_major = true}) ==
          "the projection matrix is transposed: see matrix_convention::row_major");
    CHECK(error_of(glm::orthoLH_ZO(-2.0f, 3.0f, -1.0f, 2.0f, 0.25f, 80.0f)) ==
          "the projection sees nothing before the eye: it may be of a view space of the other handedness");
    for (int element = 0; element < 16; ++element)
        for (float number : {std::numeric_limits<float>::quiet_NaN(), infinity}) {
            glm::mat4 matrix = right;
            matrix[element / 4][element % 4] = number;
            CHECK(error_of(matrix) == "an element of the projection matrix is not finite");
        }
    glm::mat4 flat = right;
    flat[0][0] = 0;
    CHECK(error_of(flat) == "the projection matrix is singular");
    CHECK(error_of(glm::mat4(2)) ==
          "the matrix is no projection: its last row must be (0, 0, -1, 0) or (0, 0, 0, 1)");
}

TEST_CASE("texels are those of the depth image, with its guard band") {
    view_parameters p;
    float matrix[16];
    std::copy_n(glm::value_ptr(glm::perspectiveRH_ZO(1.0f, 16.0f / 9, 0.25f, 80.0f)), 16, matrix);
    REQUIRE(set_projection(p, matrix, width, height, {}, 20));
    CHECK(p.resolution[0] == width);
    CHECK(p.resolution[1] == height);
    CHECK(p.texel_size[0] == 1.0f / (width + 40));
    CHECK(p.texel_size[1] == 1.0f / (height + 40));
}

TEST_CASE("the background begins at the far plane") {
    for (const projection& by : every_projection()) {
        CAPTURE(by.name);
        const view_parameters p = parameters_of(by);
        if (by.far_depth == infinity) {
            CHECK(p.far_depth > 1e14f);
        } else {
            CHECK(p.far_depth < by.far_depth); // a cleared texel is at or beyond it, in spite of rounding
            CHECK(p.far_depth > 0.998 * by.far_depth);
        }
    }
}

TEST_CASE("a cleared texel is background") {
    for (const float near : {0.01f, 0.1f, 1.0f})
        for (const float far : {10.0f, 100.0f})
            check_cleared(near, far);
}

TEST_CASE("a cleared texel is background, also where the planes are a million apart") {
    for (const float near : {0.001f, 0.01f})
        for (const float far : {1000.0f, 10000.0f})
            check_cleared(near, far);
}

TEST_CASE("a matrix that is no projection, or a size of 0, is refused and changes nothing") {
    const glm::mat4 good = glm::perspectiveRH_ZO(1.0f, 1.0f, 0.1f, 10.0f);
    float matrix[16];
    std::copy_n(glm::value_ptr(good), 16, matrix);
    CHECK_FALSE(refused(matrix));
    CHECK(refused(matrix, 0, height));
    CHECK(refused(matrix, width, 0));
    for (const int zeroed : {0, 5, 11, 14}) {
        CAPTURE(zeroed);
        std::copy_n(glm::value_ptr(good), 16, matrix);
        matrix[zeroed] = 0;
        CHECK(refused(matrix));
    }
    std::copy_n(glm::value_ptr(glm::orthoRH_ZO(-1.0f, 1.0f, -1.0f, 1.0f, 0.1f, 10.0f)), 16, matrix);
    CHECK_FALSE(refused(matrix));
    matrix[10] = 0;
    CHECK(refused(matrix));
    matrix[10] = matrix[11] = 1; // left-handed
    CHECK(refused(matrix));
}
