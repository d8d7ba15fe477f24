#include "bench/subjects/builtins.h"

#include <math.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

namespace glibra::bench {

// The errors that GLSL 4.60, section 4.7.1, allows the built-in functions: absolute, for component i of the
// exact result y of the arguments x. Functions that the section defines by an equation inherit the errors of
// its operations, added up to first order. For BuiltinFunction::allowed.
namespace bounds {
namespace {

/// `halves` / 2 units in the last place.
template <int halves>
long double ulps(const Arguments&, const Values& y, int i) {
    return halves * .5L * unitInLastPlace(y[static_cast<std::size_t>(i)]);
}

constexpr long double kRounding = 0x1p-24L;  ///< relative error of one correctly rounded operation

long double exponentialAllowed(long double exponent, long double result) {
    return (3 + 2 * std::fabs(exponent)) * unitInLastPlace(result);
}

/// The error at x, if `result` is the exact result.
long double logarithmAllowed(long double x, long double result) {
    return x >= .5L && x <= 2 ? 0x1p-21L : 3 * unitInLastPlace(result);
}

/// sqrt(x) is 1 / inversesqrt(x): 2 ULP of the latter, at most 4 roundings each, then the division.
long double rootAllowed(long double value) {
    return 4 * kRounding * value + 2.5L * unitInLastPlace(value);
}

/// (exp(x) +- exp(-x)) / 2.
long double hyperbolicAllowed(long double x) {
    const long double up = std::exp(x), down = std::exp(-x);
    return (exponentialAllowed(x, up) + exponentialAllowed(x, down)) / 2 +
           kRounding * std::fabs(up + down) / 2;
}

long double none(const Arguments&, const Values&, int) {
    return 0;
}

long double exponential(const Arguments& x, const Values& y, int) {
    return exponentialAllowed(x[0], y[0]);
}

long double logarithm(const Arguments& x, const Values& y, int) {
    return logarithmAllowed(x[0], y[0]);
}

/// pow(x, y) is exp2(y * log2(x)).
long double power(const Arguments& x, const Values& y, int) {
    const long double logarithm = std::log2(x[0]);
    const long double exponent = x[4] * logarithm;
    const long double shift =
        std::fabs(x[4]) * logarithmAllowed(x[0], logarithm) + .5L * unitInLastPlace(exponent);
    return exponentialAllowed(exponent, y[0]) + std::numbers::ln2_v<long double> * shift * y[0];
}

long double root(const Arguments&, const Values& y, int) {
    return rootAllowed(y[0]);
}

long double hyperbolic(const Arguments& x, const Values&, int) {
    return hyperbolicAllowed(x[0]);
}

long double hyperbolicTangent(const Arguments& x, const Values& y, int) {
    const long double s = std::fabs(std::sinh(x[0])), c = std::cosh(x[0]);
    return hyperbolicAllowed(x[0]) * (1 + s / c) / c + 2.5L * unitInLastPlace(y[0]);
}

/// The square root halves the relative error of the sum of three squares: at most three roundings.
long double length(const Arguments&, const Values& y, int) {
    return 1.5L * kRounding * y[0] + rootAllowed(y[0]);
}
long double distance(const Arguments& x, const Values& y, int i) {
    return kRounding * y[0] + length(x, y, i);
}

/// v / length(v).
long double normalized(const Arguments& x, const Values& y, int i) {
    const Values of{std::hypot(std::hypot(x[0], x[1]), x[2])};
    const long double component = y[static_cast<std::size_t>(i)];
    return std::fabs(component) * length(x, of, 0) / of[0] + 2.5L * unitInLastPlace(component);
}

long double dot(const Arguments& x, const Values&, int) {
    long double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += std::fabs(x[i] * x[i + 4]);
    return 4 * kRounding * sum;
}

long double cross(const Arguments& x, const Values& y, int i) {
    const auto j = static_cast<std::size_t>((i + 1) % 3), k = static_cast<std::size_t>((i + 2) % 3);
    return kRounding * (std::fabs(x[j] * x[k + 4]) + std::fabs(x[k] * x[j + 4]) +
                        std::fabs(y[static_cast<std::size_t>(i)]));
}

/// I - 2 dot(N, I) N.
long double reflected(const Arguments& x, const Values& y, int i) {
    long double scalar = 0, sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        scalar += x[k] * x[k + 4];
        sum += std::fabs(x[k] * x[k + 4]);
    }
    const auto at = static_cast<std::size_t>(i);
    return 2 * std::fabs(x[at + 4]) * kRounding * (3 * sum + 2 * std::fabs(scalar)) +
           kRounding * std::fabs(y[at]);
}

/// The columns of the matrix are a.xy and a.zw.
long double product(const Arguments& x, const Values&, int i) {
    const auto row = static_cast<std::size_t>(i);
    return 2 * kRounding * (std::fabs(x[row] * x[4]) + std::fabs(x[row + 2] * x[5]));
}

/// x (1 - t) + y t.
long double mixture(const Arguments& x, const Values& y, int) {
    return kRounding * (2 * std::fabs(x[0] * (1 - x[4])) + std::fabs(x[1] * x[4]) + std::fabs(y[0]));
}

/// Two differences and their quotient, then t t (3 - 2 t).
long double smoothStep(const Arguments& x, const Values& y, int) {
    const long double t = std::clamp((x[4] + x[0]) / (x[1] + x[0]), 0.0L, 1.0L);
    return 6 * t * (1 - t) * 7 * kRounding * t + 3 * kRounding * y[0];
}

/// x - y floor(x / y): two roundings, if floor is right.
long double modulus(const Arguments& x, const Values& y, int) {
    return kRounding * (std::fabs(x[4] * std::floor(x[0] / x[4])) + std::fabs(y[0]));
}

/// pi / 180 x: the factor and the product are rounded.
long double angle(const Arguments&, const Values& y, int) {
    return 2 * kRounding * std::fabs(y[0]);
}
}  // namespace
}  // namespace bounds

namespace {

/// A number in 0 <= u < 1 computed from the two arguments (finaliser of MurmurHash3 by Austin Appleby).
double uniform(std::uint32_t index, std::uint32_t slot) {
    std::uint64_t h = (std::uint64_t{index} << 8 | slot) + 0x9E3779B97F4A7C15ULL;
    h = (h ^ (h >> 33)) * 0xFF51AFD7ED558CCDULL;
    h = (h ^ (h >> 33)) * 0xC4CEB9FE1A85EC53ULL;
    h ^= h >> 33;
    return static_cast<double>(h >> 11) * 0x1p-53;
}

float within(const ArgumentRange& range, double u) {
    const auto at = [&](double t) {
        const double value = range.byMagnitude ? range.low * std::pow(range.high / range.low, t)
                                               : std::lerp(range.low, range.high, t);
        return static_cast<float>(std::clamp(value, range.low, range.high));
    };
    if (!range.bothSigns) return at(u);
    return u < .5 ? -at(1 - 2 * u) : at(2 * u - 1);
}

using A = Arguments;
using V = Values;

constexpr std::string_view kOpen = "open";

ArgumentRange upTo(double high) {
    return {.low = 0, .high = high, .bothSigns = true};
}
ArgumentRange between(double low, double high) {
    return {.low = low, .high = high};
}
ArgumentRange magnitudes(double low, double high) {
    return {.low = low, .high = high, .byMagnitude = true};
}
ArgumentRange signedMagnitudes(double low, double high) {
    return {.low = low, .high = high, .byMagnitude = true, .bothSigns = true};
}

std::vector<ArgumentSweep> angles() {
    return {{std::numbers::pi / 4, "|x| to pi/4", upTo(std::numbers::pi / 4)},
            {std::numbers::pi, "|x| to pi", upTo(std::numbers::pi)},
            {31.4, "|x| to 10 pi", upTo(31.4)},
            {1e3, "|x| to 1000", upTo(1e3)},
            {1e5, "|x| to 10^5", upTo(1e5)},
            {1e7, "|x| to 10^7", upTo(1e7)}};
}
std::vector<ArgumentSweep> arcs() {
    return {{1e-3, "|x| from 10^-6 to 10^-3", signedMagnitudes(1e-6, 1e-3)},
            {.5, "|x| to 0.5", upTo(.5)},
            {.9, "|x| from 0.5 to 0.9", {.5, .9, false, true}},
            {1, "|x| from 0.9 to 1", {.9, 1, false, true}}};
}
std::vector<ArgumentSweep> exponents(double most) {
    return {{1, "|x| to 1", upTo(1)}, {10, "|x| to 10", upTo(10)}, {most, "|x| to its limit", upTo(most)}};
}
std::vector<ArgumentSweep> upToTen() {
    return {{1, "|x| to 1", upTo(1)}, {10, "|x| to 10", upTo(10)}};
}
std::vector<ArgumentSweep> positives() {
    return {{2, "x from 0.5 to 2", between(.5, 2)},
            {1e6, "x from 10^-6 to 10^6", magnitudes(1e-6, 1e6)},
            {1e30, "x from 10^-30 to 10^30", magnitudes(1e-30, 1e30)}};
}
std::vector<ArgumentSweep> pairs() {
    return {{2, "0.5 to 2", {.5, 2, false, true}, {.5, 2, false, true}},
            {1e6, "10^-6 to 10^6", signedMagnitudes(1e-6, 1e6), signedMagnitudes(1e-6, 1e6)}};
}
std::vector<ArgumentSweep> vectors() {
    return {{1, "to 1", upTo(1)}, {1e15, "from 10^-15 to 10^15", signedMagnitudes(1e-15, 1e15)}};
}
std::vector<ArgumentSweep> vectorPairs() {
    return {{1, "to 1", upTo(1), upTo(1)}};
}
std::vector<ArgumentSweep> plainSweeps() {
    return {{100, "|x| to 100", upTo(100)}, {1e6, "|x| from 10^-6 to 10^6", signedMagnitudes(1e-6, 1e6)}};
}

long double exactLength(const A& x) {
    return std::hypot(std::hypot(x[0], x[1]), x[2]);
}

template <long double (*f)(long double)>
void of(const A& x, V& y) {
    y[0] = f(x[0]);
}
template <long double (*f)(long double, long double)>
void ofTwo(const A& x, V& y) {
    y[0] = f(x[0], x[4]);
}

enum class PrecisionStage { vertex, fragment };

constexpr long double kSmallestNormal = 0x1p-126L;

constexpr std::string_view kInputs = "uniform sampler2D uA;\nuniform sampler2D uB;\n";

/// A float, vec2 or vec3 as the first components of a vec4.
std::string asVec4(const BuiltinFunction& function) {
    switch (function.components) {
        case 1:
            return fmt::format("vec4({}, 0., 0., 0.)", function.expression);
        case 2:
            return fmt::format("vec4({}, 0., 0.)", function.expression);
        default:
            return fmt::format("vec4({}, 0.)", function.expression);
    }
}

/// The statement that reads the arguments at `place` and evaluates the function.
std::string evaluation(const BuiltinFunction& function, std::string_view result) {
    return fmt::format(
        "    vec4 a = texelFetch(uA, place, 0);\n    vec4 b = texelFetch(uB, place, 0);\n    {} = {};\n",
        result, asVec4(function));
}

Shader evaluating(Bench& bench, const BuiltinFunction& function, PrecisionStage stage, int side) {
    if (stage == PrecisionStage::fragment)
        return {bench, fmt::format("{}out vec4 fResult;\nvoid main() {{\n    ivec2 place = "
                                   "ivec2(gl_FragCoord.xy);\n{}}}\n",
                                   kInputs, evaluation(function, "fResult"))};
    return {bench,
            fmt::format("{0}flat out vec4 vResult;\nvoid main() {{\n"
                        "    ivec2 place = ivec2(gl_VertexID % {1}, gl_VertexID / {1});\n{2}"
                        "    gl_Position = vec4((vec2(place) + .5) * {3} - 1., 0., 1.);\n}}\n",
                        kInputs, side, evaluation(function, "vResult"), 2.0 / side),
            "flat in vec4 vResult;\nout vec4 fResult;\nvoid main() {\n    fResult = vResult;\n}\n"};
}

Texels argumentTexels(Bench& bench, const ArgumentSweep& sweep, std::size_t first, int side) {
    std::vector<float> texels;
    for (int i = 0; i < side * side; ++i) {
        const std::array<float, 8> arguments = argumentsOf(sweep, static_cast<std::uint32_t>(i));
        texels.insert(texels.end(), &arguments[first], &arguments[first] + 4);
    }
    return {bench, gpu::TexelFormat::rgba32f, {side, side, 1}, texels, 4};
}

/// One function over one sweep of arguments on the device: side * side argument sets.
class PrecisionRun {
  public:
    PrecisionRun(Bench& bench, const BuiltinFunction& function, const ArgumentSweep& sweep,
                 PrecisionStage stage, int side)
        : a_(argumentTexels(bench, sweep, 0, side)),
          b_(argumentTexels(bench, sweep, 4, side)),
          canvas_(bench, side, side, gpu::TexelFormat::rgba32f),
          shader_(evaluating(bench, function, stage, side)),
          byPoints_(stage == PrecisionStage::vertex) {
        shader_.set("uA", 0).set("uB", 1);
    }
    /// Evaluates all sets once; does not wait.
    void draw() const {
        canvas_.bind();
        a_.bind(0);
        b_.bind(1);
        if (byPoints_)
            shader_.draw(GL_POINTS, canvas_.width() * canvas_.width());
        else
            shader_.draw();
    }
    /// Draws. Four floats per argument set, in the order of their indices.
    [[nodiscard]] std::vector<float> results() const {
        draw();
        const std::vector<float> topFirst = canvas_.pixels();
        std::vector<float> values;
        const auto row = static_cast<std::ptrdiff_t>(4) * canvas_.width();
        for (auto end = topFirst.end(); end != topFirst.begin(); end -= row)
            values.insert(values.end(), end - row, end);
        return values;
    }
    /// Bytes of arguments and results.
    [[nodiscard]] double bytes() const { return a_.bytes() + b_.bytes() + canvas_.bytes(); }

  private:
    Texels a_, b_;
    Canvas canvas_;
    Shader shader_;
    bool byPoints_;
};

/// The distance from the exact value. A result with a period has the distance to the nearest neighbour that
/// the rounding of the arguments could mean.
long double distanceOf(const BuiltinFunction& function, const Arguments& arguments, long double exact,
                       long double got) {
    const long double plain = std::fabs(got - exact);
    if (!function.period) return plain;
    const long double period = function.period(arguments);
    const long double quotient = arguments[0] / period;
    const bool atBorder = std::fabs(quotient - std::round(quotient)) < 4 * unitInLastPlace(quotient);
    return atBorder ? std::min({plain, std::fabs(got - exact - period), std::fabs(got - exact + period)})
                    : plain;
}

/// 12.3, 4.2e+05, inf: short enough for a column.
std::string brief(double value) {
    if (value == 0) return "0";
    if (value < 1e-2 || value >= 1e5) return fmt::format("{:.1e}", value);
    return fmt::format("{:.{}f}", value, value < 10 ? 2 : 1);
}

std::string verdict(const PrecisionRow& row) {
    const Precision& worse = row.vertex.timesTheBound.value_or(0) > row.fragment.timesTheBound.value_or(0)
                                 ? row.vertex
                                 : row.fragment;
    if (!worse.timesTheBound) return "";
    return *worse.timesTheBound > 1 ? fmt::format("broken, {} times", brief(*worse.timesTheBound)) : "kept";
}

std::string rangeOf(const PrecisionRow& row) {
    return fmt::format("{}, {}", row.function->name, row.sweep->words);
}

constexpr std::array<std::array<const char*, 2>, 6> kGroups{
    {{"trigonometric", "sin, cos, tan"},
     {"inverse-trigonometric", "asin, acos, atan"},
     {"exponential", "exp, log, pow and their kin"},
     {"arithmetic", "product, quotient and roots"},
     {"common", "floor, fract, mod, mix, smoothstep"},
     {"geometric", "dot, length, normalize, matrix times vector"}}};

/// The result of one function over one sweep, for the findings.
struct MeasuredSweep {
    const BuiltinFunction* function;
    const ArgumentSweep* sweep;
    PrecisionStage stage;
    Precision precision;
};

/// True for the vertex stage if the fragment stage gave the same.
bool isRepeated(const MeasuredSweep& each, const std::vector<MeasuredSweep>& all) {
    return each.stage == PrecisionStage::vertex && std::ranges::any_of(all, [&](const MeasuredSweep& other) {
               return other.stage == PrecisionStage::fragment && other.sweep == each.sweep &&
                      other.precision.largest == each.precision.largest &&
                      other.precision.mean == each.precision.mean;
           });
}

std::string foundOf(const MeasuredSweep& each) {
    const std::string where = fmt::format("{} over {}{}", each.function->name, each.sweep->words,
                                          each.stage == PrecisionStage::vertex ? " in the vertex stage" : "");
    if (each.precision.notNumbers > 0)
        return fmt::format("{} gives NaN or infinity {} times in {}", where, each.precision.notNumbers,
                           each.precision.samples);
    if (each.precision.timesTheBound.value_or(0) > 1)
        return fmt::format(
            "{} breaks the bound of GLSL ({}): {:.3g} ULP at ({}), {:.3g} times what is allowed there", where,
            each.function->bound, each.precision.largest, argumentsText(*each.function, each.precision.worst),
            *each.precision.timesTheBound);
    return {};
}

/// For a function whose precision GLSL leaves undefined: the sweeps where it is best and worst.
std::string bestAndWorst(const BuiltinFunction& function, const std::vector<MeasuredSweep>& all) {
    const MeasuredSweep* best = nullptr;
    const MeasuredSweep* worst = nullptr;
    for (const MeasuredSweep& each : all) {
        if (each.function != &function || each.stage != PrecisionStage::fragment) continue;
        if (!best || each.precision.largest < best->precision.largest) best = &each;
        if (!worst || each.precision.largest > worst->precision.largest) worst = &each;
    }
    if (!best || best == worst) return {};
    return fmt::format("{}: at most {:.3g} ULP over {}, {:.3g} over {}; GLSL leaves its precision open",
                       function.name, best->precision.largest, best->sweep->words, worst->precision.largest,
                       worst->sweep->words);
}

std::vector<std::string> precisionFindings(const std::vector<MeasuredSweep>& all) {
    std::vector<std::string> sentences;
    const MeasuredSweep* worst = nullptr;
    std::size_t bounded = 0, kept = 0;
    for (const MeasuredSweep& each : all) {
        if (isRepeated(each, all)) continue;
        if (!worst || each.precision.largest > worst->precision.largest) worst = &each;
        if (each.precision.timesTheBound) {
            ++bounded;
            if (*each.precision.timesTheBound <= 1 && each.precision.notNumbers == 0) ++kept;
        }
        if (std::string sentence = foundOf(each); !sentence.empty()) sentences.push_back(std::move(sentence));
    }
    if (bounded > 0)
        sentences.insert(sentences.begin(),
                         fmt::format("{} of {} bounds of GLSL 4.60, section 4.7.1, are kept", kept, bounded));
    for (const BuiltinFunction& function : builtinFunctions())
        if (std::string sentence = function.allowed ? std::string() : bestAndWorst(function, all);
            !sentence.empty())
            sentences.push_back(std::move(sentence));
    if (worst && std::isfinite(worst->precision.largest))
        sentences.push_back(
            fmt::format("the largest error is {:.3g} ULP (absolute {:.3g}): {} over {}, at ({})",
                        worst->precision.largest, worst->precision.largestAbsolute, worst->function->name,
                        worst->sweep->words, argumentsText(*worst->function, worst->precision.worst)));
    return sentences;
}

/// A curve of one function in one stage, timed in the fragment stage. The measured values are also added to
/// `all`.
Curve functionCurve(Bench& bench, const BuiltinFunction& function, PrecisionStage stage,
                    std::vector<MeasuredSweep>& all) {
    Curve curve{std::string(function.name) + (stage == PrecisionStage::vertex ? ", vertex stage" : "")};
    for (const ArgumentSweep& sweep : function.sweeps) {
        const PrecisionRun run(bench, function, sweep, stage, bench.pick(32, 512));
        const Precision found = judgePrecision(function, sweep, run.results());
        std::optional<Timing> time;
        if (stage == PrecisionStage::fragment) time = bench.timeDrawing([&] { run.draw(); });
        curve.points.push_back(
            {sweep.setting, sweep.words,
             found.notNumbers > 0 ? std::numeric_limits<double>::quiet_NaN() : found.largest, time,
             run.bytes()});
        all.push_back({&function, &sweep, stage, found});
    }
    return curve;
}

}  // namespace

long double unitInLastPlace(long double value) {
    constexpr int kLowestExponent = -126;  // of normal floats
    if (value == 0) return 0x1p-149L;
    return std::ldexp(1.0L, std::max(std::ilogb(value), kLowestExponent) - 23);
}

std::array<float, 8> argumentsOf(const ArgumentSweep& sweep, std::uint32_t index) {
    std::array<float, 8> arguments{};
    for (std::uint32_t slot = 0; slot < 8; ++slot) {
        const double u = index == 0 ? 0 : index == 1 ? 1 : uniform(index, slot);
        arguments[slot] = within(slot < 4 ? sweep.a : sweep.b, u);
    }
    return arguments;
}

std::span<const BuiltinFunction> builtinFunctions() {
    constexpr long double kDegree = std::numbers::pi_v<long double> / 180;
    static const std::vector<BuiltinFunction> table{
        {"sin", "trigonometric", "sin(a.x)", kOpen, of<sinl>, nullptr, angles()},
        {"cos", "trigonometric", "cos(a.x)", kOpen, of<cosl>, nullptr, angles()},
        {"tan", "trigonometric", "tan(a.x)", kOpen, of<tanl>, nullptr, angles()},

        {"asin", "inverse-trigonometric", "asin(a.x)", kOpen, of<asinl>, nullptr, arcs()},
        {"acos", "inverse-trigonometric", "acos(a.x)", kOpen, of<acosl>, nullptr, arcs()},
        {"atan",
         "inverse-trigonometric",
         "atan(a.x)",
         kOpen,
         of<atanl>,
         nullptr,
         {{1, "|x| to 1", upTo(1)},
          {10, "|x| from 1 to 10", {1, 10, false, true}},
          {1e6, "|x| from 10^-6 to 10^6", signedMagnitudes(1e-6, 1e6)}}},
        {"atan(y, x)",
         "inverse-trigonometric",
         "atan(a.x, b.x)",
         kOpen,
         ofTwo<atan2l>,
         nullptr,
         {{1, "both to 1", upTo(1), upTo(1)},
          {1e3, "both from 10^-3 to 10^3", signedMagnitudes(1e-3, 1e3), signedMagnitudes(1e-3, 1e3)}}},

        {"exp", "exponential", "exp(a.x)", "(3 + 2|x|) ULP", of<expl>, bounds::exponential, exponents(80)},
        {"exp2", "exponential", "exp2(a.x)", "(3 + 2|x|) ULP", of<exp2l>, bounds::exponential,
         exponents(120)},
        {"log", "exponential", "log(a.x)", "3 ULP, 2^-21 from 0.5 to 2", of<logl>, bounds::logarithm,
         positives()},
        {"log2", "exponential", "log2(a.x)", "3 ULP, 2^-21 from 0.5 to 2", of<log2l>, bounds::logarithm,
         positives()},
        {"pow",
         "exponential",
         "pow(a.x, b.x)",
         "as exp2(y log2(x))",
         ofTwo<powl>,
         bounds::power,
         {{1, "x from 0.5 to 2, |y| to 1", between(.5, 2), upTo(1)},
          {10, "x from 0.01 to 100, |y| to 10", magnitudes(.01, 100), upTo(10)},
          {128, "x from 0.6 to 1, y from 1 to 128", between(.6, 1), between(1, 128)}}},
        {"sinh", "exponential", "sinh(a.x)", "as (exp(x) - exp(-x)) / 2", of<sinhl>, bounds::hyperbolic,
         upToTen()},
        {"cosh", "exponential", "cosh(a.x)", "as (exp(x) + exp(-x)) / 2", of<coshl>, bounds::hyperbolic,
         upToTen()},
        {"tanh", "exponential", "tanh(a.x)", "as sinh(x) / cosh(x)", of<tanhl>, bounds::hyperbolicTangent,
         upToTen()},

        {"product", "arithmetic", "a.x * b.x", "0.5 ULP", [](const A& x, V& y) { y[0] = x[0] * x[4]; },
         bounds::ulps<1>, pairs()},
        {"division", "arithmetic", "a.x / b.x", "2.5 ULP", [](const A& x, V& y) { y[0] = x[0] / x[4]; },
         bounds::ulps<5>, pairs()},
        {"1 / x", "arithmetic", "1. / a.x", "2.5 ULP", [](const A& x, V& y) { y[0] = 1 / x[0]; },
         bounds::ulps<5>, positives()},
        {"sqrt", "arithmetic", "sqrt(a.x)", "as 1 / inversesqrt(x)", of<sqrtl>, bounds::root, positives()},
        {"inversesqrt", "arithmetic", "inversesqrt(a.x)", "2 ULP",
         [](const A& x, V& y) { y[0] = 1 / std::sqrt(x[0]); }, bounds::ulps<4>, positives()},
        {"radians",
         "arithmetic",
         "radians(a.x)",
         "as pi / 180 x",
         [](const A& x, V& y) { y[0] = x[0] * kDegree; },
         bounds::angle,
         {{360, "|x| to 360", upTo(360)}}},

        {"floor", "common", "floor(a.x)", "exact", of<floorl>, bounds::none, plainSweeps()},
        {"roundEven", "common", "roundEven(a.x)", "exact", of<nearbyintl>, bounds::none, plainSweeps()},
        {"fract", "common", "fract(a.x)", "as x - floor(x)",
         [](const A& x, V& y) { y[0] = x[0] - std::floor(x[0]); }, bounds::ulps<1>, plainSweeps()},
        {"mod",
         "common",
         "mod(a.x, b.x)",
         "as x - y floor(x / y)",
         [](const A& x, V& y) { y[0] = x[0] - x[4] * std::floor(x[0] / x[4]); },
         bounds::modulus,
         {{100, "|x| to 100, y from 0.5 to 10", upTo(100), between(.5, 10)},
          {1e6, "|x| to 10^6, y from 0.5 to 10", upTo(1e6), between(.5, 10)}},
         1,
         [](const A& x) { return x[4]; }},
        {"mix",
         "common",
         "mix(a.x, a.y, b.x)",
         "as x (1 - t) + y t",
         [](const A& x, V& y) { y[0] = x[0] * (1 - x[4]) + x[1] * x[4]; },
         bounds::mixture,
         {{1, "x and y from 0 to 1", between(0, 1), between(0, 1)},
          {100, "|x| and |y| to 100", upTo(100), between(0, 1)}}},
        {"smoothstep",
         "common",
         "smoothstep(-a.x, a.y, b.x)",
         "as its polynomial",
         [](const A& x, V& y) {
             const long double t = std::clamp((x[4] + x[0]) / (x[1] + x[0]), 0.0L, 1.0L);
             y[0] = t * t * (3 - 2 * t);
         },
         bounds::smoothStep,
         {{1, "edges in 0.1 to 1, |x| to 1", between(.1, 1), upTo(1)}}},

        {"dot",
         "geometric",
         "dot(a, b)",
         "as products and sums",
         [](const A& x, V& y) {
             y[0] = 0;
             for (std::size_t i = 0; i < 4; ++i) y[0] += x[i] * x[i + 4];
         },
         bounds::dot,
         {{1, "positive", between(.1, 1), between(.1, 1)}, {2, "both signs", upTo(1), upTo(1)}}},
        {"length", "geometric", "length(a.xyz)", "as sqrt(dot(v, v))",
         [](const A& x, V& y) { y[0] = exactLength(x); }, bounds::length, vectors()},
        {"distance", "geometric", "distance(a.xyz, b.xyz)", "as length(a - b)",
         [](const A& x, V& y) { y[0] = std::hypot(std::hypot(x[0] - x[4], x[1] - x[5]), x[2] - x[6]); },
         bounds::distance, vectorPairs()},
        {"normalize", "geometric", "normalize(a.xyz)", "as v / length(v)",
         [](const A& x, V& y) {
             for (std::size_t i = 0; i < 3; ++i) y[i] = x[i] / exactLength(x);
         },
         bounds::normalized, vectors(), 3},
        {"cross", "geometric", "cross(a.xyz, b.xyz)", "as products and differences",
         [](const A& x, V& y) {
             for (std::size_t i = 0; i < 3; ++i) {
                 const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
                 y[i] = x[j] * x[k + 4] - x[k] * x[j + 4];
             }
         },
         bounds::cross, vectorPairs(), 3},
        {"reflect", "geometric", "reflect(a.xyz, b.xyz)", "as I - 2 dot(N, I) N",
         [](const A& x, V& y) {
             const long double dot = x[0] * x[4] + x[1] * x[5] + x[2] * x[6];
             for (std::size_t i = 0; i < 3; ++i) y[i] = x[i] - 2 * dot * x[i + 4];
         },
         bounds::reflected, vectorPairs(), 3},
        {"mat2 * vec2", "geometric", "mat2(a) * b.xy", "as products and sums",
         [](const A& x, V& y) {
             for (std::size_t i = 0; i < 2; ++i) y[i] = x[i] * x[4] + x[i + 2] * x[5];
         },
         bounds::product, vectorPairs(), 2},
    };
    return table;
}

Precision judgePrecision(const BuiltinFunction& function, const ArgumentSweep& sweep,
                         const std::vector<float>& results) {
    Precision found;
    double sum = 0, timesTheBound = 0;
    std::size_t finite = 0;
    found.samples = results.size() / 4;
    for (std::size_t i = 0; i < found.samples; ++i) {
        const std::array<float, 8> given = argumentsOf(sweep, static_cast<std::uint32_t>(i));
        Arguments arguments{};
        std::copy(given.begin(), given.end(), arguments.begin());
        Values exact{};
        function.exact(arguments, exact);
        for (int c = 0; c < function.components; ++c) {
            const long double wanted = exact[static_cast<std::size_t>(c)];
            const float got = results[4 * i + static_cast<std::size_t>(c)];
            double ulps = std::numeric_limits<double>::infinity();
            if (!std::isfinite(got)) {
                ++found.notNumbers;
            } else {
                long double error = distanceOf(function, arguments, wanted, static_cast<long double>(got));
                if (std::fabs(wanted) < kSmallestNormal && got == 0) error = 0;
                ulps = static_cast<double>(error / unitInLastPlace(wanted));
                sum += ulps;
                ++finite;
                found.largestAbsolute = std::max(found.largestAbsolute, static_cast<double>(error));
            }
            if (ulps > found.largest) {
                found.largest = ulps;
                found.worst = given;
            }
            if (!function.allowed || ulps == 0) continue;
            const auto allowed =
                static_cast<double>(function.allowed(arguments, exact, c) / unitInLastPlace(wanted));
            timesTheBound = std::max(timesTheBound, ulps / allowed);
        }
    }
    found.mean = finite > 0 ? sum / static_cast<double>(finite) : 0;
    if (function.allowed) found.timesTheBound = timesTheBound;
    return found;
}

std::vector<PrecisionRow> precisionTable(Bench& bench, int side) {
    std::vector<PrecisionRow> rows;
    for (const BuiltinFunction& function : builtinFunctions())
        for (const ArgumentSweep& sweep : function.sweeps) {
            const auto judged = [&](PrecisionStage stage) {
                return judgePrecision(function, sweep,
                                      PrecisionRun(bench, function, sweep, stage, side).results());
            };
            rows.push_back(
                {&function, &sweep, judged(PrecisionStage::vertex), judged(PrecisionStage::fragment)});
        }
    return rows;
}

std::string argumentsText(const BuiltinFunction& function, const std::array<float, 8>& arguments) {
    constexpr std::string_view kComponents = "xyzw";
    const std::string_view text = function.expression;
    std::array<bool, 8> isRead{};
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool isName =
            (text[i] == 'a' || text[i] == 'b') &&
            (i == 0 || std::isalnum(static_cast<unsigned char>(text[i - 1])) == 0) &&
            (i + 1 == text.size() || std::isalnum(static_cast<unsigned char>(text[i + 1])) == 0);
        if (!isName) continue;
        const std::size_t first = text[i] == 'a' ? 0 : 4;
        const bool isSwizzled = i + 1 < text.size() && text[i + 1] == '.';
        for (std::size_t c = 0; c < 4; ++c) isRead[first + c] = isRead[first + c] || !isSwizzled;
        for (std::size_t k = i + 2; isSwizzled && k < text.size(); ++k) {
            const std::size_t c = kComponents.find(text[k]);
            if (c == std::string_view::npos) break;
            isRead[first + c] = true;
        }
    }
    std::string words;
    for (std::size_t i = 0; i < 8; ++i)
        if (isRead[i]) words += fmt::format("{}{:.9g}", words.empty() ? "" : ", ", arguments[i]);
    return words;
}

std::string toText(const std::vector<PrecisionRow>& rows) {
    std::string text =
        fmt::format("{:<12} {:<36} {:>9} {:>9} {:>9} {:>9}  {:<28} {}\n", "function", "arguments", "vertex",
                    "fragment", "mean", "absolute", "GLSL 4.60 allows", "");
    std::size_t broken = 0, bounded = 0, different = 0;
    for (const PrecisionRow& row : rows) {
        text += fmt::format("{:<12} {:<36} {:>9} {:>9} {:>9} {:>9}  {:<28} {}\n", row.function->name,
                            row.sweep->words, brief(row.vertex.largest), brief(row.fragment.largest),
                            brief(row.fragment.mean), brief(row.fragment.largestAbsolute),
                            row.function->bound, verdict(row));
        if (row.fragment.timesTheBound) ++bounded;
        if (verdict(row).starts_with("broken")) ++broken;
        if (row.vertex.largest != row.fragment.largest) ++different;
    }
    text += fmt::format(
        "Largest errors in the vertex and in the fragment stage and the mean error of the latter, in units "
        "in the "
        "last place of the exact result; largest absolute error.\n"
        "{} of {} bounds are broken; the stages differ in {} of {} lines.\n",
        broken, bounded, different, rows.size());
    for (const PrecisionRow& row : rows) {
        if (!verdict(row).starts_with("broken")) continue;
        const bool inVertex = row.vertex.largest > row.fragment.largest;
        const Precision& worse = inVertex ? row.vertex : row.fragment;
        text += fmt::format("{}: {} ULP at ({}) in the {} stage, allowed: {}\n", rangeOf(row),
                            brief(worse.largest), argumentsText(*row.function, worse.worst),
                            inVertex ? "vertex" : "fragment", row.function->bound);
    }
    return text;
}

std::vector<Figure> measureBuiltins(Bench& bench) {
    std::vector<Figure> figures;
    for (const auto& [name, title] : kGroups) {
        Figure figure{.name = name,
                      .title = title,
                      .settingName = "largest argument",
                      .errorName = "largest error",
                      .errorUnit = "units in the last place",
                      .reference = "the same function of the same floats in long double on the CPU",
                      .alternatives = Alternatives::none};
        std::vector<MeasuredSweep> all;
        for (const BuiltinFunction& function : builtinFunctions()) {
            if (function.group != name) continue;
            for (const PrecisionStage stage : {PrecisionStage::fragment, PrecisionStage::vertex}) {
                if (bench.isQuick() && stage == PrecisionStage::vertex) continue;
                Curve curve = functionCurve(bench, function, stage, all);
                const std::span<const MeasuredSweep> own = std::span(all).last(curve.points.size());
                if (std::ranges::any_of(own,
                                        [&](const MeasuredSweep& each) { return !isRepeated(each, all); }))
                    figure.curves.push_back(std::move(curve));
            }
        }
        figure.findings = precisionFindings(all);
        figures.push_back(std::move(figure));
    }
    return figures;
}

}  // namespace glibra::bench
