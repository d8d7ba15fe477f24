#include <algorithm>
#include <array>

#include "bench/core/device.h"
#include "bench/subjects/claims.h"

namespace glibra::bench {
namespace {

using gpu::TexelFormat;

constexpr int kTimes = 32;

/// Two ways of writing `float form(vec2 p)`.
struct FormPair {
    const char *name, *text, *slowerName, *slower, *fasterName, *faster;
    bool mayBeEqual = false;
};

constexpr const char* kUnrolled =
    R"(float form(vec2 p) {
    float sum = p.y;
    sum = sum * p.x + p.y + 1.;
    sum = sum * p.x + p.y + 2.;
    sum = sum * p.x + p.y + 3.;
    return .01 * sum;
}
)";

constexpr FormPair kFormPairs[] = {
    {"pf05-branch", "An if is slow: an arithmetic choice is faster", "if, else",
     R"(float form(vec2 p) {
    if (fract(37. * p.x + 91. * p.y) > .5) return p.x * p.y + .25;
    else return p.x - .5 * p.y;
}
)",
     "mix and step",
     R"(float form(vec2 p) {
    return mix(p.x - .5 * p.y, p.x * p.y + .25, 1. - step(fract(37. * p.x + 91. * p.y), .5));
}
)"},
    {"pf05-loop", "A short loop is better unrolled", "loop with a bound that a uniform states",
     R"(uniform int uFour;
float form(vec2 p) {
    float sum = 0.;
    for (int i = 0; i < uFour; ++i) sum = sum * p.x + p.y + float(i);
    return .01 * sum;
}
)",
     "unrolled", kUnrolled, false},
    {"pf05-constant-loop", "A short loop is better unrolled, even if its bound is constant",
     "loop with a constant bound",
     R"(float form(vec2 p) {
    float sum = 0.;
    for (int i = 0; i < 4; ++i) sum = sum * p.x + p.y + float(i);
    return .01 * sum;
}
)",
     "unrolled", kUnrolled, false},
    {"pf06-length", "A built-in function is never slower than the form written by hand: length",
     "sqrt(x * x + y * y + z * z)",
     R"(float form(vec2 p) {
    vec3 v = vec3(p, .3 - p.x);
    return sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}
)",
     "length", "float form(vec2 p) { return length(vec3(p, .3 - p.x)); }\n", true},
    {"pf06-dot", "A built-in function is never slower than the form written by hand: dot", "x * x + y * y",
     "float form(vec2 p) { return p.x * p.x + p.y * p.y; }\n", "dot",
     "float form(vec2 p) { return dot(p, p); }\n", true},
    {"pf06-normalize", "A built-in function is never slower than the form written by hand: normalize",
     "v / sqrt(x * x + y * y + z * z)",
     R"(float form(vec2 p) {
    vec3 v = vec3(p, .3 - p.x);
    return (v / sqrt(v.x * v.x + v.y * v.y + v.z * v.z)).x;
}
)",
     "normalize", "float form(vec2 p) { return normalize(vec3(p, .3 - p.x)).x; }\n", true},
    {"pf07", "One comparison of vectors with any() is faster than an if per component", "three ifs",
     R"(float form(vec2 p) {
    vec3 v = fract(vec3(17., 29., 43.) * p.xyx + p.y);
    if (v.x > .8) return 0.;
    if (v.y > .7) return 0.;
    if (v.z > .9) return 0.;
    return v.x;
}
)",
     "any(greaterThan())",
     R"(float form(vec2 p) {
    vec3 v = fract(vec3(17., 29., 43.) * p.xyx + p.y);
    return any(greaterThan(v, vec3(.8, .7, .9))) ? 0. : v.x;
}
)"},
    {"pf08", "Do not compute an angle by atan to take its sine and cosine", "atan, sin, cos",
     R"(float form(vec2 p) {
    float r = length(p), angle = atan(p.y, p.x), wave = r + .1 * r * r;
    vec2 q = wave * vec2(cos(angle), sin(angle));
    return q.x + .5 * q.y;
}
)",
     "divided by the radius",
     R"(float form(vec2 p) {
    float r = length(p), wave = r + .1 * r * r;
    vec2 q = wave * p / r;
    return q.x + .5 * q.y;
}
)"},
    {"pf09", "The polar hyperbolic zoom needs only one square root", "polar coordinates: atan, cos, sin",
     R"(float form(vec2 p) {
    float r = length(p), angle = atan(p.y, p.x), far = r / (r + .7);
    return far * cos(angle) + far * sin(angle);
}
)",
     "one square root",
     R"(float form(vec2 p) {
    vec2 far = p / (sqrt(dot(p, p)) + .7);
    return far.x + far.y;
}
)"},
};

/// Functions against a multiplication and an addition.
constexpr std::array<std::array<const char*, 2>, 10> kMeasuredFunctions{{{"sqrt", "sqrt(x)"},
                                                                         {"inversesqrt", "inversesqrt(x)"},
                                                                         {"division", ".7 / x"},
                                                                         {"exp2", "exp2(x)"},
                                                                         {"log2", "log2(x)"},
                                                                         {"pow", "pow(x, 2.3)"},
                                                                         {"sin", "sin(x)"},
                                                                         {"tan", "tan(.3 * x)"},
                                                                         {"atan", "atan(x)"},
                                                                         {"atan of two", "atan(x, 1.3)"}}};

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
        const DrawnForm slower(bench, canvas, each.slower), faster(bench, canvas, each.faster);
        figures.push_back(claimFigure(
            bench, {.name = each.name,
                    .text = each.text,
                    .work = work,
                    .errorName = "largest difference",
                    .reference = kOtherPicture,
                    .slower = {each.slowerName, slower.draw},
                    .faster = {each.fasterName, faster.draw, largestDifference(slower.values, faster.values)},
                    .mayBeEqual = each.mayBeEqual}));
    }
    figures.push_back(discardOrBlend(bench, side));
}

}  // namespace glibra::bench
