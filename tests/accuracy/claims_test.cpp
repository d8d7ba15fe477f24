// Claims about speed: what a verdict says, and that both ways of each claim do the same work.

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "bench/core/bench.h"
#include "bench/subjects/subjects.h"
#include "samples.h"

namespace glibra::bench::test {
namespace {

TEST(Verdict, NamesTheRatioAndItsQuartiles) {
    EXPECT_EQ(verdict({1.82, 1.75, 1.9, 21}, false), "true here, by 1.82 (1.75 .. 1.90)");
    EXPECT_EQ(verdict({.5, .4, .6, 21}, false),
              "false here: the ratio is 0.50 (0.40 .. 0.60), so the other way is faster by 2.00");
    EXPECT_EQ(verdict({1.01, .98, 1.05, 21}, false),
              "false here: no difference here, the ratio is 1.01 (0.98 .. 1.05)");
    EXPECT_EQ(verdict({1.01, .98, 1.05, 21}, true),
              "true here: no difference here, the ratio is 1.01 (0.98 .. 1.05)");
}

TEST(PairedTiming, FindsTheRatioOfTwoPiecesOfWork) {
    const auto work = [](int n) {
        return [n] {
            volatile double sum = 0;
            for (int i = 0; i < n; ++i) sum = sum + 1. / (i + 1);
        };
    };
    const PairedTiming timing = timePairs(work(300'000), work(100'000), 9, true);
    EXPECT_NEAR(timing.ratio.median, 3, .5);
    EXPECT_EQ(timing.ratio.repeats, 9);
}

TEST(Claims, AreMeasuredForEveryRowAndDoTheSameWorkBothWays) {
    const std::vector<Figure> figures = quickFigures(measureClaims);
    expectSound(figures);
    std::set<std::string> rows;
    for (const Figure& figure : figures) {
        rows.insert(figure.name.substr(0, figure.name.find('-')));
        EXPECT_TRUE(figure.findings.front().find("here") != std::string::npos || figure.name == "a05")
            << figure.findings.front();
        if (figure.errorName == "largest difference") {
            for (const Curve& each : figure.curves)
                EXPECT_LT(each.points.front().error, 2e-3) << figure.name << ", " << each.name;
        }
    }
    EXPECT_EQ(rows, (std::set<std::string>{"a05", "a28", "a44", "pf02", "pf05", "pf06", "pf07", "pf08",
                                           "pf09", "pf11", "pf12", "pf16", "pf17", "pf18", "pf21", "pf22"}));
    // What the error of a method must be, whatever the machine.
    const Figure& lookups = figureOf(figures, "a05");
    for (std::size_t i = 0; i < lookups.curves[0].points.size(); ++i)
        EXPECT_NEAR(lookups.curves[0].points[i].error / lookups.curves[1].points[i].error, 1, .15);
    const Figure& pattern = figureOf(figures, "pf11");
    EXPECT_LT(pattern.curves[0].points.back().error, 1e-3);
    EXPECT_GT(pattern.curves[1].points.back().error, 1e-3);
}

}  // namespace
}  // namespace glibra::bench::test
