#include "bench/subjects/claims.h"

#include <algorithm>
#include <array>
#include <utility>

#include "bench/core/device.h"
#include "bench/subjects/subjects.h"
#include "embedded/bench_shaders.h"

namespace glibra::bench {
namespace {

/// One computation per texel of 1024 x 1024, in work groups of several shapes.
Figure workGroups(Bench& bench) {
    Figure figure{.name = "a44",
                  .title = "Work groups of one invocation waste the device",
                  .settingName = "invocations per group",
                  .errorName = "error",
                  .reference = "the stress test WorkGroups: the same results",
                  .alternatives = Alternatives::none};
    const int side = bench.pick(128, 1024);
    const gpu::Buffer buffer = need(gpu::Buffer::create(4 * static_cast<std::size_t>(side * side)));
    const auto dispatching = [&](int x, int y) -> Draw {
        const std::string text = fmt::format(R"(#version 430 core
layout(local_size_x = {0}, local_size_y = {1}) in;
layout(std430, binding = 0) buffer Result {{ float result[]; }};
void main() {{
    vec2 c = vec2(gl_GlobalInvocationID.xy) / {2}. * 2. - 1.5, z = vec2(0.);
    int n = 0;
    for (; n < 24 && dot(z, z) < 4.; ++n) z = vec2(z.x * z.x - z.y * z.y, 2. * z.x * z.y) + c;
    result[gl_GlobalInvocationID.y * {2}u + gl_GlobalInvocationID.x] = float(n);
}}
)",
                                             x, y, side);
        const Shader shader(bench, std::array{gpu::StageSource{GL_COMPUTE_SHADER, text}});
        return [shader, &buffer, x = static_cast<GLuint>(side / x), y = static_cast<GLuint>(side / y)] {
            shader.use();
            buffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
            glDispatchCompute(x, y, 1);
            glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        };
    };
    const Draw one = dispatching(1, 1);
    std::string all;
    for (const auto& [x, y] : {std::pair(1, 1), {8, 8}, {16, 16}, {32, 1}, {64, 1}}) {
        const PairedTiming timing = timedInTurn(bench, one, dispatching(x, y));
        const std::string label = fmt::format("{} x {}", x, y);
        figure.add("time by the shape of the group", {1. * x * y, label, 0, timing.second, 4. * side * side});
        if (x == 8) figure.note("{}: 1 x 1 / 8 x 8", verdict(timing.ratio, false));
        if (x > 1) all += fmt::format("{}{} {:.2f}", all.empty() ? "" : ", ", label, timing.ratio.median);
    }
    figure.note("1 x 1 in times of the other shapes: {}", all);
    return figure;
}

}  // namespace

PairedTiming timedInTurn(Bench& bench, const Draw& slower, const Draw& faster) {
    const auto waited = [](const Draw& draw) {
        return [&draw] {
            draw();
            glFinish();
        };
    };
    return timePairs(waited(slower), waited(faster), bench.pick(5, 11), bench.capabilities().isSoftware);
}

Figure claimFigure(Bench& bench, const Claim& claim) {
    const PairedTiming timing = timedInTurn(bench, claim.slower.draw, claim.faster.draw);
    Figure figure{.name = claim.name,
                  .title = claim.text,
                  .settingName = "work",
                  .errorName = claim.errorName,
                  .errorUnit = claim.errorUnit,
                  .reference = claim.reference};
    for (const auto& [way, time] : {std::pair(&claim.slower, timing.first), {&claim.faster, timing.second}})
        figure.add(way->name, {1, claim.work, way->error, time, way->memory});
    figure.note("{}: {} / {}", verdict(timing.ratio, claim.mayBeEqual), claim.slower.name, claim.faster.name);
    return figure;
}

std::string pixelsText(int side) {
    return fmt::format("{0} x {0} pixels", side);
}

std::vector<Figure> measureClaims(Bench& bench) {
    std::vector<Figure> figures;
    addFragmentClaims(figures, bench);
    addTextureClaims(figures, bench);
    addMeshClaims(figures, bench);
    if (bench.capabilities().compute) figures.push_back(workGroups(bench));
    return figures;
}

namespace {

using gpu::TexelFormat;

constexpr int kTimes = 32;

/// Two ways of writing `float form(vec2 p)`, in shaders/forms.glsl.
struct FormPair {
    const char *name, *text, *macro, *slower, *faster;
    bool mayBeEqual = false;
};

constexpr FormPair kFormPairs[] = {
    {"pf05-branch", "An if is slow: an arithmetic choice is faster", "BRANCH", "if, else", "mix and step"},
    {"pf05-loop", "A short loop is better unrolled", "LOOP", "loop with a bound that a uniform states",
     "unrolled"},
    {"pf05-constant-loop", "A short loop is better unrolled, even if its bound is constant", "CONSTANT_LOOP",
     "loop with a constant bound", "unrolled"},
    {"pf06-length", "A built-in function is never slower than the form written by hand: length", "LENGTH",
     "sqrt(x * x + y * y + z * z)", "length", true},
    {"pf06-dot", "A built-in function is never slower than the form written by hand: dot", "DOT",
     "x * x + y * y", "dot", true},
    {"pf06-normalize", "A built-in function is never slower than the form written by hand: normalize",
     "NORMALIZE", "v / sqrt(x * x + y * y + z * z)", "normalize", true},
    {"pf07", "One comparison of vectors with any() is faster than an if per component", "COMPARISON",
     "three ifs", "any(greaterThan())"},
    {"pf08", "Do not compute an angle by atan to take its sine and cosine", "ANGLE", "atan, sin, cos",
     "divided by the radius"},
    {"pf09", "The polar hyperbolic zoom needs only one square root", "ZOOM",
     "polar coordinates: atan, cos, sin", "one square root"},
};

/// Functions against a multiplication and an addition.
constexpr std::pair<const char*, const char*> kMeasuredFunctions[] = {
    {"sqrt", "sqrt(x)"},    {"inversesqrt", "inversesqrt(x)"},
    {"division", ".7 / x"}, {"exp2", "exp2(x)"},
    {"log2", "log2(x)"},    {"pow", "pow(x, 2.3)"},
    {"sin", "sin(x)"},      {"tan", "tan(.3 * x)"},
    {"atan", "atan(x)"},    {"atan of two", "atan(x, 1.3)"}};

/// A program over a whole target, and its picture.
struct DrawnForm {
    Draw draw;
    std::vector<float> values;

    DrawnForm(Bench& bench, const Canvas& canvas, std::string_view form) {
        const Shader shader(bench, fmt::format(R"(in vec2 vPlace;
out vec4 fColor;
uniform float uShift;
{0}void main() {{
    float sum = 0.;
    for (int i = 0; i < {1}; ++i) sum += form(vPlace + .01 + float(i) * uShift);
    fColor = vec4(sum / {1}.);
}}
)",
                                               form, kTimes));
        shader.set("uShift", .013).set("uFour", 4);
        draw = [shader, canvas] {
            canvas.bind();
            shader.draw();
        };
        draw();
        values = canvas.pixels(1);
    }
};

/// What each function costs in multiplications with additions.
Figure functionCosts(Bench& bench, const Canvas& canvas, const std::string& work) {
    const auto form = [&](const char* glsl) {
        return DrawnForm(bench, canvas,
                         fmt::format("float form(vec2 p) {{ float x = p.x + p.y; return {}; }}\n", glsl));
    };
    Figure figure{.name = "pf05-functions",
                  .title = "Some functions are hardware and cheap, others are software",
                  .settingName = "work",
                  .errorName = "times a multiplication and addition",
                  .reference = "the time of one multiplication and addition in the same shader",
                  .alternatives = Alternatives::none};
    const DrawnForm plain = form("x * 1.7 + .3");
    std::string all;
    for (const auto& [name, glsl] : kMeasuredFunctions) {
        const PairedTiming timing = timedInTurn(bench, form(glsl).draw, plain.draw);
        figure.add(name, {1, work, timing.ratio.median, timing.first});
        all += fmt::format("{}{} {:.2f}", all.empty() ? "" : ", ", name, timing.ratio.median);
    }
    const auto [cheapest, dearest] = std::ranges::minmax_element(
        figure.curves, {}, [](const Curve& each) { return each.points.front().error; });
    constexpr double kApart = 1.5;
    const double ratio = dearest->points.front().error / cheapest->points.front().error;
    figure.note("{} here: {} takes {:.2f} times as long as {}", ratio > kApart ? "true" : "false",
                dearest->name, ratio, cheapest->name);
    figure.note("in multiplications with addition: {}", all);
    return figure;
}

/// Half of the pixels are left out, by discard or by an alpha of 0.
Figure discardOrBlend(Bench& bench, int side) {
    const Canvas canvas(bench, side, side, TexelFormat::rgba8);
    const auto drawing = [&](bool blends) -> Draw {
        const Shader shader(bench,
                            fmt::format(R"(in vec2 vPlace;
out vec4 fColor;
void main() {{
    vec2 cell = fract(40. * vPlace) - .5;
    bool isHole = dot(cell, cell) > .16;
    {}
}}
)",
                                        blends ? "fColor = vec4(.2, .6, .9, isHole ? 0. : 1.);"
                                               : "if (isHole) discard;\n    fColor = vec4(.2, .6, .9, 1.);"));
        return [shader, canvas, blends] {
            canvas.bind();
            if (blends) {
                glEnable(GL_BLEND);
                glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
            }
            for (int i = 0; i < 4; ++i) shader.draw();
            glDisable(GL_BLEND);
        };
    };
    const Draw blending = drawing(true), discarding = drawing(false);
    const auto picture = [&](const Draw& draw) {
        canvas.clear({1, 1, 1, 1});
        draw();
        return canvas.pixels(3);
    };
    return claimFigure(
        bench,
        {.name = "pf21",
         .text = "Leaving pixels out by discard is faster than by blending with alpha 0",
         .work = fmt::format("{}, 4 times, half of them left out", pixelsText(side)),
         .errorName = "largest difference",
         .reference = kOtherPicture,
         .slower = {"blending with alpha 0", blending},
         .faster = {"discard", discarding, largestDifference(picture(blending), picture(discarding))}});
}

}  // namespace

void addFragmentClaims(std::vector<Figure>& figures, Bench& bench) {
    const int side = bench.pick(128, 512);
    const Canvas canvas(bench, side, side, TexelFormat::r32f);
    const std::string work = fmt::format("{}, {} times", pixelsText(side), kTimes);
    figures.push_back(functionCosts(bench, canvas, work));
    for (const FormPair& each : kFormPairs) {
        const std::string form = fmt::format("#define {}\n{}", each.macro, bench_shaders::forms_glsl());
        const DrawnForm slower(bench, canvas, "#define SLOWER\n" + form), faster(bench, canvas, form);
        figures.push_back(claimFigure(
            bench, {.name = each.name,
                    .text = each.text,
                    .work = work,
                    .errorName = "largest difference",
                    .reference = kOtherPicture,
                    .slower = {each.slower, slower.draw},
                    .faster = {each.faster, faster.draw, largestDifference(slower.values, faster.values)},
                    .mayBeEqual = each.mayBeEqual}));
    }
    figures.push_back(discardOrBlend(bench, side));
}

}  // namespace glibra::bench
