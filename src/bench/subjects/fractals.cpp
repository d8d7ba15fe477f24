#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "bench/core/device.h"
#include "bench/subjects/subjects.h"
#include "embedded/bench_shaders.h"

namespace glibra::bench {
namespace {

/// IEEE binary128: 113 bits of mantissa.
using Quad = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<113, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

/// For the centre and its orbit, whose rounding errors triple with every iteration.
using Deep =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

/// The number of iterations after which a point is inside. The view escapes after about 2.5 per decade of
/// zoom.
constexpr int kMostIterations = 100;
constexpr double kViewWidth = 3;    ///< width of the view at zoom 1
constexpr double kTolerable = .01;  ///< share of wrong pixels

template <class Number>
struct Pair {
    Number x{0}, y{0};
};

/// The Misiurewicz point near -.2282 + 1.1151 i, where c^3 + 2 c^2 + 2 c + 2 = 0, by Newton's method: the set
/// has detail around it at every zoom, and all of it escapes soon.
Pair<Deep> centre() {
    Pair<Deep> c{Deep(-.2281554936539618), Deep(1.115142508039937)};
    const auto times = [](const Pair<Deep>& a, const Pair<Deep>& b) {
        return Pair<Deep>{a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
    };
    for (int i = 0; i < 6; ++i) {
        const Pair<Deep> square = times(c, c), cube = times(square, c);
        const Pair<Deep> value{cube.x + 2 * square.x + 2 * c.x + 2, cube.y + 2 * square.y + 2 * c.y};
        const Pair<Deep> slope{3 * square.x + 4 * c.x + 2, 3 * square.y + 4 * c.y};
        const Deep norm = slope.x * slope.x + slope.y * slope.y;
        const Pair<Deep> quotient = times(value, {slope.x, -slope.y});
        c.x -= quotient.x / norm;
        c.y -= quotient.y / norm;
    }
    return c;
}

/// Between the centres of pixels, at a setting that is the zoom; inputs are these centres, in pixels from the
/// middle.
double spacingOf(const ComputedCase& each) {
    return kViewWidth / (each.setting * std::sqrt(static_cast<double>(each.inputs.size())));
}

template <class Number>
int escape(const Number& cx, const Number& cy) {
    Number x = 0, y = 0;
    for (int i = 0; i < kMostIterations; ++i) {
        const Number xx = x * x, yy = y * y;
        if (xx + yy > 4) return i;
        y = 2 * x * y + cy;
        x = xx - yy + cx;
    }
    return kMostIterations;
}

/// The number of iterations of each pixel.
template <class Number>
void countIterations(const ComputedCase& each, Numbers& counts) {
    const Pair<Deep> middle = centre();
    const auto cx = static_cast<Number>(middle.x), cy = static_cast<Number>(middle.y);
    const auto spacing = static_cast<Number>(spacingOf(each));
    for (std::size_t i = 0; i < counts.size(); ++i)
        counts[i].x = escape<Number>(cx + spacing * static_cast<Number>(each.inputs[i].x),
                                     cy + spacing * static_cast<Number>(each.inputs[i].y));
}

/// The orbit of the centre, with 100 digits and rounded.
std::vector<glm::vec2> centreOrbit() {
    const Pair<Deep> c = centre();
    Pair<Deep> z;
    std::vector<glm::vec2> orbit;
    for (int i = 0; i < kMostIterations; ++i) {
        orbit.emplace_back(static_cast<float>(z.x), static_cast<float>(z.y));
        z = {z.x * z.x - z.y * z.y + c.x, 2 * z.x * z.y + c.y};
    }
    return orbit;
}

/// Iterates only the difference of a pixel's orbit from that of the centre (K. I. Martin, Superfractalthing
/// Maths, 2013).
void perturbed(const ComputedCase& each, Numbers& counts) {
    static const std::vector<glm::vec2> orbit = centreOrbit();
    const auto spacing = static_cast<float>(spacingOf(each));
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const glm::vec2 c = spacing * glm::vec2(each.inputs[i]);
        glm::vec2 d(0);
        int count = 0;
        for (; count < kMostIterations; ++count) {
            const glm::vec2 z = orbit[static_cast<std::size_t>(count)], all = z + d;
            if (all.x * all.x + all.y * all.y > 4) break;
            const glm::vec2 sum = z + all;
            d = glm::vec2(sum.x * d.x - sum.y * d.y, sum.x * d.y + sum.y * d.x) + c;
        }
        counts[i].x = count;
    }
}

glm::dvec2 roundedCentre() {
    const Pair<Deep> middle = centre();
    return {static_cast<double>(middle.x), static_cast<double>(middle.y)};
}

std::vector<Computation> fractalWays(int side) {
    const double bytes = 1. * side * side * sizeof(int);
    const auto mandelbrot = [](const char* macros) {
        return fmt::format("{}#define MOST {}\n{}", macros, kMostIterations,
                           bench_shaders::mandelbrot_glsl());
    };
    return {
        {"CPU, float", countIterations<float>, bytes, false},
        {"CPU, double", countIterations<double>, bytes, false},
        {"CPU, long double", countIterations<long double>, bytes, false},
        {"CPU, float by perturbation", perturbed, bytes + kMostIterations * sizeof(glm::vec2), false},
        {.name = "shader, float",
         .glsl = mandelbrot("#define NUMBER float\n#define VEC2 vec2\n"),
         .uniforms =
             [](const Shader& shader, const ComputedCase& each) {
                 shader.set("uCentre", glm::vec2(roundedCentre())).set("uSpacing", spacingOf(each));
             }},
        {.name = "shader, double",
         .glsl = mandelbrot("#define NUMBER double\n#define VEC2 dvec2\n"),
         .uniforms =
             [](const Shader& shader, const ComputedCase& each) {
                 shader.setDouble("uCentre", roundedCentre()).setDouble("uSpacing", spacingOf(each));
             }},
        {.name = "shader, float by perturbation",
         .glsl = mandelbrot("#define PERTURBED\n"),
         .uniforms =
             [](const Shader& shader, const ComputedCase& each) {
                 shader.set("uOrbit", centreOrbit()).set("uSpacing", spacingOf(each));
             }},
    };
}

void noteLimit(Figure& figure, const Curve& curve) {
    const auto first =
        std::ranges::find_if(curve.points, [](const Point& each) { return each.error > kTolerable; });
    if (first == curve.points.end())
        figure.note("{}: at most {:.2g} % of the pixels are wrong up to {}", curve.name,
                    100 * std::ranges::max(curve.points, {}, &Point::error).error, curve.points.back().label);
    else
        figure.note("{}: {:.2g} % of the pixels are wrong at {}, and more beyond", curve.name,
                    100 * first->error, first->label);
}

}  // namespace

std::vector<Figure> measureFractals(Bench& bench) {
    Figure figure{.name = "mandelbrot",
                  .title = "The Mandelbrot set around a Misiurewicz point",
                  .settingName = "zoom",
                  .errorName = "share of wrong pixels",
                  .reference = "the number of iterations with 113 bits of mantissa (Boost.Multiprecision)",
                  .alternatives = Alternatives::setting,
                  .countsWrong = true};
    const int side = bench.pick(32, 64);
    std::vector<ComputedCase> cases;
    for (int decade = 0; decade <= 15; decade += bench.pick(5, 1)) {
        const double zoom = std::pow(10., decade);
        ComputedCase& each = cases.emplace_back(ComputedCase{zoom, fmt::format("zoom {:.0e}", zoom), {}, {}});
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i)
                each.inputs.emplace_back(i - .5 * (side - 1), j - .5 * (side - 1), 0, 0);
        Numbers truth(each.inputs.size());
        countIterations<Quad>(each, truth);
        each.error = [truth = std::move(truth)](const Numbers& counts) {
            double wrong = 0;
            for (std::size_t i = 0; i < truth.size(); ++i) wrong += counts[i].x != truth[i].x ? 1 : 0;
            return wrong / static_cast<double>(truth.size());
        };
    }
    addComputed(figure, bench, fractalWays(side), cases);
    for (const Curve& curve : figure.curves) noteLimit(figure, curve);
    return {std::move(figure)};
}

}  // namespace glibra::bench
