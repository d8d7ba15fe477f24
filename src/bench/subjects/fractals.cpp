#include <fmt/format.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <glm/vec2.hpp>
#include <utility>

#include "bench/draw/shader_values.h"
#include "bench/subjects/subjects.h"

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

struct FractalView {
    int side = 0;
    double zoom = 1;
    [[nodiscard]] double spacing() const { return kViewWidth / (zoom * side); }
    /// The centre of a pixel, in pixels from the middle.
    [[nodiscard]] double offset(int pixel) const { return pixel - .5 * (side - 1); }
};

using Counts = std::vector<int>;

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

template <class Number>
void countIterations(const FractalView& view, Counts& counts) {
    const Pair<Deep> middle = centre();
    const auto cx = static_cast<Number>(middle.x), cy = static_cast<Number>(middle.y);
    const auto spacing = static_cast<Number>(view.spacing());
    counts.clear();
    for (int j = 0; j < view.side; ++j)
        for (int i = 0; i < view.side; ++i)
            counts.push_back(escape<Number>(cx + spacing * static_cast<Number>(view.offset(i)),
                                            cy + spacing * static_cast<Number>(view.offset(j))));
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
void perturbed(const FractalView& view, Counts& counts) {
    static const std::vector<glm::vec2> orbit = centreOrbit();
    const auto spacing = static_cast<float>(view.spacing());
    counts.clear();
    for (int j = 0; j < view.side; ++j)
        for (int i = 0; i < view.side; ++i) {
            const glm::vec2 c(spacing * static_cast<float>(view.offset(i)),
                              spacing * static_cast<float>(view.offset(j)));
            glm::vec2 d(0);
            int count = 0;
            for (; count < kMostIterations; ++count) {
                const glm::vec2 z = orbit[static_cast<std::size_t>(count)], all = z + d;
                if (all.x * all.x + all.y * all.y > 4) break;
                const glm::vec2 sum = z + all;
                d = glm::vec2(sum.x * d.x - sum.y * d.y, sum.x * d.y + sum.y * d.x) + c;
            }
            counts.push_back(count);
        }
}

struct FractalMethod {
    const char* name;
    void (*draw)(const FractalView&, Counts&);
    bool hasOrbit = false;
};

constexpr FractalMethod kFractalMethods[] = {
    {"CPU, float", countIterations<float>},
    {"CPU, double", countIterations<double>},
    {"CPU, long double", countIterations<long double>},
    {"CPU, float by perturbation", perturbed, true},
};

constexpr const char* kPlainShader = R"(uniform {0}vec2 uCentre;
uniform {1} uSpacing;
vec4 value() {{
    {0}vec2 c = uCentre + uSpacing * {0}vec2(given(0).xy), z = {0}vec2(0);
    int i = 0;
    for (; i < {2}; ++i) {{
        {1} xx = z.x * z.x, yy = z.y * z.y;
        if (xx + yy > 4.) break;
        z = {0}vec2(xx - yy, 2. * z.x * z.y) + c;
    }}
    return vec4(i);
}}
)";

constexpr const char* kPerturbedShader = R"(uniform float uSpacing;
uniform vec2 uOrbit[{0}];
vec4 value() {{
    vec2 c = uSpacing * given(0).xy, d = vec2(0);
    int i = 0;
    for (; i < {0}; ++i) {{
        vec2 all = uOrbit[i] + d;
        if (dot(all, all) > 4.) break;
        vec2 sum = uOrbit[i] + all;
        d = vec2(sum.x * d.x - sum.y * d.y, sum.x * d.y + sum.y * d.x) + c;
    }}
    return vec4(i);
}}
)";

struct FractalShader {
    const char* name;
    std::string glsl;
    bool isDouble = false;
};

std::vector<FractalShader> fractalShaders() {
    return {{"shader, float", fmt::format(fmt::runtime(kPlainShader), "", "float", kMostIterations), false},
            {"shader, double", fmt::format(fmt::runtime(kPlainShader), "d", "double", kMostIterations), true},
            {"shader, float by perturbation", fmt::format(fmt::runtime(kPerturbedShader), kMostIterations),
             false}};
}

/// Uniforms that a method does not have are ignored.
void setFractalView(const gpu::Program& program, const FractalView& view, bool isDouble) {
    program.use();
    const auto location = [&](const char* name) { return glGetUniformLocation(program.id(), name); };
    const Pair<Deep> middle = centre();
    const std::vector<glm::vec2> orbit = centreOrbit();
    if (isDouble) {
        glUniform2d(location("uCentre"), static_cast<double>(middle.x), static_cast<double>(middle.y));
        glUniform1d(location("uSpacing"), view.spacing());
    } else {
        glUniform2f(location("uCentre"), static_cast<float>(middle.x), static_cast<float>(middle.y));
        glUniform1f(location("uSpacing"), static_cast<float>(view.spacing()));
    }
    glUniform2fv(location("uOrbit"), kMostIterations, &orbit[0].x);
}

double wrongShare(const Counts& truth, const Counts& counts) {
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        if (counts[i] != truth[i]) ++wrong;
    return static_cast<double>(wrong) / static_cast<double>(truth.size());
}

struct Case {
    FractalView view;
    Counts truth{};
};

Point zoomPoint(const FractalView& view, double error, const Timing& time, double bytes) {
    return {.setting = view.zoom,
            .label = fmt::format("zoom {:.0e}", view.zoom),
            .error = error,
            .time = time,
            .memory = bytes};
}

Result<Curve> fractalShaderCurve(Bench& bench, const FractalShader& method, const std::vector<Case>& cases) {
    std::vector<Four> offsets;
    const FractalView& any = cases.front().view;
    for (int j = 0; j < any.side; ++j)
        for (int i = 0; i < any.side; ++i)
            offsets.push_back({static_cast<float>(any.offset(i)), static_cast<float>(any.offset(j)), 0, 0});
    const Result<ShaderValues> shader = ShaderValues::create(bench, method.glsl, offsets);
    if (!shader) return shader.diagnostics;
    Curve curve{method.name, {}};
    for (const Case& each : cases) {
        setFractalView(shader->program(), each.view, method.isDouble);
        const Result<std::vector<Four>> values = shader->values();
        if (!values) return values.diagnostics;
        Counts counts;
        for (const Four& value : *values) counts.push_back(static_cast<int>(value[0]));
        curve.points.push_back(zoomPoint(each.view, wrongShare(each.truth, counts),
                                         bench.time([&] { shader->compute(); }), shader->bytes()));
    }
    return curve;
}

std::string limitSentence(const Curve& curve) {
    const auto first =
        std::ranges::find_if(curve.points, [](const Point& each) { return each.error > kTolerable; });
    if (first == curve.points.end())
        return fmt::format("{}: at most {:.2g} % of the pixels are wrong up to {}", curve.name,
                           100 * std::ranges::max(curve.points, {}, &Point::error).error,
                           curve.points.back().label);
    return fmt::format("{}: {:.2g} % of the pixels are wrong at {}, and more beyond", curve.name,
                       100 * first->error, first->label);
}

}  // namespace

Result<std::vector<Figure>> measureFractals(Bench& bench) {
    Figure figure;
    figure.name = "mandelbrot";
    figure.settingName = "zoom";
    figure.errorName = "share of wrong pixels";
    figure.reference = "the number of iterations with 113 bits of mantissa (Boost.Multiprecision)";
    figure.alternatives = Alternatives::setting;
    figure.countsWrong = true;
    std::vector<Case> cases;
    const int side = bench.isQuick() ? 32 : 64;
    figure.title = "The Mandelbrot set around a Misiurewicz point";
    for (int decade = 0; decade <= 15; decade += bench.isQuick() ? 5 : 1) {
        Case& each = cases.emplace_back(Case{{side, std::pow(10., decade)}});
        countIterations<Quad>(each.view, each.truth);
    }
    Diagnostics problems;
    Counts counts;
    for (const FractalMethod& method : kFractalMethods) {
        Curve& curve = figure.curves.emplace_back(Curve{.name = method.name, .isForScenes = false});
        for (const Case& each : cases) {
            const Timing time = bench.time([&] { method.draw(each.view, counts); });
            const std::size_t orbit = method.hasOrbit ? kMostIterations * sizeof(glm::vec2) : 0;
            curve.points.push_back(zoomPoint(each.view, wrongShare(each.truth, counts), time,
                                             static_cast<double>(counts.size() * sizeof(int) + orbit)));
        }
    }
    for (const FractalShader& method : fractalShaders()) {
        Result<Curve> curve = fractalShaderCurve(bench, method, cases);
        if (!hasError(problems)) append(problems, std::move(curve.diagnostics));
        if (curve) figure.curves.push_back(std::move(*curve));
    }
    for (const Curve& curve : figure.curves) figure.findings.push_back(limitSentence(curve));
    return {std::vector{std::move(figure)}, std::move(problems)};
}

}  // namespace glibra::bench
