// Counts for values that programs compute at vertices, with pictures of known error instead of drawn ones.

#include "budget/error_models.h"
#include "budget/least_counts.h"
#include "glib/statement_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <numbers>
#include <vector>

namespace glibra::budget {
namespace {

constexpr int kColumnsSide = 128;

/// Columns of grey.
image::Image greyColumns(const std::function<double(double x)>& grey) {
    std::vector<float> values;
    for (int i = 0; i < kColumnsSide * kColumnsSide; ++i)
        values.insert(values.end(), 3, static_cast<float>(grey(i % kColumnsSide)));
    image::Image made{kColumnsSide, kColumnsSide, 3, image::Component::f32, {}};
    made.data.resize(values.size() * sizeof(float));
    std::memcpy(made.data.data(), values.data(), made.data.size());
    return made;
}

/// A gentle slope to which light of that strength is added.
image::Image slope(double light) {
    return greyColumns([&](double x) { return .2 + .005 * x + light; });
}

/// Waves with steep slopes, moved by so many pixels.
image::Image waves(double shift) {
    return greyColumns([&](double x) { return .5 + .4 * std::sin((x - shift) * std::numbers::pi / 16); });
}

VertexDraw sphere(std::size_t program, double slices, bool isFree = true) {
    return {.pass = 0,
            .step = program,
            .model = surfaceModel(glib::commandOf("Sphere")),
            .numbers = {1, slices, slices / 2},
            .before = {1, slices, slices / 2},
            .isFree = {isFree, isFree},
            .program = plan::PlannedProgramIndex(program),
            .fidelity = Fidelity::shape,
            .scale = .1};
}

/// Light that is off by `error`(slices), the largest over the draws.
class Pictures {
  public:
    explicit Pictures(std::function<double(std::size_t step, double slices)> error)
        : error_(std::move(error)) {}

    VertexRequest request(std::vector<VertexDraw> draws) {
        return {std::move(draws), .25, [this](auto from, auto to) {
                    ++asked;
                    return std::optional(ContourShifts(slope(light(from)), slope(light(to))));
                }};
    }
    int asked = 0;

  private:
    [[nodiscard]] double light(std::span<const ShapeChoice> shapes) const {
        double largest = 0;
        for (const ShapeChoice& each : shapes)
            largest = std::max(largest, error_(each.step, each.numbers[1]));
        return largest;
    }
    std::function<double(std::size_t step, double slices)> error_;
};

/// Off by 8/255 with that many slices; the error falls with the square of the slices.
std::function<double(std::size_t, double)> visibleBelow(double slices) {
    return [slices](std::size_t, double n) { return 8. / 255 * slices * slices / (n * n); };
}

TEST(VertexValues, AreKeptWhereFinerMeshesShowTheSame) {
    Pictures pictures(visibleBelow(20));
    const VertexRequest request = pictures.request({sphere(0, 36), sphere(1, 50)});
    const auto found = vertexValues(request);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->numbers[0], (std::vector<double>{1, 36, 18}));
    EXPECT_EQ(found->numbers[1], (std::vector<double>{1, 50, 25}));
    ASSERT_EQ(found->programs.size(), 2U);
    EXPECT_TRUE(found->programs[0].error.isKept && found->programs[1].error.isKept);
    EXPECT_EQ(pictures.asked, 1) << "two pictures tell it of all programs";
}

TEST(VertexValues, RiseUntilLightHasItsColour) {
    Pictures pictures(visibleBelow(100));
    const VertexRequest request = pictures.request({sphere(0, 36)});
    const auto found = vertexValues(request);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->programs[0].error.isKept);
    EXPECT_LE(found->programs[0].error.colored, .001);
    EXPECT_GE(found->numbers[0][1], 100);
    EXPECT_LE(found->numbers[0][1], 300);
    EXPECT_NEAR(found->numbers[0][1] / found->numbers[0][2], 2, .05);
}

TEST(VertexValues, RiseForTheProgramThatNeedsThemAlone) {
    Pictures pictures([](std::size_t step, double n) { return visibleBelow(step == 1 ? 100 : 10)(step, n); });
    const VertexRequest request = pictures.request({sphere(0, 36), sphere(1, 36)});
    const auto found = vertexValues(request);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->numbers[0][1], 36);
    EXPECT_GE(found->numbers[1][1], 100);
}

TEST(VertexValues, StatedCountsAreToldAndKept) {
    Pictures pictures(visibleBelow(100));
    const VertexRequest request = pictures.request({sphere(0, 36, false)});
    const auto found = vertexValues(request);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->numbers[0][1], 36);
    EXPECT_FALSE(found->programs[0].error.isKept);
    EXPECT_NEAR(found->programs[0].error.colored, 1, .05);
    EXPECT_NE(changeText(found->programs[0].error.pixels, found->programs[0].error.colored)
                  .find("of 1000 pixels have another colour"),
              std::string::npos);
}

TEST(VertexValues, EndWhereFinerMeshesDoNotHelp) {
    // The picture changes by the same amount with every count.
    Pictures pictures([](std::size_t, double n) { return std::fmod(n, 2) < 1 ? .1 : 0; });
    const VertexRequest request = pictures.request({sphere(0, 50)});
    const auto found = vertexValues(request);
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->programs[0].error.isKept);
    EXPECT_EQ(found->numbers[0][1], 50);
    EXPECT_LE(pictures.asked, 2);
}

TEST(VertexValues, EndWhereMeshesBecomeTooLarge) {
    Pictures pictures(visibleBelow(2000));
    const VertexRequest request = pictures.request({sphere(0, 500)});
    const auto found = vertexValues(request);
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->programs[0].error.isKept);
    EXPECT_EQ(found->numbers[0][1], 500);
}

TEST(VertexValues, WithoutPicturesNothingIsTold) {
    VertexRequest request;
    request.draws = {sphere(0, 36)};
    request.maxError = .25;
    request.shift = [](auto, auto) { return std::optional<ContourShifts>(); };
    EXPECT_FALSE(vertexValues(request));
}

TEST(VertexValues, AShapeOwnShareIsNotTheirs) {
    // The whole picture moves by the error of the sphere with 20 x 10 cells.
    VertexRequest request;
    request.draws = {sphere(0, 20)};
    request.draws[0].scale = 20;
    request.maxError = .25;
    request.shift = [&](std::span<const ShapeChoice> from, std::span<const ShapeChoice> to) {
        const auto off = [&](const ShapeChoice& each) {
            return 20 * request.draws[0].model->deviation(each.numbers, Fidelity::shape);
        };
        return std::optional(ContourShifts(waves(off(from[0])), waves(off(to[0]))));
    };
    const double shape = 20 * request.draws[0].model->deviation(request.draws[0].numbers, Fidelity::shape);
    ASSERT_GT(shape, .25);
    const auto found = vertexValues(request);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->programs[0].error.isKept);
    EXPECT_EQ(found->numbers[0][1], 20) << "finer counts are no matter of its vertices";
    EXPECT_LT(found->programs[0].error.pixels, .2 * shape);
    EXPECT_EQ(found->programs[0].error.colored, 0);
}

}  // namespace
}  // namespace glibra::budget
