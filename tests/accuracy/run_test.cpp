// Fronts, timing, orders of convergence, and runs of subjects.

#include "bench/core/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/core/figure.h"
#include "bench/report/reports.h"
#include "bench/subjects/subjects.h"
#include "samples.h"

namespace glibra::bench::test {
namespace {

std::string frontOf(Figure figure) {
    markFront(figure);
    std::string marks;
    for (const Curve& curve : figure.curves) {
        for (const Point& point : curve.points) marks += point.isOnFront ? '*' : '.';
        marks += ' ';
    }
    return marks;
}

TEST(Front, HoldsPointsThatNothingCheaperBeats) {
    Figure figure;
    figure.curves = {{"a", {timedPoint(1, .5, 1), timedPoint(2, .1, 4), timedPoint(3, .05, 9)}},
                     {"b", {timedPoint(1, .6, 2), timedPoint(2, .2, 3), timedPoint(3, .05, 12)}}};
    EXPECT_EQ(frontOf(figure), "*** .*. ");
}

TEST(Front, IsByTheSettingUnlessAllPointsAreTimed) {
    Figure figure;
    figure.curves = {{"a", {timedPoint(4, .1, 1)}}, {"b", {timedPoint(2, .2, 5)}}};
    EXPECT_EQ(frontOf(figure), "* . ");
    figure.curves[1].points[0].time.reset();
    EXPECT_EQ(frontOf(figure), "* * ") << "the setting 2 is cheaper than 4";
}

TEST(Front, HoldsEqualPointsTogetherAndNeverOneWithoutError) {
    Figure figure;
    figure.curves = {
        {"a", {timedPoint(1, .1, 1), timedPoint(2, .1, 2)}},
        {"b", {timedPoint(1, .1, 1), timedPoint(1, std::numeric_limits<double>::quiet_NaN(), .1)}}};
    EXPECT_EQ(frontOf(figure), "*. *. ");
}

TEST(Front, KnowsTheSpreadOfTheTimes) {
    Figure figure;
    figure.curves = {{"a", {timedPoint(1, 89.9, .99), timedPoint(2, .1, 1), timedPoint(3, 60, .5)}}};
    for (Point& each : figure.curves[0].points) each.time->low = each.time->high = each.time->median;
    EXPECT_EQ(frontOf(figure), ".** ") << "one percent faster is not faster";
    figure.curves[0].points[0].time = Timing{.8, .7, 1.05, 9};
    EXPECT_EQ(frontOf(figure), ".** ") << "the spreads overlap";
    figure.curves[0].points[0].time = Timing{.3, .29, .31, 9};
    EXPECT_EQ(frontOf(figure), "*** ");
}

TEST(Front, IsNotEmptyWhereOneTimeOverlapsTheNext) {
    // Each time overlaps the next one, and the last is ten times the first.
    Figure figure;
    Curve& curve = figure.curves.emplace_back(Curve{"a", {}});
    for (int i = 0; i < 30; ++i) {
        Point& point = curve.points.emplace_back(timedPoint(i, 1. / (i + 1), 1 + .3 * i));
        point.time = Timing{1 + .3 * i, .8 + .3 * i, 1.2 + .3 * i, 9};
    }
    markFront(figure);
    const auto front = std::count_if(curve.points.begin(), curve.points.end(),
                                     [](const Point& each) { return each.isOnFront; });
    EXPECT_GT(front, 5);
    EXPECT_LT(front, 30);
    EXPECT_TRUE(curve.points.back().isOnFront);
}

TEST(Recommendation, SaysWhatToUseAndWhatTheEndsOfTheFrontGive) {
    Figure figure;
    figure.errorName = "largest distance";
    figure.errorUnit = "pixels";
    figure.curves = {{"fine", {timedPoint(1, .001, 1), timedPoint(2, .0001, 100)}},
                     {"coarse", {timedPoint(1, 5, .1)}}};
    markFront(figure);
    const std::string text = recommendation(figure);
    EXPECT_EQ(text.rfind("In short: use fine (", 0), 0U) << text;
    EXPECT_NE(text.find("; most accurate is fine ("), std::string::npos) << text;
    EXPECT_NE(text.find("; cheapest is coarse ("), std::string::npos) << text;
    figure.alternatives = Alternatives::none;
    EXPECT_EQ(recommendation(figure), "");
}

/// A figure whose settings are difficulties.
Figure byDifficulty(std::vector<Curve> curves) {
    Figure figure;
    figure.settingName = "distance";
    figure.alternatives = Alternatives::setting;
    figure.curves = std::move(curves);
    markFront(figure);
    return figure;
}

TEST(Recommendation, IsTheSmallestMeanProductWhereSettingsAreDifficulties) {
    // A million times more accurate where it is difficult, for 1.7 times the time everywhere.
    const Figure figure = byDifficulty(
        {{"textbook", {timedPoint(1, 1e-7, 1), timedPoint(2, 1e-3, 1), timedPoint(3, 1, 1)}},
         {"stable", {timedPoint(1, 1e-7, 1.7), timedPoint(2, 1e-6, 1.7), timedPoint(3, 1e-6, 1.7)}}});
    EXPECT_EQ(recommendation(figure),
              "In short: use stable, the best choice over all settings of distance together, and for 2 of 3 "
              "alone");
    EXPECT_EQ(recommendation(byDifficulty(
                  {{"a", {pointAt(1, .1), pointAt(2, .1)}}, {"b", {pointAt(1, .3), pointAt(2, .9)}}})),
              "In short: use a, at all settings of distance");
}

TEST(Recommendation, IsTheSameWhenTimesVary) {
    const auto sentence = [](double noise) {
        const Figure figure =
            byDifficulty({{"fast", {timedPoint(1, .02, 1), timedPoint(2, .02, 1)}},
                          {"fine", {timedPoint(1, .01, 2 * noise), timedPoint(2, .01, 2 * noise)}}});
        return recommendation(figure);
    };
    for (const double noise : {.8, .95, 1., 1.05, 1.2}) EXPECT_EQ(sentence(noise), sentence(1)) << noise;
    EXPECT_EQ(sentence(1), "In short: use fine, at all settings of distance");
}

TEST(Recommendation, IsNothingThatIsWrong) {
    Figure figure = byDifficulty({{"cheap", {timedPoint(1, .001, .01), timedPoint(2, .3, .01)}},
                                  {"right", {timedPoint(1, .001, 9), timedPoint(2, .001, 9)}}});
    EXPECT_NE(recommendation(figure).find("use cheap"), std::string::npos);
    figure.countsWrong = true;
    EXPECT_NE(recommendation(figure).find("use right"), std::string::npos) << recommendation(figure);

    Figure angles;
    angles.errorUnit = "degrees";
    angles.curves = {{"grid", {timedPoint(1, 106, 1), timedPoint(2, 90, 2)}}};
    markFront(angles);
    EXPECT_EQ(recommendation(angles), "");
    angles.curves[0].points.push_back(timedPoint(3, .5, 500));
    angles.curves[0].points.push_back(timedPoint(4, .1, 5000));
    EXPECT_NE(recommendation(angles).find("use grid (3)"), std::string::npos) << recommendation(angles);
}

TEST(Recommendation, IsNothingThatASceneCannotUse) {
    Figure figure = byDifficulty({{"on the processor", {timedPoint(1, 1e-9, .1), timedPoint(2, 1e-9, .1)}},
                                  {"shader", {timedPoint(1, .1, 1), timedPoint(2, .1, 1)}},
                                  {"slow shader", {timedPoint(1, .1, 9), timedPoint(2, .1, 9)}}});
    EXPECT_NE(recommendation(figure).find("use on the processor"), std::string::npos);
    figure.curves[0].isForScenes = false;
    EXPECT_EQ(recommendation(figure), "In short: use shader, at all settings of distance");
}

TEST(Recommendation, AnErrorOfNothingIsNoReasonToPayForIt) {
    Figure figure;
    figure.curves = {{"a", {timedPoint(1, .01, 1), timedPoint(2, 0, 1000)}}};
    markFront(figure);
    EXPECT_NE(recommendation(figure).find("use a (1)"), std::string::npos) << recommendation(figure);
}

TEST(Front, HoldsNoTheory) {
    Figure figure;
    figure.curves = {{"a", {pointAt(1, .2), pointAt(2, .1)}},
                     {"theory: a", {pointAt(1, .1), pointAt(2, .05)}}};
    EXPECT_EQ(frontOf(figure), ".. ** ");
    figure.curves[1].theoryOf = 0;
    EXPECT_EQ(frontOf(figure), "** .. ");
}

TEST(Front, IsOneOfAlternativesOnly) {
    Figure figure;
    figure.curves = {{"a", {timedPoint(1, .1, 1), timedPoint(2, .3, 2)}},
                     {"b", {timedPoint(1, .2, 3), timedPoint(2, .2, 4)}}};
    EXPECT_EQ(frontOf(figure), "*. .. ");
    figure.alternatives = Alternatives::curve;
    EXPECT_EQ(frontOf(figure), "*. *. ");
    figure.alternatives = Alternatives::setting;
    EXPECT_EQ(frontOf(figure), "** .* ");
    figure.alternatives = Alternatives::none;
    EXPECT_EQ(frontOf(figure), ".. .. ");
}

TEST(TimingOf, InterpolatesQuartilesBetweenRanks) {
    const Timing five = timingOf({5, 1, 4, 2, 3});
    EXPECT_EQ(five.low, 2);
    EXPECT_EQ(five.median, 3);
    EXPECT_EQ(five.high, 4);
    EXPECT_EQ(five.repeats, 5);
    const Timing four = timingOf({10, 40, 20, 30});
    EXPECT_EQ(four.low, 17.5);
    EXPECT_EQ(four.median, 25);
    EXPECT_EQ(four.high, 32.5);
    EXPECT_EQ(timingOf({7}).high, 7);
}

TEST(Timing, IsRepeatedAndOrdered) {
    const Bench quick({.quick = true});
    int calls = 0;
    const Timing timing = quick.time([&] { ++calls; });
    EXPECT_EQ(timing.repeats, 3);
    EXPECT_LE(timing.low, timing.median);
    EXPECT_LE(timing.median, timing.high);
}

/// A clock of its own: work that takes `cold` seconds the first time and `warm` from then on.
struct FakeWork {
    double cold, warm;
    std::vector<int> times{};  ///< of each measurement

    double operator()(int count) {
        times.push_back(count);
        return (times.size() == 1 ? cold - warm : 0) + warm * count;
    }
};

Timing timed(FakeWork& work, bool quick = false, double enough = .5) {
    return timingBy(std::ref(work), quick, enough);
}

TEST(TimingBy, RepeatsShortWorkInsideOneMeasurementHoweverColdTheFirstCallIs) {
    for (const double cold : {2e-9, 1e-6, 1e-3, 1.}) {
        FakeWork work{.cold = cold, .warm = 2e-9};
        const Timing timing = timed(work, true);
        EXPECT_NEAR(timing.median, 2e-9, 1e-12) << cold;
        EXPECT_EQ(timing.repeats, 3);
        EXPECT_GE(work.times.back() * work.warm, 20e-6) << cold;
    }
}

TEST(TimingBy, RepeatsMiddlingWorkUntilItIsEnoughAndLongWorkThreeTimes) {
    FakeWork middling{.cold = .01, .warm = .01};
    EXPECT_EQ(timed(middling).repeats, 50);
    EXPECT_EQ(middling.times.back(), 1);
    FakeWork slower{.cold = .2, .warm = .2};
    EXPECT_EQ(timed(slower).repeats, 5);
    FakeWork longest{.cold = 1, .warm = 1};
    EXPECT_EQ(timed(longest).repeats, 3);
    EXPECT_EQ(longest.times.size(), 3U) << "the first one counts";
    FakeWork standing{.cold = 0, .warm = 0};
    EXPECT_EQ(timed(standing).median, 0) << "a clock that stands still ends, too";
}

TEST(FittedOrder, FindsThePowerOfAPowerLaw) {
    Curve curve{"c", {}};
    for (const double n : {4., 8., 16., 64.}) curve.points.push_back(pointAt(n, 3 * std::pow(n, -2.5)));
    EXPECT_NEAR(fittedOrder(curve), -2.5, 1e-12);
    curve.points.push_back(pointAt(128, 1));
    EXPECT_GT(fittedOrder(curve), -2) << "it has to see the outlier";
    EXPECT_NEAR(fittedOrder(curve, 0, 64), -2.5, 1e-12);
    EXPECT_TRUE(std::isnan(fittedOrder(curve, 100)));
    EXPECT_EQ(orderSentence(curve, "n", 0, 64), "c: error falls as n^-2.50");
}

TEST(LogAxis, PlacesPowersAtEqualSteps) {
    const std::vector<double> values{1e-6, 1e3};
    const LogAxis axis(values, 10);
    const double step = axis.place(10) - axis.place(1);
    EXPECT_NEAR(axis.place(1e-3) - axis.place(1e-4), step, 1e-12);
    EXPECT_EQ(axis.place(0), 0);
    for (const Tick& tick : axis.ticks()) {
        EXPECT_GE(tick.place, 0);
        EXPECT_LE(tick.place, 1);
    }
    EXPECT_EQ(axis.ticks().size(), 10U);
}

TEST(LogAxis, NeverHasOneLabelAlone) {
    for (double low = 1; low < 10; low *= 1.07)
        for (const double factor : {1., 1.3, 2., 4., 30., 300.}) {
            const std::vector<double> values{low, low * factor};
            EXPECT_GE(LogAxis(values, 8).ticks().size(), 2U) << low << " to " << low * factor;
        }
}

TEST(LogAxis, HasFewDigitsWhereTheyAreEnough) {
    const std::vector<double> values{1, 20};
    std::string labels;
    const LogAxis axis(values, 8);
    for (const Tick& tick : axis.ticks()) labels += tick.label + " ";
    EXPECT_EQ(labels, "1 2 5 10 20 ");
}

std::vector<Figure> fails(Bench& /*bench*/) {
    throw Failed({diagnose("gpu-E01", "no usable OpenGL driver")});
}
std::vector<Figure> works(Bench& /*bench*/) {
    Figure figure;
    figure.name = "one";
    figure.curves = {{"c", {pointAt(1, .5)}}};
    return {figure};
}

std::vector<Figure> crashes(Bench& /*bench*/) {
    std::raise(SIGSEGV);
    return {};
}
std::vector<Figure> throws(Bench& /*bench*/) {
    throw std::runtime_error("no memory for that");
}

/// Needs a process into which no earlier test has loaded a driver: --gtest_filter='*ApartFromTheStart.*'
TEST(RunApartFromTheStart, ASubjectThatCrashesIsReportedAndTheOthersAreMeasured) {
    const std::vector<Subject> table{
        {"one", "One", works}, {"bad", "Bad", crashes}, {"worse", "Worse", throws}, {"last", "Last", works}};
    std::vector<const Subject*> chosen;
    for (const Subject& each : table) chosen.push_back(&each);
    std::vector<std::size_t> known;
    const Report report =
        run(chosen, {.quick = true},
            {.measured = [&](const Report& soFar) { known.push_back(soFar.subjects.size()); }});
    EXPECT_EQ(known, (std::vector<std::size_t>{1, 2, 3, 4})) << "each result is given at once";
    ASSERT_EQ(report.subjects.size(), 4U);
    for (const std::size_t good : {0U, 3U}) {
        ASSERT_EQ(report.subjects[good].figures.size(), 1U);
        EXPECT_EQ(report.subjects[good].figures[0].curves[0].points[0].error, .5);
        EXPECT_TRUE(report.subjects[good].figures[0].curves[0].points[0].isOnFront);
        EXPECT_TRUE(report.subjects[good].diagnostics.empty());
    }
    ASSERT_EQ(report.subjects[1].diagnostics.size(), 1U);
    EXPECT_EQ(toString(report.subjects[1].diagnostics[0]),
              "error: subject 'bad' ended by signal 11 (Segmentation fault) [bench-E04]");
    ASSERT_EQ(report.subjects[2].diagnostics.size(), 1U);
    EXPECT_EQ(report.subjects[2].diagnostics[0].text, "subject 'worse' failed: no memory for that");
    EXPECT_FALSE(report.machine.processor.empty());
}

std::string problemsOfTheOtherProcess(const std::string& /*request*/) {
    Bench bench({.quick = true});
    if (bench.capabilities().family.find("llvmpipe") == std::string::npos) return "skipped";
    std::string text = filteredInBytes(bench, crashes) ? "points" : "none";
    for (const Diagnostic& each : bench.problems()) text += "; " + toString(each);
    return text;
}

TEST(FilteredInBytesApartFromTheStart, TellsWhyThereIsNoCurve) {
    const std::optional<std::string> answer = Apart().run(problemsOfTheOtherProcess, "");
    if (answer == "skipped") GTEST_SKIP() << "only llvmpipe filters in bytes";
    EXPECT_EQ(answer, "none; warning: subject 'bytes' ended by signal 11 (Segmentation fault) [bench-E04]");
}

TEST(Run, ContinuesAfterASubjectThatFails) {
    const std::vector<Subject> table{{"bad", "Bad", fails}, {"good", "Good", works}};
    const std::vector<const Subject*> chosen{&table[0], &table[1]};
    std::vector<std::string> started;
    const Report report =
        run(chosen, {.quick = true}, {.begins = [&](const Subject& subject, std::size_t, std::size_t) {
                started.emplace_back(subject.name);
            }});
    EXPECT_EQ(started, (std::vector<std::string>{"bad", "good"}));
    ASSERT_EQ(report.subjects.size(), 2U);
    EXPECT_TRUE(hasError(report.subjects[0].diagnostics));
    EXPECT_TRUE(lacksDriver(report));
    ASSERT_EQ(report.subjects[1].figures.size(), 1U);
    EXPECT_TRUE(report.subjects[1].figures[0].curves[0].points[0].isOnFront);
    EXPECT_FALSE(report.machine.processor.empty());
    EXPECT_GT(report.machine.cores, 0);
    EXPECT_EQ(report.date.size(), std::string("2026-03-01T12:00:00Z").size());
}

TEST(Subjects, HaveUniqueNames) {
    std::vector<std::string_view> names;
    for (const Subject& each : subjects()) {
        EXPECT_EQ(std::ranges::count(names, each.name), 0) << each.name;
        EXPECT_FALSE(each.title.empty());
        names.push_back(each.name);
    }
    EXPECT_FALSE(names.empty());
}

}  // namespace
}  // namespace glibra::bench::test
