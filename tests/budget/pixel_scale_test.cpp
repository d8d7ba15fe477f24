// The scale compared with steps that are projected one by one.

#include "budget/error_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <random>

namespace glibra::budget {
namespace {

constexpr double kWidth = 800, kHeight = 500;

class Steps {
  public:
    explicit Steps(unsigned seed) : random_(seed) {}
    double number(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    glm::dvec3 direction() {
        std::normal_distribution<double> normal;
        return glm::normalize(glm::dvec3(normal(random_), normal(random_), normal(random_)));
    }
    /// The largest factor over random steps inside the ball that begin and end in the picture.
    double largest(const glm::dmat4& clipFromModel, double radius, int tries) {
        double most = 0;
        for (int i = 0; i < tries; ++i) {
            const glm::dvec3 from = radius * std::cbrt(number(0, 1)) * direction();
            const glm::dvec3 to = from + 1e-4 * radius * direction();
            const auto a = window(clipFromModel, from), b = window(clipFromModel, to);
            if (a && b && glm::length(to) <= radius)
                most = std::max(most, glm::length(*b - *a) / glm::length(to - from));
        }
        return most;
    }

  private:
    static std::optional<glm::dvec2> window(const glm::dmat4& clipFromModel, const glm::dvec3& point) {
        const glm::dvec4 clip = clipFromModel * glm::dvec4(point, 1);
        if (clip.z < -clip.w || std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w) return std::nullopt;
        return glm::dvec2(clip) / clip.w * glm::dvec2(kWidth, kHeight) * .5;
    }
    std::mt19937 random_;
};

geometry::Extent ball(double radius) {
    return {glm::dvec3(-radius), glm::dvec3(radius), radius};
}

TEST(PixelScale, IsNoSmallerThanAnyStepAndNotMuchLarger) {
    Steps steps(5);
    for (int i = 0; i < 60; ++i) {
        const double distance = steps.number(1.5, 12);
        const glm::dmat4 projection = glm::perspective(steps.number(.3, 1.5), kWidth / kHeight, .1, 1000.);
        const glm::dmat4 view = glm::lookAt(distance * steps.direction(), glm::dvec3(0), steps.direction());
        const glm::dmat4 model = glm::scale(glm::rotate(glm::dmat4(1), steps.number(0, 6), steps.direction()),
                                            glm::dvec3(steps.number(.5, 1), steps.number(.2, 1), 1.));
        const glm::dmat4 matrix = projection * view * model;
        const auto scale = pixelsPerUnit(matrix, ball(1), kWidth, kHeight);
        ASSERT_TRUE(scale);
        const double largest = steps.largest(matrix, 1, 4000);
        EXPECT_LE(largest, *scale * (1 + 1e-3));  // steps of finite length are a little longer
        EXPECT_GE(largest, *scale * .5);
    }
}

TEST(PixelScale, HoldsForWhatReachesThroughTheNearPlane) {
    Steps steps(6);
    for (int i = 0; i < 30; ++i) {
        const glm::dmat4 matrix =
            glm::perspective(.9, kWidth / kHeight, .2, 100.) *
            glm::lookAt(steps.number(.3, 1.1) * steps.direction(), glm::dvec3(0), steps.direction());
        const auto scale = pixelsPerUnit(matrix, ball(1), kWidth, kHeight);
        ASSERT_TRUE(scale);
        EXPECT_LE(steps.largest(matrix, 1, 4000), *scale * (1 + 1e-3));
    }
}

TEST(PixelScale, IsThatOfTheBoxInAParallelProjection) {
    const glm::dmat4 matrix = glm::ortho(-4., 4., -2.5, 2.5, -10., 10.);
    const auto scale = pixelsPerUnit(matrix, ball(1), kWidth, kHeight);
    ASSERT_TRUE(scale);
    EXPECT_NEAR(*scale, 100, 1e-9);  // 800 pixels for 8 units
    EXPECT_NEAR(
        *pixelsPerUnit(matrix * glm::scale(glm::dmat4(1), glm::dvec3(1, 3, 9)), ball(1), kWidth, kHeight),
        300, 1e-9);  // depth does not count
}

TEST(PixelScale, IsZeroForWhatIsNotInView) {
    const glm::dmat4 projection = glm::perspective(.9, kWidth / kHeight, .1, 100.);
    const auto at = [&](const glm::dvec3& place) {
        return pixelsPerUnit(projection * glm::translate(glm::dmat4(1), place), ball(1), kWidth, kHeight);
    };
    EXPECT_EQ(at({0, 0, 5}), 0);    // behind
    EXPECT_EQ(at({30, 0, -5}), 0);  // beside
    EXPECT_GT(*at({0, 0, -5}), 0);
}

TEST(PixelScale, IsNoNumberWhereTheMatrixIsNone) {
    EXPECT_FALSE(pixelsPerUnit(glm::dmat4(NAN), ball(1), kWidth, kHeight));
    EXPECT_FALSE(pixelsPerUnit(glm::dmat4(0), ball(1), kWidth, kHeight));
}

}  // namespace
}  // namespace glibra::budget
