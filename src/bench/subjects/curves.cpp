#include "bench/subjects/curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/core/fit.h"
#include "bench/draw/offscreen.h"
#include "bench/draw/shader_values.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

/// The largest distance of the parameters from i / n, which double gives to 1e-16.
template <class Next>
double largestParameterError(int steps, Next next) {
    double largest = 0;
    for (int i = 1; i <= steps; ++i)
        largest = std::max(largest, std::abs(static_cast<double>(next(i)) - static_cast<double>(i) / steps));
    return largest;
}

double summed(int steps) {
    const float step = 1.F / static_cast<float>(steps);
    return largestParameterError(steps, [&, t = 0.F](int) mutable { return t += step; });
}

/// Kahan, Further remarks on reducing truncation errors, Communications of the ACM 8(1), 1965.
double summedWithCompensation(int steps) {
    const float step = 1.F / static_cast<float>(steps);
    return largestParameterError(steps, [&, t = 0.F, lost = 0.F](int) mutable {
        const float wanted = step - lost, next = t + wanted;
        lost = (next - t) - wanted;
        return t = next;
    });
}

double multipliedStep(int steps) {
    const float step = 1.F / static_cast<float>(steps);
    return largestParameterError(steps, [&](int i) { return static_cast<float>(i) * step; });
}

double divided(int steps) {
    return largestParameterError(steps,
                                 [&](int i) { return static_cast<float>(i) / static_cast<float>(steps); });
}

double summedInDouble(int steps) {
    const double step = 1. / steps;
    return largestParameterError(steps, [&, t = 0.](int) mutable { return t += step; });
}

struct ParameterMethod {
    const char* name;
    double (*largestError)(int steps);
    std::size_t bytes;  ///< of the state between two steps
};

constexpr ParameterMethod kParameterMethods[] = {
    {"float, t += dt", summed, sizeof(float)},
    {"float, t += dt with compensation", summedWithCompensation, 2 * sizeof(float)},
    {"float, t = i * dt", multipliedStep, sizeof(int)},
    {"float, t = i / n", divided, sizeof(int)},
    {"double, t += dt", summedInDouble, sizeof(double)},
};

constexpr const char* kSummingShader = R"(uniform int uSteps;
vec4 value() {
    float dt = 1. / float(uSteps), t = 0.;
    for (int i = 0; i < uSteps; i += 10) {
        t += dt; t += dt; t += dt; t += dt; t += dt;
        t += dt; t += dt; t += dt; t += dt; t += dt;
    }
    return vec4(t);
}
)";

/// Drivers may end a loop early: llvmpipe does so after 65,535 rounds of all loops together.
constexpr int kMostShaderSteps = 100000;
constexpr int kManyRuns = 1000000;
constexpr const char* kLoopShader = R"(uniform int uRuns;
vec4 value() {
    int i = 0;
    while (i < uRuns) ++i;
    return vec4(i);
}
)";

Point stepsPoint(int steps, double error, const Timing& time, double bytes) {
    return {.setting = static_cast<double>(steps),
            .label = fmt::format("{} steps", steps),
            .error = error,
            .time = time,
            .memory = bytes};
}

/// The last parameter only, which is the worst one of a sum.
Result<Curve> summedInShader(Bench& bench, const std::vector<int>& counts) {
    const Four nothing{};
    const Result<ShaderValues> shader = ShaderValues::create(bench, kSummingShader, std::span(&nothing, 1));
    if (!shader) return shader.diagnostics;
    Curve curve{"shader, t += dt (at the end)", {}};
    for (const int steps : counts) {
        setInt(shader->program(), "uSteps", steps);
        const Result<std::vector<Four>> values = shader->values();
        if (!values) return values.diagnostics;
        const double error = std::abs(static_cast<double>(values->front()[0]) - 1);
        curve.points.push_back(
            stepsPoint(steps, error, bench.time([&] { shader->compute(); }), shader->bytes()));
    }
    return curve;
}

/// How many rounds a loop of kManyRuns rounds makes in a shader.
Result<int> loopRuns(Bench& bench) {
    const Four nothing{};
    const Result<ShaderValues> shader = ShaderValues::create(bench, kLoopShader, std::span(&nothing, 1));
    if (!shader) return shader.diagnostics;
    setInt(shader->program(), "uRuns", kManyRuns);
    const Result<std::vector<Four>> values = shader->values();
    if (!values) return values.diagnostics;
    return static_cast<int>(values->front()[0]);
}

/// How many of the loops `for (float t = 0; t <= 1; t += 1 / n)`, n = 2..1000, do not make n + 1 rounds.
int miscountedLoops() {
    int wrong = 0;
    for (int n = 2; n <= 1000; ++n) {
        const float step = 1.F / static_cast<float>(n);
        int runs = 0;
        float t = 0;
        while (t <= 1) {
            ++runs;
            t += step;
        }
        if (runs != n + 1) ++wrong;
    }
    return wrong;
}

}  // namespace

Figure parameterFigure(Bench& bench, Diagnostics& problems) {
    Figure figure;
    figure.name = "parameter";
    figure.title = "The parameter of a curve, from 0 to 1 in n steps";
    figure.settingName = "steps";
    figure.errorName = "largest error of t";
    figure.reference = "i / n in double";
    figure.alternatives = Alternatives::setting;
    std::vector<int> counts{10, 100, 1000, 10000, 100000};
    if (!bench.isQuick()) counts.insert(counts.end(), {1000000, 10000000});
    for (const ParameterMethod& method : kParameterMethods) {
        Curve& curve = figure.curves.emplace_back(Curve{method.name, {}});
        for (const int steps : counts) {
            // The result must reach memory, otherwise the compiler removes the work.
            const Timing time = bench.time([&] {
                const volatile double kept = method.largestError(steps);
                static_cast<void>(kept);
            });
            curve.points.push_back(
                stepsPoint(steps, method.largestError(steps), time, static_cast<double>(method.bytes)));
        }
    }
    std::vector<int> shaderCounts = counts;
    std::erase_if(shaderCounts, [](int steps) { return steps > kMostShaderSteps; });
    Result<Curve> shader = summedInShader(bench, shaderCounts);
    append(problems, std::move(shader.diagnostics));
    if (shader) figure.curves.push_back(std::move(*shader));
    for (const Curve& curve : figure.curves) figure.findings.push_back(orderSentence(curve, "steps", 100));
    const Point &sum = figure.curves[0].points.back(), &quotient = figure.curves[3].points.back();
    figure.findings.push_back(fmt::format("{}: t is {} off when accumulated, {} when computed as i / n",
                                          sum.label, numberText(sum.error), numberText(quotient.error)));
    figure.findings.push_back(
        fmt::format("of the 999 loops for (t = 0; t <= 1; t += 1 / n) with n from 2 to "
                    "1000, {} do not run n + 1 times",
                    miscountedLoops()));
    if (const Result<int> runs = loopRuns(bench); runs && *runs < kManyRuns)
        figure.findings.push_back(
            fmt::format("this driver ends a shader's loop of {} runs after {}", kManyRuns, *runs));
    return figure;
}

Result<std::vector<Figure>> measureCurves(Bench& bench) {
    Diagnostics problems;
    std::vector<Figure> figures{parameterFigure(bench, problems), chordFigure(bench, false),
                                chordFigure(bench, true), streamlineFigure(bench)};
    return {std::move(figures), std::move(problems)};
}

}  // namespace glibra::bench
