// Compares what is reported as out of sight with vertices computed in floats, as a driver does.

#include "render/draw/sight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <random>

#include "scene/view.h"

namespace glibra::render {
namespace {

VertexBox box(const glm::dvec3& low, const glm::dvec3& high) {
    return {{low, 1}, {high, 1}, true};
}
DrawView drawView(const glm::dmat4& modelView,
                  const scene::Projection& projection = scene::Perspective{50, .1, 1000}, int width = 200,
                  int height = 100) {
    DrawView result;
    result.modelView = modelView;
    result.projection = scene::projectionMatrix(projection, static_cast<double>(width) / height);
    result.width = width;
    result.height = height;
    result.tile = {0, 0, width, height};
    result.oneSample = true;
    return result;
}
Sight of(const glm::dvec3& place, double size = 1) {
    return sightOf(box(glm::dvec3(-size), glm::dvec3(size)), drawView(scene::translation(place)));
}

TEST(Sight, NamesTheSideOnWhichABoxLies) {
    EXPECT_EQ(of({0, 0, -10}), Sight::possible);
    EXPECT_EQ(of({0, 0, 0}), Sight::possible) << "around the eye";
    EXPECT_EQ(of({0, 0, 10}), Sight::nearer);
    EXPECT_EQ(of({.5, .5, -1000}), Sight::betweenPixels) << "a fifth of a pixel high";
    EXPECT_EQ(of({-30, 0, -10}), Sight::left);
    EXPECT_EQ(of({30, 0, -10}), Sight::right);
    EXPECT_EQ(of({0, -30, -10}), Sight::below);
    EXPECT_EQ(of({0, 30, -10}), Sight::above);
    EXPECT_EQ(of({30, 0, -100}), Sight::possible) << "farther away it is in";
    const scene::Perspective narrow{50, 1, 20};
    const VertexBox cube = box(glm::dvec3(-1), glm::dvec3(1));
    EXPECT_EQ(sightOf(cube, drawView(scene::translation({0, 0, -22}), narrow)), Sight::farther);
    EXPECT_EQ(sightOf(cube, drawView(scene::translation({0, 0, -20.5}), narrow)), Sight::possible)
        << "a quarter of it is before the far plane";
}

TEST(Sight, IsNotEndedByNearAndFarPlaneWithDepthClamp) {
    DrawView clamped = drawView(scene::translation({0, 0, -22}), scene::Perspective{50, 1, 20});
    clamped.depthClamp = true;
    const VertexBox cube = box(glm::dvec3(-1), glm::dvec3(1));
    EXPECT_EQ(sightOf(cube, clamped), Sight::possible);
    clamped = drawView(glm::dmat4(1.0), scene::Perspective{50, 3, 20});
    EXPECT_EQ(sightOf(cube, clamped), Sight::nearer);
    clamped.depthClamp = true;
    EXPECT_EQ(sightOf(cube, clamped), Sight::possible);
}

TEST(Sight, HoldsForOrthographicBoxesToo) {
    const scene::Orthographic view{-3, 3, -3, 3, -10, 10};
    const auto at = [&](const glm::dvec3& place) {
        return sightOf(box(glm::dvec3(-1), glm::dvec3(1)),
                       drawView(scene::translation(place), view, 100, 100));
    };
    EXPECT_EQ(at({0, 0, 0}), Sight::possible);
    EXPECT_EQ(at({0, 0, 12}), Sight::nearer);
    EXPECT_EQ(at({0, 0, -12}), Sight::farther);
    EXPECT_EQ(at({4.5, 0, 0}), Sight::right);
    EXPECT_EQ(at({3.9, 0, 0}), Sight::possible);
}

TEST(Sight, OfSomethingBetweenThePixelsCentresIsNone) {
    // One pixel is .06 units wide at z = 0; the picture's centre is a corner of four pixels.
    const scene::Orthographic view{-3, 3, -3, 3, -10, 10};
    DrawView with = drawView(glm::dmat4(1), view, 100, 100);
    const auto small = [](double x, double y) {
        return box({x - .01, y - .01, -.01}, {x + .01, y + .01, .01});
    };
    EXPECT_EQ(sightOf(small(0, 0), with), Sight::betweenPixels);
    EXPECT_EQ(sightOf(small(0, .03), with), Sight::betweenPixels) << "beside the centres of a column";
    EXPECT_EQ(sightOf(small(.03, .03), with), Sight::possible);
    EXPECT_EQ(sightOf(box({-.04, -.01, 0}, {.04, .01, 0}), with), Sight::betweenPixels)
        << "wide, but between two rows";
    with.oneSample = false;
    EXPECT_EQ(sightOf(small(0, 0), with), Sight::possible) << "where the samples are is the driver's affair";
    with.oneSample = true;
    with.filled = false;
    EXPECT_EQ(sightOf(small(0, 0), with), Sight::possible) << "points and lines have a width";
}

TEST(Sight, OfPointsAndLinesReachesBeyondTheirVertices) {
    const scene::Orthographic view{-1, 1, -1, 1, -10, 10};
    DrawView with = drawView(glm::dmat4(1), view, 100, 100);
    with.filled = false;
    with.reach = 11;  // pixels: .22 units
    EXPECT_EQ(sightOf(box({1.2, 0, 0}, {1.2, 0, 0}), with), Sight::possible);
    EXPECT_EQ(sightOf(box({1.23, 0, 0}, {1.23, 0, 0}), with), Sight::right);
    with.reach = 0;
    EXPECT_EQ(sightOf(box({1.2, 0, 0}, {1.2, 0, 0}), with), Sight::right);
}

TEST(Sight, OfATileIsThatOfItsPartOfThePicture) {
    const scene::Orthographic view{-1, 1, -1, 1, -10, 10};
    DrawView with = drawView(glm::dmat4(1), view, 400, 400);
    const VertexBox lowerLeft = box({-.9, -.9, 0}, {-.6, -.6, 0});
    with.tile = {0, 0, 100, 100};
    EXPECT_EQ(sightOf(lowerLeft, with), Sight::possible);
    with.tile = {100, 0, 100, 100};
    EXPECT_EQ(sightOf(lowerLeft, with), Sight::left);
    with.tile = {0, 300, 100, 100};
    EXPECT_EQ(sightOf(lowerLeft, with), Sight::below);
}

TEST(Sight, OfWhatIsNoFiniteNumberIsPossible) {
    geometry::Mesh mesh;
    mesh.attributes.push_back({std::string(geometry::kPosition), 3, {5, 5, 5, 6, 6, 6}});
    EXPECT_EQ(sightOf(boundsOf(mesh), drawView(glm::dmat4(1))), Sight::nearer);
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        mesh.attributes[0].values[4] = bad;
        EXPECT_EQ(sightOf(boundsOf(mesh), drawView(glm::dmat4(1))), Sight::possible);
    }
    DrawView broken = drawView(scene::translation({0, 0, 1e38}));
    EXPECT_EQ(sightOf(box(glm::dvec3(-1), glm::dvec3(1)), broken), Sight::possible);
    broken.modelView = glm::dmat4(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(sightOf(box(glm::dvec3(-1), glm::dvec3(1)), broken), Sight::possible);
    EXPECT_EQ(sightOf(VertexBox{}, drawView(glm::dmat4(1))), Sight::possible);
}

TEST(Sight, TakesAFourthCoordinateAsItIs) {
    geometry::Mesh mesh;
    // (0, 0, -5, -1) is the point (0, 0, 5) behind the eye, but visible points lie between it and (0, 0, -5,
    // 1).
    mesh.attributes.push_back({std::string(geometry::kPosition), 4, {-1, -1, -5, 1, 1, 1, -5, -1}});
    EXPECT_EQ(sightOf(placed(boundsOf(mesh), glsl::Placement::vertex), drawView(glm::dmat4(1))),
              Sight::possible);
    mesh.attributes[0].values = {30, 0, -5, 2, 40, 0, -5, 3};
    EXPECT_EQ(sightOf(placed(boundsOf(mesh), glsl::Placement::vertex), drawView(glm::dmat4(1))),
              Sight::right);
    mesh.attributes[0].values = {1, 0, -5, .01F, 1, 1, -5, .01F};
    EXPECT_EQ(sightOf(placed(boundsOf(mesh), glsl::Placement::point), drawView(glm::dmat4(1))),
              Sight::possible);
    EXPECT_EQ(sightOf(placed(boundsOf(mesh), glsl::Placement::unknown), drawView(glm::dmat4(1))),
              Sight::possible);
}

using Vec4f = std::array<float, 4>;
using Mat4f = std::array<Vec4f, 4>;  // columns

Mat4f rounded(const glm::dmat4& matrix) {
    Mat4f result{};
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            result[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)] =
                static_cast<float>(matrix[column][row]);
    return result;
}
Vec4f times(const Mat4f& matrix, const Vec4f& vector) {
    Vec4f result{};
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            result[row] += matrix[column][row] * vector[column];
    return result;
}

/// True if the point is beyond the plane that `sight` names; for betweenPixels, if it is far enough from all
/// centres in one direction.
bool isRightly(Sight sight, const Vec4f& clip) {
    switch (sight) {
        case Sight::left:
            return clip[0] < -clip[3];
        case Sight::right:
            return clip[0] > clip[3];
        case Sight::below:
            return clip[1] < -clip[3];
        case Sight::above:
            return clip[1] > clip[3];
        case Sight::nearer:
            return clip[2] < -clip[3];
        case Sight::farther:
            return clip[2] > clip[3];
        default:
            return clip[3] > 0;
    }
}

TEST(Sight, IsRightForRandomBoxesUnderRandomMatricesInFloats) {
    std::mt19937 random(7);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    std::array<int, 8> found{};
    for (int i = 0; i < 20'000; ++i) {
        const glm::dvec3 axis(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
        const double scale = std::pow(10, uniform(-4, 3));
        const glm::dmat4 modelView =
            scene::translation({uniform(-20, 20), uniform(-20, 20), uniform(-30, 5)}) *
            scene::rotation(uniform(0, 360), axis) * scene::scaling(glm::dvec3(scale));
        scene::Projection projection = scene::Perspective{uniform(10, 120), .1, 40};
        if (i % 2 == 0) projection = scene::Orthographic{-10, 10, -10, 10, -5, 20};
        const DrawView with = drawView(modelView, projection, 64, 48);
        const glm::dvec3 middle(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
        const glm::dvec3 half(uniform(0, 1), uniform(0, 1), uniform(0, 1));
        const Sight sight = sightOf(box(middle - half, middle + half), with);
        ++found[static_cast<std::size_t>(sight)];
        if (sight == Sight::possible) continue;
        const Mat4f whole = rounded(with.projection * with.modelView);
        const Mat4f first = rounded(with.modelView);
        const Mat4f second = rounded(with.projection);
        std::array<std::array<double, 2>, 2> span{{{1e9, -1e9}, {1e9, -1e9}}};
        for (int k = 0; k < 30; ++k) {
            Vec4f vertex{0, 0, 0, 1};
            for (int d = 0; d < 3; ++d) {
                const double place = k < 8 ? ((k >> d & 1) != 0 ? 1 : -1) : uniform(-1, 1);
                vertex[static_cast<std::size_t>(d)] = static_cast<float>(middle[d] + place * half[d]);
            }
            for (const Vec4f& clip : {times(whole, vertex), times(second, times(first, vertex))}) {
                ASSERT_TRUE(isRightly(sight, clip)) << i << " " << describe(sight);
                const std::array<int, 2> sizes{64, 48};
                for (std::size_t d = 0; d < 2; ++d) {
                    const double pixel = (static_cast<double>(clip[d] / clip[3]) + 1) / 2 * sizes[d] - .5;
                    span[d] = {std::min(span[d][0], pixel), std::max(span[d][1], pixel)};
                }
            }
        }
        if (sight == Sight::betweenPixels) {
            EXPECT_TRUE(std::floor(span[0][1]) < std::ceil(span[0][0]) ||
                        std::floor(span[1][1]) < std::ceil(span[1][0]))
                << i;
        }
    }
    for (std::size_t each = 0; each < found.size(); ++each) EXPECT_GT(found[each], 100) << each;
}

}  // namespace
}  // namespace glibra::render
