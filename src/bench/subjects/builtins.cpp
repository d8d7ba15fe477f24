#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/subjects/builtin_precision.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

struct Group {
    std::string_view name, title;
};

constexpr std::array<Group, 6> kGroups{{{"trigonometric", "sin, cos, tan"},
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

std::string found(const MeasuredSweep& each) {
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

std::vector<std::string> findings(const std::vector<MeasuredSweep>& all) {
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
        if (std::string sentence = found(each); !sentence.empty()) sentences.push_back(std::move(sentence));
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
Result<Curve> functionCurve(Bench& bench, const gpu::Capabilities& capabilities,
                            const BuiltinFunction& function, PrecisionStage stage,
                            std::vector<MeasuredSweep>& all) {
    const int side = bench.isQuick() ? 32 : 512;
    Curve curve;
    curve.name = std::string(function.name) + (stage == PrecisionStage::vertex ? ", vertex stage" : "");
    for (const ArgumentSweep& sweep : function.sweeps) {
        const Result<PrecisionRun> run = PrecisionRun::create(capabilities, function, sweep, stage, side);
        if (!run) return run.diagnostics;
        Point point;
        point.setting = sweep.setting;
        point.label = sweep.words;
        point.memory = run->bytes();
        run->draw();
        if (stage == PrecisionStage::fragment)
            point.time = bench.time([&] {
                run->draw();
                glFinish();
            });
        const Result<std::vector<float>> results = run->results(capabilities);
        if (!results) return results.diagnostics;
        all.push_back({&function, &sweep, stage, judgePrecision(function, sweep, *results)});
        point.error = all.back().precision.notNumbers > 0 ? std::numeric_limits<double>::quiet_NaN()
                                                          : all.back().precision.largest;
        curve.points.push_back(std::move(point));
    }
    return curve;
}

}  // namespace

Result<std::vector<Figure>> measureBuiltins(Bench& bench) {
    const Result<gpu::Context*> context = bench.context();
    if (!context) return context.diagnostics;
    const gpu::Capabilities& capabilities = (*context)->capabilities();
    std::vector<Figure> figures;
    for (const Group& group : kGroups) {
        Figure figure{.name = std::string(group.name),
                      .title = std::string(group.title),
                      .settingName = "largest argument",
                      .errorName = "largest error",
                      .errorUnit = "units in the last place",
                      .reference = "the same function of the same floats in long double on the CPU",
                      .alternatives = Alternatives::none};
        std::vector<MeasuredSweep> all;
        for (const BuiltinFunction& function : builtinFunctions()) {
            if (function.group != group.name) continue;
            for (const PrecisionStage stage : {PrecisionStage::fragment, PrecisionStage::vertex}) {
                if (bench.isQuick() && stage == PrecisionStage::vertex) continue;
                Result<Curve> curve = functionCurve(bench, capabilities, function, stage, all);
                if (!curve) return std::move(curve.diagnostics);
                const bool isNew =
                    std::any_of(all.end() - static_cast<std::ptrdiff_t>(curve->points.size()), all.end(),
                                [&](const MeasuredSweep& each) { return !isRepeated(each, all); });
                if (isNew) figure.curves.push_back(std::move(*curve));
            }
        }
        figure.findings = findings(all);
        figures.push_back(std::move(figure));
    }
    return figures;
}

}  // namespace glibra::bench
