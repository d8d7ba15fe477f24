// Least counts compared with trying all counts.

#include "budget/least_counts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <random>

#include "glib/statement_table.h"
#include "scene/primitives.h"

namespace glibra::budget {
namespace {

using glib::CommandId;

std::uint64_t vertices(CommandId command, const std::vector<double>& numbers) {
    return scene::countsOf({command, numbers, {}, nullptr})->vertices;
}

CountsRequest countsRequest(CommandId command, std::vector<double> numbers, double allowed,
                            Fidelity fidelity = Fidelity::shape) {
    return {.model = surfaceModel(command),
            .numbers = std::move(numbers),
            .isFree = {true, true},
            .fidelity = fidelity,
            .allowed = allowed};
}

bool isKept(const CountsRequest& wanted, const std::vector<double>& numbers) {
    return wanted.model->deviation(numbers, wanted.fidelity) <= wanted.allowed;
}

/// Returns the smallest number of vertices among all counts below 300 that keep the bound.
std::uint64_t fewestOfAll(const CountsRequest& wanted) {
    std::uint64_t fewest = std::numeric_limits<std::uint64_t>::max();
    std::vector<double> numbers = wanted.numbers;
    for (int a = wanted.model->counts[0].least; a < 300; ++a)
        for (int b = wanted.model->counts[1].least; b < 300; ++b) {
            numbers[wanted.model->counts[0].index] = a;
            numbers[wanted.model->counts[1].index] = b;
            if (isKept(wanted, numbers)) fewest = std::min(fewest, vertices(wanted.model->command, numbers));
        }
    return fewest;
}

TEST(LeastCounts, HaveTheFewestVerticesOfAllThatKeepTheBound) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> exponent(-3.2, -.5);
    for (int i = 0; i < 12; ++i)
        for (const Fidelity fidelity : {Fidelity::shape, Fidelity::pattern})
            for (const CountsRequest& wanted : {countsRequest(glib::commandOf("Sphere"), {1, 60, 60},
                                                              std::pow(10, exponent(random)), fidelity),
                                                countsRequest(glib::commandOf("Torus"), {1, .4, 20, 40},
                                                              std::pow(10, exponent(random)), fidelity),
                                                countsRequest(glib::commandOf("Cone"), {1, 1, 60, 20},
                                                              std::pow(10, exponent(random)), fidelity)}) {
                const std::vector<double> found = leastCounts(wanted);
                EXPECT_TRUE(isKept(wanted, found));
                EXPECT_EQ(vertices(wanted.model->command, found), fewestOfAll(wanted)) << wanted.allowed;
            }
}

TEST(LeastCounts, GoUpToWhereOneFewerBreaksTheBound) {
    for (const double allowed : {.1, .01, 1e-3, 1e-4, 1e-5, 1e-6}) {
        const CountsRequest wanted = countsRequest(glib::commandOf("DiskXY"), {0, 1, 60, 10}, allowed);
        const std::vector<double> found = leastCounts(wanted);
        ASSERT_TRUE(isKept(wanted, found));
        // r (1 - cos(pi/n)) <= e
        const double least = std::ceil(std::numbers::pi / std::acos(1 - allowed) - 1e-9);
        EXPECT_EQ(found[2], std::max(3., least)) << allowed;
        EXPECT_EQ(found[3], 1);
    }
}

TEST(LeastCounts, KeepWhatIsNotFree) {
    CountsRequest wanted = countsRequest(glib::commandOf("Sphere"), {1, 90, 7}, .001);
    wanted.isFree = {true, false};
    const std::vector<double> coarse = leastCounts(wanted);
    EXPECT_EQ(coarse[2], 7);
    // Seven stacks alone are off by .025.
    EXPECT_GT(wanted.model->deviation(coarse, wanted.fidelity), .02);
    // The slices are chosen as if there were enough stacks; they are not the largest possible number.
    EXPECT_EQ(coarse[1], leastCounts(countsRequest(glib::commandOf("Sphere"), {1, 90, 7}, .001))[1]);

    wanted = countsRequest(glib::commandOf("Sphere"), {1, 90, 7}, .01);
    wanted.isFree = {false, true};
    const std::vector<double> fine = leastCounts(wanted);
    EXPECT_EQ(fine[1], 90);
    EXPECT_TRUE(isKept(wanted, fine));
    EXPECT_GT(surfaceModel(glib::commandOf("Sphere"))
                  ->deviation(std::vector{1., 90., fine[2] - 1}, Fidelity::shape),
              .01);
}

TEST(LeastCounts, DoNotGoBelowWhatIsAskedFor) {
    CountsRequest wanted =
        countsRequest(glib::commandOf("Sphere"), {1, 60, 60}, std::numeric_limits<double>::infinity());
    wanted.least = {36, 18};
    EXPECT_EQ(leastCounts(wanted), (std::vector<double>{1, 36, 18}));
    wanted.least = {1, 1};
    EXPECT_EQ(leastCounts(wanted), (std::vector<double>{1, 3, 2}));
}

TEST(LeastCounts, StopAtTheLimitAndSaySo) {
    for (const CommandId command :
         {glib::commandOf("Sphere"), glib::commandOf("Teapot"), glib::commandOf("Soccerball")}) {
        std::vector<double> numbers{1, 60, 60};
        if (command != glib::commandOf("Sphere"))
            numbers = surfaceModel(command)->complete({command, {1}, {}, {}});
        if (command == glib::commandOf("Teapot")) numbers = {16};
        const CountsRequest wanted = countsRequest(command, numbers, 1e-15);
        const std::vector<double> found = leastCounts(wanted);
        EXPECT_FALSE(isKept(wanted, found));
        EXPECT_LE(vertices(command, found), kMostBudgetVertices);
        EXPECT_GT(vertices(command, found), kMostBudgetVertices * 9 / 10);
    }
}

}  // namespace
}  // namespace glibra::budget
