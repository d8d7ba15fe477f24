#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "bench/core/device.h"
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

constexpr std::string_view kPlainShader = R"(uniform {0}vec2 uCentre;
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

constexpr std::string_view kPerturbedShader = R"(uniform float uSpacing;
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
    return {{"shader, float", fmt::format(kPlainShader, "", "float", kMostIterations)},
            {"shader, double", fmt::format(kPlainShader, "d", "double", kMostIterations), true},
            {"shader, float by perturbation", fmt::format(kPerturbedShader, kMostIterations)}};
}

/// Uniforms that a method does not have are ignored.
void setFractalView(const Shader& shader, const FractalView& view, bool isDouble) {
    const Pair<Deep> middle = centre();
    const glm::dvec2 place(static_cast<double>(middle.x), static_cast<double>(middle.y));
    if (isDouble)
        shader.setDouble("uCentre", place).setDouble("uSpacing", view.spacing());
    else
        shader.set("uCentre", glm::vec2(place)).set("uSpacing", view.spacing());
    if (shader.has("uOrbit")) shader.set("uOrbit", centreOrbit());
}

struct Case {
    FractalView view;
    Counts truth{};

    [[nodiscard]] Point point(const Counts& counts, const Timing& time, double bytes) const {
        double wrong = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) wrong += counts[i] != truth[i] ? 1 : 0;
        return {view.zoom, fmt::format("zoom {:.0e}", view.zoom), wrong / static_cast<double>(truth.size()),
                time, bytes};
    }
};

void addFractalCurve(Figure& figure, Bench& bench, const FractalShader& method,
                     const std::vector<Case>& cases) {
    std::vector<Four> offsets;
    const FractalView& any = cases.front().view;
    for (int j = 0; j < any.side; ++j)
        for (int i = 0; i < any.side; ++i)
            offsets.push_back({static_cast<float>(any.offset(i)), static_cast<float>(any.offset(j)), 0, 0});
    const ShaderValues values(bench, method.glsl, offsets);
    for (const Case& each : cases) {
        setFractalView(values.shader(), each.view, method.isDouble);
        Counts counts;
        for (const Four& value : values.values()) counts.push_back(static_cast<int>(value[0]));
        figure.add(method.name, each.point(counts, bench.time([&] { values.compute(); }), values.bytes()));
    }
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
    std::vector<Case> cases;
    for (int decade = 0; decade <= 15; decade += bench.pick(5, 1)) {
        Case& each = cases.emplace_back(Case{{bench.pick(32, 64), std::pow(10., decade)}});
        countIterations<Quad>(each.view, each.truth);
    }
    Counts counts;
    for (const FractalMethod& method : kFractalMethods)
        for (const Case& each : cases) {
            const Timing time = bench.time([&] { method.draw(each.view, counts); });
            const std::size_t orbit = method.hasOrbit ? kMostIterations * sizeof(glm::vec2) : 0;
            figure.add(method.name,
                       each.point(counts, time, static_cast<double>(counts.size() * sizeof(int) + orbit)));
            figure.curves.back().isForScenes = false;
        }
    for (const FractalShader& method : fractalShaders())
        bench.attempt([&] { addFractalCurve(figure, bench, method, cases); });
    for (const Curve& curve : figure.curves) noteLimit(figure, curve);
    return {std::move(figure)};
}

}  // namespace glibra::bench
