#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <glm/geometric.hpp>

#include "bench/core/device.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

/// A sequence of n parameters from a function that is made for n and gives one after the other. The error is
/// their largest distance from i / n, which double gives to 1e-16. `bytes` are those of the state between two
/// steps.
template <class MakeNext>
Computation parameterWay(const char* name, std::size_t bytes, MakeNext makeNext) {
    const auto largestError = [makeNext](const ComputedCase& each, Numbers& result) {
        const int steps = static_cast<int>(each.setting);
        auto next = makeNext(steps);
        double largest = 0;
        for (int i = 1; i <= steps; ++i)
            largest =
                std::max(largest, std::abs(static_cast<double>(next(i)) - static_cast<double>(i) / steps));
        result.front().x = largest;
    };
    return {name, largestError, static_cast<double>(bytes)};
}

float floatStep(int n) {
    return 1.F / static_cast<float>(n);
}

std::vector<Computation> parameterWays() {
    return {
        parameterWay("float, t += dt", sizeof(float),
                     [](int n) { return [dt = floatStep(n), t = 0.F](int) mutable { return t += dt; }; }),
        // Kahan, Further remarks on reducing truncation errors, Communications of the ACM 8(1), 1965.
        parameterWay("float, t += dt with compensation", 2 * sizeof(float),
                     [](int n) {
                         return [dt = floatStep(n), t = 0.F, lost = 0.F](int) mutable {
                             const float wanted = dt - lost, next = t + wanted;
                             lost = (next - t) - wanted;
                             return t = next;
                         };
                     }),
        parameterWay("float, t = i * dt", sizeof(int),
                     [](int n) { return [dt = floatStep(n)](int i) { return static_cast<float>(i) * dt; }; }),
        parameterWay(
            "float, t = i / n", sizeof(int),
            [](int n) { return [n](int i) { return static_cast<float>(i) / static_cast<float>(n); }; }),
        parameterWay("double, t += dt", sizeof(double),
                     [](int n) { return [dt = 1. / n, t = 0.](int) mutable { return t += dt; }; }),
    };
}

constexpr const char* kSummingShader = R"(uniform int uSteps;
vec4 value() {
    float dt = 1. / float(uSteps), t = 0.;
    for (int i = 0; i < uSteps; i += 10) {
        t += dt; t += dt; t += dt; t += dt; t += dt;
        t += dt; t += dt; t += dt; t += dt; t += dt;
    }
    return vec4(abs(t - 1.));  // the last parameter is the worst one of a sum
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

Figure parameterFigure(Bench& bench) {
    Figure figure{.name = "parameter",
                  .title = "The parameter of a curve, from 0 to 1 in n steps",
                  .settingName = "steps",
                  .errorName = "largest error of t",
                  .reference = "i / n in double",
                  .alternatives = Alternatives::setting};
    const auto upTo = [](int most) {
        std::vector<ComputedCase> cases;
        for (int steps = 10; steps <= most; steps *= 10)
            cases.push_back({1. * steps, fmt::format("{} steps", steps),
                             [](const Numbers& error) { return error.front().x; }});
        return cases;
    };
    addComputed(figure, bench, parameterWays(), upTo(bench.pick(100000, 10000000)));
    addComputed(figure, bench,
                {{.name = "shader, t += dt (at the end)",
                  .glsl = kSummingShader,
                  .uniforms =
                      [](const Shader& shader, const ComputedCase& each) {
                          shader.set("uSteps", static_cast<int>(each.setting));
                      }}},
                upTo(kMostShaderSteps));
    std::optional<int> runs;  // of a loop of kManyRuns in a shader
    bench.attempt([&] {
        const ShaderValues loop(bench, kLoopShader, std::array{Four(0)});
        loop.shader().set("uRuns", kManyRuns);
        runs = static_cast<int>(loop.values().front()[0]);
    });
    figure.noteOrders("steps", 100);
    figure.note("{}: t is {} off when accumulated, {} when computed as i / n", figure.last(0).label,
                numberText(figure.last(0).error), numberText(figure.last(3).error));
    figure.note(
        "of the 999 loops for (t = 0; t <= 1; t += 1 / n) with n from 2 to 1000, {} do not run n + 1 times",
        miscountedLoops());
    if (runs && *runs < kManyRuns)
        figure.note("this driver ends a shader's loop of {} runs after {}", kManyRuns, *runs);
    return figure;
}

using Cubic = std::array<glm::dvec2, 4>;

/// Almost a cusp in the middle; length 1 from end to end.
constexpr Cubic kCurve{glm::dvec2(0, 0), glm::dvec2(.96, 1), glm::dvec2(.04, 1), glm::dvec2(1, 0)};

/// Horner's scheme in powers of t, as programs evaluate it.
glm::dvec2 powerForm(double t) {
    const glm::dvec2 first = 3. * (kCurve[1] - kCurve[0]),
                     second = 3. * (kCurve[0] - 2. * kCurve[1] + kCurve[2]),
                     third = kCurve[3] - 3. * kCurve[2] + 3. * kCurve[1] - kCurve[0];
    return kCurve[0] + t * (first + t * (second + t * third));
}

/// De Casteljau's algorithm.
glm::dvec2 byDeCasteljau(double t) {
    Cubic p = kCurve;
    for (std::size_t level = 3; level > 0; --level)
        for (std::size_t i = 0; i < level; ++i) p[i] = (1 - t) * p[i] + t * p[i + 1];
    return p[0];
}

constexpr double kSteepness = 200;

glm::dvec2 step(double t) {
    return {t, .25 * std::tanh(kSteepness * (t - .4))};
}

/// The same with exponentials.
glm::dvec2 stepByExponentials(double t) {
    return {t, .25 - .5 / (std::exp(2 * kSteepness * (t - .4)) + 1)};
}

/// t runs from 0 to 1.
struct ChordShape {
    const char *name, *title, *reference;
    glm::dvec2 (*place)(double t);
    glm::dvec2 (*truth)(double t);  ///< by another formula
};

constexpr ChordShape kBezierShape{
    "chords", "A Bézier curve with a narrow bend, as line segments",
    "de Casteljau's algorithm in double at 32 points of every segment; a length is that from end to end",
    powerForm, byDeCasteljau};
constexpr ChordShape kStepShape{
    "chords-step", "A graph with a steep step, as line segments",
    "the step from exponentials in double at 32 points of every segment; a length is that of the t axis",
    step, stepByExponentials};

struct Vertex {
    double t = 0;
    glm::dvec2 place{0};
};

using Chain = std::vector<Vertex>;

Chain byFixedSteps(const ChordShape& shape, int steps) {
    Chain chain;
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        chain.push_back({t, shape.place(t)});
    }
    return chain;
}

double distanceFromChord(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 along = b - a;
    const double square = glm::dot(along, along);
    const double s = square > 0 ? std::clamp(glm::dot(p - a, along) / square, 0., 1.) : 0.;
    return glm::distance(p, a + s * along);
}

/// Halves a part until points at its quarters are within the tolerance of the chord.
void addFlat(Chain& chain, const ChordShape& shape, const Vertex& from, const Vertex& to, double tolerance) {
    constexpr double kShortestPart = 1e-9, kLongestPart = .125;
    const auto at = [&](double share) {
        const double t = std::lerp(from.t, to.t, share);
        return Vertex{t, shape.place(t)};
    };
    const Vertex middle = at(.5);
    const auto isNear = [&](const Vertex& v) {
        return distanceFromChord(v.place, from.place, to.place) <= tolerance;
    };
    const double length = to.t - from.t;
    const bool isFlat = length <= kLongestPart && isNear(middle) && isNear(at(.25)) && isNear(at(.75));
    if (isFlat || length < kShortestPart) {
        chain.push_back(to);
        return;
    }
    addFlat(chain, shape, from, middle, tolerance);
    addFlat(chain, shape, middle, to, tolerance);
}

Chain byFlatness(const ChordShape& shape, double tolerance) {
    const Vertex from{0, shape.place(0)}, to{1, shape.place(1)};
    Chain chain{from};
    addFlat(chain, shape, from, to, tolerance);
    return chain;
}

/// The largest distance of the curve from its chords, at 32 points of each.
double largestDistance(const ChordShape& shape, const Chain& chain) {
    constexpr int kPointsEach = 32;
    double largest = 0;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        for (int k = 1; k < kPointsEach; ++k) {
            const double t = std::lerp(chain[i].t, chain[i + 1].t, static_cast<double>(k) / kPointsEach);
            largest =
                std::max(largest, distanceFromChord(shape.truth(t), chain[i].place, chain[i + 1].place));
        }
    return largest;
}

Figure chordFigure(const Bench& bench, const ChordShape& shape) {
    Figure figure{.name = shape.name,
                  .title = shape.title,
                  .settingName = "segments",
                  .errorName = "largest distance of curve and chord",
                  .errorUnit = "lengths",
                  .reference = shape.reference};
    const auto add = [&](const char* curve, std::string label, const std::function<Chain()>& make) {
        const Chain chain = make();
        figure.add(curve,
                   {static_cast<double>(chain.size() - 1), std::move(label), largestDistance(shape, chain),
                    bench.time([&] { make(); }), static_cast<double>(chain.size()) * 2 * sizeof(float)});
    };
    for (int steps = 8; steps <= bench.pick(1024, 8192); steps *= 2)
        add("fixed steps of t", fmt::format("{} segments", steps),
            [&] { return byFixedSteps(shape, steps); });
    for (int power = -4; power >= bench.pick(-16, -20); power -= 2)
        add("halved until flat", fmt::format("tolerance 2^{}", power),
            [&] { return byFlatness(shape, std::ldexp(1., power)); });
    figure.findings = {orderSentence(figure.curves[0], "segments", 256),
                       orderSentence(figure.curves[1], "segments", 30)};
    // The number of fixed steps that reaches the error of the finest adaptive chain, by the fitted order.
    const double order = fittedOrder(figure.curves[0], 256);
    const Point &goal = figure.last(1), &from = figure.last(0);
    const double needed = from.setting * std::pow(goal.error / from.error, 1 / order);
    figure.note(
        "{} segments halved until flat are {} lengths off; fixed steps take {:.0f} segments for that, "
        "{:.2g} times as many",
        goal.setting, numberText(goal.error), needed, needed / goal.setting);
    return figure;
}

constexpr double kEnd = 2;
const std::complex<double> kStart(1, .1);  ///< reaches |z| = 10 half-way

/// 1 / z decreases by t: the exact solution.
std::complex<double> exactAt(double t) {
    return kStart / (1. - kStart * t);
}

template <class Number>
using Complex = std::complex<Number>;

template <class Number>
Complex<Number> field(const Complex<Number>& z) {
    return {(z.real() - z.imag()) * (z.real() + z.imag()), 2 * z.real() * z.imag()};
}

struct Traced {
    double error = 0;     ///< largest distance from the exact place at that time
    int evaluations = 0;  ///< of the field
};

template <class Number, class Step>
Traced tracedInFixedSteps(int steps, int evaluationsEach, Step step) {
    Complex<Number> z(kStart);
    const auto h = static_cast<Number>(kEnd / steps);
    double largest = 0;
    for (int i = 1; i <= steps; ++i) {
        z = step(z, h);
        largest = std::max(largest, std::abs(std::complex<double>(z) - exactAt(kEnd * i / steps)));
    }
    return {largest, steps * evaluationsEach};
}

Traced euler(int steps) {
    return tracedInFixedSteps<double>(steps, 1,
                                      [](const Complex<double>& z, double h) { return z + h * field(z); });
}

Traced midpoint(int steps) {
    return tracedInFixedSteps<double>(
        steps, 2, [](const Complex<double>& z, double h) { return z + h * field(z + .5 * h * field(z)); });
}

/// The classic Runge-Kutta method.
template <class Number>
Traced rungeKutta(int steps) {
    return tracedInFixedSteps<Number>(steps, 4, [](const Complex<Number>& z, Number h) {
        const Complex<Number> a = field(z), b = field(z + h / 2 * a), c = field(z + h / 2 * b),
                              d = field(z + h * c);
        return z + h / 6 * (a + Number(2) * (b + c) + d);
    });
}

/// Dormand and Prince, A family of embedded Runge-Kutta formulae, Journal of Computational and Applied
/// Mathematics 6(1), 1980: fifth order, with an embedded fourth-order result that estimates the error. The
/// last evaluation of a step is the first of the next.
template <class Number>
Traced dormandPrince(double tolerance) {
    using Z = Complex<Number>;
    static constexpr std::array<std::array<double, 6>, 6> kStages{{
        {1. / 5},
        {3. / 40, 9. / 40},
        {44. / 45, -56. / 15, 32. / 9},
        {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
        {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656},
        {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84},
    }};
    static constexpr std::array<double, 7> kDifference{71. / 57600,      0,         -71. / 16695, 71. / 1920,
                                                       -17253. / 339200, 22. / 525, -1. / 40};
    constexpr int kMostSteps = 1000000;
    Z z(kStart);
    double t = 0, h = .01, largest = 0;
    std::array<Z, 7> k{field(z)};
    int evaluations = 1;
    for (int step = 0; step < kMostSteps && t < kEnd; ++step) {
        h = std::min(h, kEnd - t);
        Z next = z;
        for (std::size_t stage = 0; stage < kStages.size(); ++stage) {
            Z slope(0);
            for (std::size_t i = 0; i <= stage; ++i) slope += static_cast<Number>(kStages[stage][i]) * k[i];
            next = z + static_cast<Number>(h) * slope;
            k[stage + 1] = field(next);
        }
        evaluations += 6;
        Z difference(0);
        for (std::size_t i = 0; i < k.size(); ++i) difference += static_cast<Number>(kDifference[i]) * k[i];
        const double error = h * static_cast<double>(std::abs(difference)) / tolerance;
        if (error <= 1) {
            t = h == kEnd - t ? kEnd : t + h;
            z = next;
            k[0] = k[6];
            largest = std::max(largest, std::abs(std::complex<double>(z) - exactAt(t)));
        }
        h *= std::clamp(.9 * std::pow(std::max(error, 1e-10), -.2), .2, 5.);
    }
    return {largest, evaluations};
}

Figure streamlineFigure(const Bench& bench) {
    Figure figure{
        .name = "streamlines",
        .title = "A streamline past a dipole",
        .settingName = "evaluations of the field",
        .errorName = "largest distance on the way",
        .errorUnit = "radii of the start",
        .reference = "the solution in closed form at the time of every step, z(t) = z0 / (1 - z0 t)"};
    const auto add = [&](const char* curve, std::string label, std::size_t bytes, const auto& trace) {
        const Traced traced = trace();
        figure.add(curve, {1. * traced.evaluations, std::move(label), traced.error,
                           bench.time([&] { trace(); }), static_cast<double>(bytes)});
    };
    // With the bytes of the place and the slopes of a step.
    constexpr std::size_t kFloats = sizeof(Complex<float>), kDoubles = sizeof(Complex<double>);
    const auto addFixed = [&](const char* curve, Traced (*trace)(int steps), std::size_t bytes) {
        for (int steps = 256; steps <= bench.pick(4096, 65536); steps *= 4)
            add(curve, fmt::format("{} steps", steps), bytes, [&] { return trace(steps); });
    };
    const auto addAdaptive = [&](const char* curve, Traced (*trace)(double tolerance), int smallest,
                                 std::size_t bytes) {
        for (int power = -2; power >= smallest; power -= 2)
            add(curve, fmt::format("tolerance 1e{}", power), bytes,
                [&] { return trace(std::pow(10., power)); });
    };
    addFixed("Euler", euler, 2 * kDoubles);
    addFixed("midpoint", midpoint, 3 * kDoubles);
    addFixed("Runge-Kutta 4", rungeKutta<double>, 5 * kDoubles);
    addFixed("Runge-Kutta 4, float", rungeKutta<float>, 5 * kFloats);
    addAdaptive("Dormand-Prince, adaptive", dormandPrince<double>, bench.pick(-6, -12), 8 * kDoubles);
    addAdaptive("Dormand-Prince, adaptive, float", dormandPrince<float>, -6, 8 * kFloats);
    figure.findings = {orderSentence(figure.curves[0], "evaluations", 4000),
                       orderSentence(figure.curves[1], "evaluations", 2000),
                       orderSentence(figure.curves[2], "evaluations", 2000, 70000)};
    const auto best = [&](std::size_t curve) {
        return *std::ranges::min_element(figure.curves[curve].points, {}, &Point::error);
    };
    figure.note(
        "at best {} with {:.0f} evaluations at fixed steps, {} with {:.0f} adaptive, {} at fixed steps in "
        "float",
        numberText(best(2).error), best(2).setting, numberText(best(4).error), best(4).setting,
        numberText(best(3).error));
    return figure;
}

}  // namespace

std::vector<Figure> measureCurves(Bench& bench) {
    return {parameterFigure(bench), chordFigure(bench, kBezierShape), chordFigure(bench, kStepShape),
            streamlineFigure(bench)};
}

}  // namespace glibra::bench
