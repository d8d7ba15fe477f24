// A streamline of a dipole, which passes near it and is fast there: dz/dt = z^2 in complex numbers.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <utility>

#include "bench/core/fit.h"
#include "bench/subjects/curves.h"

namespace glibra::bench {
namespace {

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

Point tracePoint(const Bench& bench, std::string label, std::size_t bytes,
                 const std::function<Traced()>& trace) {
    const Traced traced = trace();
    return {.setting = static_cast<double>(traced.evaluations),
            .label = std::move(label),
            .error = traced.error,
            .time = bench.time([&] { trace(); }),
            .memory = static_cast<double>(bytes)};
}

struct StreamlineMethod {
    const char* name;
    Traced (*trace)(int steps);
    std::size_t bytes;  ///< the place and the slopes of a step
};

}  // namespace

Figure streamlineFigure(const Bench& bench) {
    Figure figure;
    figure.name = "streamlines";
    figure.title = "A streamline past a dipole";
    figure.settingName = "evaluations of the field";
    figure.errorName = "largest distance on the way";
    figure.errorUnit = "radii of the start";
    figure.reference = "the solution in closed form at the time of every step, z(t) = z0 / (1 - z0 t)";
    constexpr StreamlineMethod kMethods[] = {
        {"Euler", euler, 2 * sizeof(Complex<double>)},
        {"midpoint", midpoint, 3 * sizeof(Complex<double>)},
        {"Runge-Kutta 4", rungeKutta<double>, 5 * sizeof(Complex<double>)},
        {"Runge-Kutta 4, float", rungeKutta<float>, 5 * sizeof(Complex<float>)}};
    const int finest = bench.isQuick() ? 4096 : 65536;
    for (const StreamlineMethod& method : kMethods) {
        Curve& curve = figure.curves.emplace_back(Curve{method.name, {}});
        for (int steps = 256; steps <= finest; steps *= 4)
            curve.points.push_back(tracePoint(bench, fmt::format("{} steps", steps), method.bytes,
                                              [&] { return method.trace(steps); }));
    }
    const int smallest = bench.isQuick() ? -6 : -12;
    for (const bool isDouble : {true, false}) {
        Curve& curve = figure.curves.emplace_back(
            Curve{isDouble ? "Dormand-Prince, adaptive" : "Dormand-Prince, adaptive, float", {}});
        for (int power = -2; power >= (isDouble ? smallest : std::max(smallest, -6)); power -= 2) {
            const double tolerance = std::pow(10., power);
            const std::size_t bytes = 8 * (isDouble ? sizeof(Complex<double>) : sizeof(Complex<float>));
            curve.points.push_back(tracePoint(bench, fmt::format("tolerance 1e{}", power), bytes, [&] {
                return isDouble ? dormandPrince<double>(tolerance) : dormandPrince<float>(tolerance);
            }));
        }
    }
    figure.findings = {orderSentence(figure.curves[0], "evaluations", 4000),
                       orderSentence(figure.curves[1], "evaluations", 2000),
                       orderSentence(figure.curves[2], "evaluations", 2000, 70000)};
    const auto best = [](const Curve& curve) {
        return *std::ranges::min_element(curve.points, {}, &Point::error);
    };
    const Point fixed = best(figure.curves[2]), adaptive = best(figure.curves[4]),
                floats = best(figure.curves[3]);
    figure.findings.push_back(
        fmt::format("at best {} with {:.0f} evaluations at fixed steps, {} with {:.0f} adaptive, {} at "
                    "fixed steps in float",
                    numberText(fixed.error), fixed.setting, numberText(adaptive.error), adaptive.setting,
                    numberText(floats.error)));
    return figure;
}

}  // namespace glibra::bench
