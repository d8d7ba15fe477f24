#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bench/core/device.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

/// What turns makes 17 turns in 10 seconds, at 60 frames per second: after k frames k * 17 / 600 turns, whose
/// fraction follows from integers.
constexpr long long kTurns = 17, kFramesOfTurns = 600;

double turnsApart(double a, double b) {
    const double apart = std::abs(a - b);
    return std::min(apart, std::abs(1 - apart));
}

/// What a shader computes the fraction of a turn from: seconds, whole seconds, the rest of them, and seconds
/// reduced to a period in double.
constexpr std::pair<const char*, const char*> kClockWays[] = {
    {"seconds as a float", "fract(given(0).x * 1.7)"},
    {"seconds as a float, reduced to ten in the shader", "fract(mod(given(0).x, 10.) * 1.7)"},
    {"whole seconds and their rest", "fract(fract(given(0).y * 1.7) + given(0).z * 1.7)"},
    {"seconds reduced to ten in double", "fract(given(0).w * 1.7)"}};

/// 600 frames from a time on.
ComputedCase clockCase(const char* label, long long seconds) {
    const long long first = 60 * seconds;
    const auto error = [first](const Numbers& fractions) {
        double largest = 0;
        long long frame = first;
        for (const glm::dvec4& each : fractions) {
            const long long turns = frame++ * kTurns % kFramesOfTurns;
            largest = std::max(largest, turnsApart(each.x, static_cast<double>(turns) / kFramesOfTurns));
        }
        return largest;
    };
    ComputedCase clock{static_cast<double>(seconds), label, error, {}};
    for (long long frame = first; frame < first + kFramesOfTurns; ++frame) {
        const double t = static_cast<double>(frame) / 60, whole = std::floor(t);
        clock.inputs.emplace_back(t, whole, t - whole, std::fmod(t, 10.));
    }
    return clock;
}

Figure clockFigure(Bench& bench) {
    Figure figure{
        .name = "clock",
        .title = "The fraction of a turn, 1.7 turns per second, by the time since the start",
        .settingName = "seconds since the start",
        .errorName = "largest error",
        .errorUnit = "turns",
        .reference = "the fraction from the number of frames, in integers; 600 frames, 60 per second",
        .alternatives = Alternatives::setting};
    std::vector<Computation> ways;
    for (const auto& [name, glsl] : kClockWays)
        ways.push_back({.name = name, .glsl = fmt::format("vec4 value() {{ return vec4({}); }}", glsl)});
    addComputed(figure, bench, ways,
                {clockCase("1 minute", 60), clockCase("10 minutes", 600), clockCase("1 hour", 3600),
                 clockCase("1 day", 86400), clockCase("1 week", 604800), clockCase("1 month", 2592000),
                 clockCase("1 year", 31536000)});
    for (const Curve& curve : figure.curves) {
        figure.findings.push_back(orderSentence(curve, "seconds", 600, 1e6));  // until errors are half a turn
        const auto late =
            std::ranges::find_if(curve.points, [](const Point& each) { return each.error > .01; });
        if (late == curve.points.end())
            figure.note("{}: within a hundredth of a turn up to {}", curve.name, curve.points.back().label);
        else
            figure.note("{}: more than a hundredth of a turn off after {}", curve.name, late->label);
    }
    return figure;
}

/// A place on a unit circle and its speed, moved by a step h of one method. Without friction it stays there.
struct OrbitMethod {
    const char *name, *glsl;
    /// The steps per turn between which the error has its order: with fewer it is too large, with more there
    /// is only rounding left.
    double from, to = std::numeric_limits<double>::infinity();
};
constexpr OrbitMethod kOrbitMethods[] = {
    {"Euler", "vec2 a = -x; x += h * v; v += h * a;", 512},
    {"Euler, speed first", "v -= h * x; x += h * v;", 256},
    {"leapfrog", "v -= .5 * h * x; x += h * v; v -= .5 * h * x;", 32, 256},
    {"midpoint", "vec2 m = x + .5 * h * v, w = v - .5 * h * x; x += h * w; v -= h * m;", 64, 512},
    {"Runge-Kutta 4",
     "vec2 k1 = v, l1 = -x, k2 = v + .5 * h * l1, l2 = -(x + .5 * h * k1), k3 = v + .5 * h * l2, "
     "l3 = -(x + .5 * h * k2), k4 = v + h * l3, l4 = -(x + h * k3); "
     "x += h / 6. * (k1 + 2. * (k2 + k3) + k4); v += h / 6. * (l1 + 2. * (l2 + l3) + l4);",
     16, 64}};

Figure orbitFigure(Bench& bench) {
    Figure figure{.name = "integrators",
                  .title = "A body on a circle under a spring, after eight and a quarter turns in a shader",
                  .settingName = "steps per turn",
                  .errorName = "distance from the place",
                  .errorUnit = "radii",
                  .reference = "the closed form: it is a quarter turn from where it began"};
    // After whole turns, the first-order term of Euler's method with the speed first is 0.
    constexpr int kOrbits = 8;
    std::vector<ComputedCase> cases;
    for (int steps = 16; steps <= bench.pick(1024, 4096); steps *= 2)
        cases.push_back({1. * steps, fmt::format("{} steps per turn", steps), [](const Numbers& place) {
                             return std::hypot(place.front().x, place.front().y - 1);
                         }});
    const auto uniforms = [](const Shader& shader, const ComputedCase& each) {
        const int steps = static_cast<int>(each.setting);
        shader.set("uSteps", kOrbits * steps + steps / 4).set("uStep", 2 * std::numbers::pi / steps);
    };
    std::vector<Computation> ways;
    for (const OrbitMethod& method : kOrbitMethods)
        ways.push_back({.name = method.name,
                        .glsl = fmt::format(R"(uniform int uSteps;
uniform float uStep;
vec4 value() {{
    float h = uStep;
    vec2 x = vec2(1., 0.), v = vec2(0., 1.);
    for (int i = 0; i < uSteps; ++i) {{ {} }}
    return vec4(x, v);
}}
)",
                                            method.glsl),
                        .uniforms = uniforms});
    addComputed(figure, bench, ways, cases);
    for (std::size_t i = 0; i < figure.curves.size(); ++i)
        figure.findings.push_back(
            orderSentence(figure.curves[i], "steps", kOrbitMethods[i].from, kOrbitMethods[i].to));
    return figure;
}

}  // namespace

std::vector<Figure> measureTime(Bench& bench) {
    return {clockFigure(bench), orbitFigure(bench)};
}

}  // namespace glibra::bench
