// Claims about functions and statements of fragment shaders.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "bench/core/fit.h"
#include "bench/draw/offscreen.h"
#include "bench/subjects/claim.h"

namespace glibra::bench {
namespace {

constexpr int kTimes = 32;

/// Two ways of writing `float form(vec2 p)`.
struct FormPair {
    const char* name;
    const char* text;
    const char* slowerName;
    const char* slower;
    const char* fasterName;
    const char* faster;
    bool mayBeEqual;
};

constexpr const char* kUnrolled =
    "float form(vec2 p) {\n"
    "    float sum = p.y;\n"
    "    sum = sum * p.x + p.y + 1.;\n"
    "    sum = sum * p.x + p.y + 2.;\n"
    "    sum = sum * p.x + p.y + 3.;\n"
    "    return .01 * sum;\n"
    "}\n";

constexpr FormPair kFormPairs[] = {
    {"pf05-branch", "An if is slow: an arithmetic choice is faster", "if, else",
     "float form(vec2 p) {\n"
     "    if (fract(37. * p.x + 91. * p.y) > .5) return p.x * p.y + .25;\n"
     "    else return p.x - .5 * p.y;\n"
     "}\n",
     "mix and step",
     "float form(vec2 p) {\n"
     "    return mix(p.x - .5 * p.y, p.x * p.y + .25, 1. - step(fract(37. * p.x + 91. * p.y), .5));\n"
     "}\n",
     false},
    {"pf05-loop", "A short loop is better unrolled", "loop with a bound that a uniform states",
     "uniform int uFour;\n"
     "float form(vec2 p) {\n"
     "    float sum = 0.;\n"
     "    for (int i = 0; i < uFour; ++i) sum = sum * p.x + p.y + float(i);\n"
     "    return .01 * sum;\n"
     "}\n",
     "unrolled", kUnrolled, false},
    {"pf05-constant-loop", "A short loop is better unrolled, even if its bound is constant",
     "loop with a constant bound",
     "float form(vec2 p) {\n"
     "    float sum = 0.;\n"
     "    for (int i = 0; i < 4; ++i) sum = sum * p.x + p.y + float(i);\n"
     "    return .01 * sum;\n"
     "}\n",
     "unrolled", kUnrolled, false},
    {"pf06-length", "A built-in function is never slower than the form written by hand: length",
     "sqrt(x * x + y * y + z * z)",
     "float form(vec2 p) {\n"
     "    vec3 v = vec3(p, .3 - p.x);\n"
     "    return sqrt(v.x * v.x + v.y * v.y + v.z * v.z);\n"
     "}\n",
     "length", "float form(vec2 p) { return length(vec3(p, .3 - p.x)); }\n", true},
    {"pf06-dot", "A built-in function is never slower than the form written by hand: dot", "x * x + y * y",
     "float form(vec2 p) { return p.x * p.x + p.y * p.y; }\n", "dot",
     "float form(vec2 p) { return dot(p, p); }\n", true},
    {"pf06-normalize", "A built-in function is never slower than the form written by hand: normalize",
     "v / sqrt(x * x + y * y + z * z)",
     "float form(vec2 p) {\n"
     "    vec3 v = vec3(p, .3 - p.x);\n"
     "    return (v / sqrt(v.x * v.x + v.y * v.y + v.z * v.z)).x;\n"
     "}\n",
     "normalize", "float form(vec2 p) { return normalize(vec3(p, .3 - p.x)).x; }\n", true},
    {"pf07", "One comparison of vectors with any() is faster than an if per component", "three ifs",
     "float form(vec2 p) {\n"
     "    vec3 v = fract(vec3(17., 29., 43.) * p.xyx + p.y);\n"
     "    if (v.x > .8) return 0.;\n"
     "    if (v.y > .7) return 0.;\n"
     "    if (v.z > .9) return 0.;\n"
     "    return v.x;\n"
     "}\n",
     "any(greaterThan())",
     "float form(vec2 p) {\n"
     "    vec3 v = fract(vec3(17., 29., 43.) * p.xyx + p.y);\n"
     "    return any(greaterThan(v, vec3(.8, .7, .9))) ? 0. : v.x;\n"
     "}\n",
     false},
    {"pf08", "Do not compute an angle by atan to take its sine and cosine", "atan, sin, cos",
     "float form(vec2 p) {\n"
     "    float r = length(p), angle = atan(p.y, p.x), wave = r + .1 * r * r;\n"
     "    vec2 q = wave * vec2(cos(angle), sin(angle));\n"
     "    return q.x + .5 * q.y;\n"
     "}\n",
     "divided by the radius",
     "float form(vec2 p) {\n"
     "    float r = length(p), wave = r + .1 * r * r;\n"
     "    vec2 q = wave * p / r;\n"
     "    return q.x + .5 * q.y;\n"
     "}\n",
     false},
    {"pf09", "The polar hyperbolic zoom needs only one square root", "polar coordinates: atan, cos, sin",
     "float form(vec2 p) {\n"
     "    float r = length(p), angle = atan(p.y, p.x), far = r / (r + .7);\n"
     "    return far * cos(angle) + far * sin(angle);\n"
     "}\n",
     "one square root",
     "float form(vec2 p) {\n"
     "    vec2 far = p / (sqrt(dot(p, p)) + .7);\n"
     "    return far.x + far.y;\n"
     "}\n",
     false},
};

/// Functions against a multiplication and an addition.
struct MeasuredFunction {
    const char* name;
    const char* glsl;
};
constexpr MeasuredFunction kMeasuredFunctions[] = {
    {"sqrt", "sqrt(x)"},    {"inversesqrt", "inversesqrt(x)"},
    {"division", ".7 / x"}, {"exp2", "exp2(x)"},
    {"log2", "log2(x)"},    {"pow", "pow(x, 2.3)"},
    {"sin", "sin(x)"},      {"tan", "tan(.3 * x)"},
    {"atan", "atan(x)"},    {"atan of two", "atan(x, 1.3)"},
};

std::string wholeShader(std::string_view form) {
    return fmt::format(
        "in vec2 vPlace;\n"
        "out vec4 fColor;\n"
        "uniform float uShift;\n"
        "{}"
        "void main() {{\n"
        "    float sum = 0.;\n"
        "    for (int i = 0; i < {}; ++i) sum += form(vPlace + .01 + float(i) * uShift);\n"
        "    fColor = vec4(sum / {}.);\n"
        "}}\n",
        form, kTimes, kTimes);
}

/// A program over a whole target, and its picture.
struct DrawnForm {
    std::function<void()> draw;
    std::vector<float> values;
};

Result<DrawnForm> drawnForm(const ClaimSetup& setup, const std::shared_ptr<gpu::Target>& target,
                            std::string_view form) {
    Result<gpu::Program> built = program(setup.capabilities(), kWholeTarget, wholeShader(form));
    if (!built) return std::move(built.diagnostics);
    setFloats(*built, "uShift", {.013F});
    setInt(*built, "uFour", 4);
    const auto owned = shared(std::move(*built));
    DrawnForm drawn{[owned, target] {
                        target->bind();
                        drawWhole(*owned);
                    },
                    {}};
    drawn.draw();
    Result<std::vector<float>> values = readFloats(setup.capabilities(), *target, 1);
    if (!values) return std::move(values.diagnostics);
    drawn.values = std::move(*values);
    return drawn;
}

double largestDifference(const std::vector<float>& a, const std::vector<float>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
    return largest;
}

/// What each function costs in multiplications with additions.
Result<Figure> functionCosts(const ClaimSetup& setup, const std::shared_ptr<gpu::Target>& target,
                             const std::string& work) {
    const auto form = [](const char* glsl) {
        return fmt::format("float form(vec2 p) {{ float x = p.x + p.y; return {}; }}\n", glsl);
    };
    const Result<DrawnForm> plain = drawnForm(setup, target, form("x * 1.7 + .3"));
    if (!plain) return plain.diagnostics;
    Figure figure{.name = "pf05-functions",
                  .title = "Some functions are hardware and cheap, others are software",
                  .settingName = "work",
                  .errorName = "times a multiplication and addition",
                  .errorUnit = "",
                  .reference = "the time of one multiplication and addition in the same shader",
                  .alternatives = Alternatives::none};
    double least = 1e9, most = 0;
    std::string cheapest, dearest, all;
    for (const MeasuredFunction& each : kMeasuredFunctions) {
        const Result<DrawnForm> drawn = drawnForm(setup, target, form(each.glsl));
        if (!drawn) return drawn.diagnostics;
        const PairedTiming timing = setup.time(drawn->draw, plain->draw);
        figure.curves.push_back(
            {each.name, {{.setting = 1, .label = work, .error = timing.ratio.median, .time = timing.first}}});
        all += fmt::format("{}{} {:.2f}", all.empty() ? "" : ", ", each.name, timing.ratio.median);
        if (timing.ratio.median < least) least = timing.ratio.median, cheapest = each.name;
        if (timing.ratio.median > most) most = timing.ratio.median, dearest = each.name;
    }
    constexpr double kApart = 1.5;
    figure.findings = {fmt::format("{} here: {} takes {:.2f} times as long as {}",
                                   most / least > kApart ? "true" : "false", dearest, most / least, cheapest),
                       "in multiplications with addition: " + all};
    return figure;
}

/// Half of the pixels are left out, by discard or by an alpha of 0.
Result<Figure> discardOrBlend(const ClaimSetup& setup, int side) {
    Result<gpu::Target> made = gpu::Target::window(setup.capabilities(), side, side, gpu::TexelFormat::rgba8);
    if (!made) return std::move(made.diagnostics);
    const auto target = shared(std::move(*made));
    const std::string start =
        "in vec2 vPlace;\nout vec4 fColor;\nvoid main() {\n"
        "    vec2 cell = fract(40. * vPlace) - .5;\n    bool isHole = dot(cell, cell) > .16;\n";
    struct Drawn {
        gpu::Program program;
        bool blends;
    };
    std::vector<std::shared_ptr<Drawn>> ways;
    std::vector<std::vector<float>> pictures;
    for (const bool blends : {true, false}) {
        Result<gpu::Program> built =
            program(setup.capabilities(), kWholeTarget,
                    start + (blends ? "    fColor = vec4(.2, .6, .9, isHole ? 0. : 1.);\n}\n"
                                    : "    if (isHole) discard;\n    fColor = vec4(.2, .6, .9, 1.);\n}\n"));
        if (!built) return std::move(built.diagnostics);
        ways.push_back(shared(Drawn{std::move(*built), blends}));
    }
    const auto draws = [target](const std::shared_ptr<Drawn>& way) {
        return [target, way] {
            target->bind();
            if (way->blends) {
                glEnable(GL_BLEND);
                glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
            }
            for (int i = 0; i < 4; ++i) drawWhole(way->program);
            glDisable(GL_BLEND);
        };
    };
    for (const auto& way : ways) {
        target->bind();
        target->clearColor(0, {1, 1, 1, 1});
        draws(way)();
        Result<std::vector<float>> picture = readFloats(setup.capabilities(), *target, 3);
        if (!picture) return std::move(picture.diagnostics);
        pictures.push_back(std::move(*picture));
    }
    return figureOf(setup,
                    {.name = "pf21",
                     .text = "Leaving pixels out by discard is faster than by blending with alpha 0",
                     .work = fmt::format("{0} x {0} pixels, 4 times, half of them left out", side),
                     .errorName = "largest difference",
                     .errorUnit = "",
                     .reference = "the picture of the other way",
                     .slower = {"blending with alpha 0", draws(ways[0])},
                     .faster = {"discard", draws(ways[1]), largestDifference(pictures[0], pictures[1])}});
}

}  // namespace

Result<std::vector<Figure>> measureFragmentClaims(const ClaimSetup& setup) {
    const int side = setup.bench.isQuick() ? 128 : 512;
    Result<gpu::Target> made = gpu::Target::window(setup.capabilities(), side, side, gpu::TexelFormat::r32f);
    if (!made) return std::move(made.diagnostics);
    const auto target = shared(std::move(*made));
    const std::string work = fmt::format("{0} x {0} pixels, {1} times", side, kTimes);
    std::vector<Figure> figures;
    Result<Figure> costs = functionCosts(setup, target, work);
    if (!costs) return std::move(costs.diagnostics);
    figures.push_back(std::move(*costs));
    for (const FormPair& each : kFormPairs) {
        const Result<DrawnForm> slower = drawnForm(setup, target, each.slower);
        if (!slower) return slower.diagnostics;
        const Result<DrawnForm> faster = drawnForm(setup, target, each.faster);
        if (!faster) return faster.diagnostics;
        figures.push_back(figureOf(setup, {.name = each.name,
                                           .text = each.text,
                                           .work = work,
                                           .errorName = "largest difference",
                                           .errorUnit = "",
                                           .reference = "the picture of the other way",
                                           .slower = {each.slowerName, slower->draw},
                                           .faster = {each.fasterName, faster->draw,
                                                      largestDifference(slower->values, faster->values)},
                                           .mayBeEqual = each.mayBeEqual}));
    }
    Result<Figure> holes = discardOrBlend(setup, side);
    if (!holes) return std::move(holes.diagnostics);
    figures.push_back(std::move(*holes));
    return figures;
}

}  // namespace glibra::bench
