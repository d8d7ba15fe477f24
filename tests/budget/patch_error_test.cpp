// The error of patches compared with a closed form: a parabola and its chords.

#include "budget/error_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace glibra::budget {
namespace {

using Surface = std::function<glm::dvec4(double u, double v)>;

PatchVertex vertexAt(const Surface& surface, double u, double v) {
    return {surface(u, v), {u, v, 0}};
}

/// A line of n pieces.
Patch line(const Surface& surface, int n, double v = 0) {
    Patch patch{2, {}};
    for (int i = 0; i < n; ++i)
        for (const int end : {i, i + 1})
            patch.vertices.push_back(vertexAt(surface, static_cast<double>(end) / n, v));
    return patch;
}

/// n x n squares of two triangles each.
Patch squares(const Surface& surface, int n) {
    Patch patch{3, {}};
    const auto add = [&](int i, int j) {
        patch.vertices.push_back(vertexAt(surface, static_cast<double>(i) / n, static_cast<double>(j) / n));
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (const auto& [di, dj] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
                add(i + di, j + dj);
    return patch;
}

glm::dvec4 parabola(double u, double) {
    return {2 * u - 1, u * u, 0, 1};
}

TEST(PatchError, OfAParabolaIsTheHeightOverItsChord) {
    // Over a chord of length 1/n a parabola u^2 rises by 1 / (4 n^2); 1 is half of 300 pixels.
    for (const int n : {1, 2, 3, 5, 8}) {
        const auto found = patchError(line(parabola, n), line(parabola, 120), {300, 300});
        ASSERT_TRUE(found);
        EXPECT_NEAR(*found, 150. / 4 / n / n, .02) << n;
    }
}

TEST(PatchError, OfTrianglesIsTakenAtTheCoordinatesOfTheFineOnes) {
    const Surface surface = [](double u, double v) { return glm::dvec4(2 * u - 1, u * u + v * v - 1, v, 1); };
    for (const int n : {1, 2, 5}) {
        const auto found = patchError(squares(surface, n), squares(surface, 40), {400, 200});
        ASSERT_TRUE(found);
        EXPECT_NEAR(*found, 100. * 2 / 4 / n / n, .02) << n;
    }
}

TEST(PatchError, IsZeroForThePatchItself) {
    const auto found = patchError(line(parabola, 7), line(parabola, 7), {300, 300});
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, 0, 1e-10);
}

TEST(PatchError, IsSeenThroughTheProjection) {
    // Twice as far away, half as large.
    const Surface far = [](double u, double v) {
        glm::dvec4 clip = parabola(u, v);
        clip.w = 2;
        return clip;
    };
    EXPECT_NEAR(*patchError(line(far, 2), line(far, 120), {300, 300}),
                *patchError(line(parabola, 2), line(parabola, 120), {300, 300}) / 2, 1e-6);
}

TEST(PatchError, DoesNotCountWhatIsOutsideThePicture) {
    const Surface beside = [](double u, double v) { return parabola(u, v) + glm::dvec4(4, 0, 0, 0); };
    EXPECT_EQ(patchError(line(beside, 1), line(beside, 50), {300, 300}), 0);
}

TEST(PatchError, HasNoBoundBehindTheEyeAndNoAnswerForOtherLines) {
    const Surface behind = [](double u, double) { return glm::dvec4(u, 0, 0, u - .5); };
    EXPECT_EQ(patchError(line(behind, 2), line(behind, 9), {300, 300}),
              std::numeric_limits<double>::infinity());
    EXPECT_FALSE(patchError(line(parabola, 2, 0), line(parabola, 9, .5), {300, 300}));
}

}  // namespace
}  // namespace glibra::budget
