// Matrices compared with other ways to compute the same numbers (language, 6.2).

#include "scene/view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace glibra::scene {
namespace {

/// A pseudo-random number in -1..1 for each index.
double spread(std::uint32_t i) {
    std::uint32_t x = i * 0x9e3779b9U + 1;
    x ^= x >> 16U;
    x *= 0x7feb352dU;
    x ^= x >> 15U;
    x *= 0x846ca68bU;
    x ^= x >> 16U;
    return x / 2147483648. - 1;
}
glm::dmat4 spreadMatrix(std::uint32_t seed) {
    glm::dmat4 matrix;
    for (std::uint32_t i = 0; i < 16; ++i)
        matrix[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = spread(16 * seed + i);
    return matrix;
}
glm::dvec3 spreadVector(std::uint32_t seed) {
    return {spread(seed), spread(seed + 1000), spread(seed + 2000)};
}

template <class Matrix>
double largestDifference(const Matrix& a, const Matrix& b) {
    double largest = 0;
    for (int i = 0; i < Matrix::length(); ++i)
        for (int j = 0; j < Matrix::length(); ++j) largest = std::max(largest, std::abs(a[i][j] - b[i][j]));
    return largest;
}

TEST(Matrices, QuarterTurnsAreExact) {
    for (const int turns : {-5, -1, 0, 1, 2, 3, 4, 1'000'001}) {
        const int quarter = ((turns % 4) + 4) % 4;
        const double sines[] = {0, 1, 0, -1};
        EXPECT_EQ(sineOfDegrees(90. * turns), sines[quarter]);
        EXPECT_EQ(cosineOfDegrees(90. * turns), sines[(quarter + 1) % 4]);
    }
}

TEST(Matrices, SinesOfDegreesAreThoseOfRadians) {
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const double degrees = 720 * spread(i);
        const long double radians =
            static_cast<long double>(degrees) * 3.14159265358979323846264338327950288L / 180;
        EXPECT_NEAR(sineOfDegrees(degrees), static_cast<double>(std::sin(radians)), 2.3e-16);
        EXPECT_NEAR(cosineOfDegrees(degrees), static_cast<double>(std::cos(radians)), 2.3e-16);
    }
}

TEST(Matrices, RotationIsThatOfGlm) {
    for (std::uint32_t i = 0; i < 200; ++i) {
        const glm::dvec3 axis = spreadVector(i);
        const double degrees = 360 * spread(i + 5000);
        EXPECT_LT(largestDifference(rotation(degrees, axis),
                                    glm::rotate(glm::dmat4(1.0), glm::radians(degrees), axis)),
                  1e-14);
    }
}

TEST(Matrices, RotationAxesOfAnyLengthAreTheSame) {
    const glm::dvec3 axis(1, 2, 3);
    for (const double length : {1e-300, 1e-30, 1e30, 1e300})
        EXPECT_LT(largestDifference(rotation(30, axis * length), rotation(30, axis)), 1e-15);
    EXPECT_EQ(rotation(30, {0, 0, 0}), glm::dmat4(1.0));
}

TEST(Matrices, ViewingMatrixIsThatOfGlm) {
    for (std::uint32_t i = 0; i < 200; ++i) {
        const glm::dvec3 eye = spreadVector(i);
        const glm::dvec3 centre = spreadVector(i + 7000);
        const glm::dvec3 up = spreadVector(i + 9000);
        const auto matrix = viewingMatrix(eye, centre, up);
        ASSERT_TRUE(matrix);
        EXPECT_LT(largestDifference(*matrix, glm::lookAt(eye, centre, up)), 1e-12);
    }
}

TEST(Matrices, ViewingMatrixNeedsAnUpDirection) {
    EXPECT_FALSE(viewingMatrix({0, 0, 0}, {0, 0, 0}, {0, 1, 0}));
    EXPECT_FALSE(viewingMatrix({0, 0, 0}, {0, 3, 0}, {0, -1, 0}));
    EXPECT_FALSE(viewingMatrix({0, 0, 0}, {0, 0, 1}, {0, 0, 0}));
    EXPECT_FALSE(viewingMatrix({1, 1, 1}, {4, 7, 10}, {.1, .2, .3}));
    EXPECT_TRUE(viewingMatrix({0, 0, 0}, {0, 0, 1}, {0, 1e-3, 1}));
}

TEST(Matrices, AMatrixTimesItsInverseIsTheIdentity) {
    for (std::uint32_t i = 0; i < 200; ++i) {
        const glm::dmat4 matrix = spreadMatrix(i);
        EXPECT_LT(largestDifference(matrix * inverseOrZero(matrix), glm::dmat4(1.0)), 1e-10);
        EXPECT_LT(largestDifference(inverseOrZero(matrix), glm::inverse(matrix)),
                  1e-10 * (1 + largestDifference(glm::inverse(matrix), glm::dmat4(0.0))));
    }
}

TEST(Matrices, TheInverseOfASingularMatrixIsZero) {
    const glm::dmat4 turn = rotation(33, {1, 2, 3});
    const glm::dmat4 flat = scaling({1, 0, 1});
    for (const glm::dmat4& matrix : {flat, turn * flat, flat * turn, turn * flat * turn, glm::dmat4(0.0)}) {
        EXPECT_TRUE(isSingular(matrix));
        EXPECT_EQ(inverseOrZero(matrix), glm::dmat4(0.0));
    }
    glm::dmat4 broken(1.0);
    broken[1][1] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(inverseOrZero(broken), glm::dmat4(0.0));
    broken[1][1] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(inverseOrZero(broken), glm::dmat4(0.0));
}

TEST(Matrices, VerySmallAndLargeScalesStillHaveInverses) {
    for (const double factor : {1e-100, 1e-30, 1e30, 1e100}) {
        const glm::dmat4 matrix = rotation(33, {1, 2, 3}) * scaling({factor, 2 * factor, 1});
        EXPECT_FALSE(isSingular(matrix));
        EXPECT_LT(largestDifference(matrix * inverseOrZero(matrix), glm::dmat4(1.0)), 1e-14);
    }
}

TEST(Matrices, NormalsStayPerpendicularToTheirSurface) {
    for (std::uint32_t i = 0; i < 200; ++i) {
        const glm::dmat4 matrix = spreadMatrix(i);
        const glm::dvec3 u = spreadVector(i + 100);
        const glm::dvec3 v = spreadVector(i + 300);
        const glm::dvec3 normal = normalMatrix(matrix) * glm::cross(u, v);
        const glm::dmat3 linear(matrix);
        const double size = glm::length(normal);
        EXPECT_NEAR(glm::dot(normal, linear * u) / size, 0, 1e-12);
        EXPECT_NEAR(glm::dot(normal, linear * v) / size, 0, 1e-12);
    }
}

TEST(Matrices, TheNormalMatrixIsTheInverseTranspose) {
    for (std::uint32_t i = 0; i < 200; ++i) {
        const glm::dmat4 matrix = spreadMatrix(i);
        const glm::dmat3 expected = glm::inverseTranspose(glm::dmat3(matrix));
        EXPECT_LT(largestDifference(normalMatrix(matrix), expected),
                  1e-12 * (1 + largestDifference(expected, glm::dmat3(0.0))));
    }
    EXPECT_EQ(normalMatrix(scaling({2, 4, 8})), glm::dmat3(scaling({.5, .25, .125})));
}

TEST(Matrices, TheNormalMatrixOfASingularMatrixIsItsCofactorMatrix) {
    // A surface that is flattened along y faces y, whatever its normal was.
    const glm::dmat3 normal = normalMatrix(scaling({2, 0, 3}));
    EXPECT_EQ(normal * glm::dvec3(0, 1, 0), glm::dvec3(0, 6, 0));
    EXPECT_EQ(normal * glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 0));
    EXPECT_EQ(normalMatrix(scaling({0, 0, 0})), glm::dmat3(0.0));
}

}  // namespace
}  // namespace glibra::scene
