#include "bench/subjects/builtins.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <limits>

namespace glibra::bench {
namespace {

constexpr long double kSmallestNormal = 0x1p-126L;

/// A function at side * side argument sets of a sweep on the device.
ShaderValues evaluating(Bench& bench, const BuiltinFunction& function, const ArgumentSweep& sweep,
                        GLenum stage, int side) {
    std::vector<Four> arguments;
    for (int i = 0; i < side * side; ++i) {
        const std::array<float, 8> x = argumentsOf(sweep, static_cast<std::uint32_t>(i));
        arguments.insert(arguments.end(), {Four(x[0], x[1], x[2], x[3]), Four(x[4], x[5], x[6], x[7])});
    }
    constexpr std::array kRest{", 0., 0., 0.", ", 0., 0.", ", 0."};  // of a float, vec2 or vec3 as a vec4
    const std::string glsl =
        fmt::format("vec4 value() {{ vec4 a = given(0), b = given(1); return vec4({}{}); }}",
                    function.expression, kRest.at(static_cast<std::size_t>(function.components - 1)));
    return {bench, glsl, arguments, 2, stage};
}

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
    GLenum stage;
    Precision precision;
};

std::string foundOf(const MeasuredSweep& each) {
    const std::string where = fmt::format("{} over {}{}", each.function->name, each.sweep->words,
                                          each.stage == GL_VERTEX_SHADER ? " in the vertex stage" : "");
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
        if (each.function != &function || each.stage != GL_FRAGMENT_SHADER) continue;
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

/// Adds the curves of a function: in the fragment stage, which is timed, and in the vertex stage if a result
/// differs. The measured values are also added to `all`, but those of the vertex stage that are repeated.
void addCurves(Figure& figure, Bench& bench, const BuiltinFunction& function,
               std::vector<MeasuredSweep>& all) {
    Curve fragment{std::string(function.name)}, vertex{fragment.name + ", vertex stage"};
    bool differs = false;
    for (const ArgumentSweep& sweep : function.sweeps) {
        const auto measured = [&](GLenum stage, Curve& to, bool isTimed) {
            const ShaderValues values = evaluating(bench, function, sweep, stage, bench.pick(32, 512));
            const Precision found = judgePrecision(function, sweep, values.values());
            std::optional<Timing> time;
            if (isTimed) time = bench.timeDrawing([&] { values.compute(); });
            to.points.push_back(
                {sweep.setting, sweep.words,
                 found.notNumbers > 0 ? std::numeric_limits<double>::quiet_NaN() : found.largest, time,
                 values.bytes()});
            return found;
        };
        const Precision found = measured(GL_FRAGMENT_SHADER, fragment, true);
        all.push_back({&function, &sweep, GL_FRAGMENT_SHADER, found});
        if (bench.isQuick()) continue;
        const Precision other = measured(GL_VERTEX_SHADER, vertex, false);
        if (other.largest == found.largest && other.mean == found.mean) continue;
        all.push_back({&function, &sweep, GL_VERTEX_SHADER, other});
        differs = true;
    }
    figure.curves.push_back(std::move(fragment));
    if (differs) figure.curves.push_back(std::move(vertex));
}

}  // namespace

Precision judgePrecision(const BuiltinFunction& function, const ArgumentSweep& sweep,
                         const std::vector<Four>& results) {
    Precision found;
    double sum = 0, timesTheBound = 0;
    std::size_t finite = 0;
    found.samples = results.size();
    for (std::size_t i = 0; i < found.samples; ++i) {
        const std::array<float, 8> given = argumentsOf(sweep, static_cast<std::uint32_t>(i));
        Arguments arguments{};
        std::copy(given.begin(), given.end(), arguments.begin());
        Values exact{};
        function.exact(arguments, exact);
        for (int c = 0; c < function.components; ++c) {
            const long double wanted = exact[static_cast<std::size_t>(c)];
            const float got = results[i][c];
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
            const auto judged = [&](GLenum stage) {
                return judgePrecision(function, sweep,
                                      evaluating(bench, function, sweep, stage, side).values());
            };
            rows.push_back({&function, &sweep, judged(GL_VERTEX_SHADER), judged(GL_FRAGMENT_SHADER)});
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
        for (const BuiltinFunction& function : builtinFunctions())
            if (function.group == name) addCurves(figure, bench, function, all);
        figure.findings = precisionFindings(all);
        figures.push_back(std::move(figure));
    }
    return figures;
}

}  // namespace glibra::bench
