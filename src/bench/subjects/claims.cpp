#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "bench/core/device.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

using gpu::TexelFormat;
using Draw = std::function<void()>;  ///< without waiting for the device

constexpr const char* kOtherPicture = "the picture of the other way";

/// One claim: a way that is said to be slower, and one that is said to be faster.
struct Claim {
    std::string name;       ///< of the figure: "pf06-length"
    std::string text;       ///< "A built-in function is never slower than the form written by hand"
    std::string work;       ///< what both do: "512 x 512 pixels, 32 times"
    std::string errorName;  ///< of the ways, and what it is measured against
    std::string errorUnit{}, reference{};
    struct Way {
        std::string name;
        Draw draw;
        double error = 0;   ///< against the reference
        double memory = 0;  ///< bytes
    } slower{}, faster{};
    bool mayBeEqual = false;  ///< the claim holds without a difference, too
};

/// Draws both in turn and waits each time.
PairedTiming timed(Bench& bench, const Draw& slower, const Draw& faster) {
    const auto waited = [](const Draw& draw) {
        return [&draw] {
            draw();
            glFinish();
        };
    };
    return timePairs(waited(slower), waited(faster), bench.pick(5, 11), bench.capabilities().isSoftware);
}

/// Measures both ways.
Figure figureOf(Bench& bench, const Claim& claim) {
    const PairedTiming timing = timed(bench, claim.slower.draw, claim.faster.draw);
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

double largestDifference(const std::vector<float>& a, const std::vector<float>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
    return largest;
}

std::string pixelsText(int side) {
    return fmt::format("{0} x {0} pixels", side);
}

// Functions and statements of fragment shaders.

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
        const PairedTiming timing = timed(bench, form(glsl).draw, plain.draw);
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
    return figureOf(bench, {.name = "pf21",
                            .text = "Leaving pixels out by discard is faster than by blending with alpha 0",
                            .work = fmt::format("{}, 4 times, half of them left out", pixelsText(side)),
                            .errorName = "largest difference",
                            .reference = kOtherPicture,
                            .slower = {"blending with alpha 0", blending},
                            .faster = {"discard", discarding,
                                       largestDifference(picture(blending), picture(discarding))}});
}

void addFragmentClaims(std::vector<Figure>& figures, Bench& bench) {
    const int side = bench.pick(128, 512);
    const Canvas canvas(bench, side, side, TexelFormat::r32f);
    const std::string work = fmt::format("{}, {} times", pixelsText(side), kTimes);
    figures.push_back(functionCosts(bench, canvas, work));
    for (const FormPair& each : kFormPairs) {
        const DrawnForm slower(bench, canvas, each.slower), faster(bench, canvas, each.faster);
        figures.push_back(figureOf(
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

// Textures in place of computations and geometry, and lookups in shadow maps.

/// Draws with a texture on unit 0.
Draw reading(const Canvas& canvas, const Shader& shader, const Texels& texels, int vertices = 3) {
    return [=] {
        canvas.bind();
        texels.bind(0);
        if (vertices > 3) {
            glEnable(GL_DEPTH_TEST);
            glClear(GL_DEPTH_BUFFER_BIT);
        }
        shader.draw(GL_TRIANGLES, vertices);
        glDisable(GL_DEPTH_TEST);
    };
}

/// The pattern of pf11, for places 0..1.
double waves(double x, double y) {
    return .5 + .5 * std::sin(40 * x + 6 * std::sin(30 * y));
}

/// A pattern that is computed, and the same from a texture of 512 x 512 floats, when zoomed in.
Figure proceduralOrTexture(Bench& bench) {
    constexpr int kTexels = 512;
    const int side = bench.pick(128, 512);
    const Canvas canvas(bench, side, side, TexelFormat::r32f);
    std::vector<float> values;
    for (int y = 0; y < kTexels; ++y)
        for (int x = 0; x < kTexels; ++x)
            values.push_back(static_cast<float>(waves((x + .5) / kTexels, (y + .5) / kTexels)));
    const Texels texels(bench, TexelFormat::r8, {kTexels, kTexels, 1}, values);
    const auto shader = [&](const char* value) {
        return Shader(bench, fmt::format(R"(in vec2 vPlace;
out vec4 fColor;
uniform float uZoom;
uniform sampler2D uTexture;
void main() {{
    vec2 p = vec2(.4, .3) + vPlace * uZoom;
    fColor = vec4({});
}}
)",
                                         value));
    };
    const Shader shaders[] = {shader(".5 + .5 * sin(40. * p.x + 6. * sin(30. * p.y))"),
                              shader("texture(uTexture, p).r")};
    const Draw computed = reading(canvas, shaders[0], texels), read = reading(canvas, shaders[1], texels);
    Figure figure{.name = "pf11",
                  .title = "A computed pattern keeps its resolution and takes no texture memory",
                  .settingName = "zoom",
                  .errorName = "largest error",
                  .reference = "the formula in double",
                  .curves = {{"computed in the shader"}, {"texture of 512 x 512 bytes, linear"}},
                  .alternatives = Alternatives::setting};
    Timing ratio;
    for (const int zoom : {1, 4, 16, 64}) {
        const float size = .5F / static_cast<float>(zoom);
        for (const Shader& each : shaders) each.set("uZoom", static_cast<double>(size));
        const auto error = [&](const Draw& draw) {
            draw();
            const std::vector<float> drawn = canvas.pixels(1);
            double largest = 0;
            for (int i = 0; i < side * side; ++i) {
                const double x = .4 + size * (i % side + .5) / side,
                             y = .3 + size * (side - i / side - .5) / side;
                largest = std::max(
                    largest, std::abs(static_cast<double>(drawn[static_cast<std::size_t>(i)]) - waves(x, y)));
            }
            return largest;
        };
        const PairedTiming timing = timed(bench, computed, read);
        ratio = timing.ratio;
        const std::string label = fmt::format("zoom {}", zoom);
        figure.curves[0].points.push_back({1. * zoom, label, error(computed), timing.first, 0.});
        figure.curves[1].points.push_back({1. * zoom, label, error(read), timing.second, texels.bytes()});
    }
    const double exact = figure.last(0).error, filtered = figure.last(1).error;
    figure.note("{} here: zoomed by 64 the computed pattern is off by {}, the texture by {}",
                exact < filtered ? "true" : "false", numberText(exact), numberText(filtered));
    figure.note("it takes {:.2f} ({:.2f} .. {:.2f}) times as long as the texture", ratio.median, ratio.low,
                ratio.high);
    return figure;
}

constexpr std::string_view kReliefVertex = R"(out vec2 vST;
uniform sampler2D uTexture;
void show(vec2 st, float height) {
    vST = st;
    vec2 p = 2. * st - 1.;
    gl_Position = vec4(.9 * p.x, .8 * p.y + .6 * height, .3 * p.y - height, 1.);
}
/// The place of a corner of the two triangles of a cell.
ivec2 cornerOf(int corner) {
    return ivec2(corner == 1 || corner == 2 || corner == 4 ? 1 : 0, corner == 2 || corner > 3 ? 1 : 0);
}
)";
constexpr std::string_view kReliefFragment = R"(in vec2 vST;
out vec4 fColor;
uniform sampler2D uTexture;
float at(vec2 st) { return texture(uTexture, st).r; }
void main() {
    vec2 texel = 1. / vec2(textureSize(uTexture, 0)), x = vec2(texel.x, 0.), y = vec2(0., texel.y);
    float east = at(vST + x) - at(vST - x), north = at(vST + y) - at(vST - y);
    vec3 n = normalize(vec3(-east / (4. * texel.x), -north / (4. * texel.y), 1.));
    fColor = vec4(vec3(max(dot(n, normalize(vec3(-.4, .5, .8))), 0.)), 1.);
}
)";

/// Terrain as a mesh with a vertex per texel, and as one rectangle with normals from the same texture.
Figure bumpsOrGeometry(Bench& bench) {
    const int width = bench.pick(256, 2048), height = width * 9 / 16, side = 512;
    const Canvas canvas(bench, side, side, TexelFormat::rgba8);
    std::vector<float> heights;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            heights.push_back(
                static_cast<float>(.05 * std::sin(25. * x / width) * std::cos(18. * y / height) +
                                   .01 * std::sin(140. * x / width)));
    const Texels map(bench, TexelFormat::r32f, {width, height, 1}, heights);
    const auto shader = [&](std::string_view main) {
        return Shader(bench, fmt::format("{}void main() {{\n{}}}\n", kReliefVertex, main), kReliefFragment);
    };
    const int vertices = 6 * (width - 1) * (height - 1);
    const Draw geometry = reading(canvas, shader(R"(    ivec2 size = textureSize(uTexture, 0);
    int cell = gl_VertexID / 6;
    ivec2 place = ivec2(cell % (size.x - 1), cell / (size.x - 1)) + cornerOf(gl_VertexID % 6);
    show((vec2(place) + .5) / vec2(size), texelFetch(uTexture, place, 0).r);
)"),
                                  map, vertices),
               bumps = reading(canvas, shader("    show(vec2(cornerOf(gl_VertexID)), 0.);\n"), map, 6);
    const auto picture = [&](const Draw& draw) {
        canvas.clear();
        draw();
        return canvas.pixels(1);
    };
    const std::vector<float> wanted = picture(geometry), got = picture(bumps);
    double squares = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i)
        squares += std::pow(static_cast<double>(wanted[i]) - static_cast<double>(got[i]), 2);
    return figureOf(
        bench, {.name = "pf12",
                .text = "Terrain from one rectangle with bumps is faster than from geometry",
                .work = fmt::format("a map of {} x {} heights", width, height),
                .errorName = "difference (root of the mean square)",
                .reference = "the picture of the geometry: bumps move no outline",
                .slower = {fmt::format("geometry: {} triangles", vertices / 3), geometry, 0, map.bytes()},
                .faster = {"one rectangle with bumps", bumps,
                           std::sqrt(squares / static_cast<double>(got.size())), map.bytes()}});
}

/// n x n lookups of a shadow map with one straight edge, against the ramp of an area light.
Figure shadowLookups(Bench& bench) {
    constexpr int kTexels = 1024;
    constexpr double kWidth = .2;
    const int side = bench.pick(128, 512);
    const Canvas canvas(bench, side, side, TexelFormat::r32f);
    std::vector<float> depths;
    for (int i = 0; i < kTexels * kTexels; ++i) depths.push_back(i % kTexels < kTexels / 2 ? .3F : 1.F);
    Texels map(bench, TexelFormat::r32f, {kTexels, kTexels, 1}, depths);
    using enum gpu::Wrap;
    map.sampledBy({.filter = base::Filter::nearest, .wrap = {clampToEdge, clampToEdge}, .border = {}});
    const Shader shader(bench, R"(in vec2 vPlace;
out vec4 fColor;
uniform sampler2D uTexture;
uniform int uGrid;
void main() {
    float sum = 0.;
    for (int i = 0; i < uGrid; ++i)
        for (int j = 0; j < uGrid; ++j) {
            vec2 at = (vec2(i, j) + .5) / float(uGrid) - .5;
            sum += texture(uTexture, vPlace + .2 * at).r > .6 ? 1. : 0.;
        }
    fColor = vec4(sum / float(uGrid * uGrid));
}
)");
    Figure figure{.name = "a05",
                  .title = "Soft shadows: what more lookups per pixel cost and bring",
                  .settingName = "lookups per pixel",
                  .errorName = "error of the penumbra (root of the mean square)",
                  .reference = "the ramp of a square light above a straight edge",
                  .curves = {{"percentage-closer filtering"},
                             {.name = "theory: 1 / (n sqrt 12) for n x n", .theoryOf = 0}}};
    const auto drawWith = [&](int grid) -> Draw {
        return [grid, &shader, draw = reading(canvas, shader, map)] {
            shader.set("uGrid", grid);
            draw();
        };
    };
    std::string ratios;
    for (const int grid : {1, 2, 4, 8}) {
        drawWith(grid)();
        const std::vector<float> values = canvas.pixels(1);
        double squares = 0, count = 0;
        for (int column = 0; column < side; ++column) {
            const double x = (column + .5) / side - .5;
            if (std::abs(x) > kWidth / 2) continue;
            const double drawn = values[static_cast<std::size_t>(side / 2 * side + column)];
            squares += std::pow(drawn - (.5 + x / kWidth), 2);
            ++count;
        }
        const PairedTiming timing = timed(bench, drawWith(grid), drawWith(1));
        const std::string label = fmt::format("{} lookups", grid * grid);
        figure.curves[0].points.push_back(
            {1. * grid * grid, label, std::sqrt(squares / count), timing.first, map.bytes()});
        figure.curves[1].points.push_back({1. * grid * grid, label, 1 / (grid * std::sqrt(12.))});
        if (grid > 1)
            ratios += fmt::format("{}{} {:.2f}", ratios.empty() ? "" : ", ", label, timing.ratio.median);
    }
    figure.noteOrders("lookups");
    figure.note("in times of one lookup per pixel: {}", ratios);
    return figure;
}

/// Colours from a texture, and values whose colours the shader computes.
void addColorClaims(std::vector<Figure>& figures, Bench& bench) {
    const int cells = bench.pick(32, 64), side = bench.pick(128, 512);
    const Canvas canvas(bench, side, side, TexelFormat::rgba8);
    std::vector<float> values;
    for (int i = 0; i < cells * cells * cells; ++i)
        values.push_back(static_cast<float>(.5 + .5 * std::sin(.013 * i)));
    const auto colorsFor = [values](float turn) {
        std::vector<float> colors;
        colors.reserve(4 * values.size());
        for (const float t : values) {
            const float band = 4 * t;
            for (const float each : {band - turn, 2 - std::abs(band - 2), turn - band, 1.F})
                colors.push_back(std::clamp(each, 0.F, 1.F));
        }
        return colors;
    };
    const Texels scalars(bench, TexelFormat::r8, {cells, cells, cells}, values),
        colors(bench, TexelFormat::rgba8, {cells, cells, cells}, colorsFor(2), 4);
    const auto shader = [&](const char* color) {
        return Shader(bench, fmt::format(R"(in vec2 vPlace;
out vec4 fColor;
uniform sampler3D uTexture;
uniform float uTurn;
vec3 transfer(float t) {{
    float band = 4. * clamp(t, 0., 1.);
    return clamp(vec3(band - uTurn, 2. - abs(band - 2.), uTurn - band), 0., 1.);
}}
void main() {{
    vec3 sum = vec3(0.);
    for (int i = 0; i < 32; ++i) {{
        vec4 texel = texture(uTexture, vec3(vPlace, (float(i) + .5) / 32.));
        sum += {};
    }}
    fColor = vec4(sum / 32., 1.);
}}
)",
                                         color));
    };
    const Shader computed = shader("transfer(texel.r)").set("uTurn", 2.);
    const Draw transfers = reading(canvas, computed, scalars),
               lookups = reading(canvas, shader("texel.rgb"), colors);
    const double texels = 1. * cells * cells * cells;
    const char* const notCompared =
        "not compared: interpolated colours are not the colours of interpolated values";
    figures.push_back(figureOf(
        bench, {.name = "pf22-picture",
                .text = "A texture of colours is faster to look up than values with a transfer function",
                .work = fmt::format("{}, 32 lookups in {}^3 texels", pixelsText(side), cells),
                .errorName = "error",
                .reference = notCompared,
                .slower = {"values and a transfer function", transfers, 0, texels},
                .faster = {"precomputed colours", lookups, 0, 4 * texels}}));
    float turn = 2;
    const auto change = [&turn] { return turn = turn > 2.5F ? 1.5F : turn + .01F; };
    figures.push_back(
        figureOf(bench, {.name = "pf22-change",
                         .text = "A change of the transfer function is faster where the shader applies it",
                         .work = fmt::format("one change and one picture of {}", pixelsText(side)),
                         .errorName = "error",
                         .reference = notCompared,
                         .slower = {"precomputed colours: computed and uploaded again",
                                    [&] {
                                        const std::vector<float> anew = colorsFor(change());
                                        check(colors.texture().upload(0, texelsOf(std::span(anew), 4)));
                                        lookups();
                                    },
                                    0, 4 * texels},
                         .faster = {"values and a transfer function: one uniform",
                                    [&] {
                                        computed.set("uTurn", static_cast<double>(change()));
                                        transfers();
                                    },
                                    0, texels}}));
}

// Strips, geometry and tessellation stages, and culled faces.

constexpr std::string_view kPlainFragment = R"(in vec3 vPosition;
out vec4 fColor;
void main() { fColor = vec4(fract(vPosition), 1.); }
)";
/// Gives each vertex its number, for the stages after it.
constexpr std::string_view kNumberVertex = R"(flat out int vNumber;
void main() {
    vNumber = gl_VertexID;
    gl_Position = vec4(0.);
}
)";

Canvas meshCanvas(Bench& bench) {
    return {bench, 512, 512, TexelFormat::rgba8};
}

/// A grid of points as one strip, whose rows end with a restart, and as separate triangles.
Figure stripOrTriangles(Bench& bench) {
    constexpr std::uint32_t kRestart = 0xFFFFFFFF;
    const int width = bench.pick(128, 1024), height = bench.pick(71, 569);
    const Canvas canvas = meshCanvas(bench);
    const auto number = [&](int x, int y) { return static_cast<std::uint32_t>(y * width + x); };
    std::vector<std::uint32_t> strip, triangles;
    for (int y = 0; y + 1 < height; ++y) {
        for (int x = 0; x < width; ++x) {
            strip.insert(strip.end(), {number(x, y + 1), number(x, y)});
            if (x + 1 == width) continue;
            triangles.insert(triangles.end(), {number(x, y + 1), number(x, y), number(x + 1, y + 1),
                                               number(x + 1, y + 1), number(x, y), number(x + 1, y)});
        }
        strip.push_back(kRestart);
    }
    const Shader shader(bench,
                        fmt::format(R"(out vec3 vPosition;
void main() {{
    vec2 p = vec2(gl_VertexID % {0}, gl_VertexID / {0}) / vec2({0}, {1});
    vPosition = vec3(2. * p - 1., .2 * sin(20. * p.x) * cos(15. * p.y));
    gl_Position = vec4(vPosition.xy * .95, vPosition.z, 1.);
}}
)",
                                    width, height),
                        kPlainFragment);
    const auto drawing = [&](const std::vector<std::uint32_t>& indices, GLenum primitive) -> Draw {
        return [=, vertices = std::make_shared<const Vertices>(std::vector<Vertices::Values>(), indices)] {
            canvas.bind();
            glEnable(GL_PRIMITIVE_RESTART);
            glPrimitiveRestartIndex(kRestart);
            vertices->draw(shader, primitive);
            glDisable(GL_PRIMITIVE_RESTART);
        };
    };
    const Draw separate = drawing(triangles, GL_TRIANGLES), joined = drawing(strip, GL_TRIANGLE_STRIP);
    const auto picture = [&](const Draw& draw) {
        canvas.clear();
        draw();
        return canvas.pixels(3);
    };
    Figure figure =
        figureOf(bench, {.name = "pf02",
                         .text = "A grid is faster as one strip with restarts than as separate triangles",
                         .work = fmt::format("a grid of {} x {} points", width, height),
                         .errorName = "largest difference",
                         .reference = kOtherPicture,
                         .slower = {"triangles", separate, 0, 4. * static_cast<double>(triangles.size())},
                         .faster = {"strip", joined, largestDifference(picture(separate), picture(joined)),
                                    4. * static_cast<double>(strip.size())}});
    if (bench.isQuick()) return figure;
    const double frame = bench.timeDrawing(joined).median;
    figure.note("1000 such strips per second, as on a GTX 480, is {} here, by {:.2g}",
                frame < 1e-3 ? "true" : "false", frame < 1e-3 ? 1e-3 / frame : frame / 1e-3);
    return figure;
}

/// The corners of octant i of a sphere, moved so that many spheres stand in a grid.
constexpr std::string_view kOctants =
    R"(vec3 octantSigns(int i) { return vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1) * 2. - 1.; }
vec3 placed(vec3 p, int ball) {
    return vec3(vec2(ball % 8, ball / 8) * .24 - .84, 0.) + .11 * p;
}
)";

/// Subdivides octants in a geometry stage: `level` rows of strips each.
Shader geometryBalls(Bench& bench, int level) {
    const std::string geometry = fmt::format(R"(layout(points) in;
layout(triangle_strip, max_vertices = {0}) out;
flat in int vNumber[];
out vec3 vPosition;
{1}void put(int row, int column, vec3 signs, int ball) {{
    vec3 p = vec3(float({2} - row), float(row - column), float(column)) / {2}.;
    vPosition = placed(signs * normalize(p), ball);
    gl_Position = vec4(vPosition, 1.);
    EmitVertex();
}}
void main() {{
    vec3 signs = octantSigns(vNumber[0] % 8);
    int ball = vNumber[0] / 8;
    for (int row = 0; row < {2}; ++row) {{
        put(row + 1, 0, signs, ball);
        for (int column = 0; column <= row; ++column) {{
            put(row, column, signs, ball);
            put(row + 1, column + 1, signs, ball);
        }}
        EndPrimitive();
    }}
}}
)",
                                             level * (level + 2), kOctants, level);
    return {bench, std::array{gpu::StageSource{GL_VERTEX_SHADER, kNumberVertex},
                              gpu::StageSource{GL_GEOMETRY_SHADER, geometry},
                              gpu::StageSource{GL_FRAGMENT_SHADER, kPlainFragment}}};
}

/// Spheres by tessellation: of octants, or of one rectangle of longitude and latitude. `atOrigin` leaves them
/// at the origin with radius 1, for captures.
Shader tessellatedBalls(Bench& bench, bool octants, double level, bool atOrigin) {
    const std::string control = fmt::format(R"(layout(vertices = 1) out;
flat in int vNumber[];
out int cNumber[];
uniform float uLevel;
void main() {{
    cNumber[gl_InvocationID] = vNumber[0];
    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = {0};
    for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = {0};
}}
)",
                                            level > 0 ? fmt::format("{:.3f}", level) : "uLevel");
    const std::string evaluation = fmt::format(
        R"(layout({}, equal_spacing, ccw) in;
in int cNumber[];
out vec3 vPosition;
{}void main() {{
{}    vPosition = {};
    gl_Position = vec4({} * vPosition, 1.);
}}
)",
        octants ? "triangles" : "quads", kOctants,
        octants ? R"(    int ball = cNumber[0] / 8;
    vec3 p = octantSigns(cNumber[0] % 8) * normalize(gl_TessCoord);
)"
                : R"(    int ball = cNumber[0];
    float around = 6.283185307 * gl_TessCoord.x, up = 3.14159265 * (gl_TessCoord.y - .5);
    vec3 p = vec3(cos(up) * cos(around), sin(up), cos(up) * sin(around));
)",
        atOrigin ? "p" : "placed(p, ball)", atOrigin ? ".5" : "1.");
    return {bench,
            std::array{gpu::StageSource{GL_VERTEX_SHADER, kNumberVertex},
                       gpu::StageSource{GL_TESS_CONTROL_SHADER, control},
                       gpu::StageSource{GL_TESS_EVALUATION_SHADER, evaluation},
                       gpu::StageSource{GL_FRAGMENT_SHADER, kPlainFragment}},
            atOrigin ? std::vector<std::string>{"vPosition"} : std::vector<std::string>{}};
}

/// Draws the balls one by one, because llvmpipe numbers the vertices of one draw with 16 bits.
Draw drawnBalls(const Canvas& canvas, const Shader& shader, GLenum primitive, int perBall, int balls) {
    return [=] {
        canvas.bind();
        if (primitive == GL_PATCHES) glPatchParameteri(GL_PATCH_VERTICES, 1);
        for (int i = 0; i < balls; ++i) shader.draw(primitive, perBall, i * perBall);
    };
}

Captured capturedPatches(const Shader& shader, int patches) {
    glPatchParameteri(GL_PATCH_VERTICES, 1);
    return shader.capture(GL_PATCHES, patches, GL_TRIANGLES, 3, 40'000);
}

/// Spheres that a geometry stage subdivides, and those of a tessellation stage.
Figure geometryOrTessellation(Bench& bench) {
    const int balls = bench.pick(4, 32);
    constexpr int kRows = 10;  // 120 vertices of 7 components: below the 1024 that every driver has
    // Both have about 100 triangles per octant: 10 x 10, and 1.5 x 8 x 8.
    constexpr double kLevel = 8;
    const Canvas canvas = meshCanvas(bench);
    Figure figure = figureOf(
        bench,
        {.name = "pf16",
         .text = "A geometry stage is slower than tessellation for subdividing surfaces",
         .work = fmt::format("{} spheres of about 800 triangles", balls),
         .errorName = "share of triangles too many or too few",
         .reference = "10 x 10 triangles per octant",
         .slower = {"geometry stage, 120 vertices per octant",
                    drawnBalls(canvas, geometryBalls(bench, kRows), GL_POINTS, 8, balls)},
         .faster = {"tessellation, level 8",
                    drawnBalls(canvas, tessellatedBalls(bench, true, kLevel, false), GL_PATCHES, 8, balls),
                    std::abs(1.5 * kLevel * kLevel / (kRows * kRows) - 1)}});
    const gpu::Capabilities& limits = bench.capabilities();
    const int most = limits.maxGeometryOutputVertices, components = limits.maxGeometryTotalOutputComponents;
    figure.note(
        "a geometry stage may emit {} vertices and {} components here, so that an octant has at most {} "
        "rows; tessellation has levels up to {}",
        most, components, static_cast<int>(std::sqrt(1. + std::min(most, components / 7)) - 1),
        limits.maxTessellationLevel);
    return figure;
}

/// Spheres of one patch of longitude and latitude, and of eight octants.
Figure patchOrOctants(Bench& bench) {
    const int balls = bench.pick(4, 32);
    const Canvas canvas = meshCanvas(bench);
    // 8 x 1.5 x 26 x 26 and 2 x 64 x 64 triangles.
    const auto way = [&](bool octants) -> Claim::Way {
        const double level = octants ? 26 : 64;
        const int patches = octants ? 8 : 1;
        const Captured captured = capturedPatches(tessellatedBalls(bench, octants, level, true), patches);
        double farthest = 0;  // of the middles of the triangles from the unit sphere
        for (std::size_t i = 0; i + 8 < captured.values.size(); i += 9) {
            glm::dvec3 middle(0);
            for (std::size_t k = 0; k < 9; ++k)
                middle[static_cast<int>(k % 3)] += static_cast<double>(captured.values[i + k]) / 3;
            farthest = std::max(farthest, 1 - std::hypot(middle.x, middle.y, middle.z));
        }
        return {
            fmt::format("{}, level {:.0f}: {} triangles", octants ? "octants" : "one patch", level,
                        captured.primitives),
            drawnBalls(canvas, tessellatedBalls(bench, octants, level, false), GL_PATCHES, patches, balls),
            farthest};
    };
    return figureOf(bench,
                    {.name = "pf17",
                     .text = "A sphere of eight octants is faster than one patch of longitude and latitude",
                     .work = fmt::format("{} spheres of about 8000 triangles", balls),
                     .errorName = "largest distance of a triangle's middle from the sphere",
                     .errorUnit = "radii",
                     .reference = "the sphere",
                     .slower = way(false),
                     .faster = way(true)});
}

/// The size of triangles of a sphere of octants, whose level follows its radius in pixels.
Figure adaptiveLevels(Bench& bench) {
    constexpr double kEdge = 8;  ///< pixels: what an edge of a triangle shall have
    const Shader shader = tessellatedBalls(bench, true, 0, true);
    const int most = bench.capabilities().maxTessellationLevel;
    Figure figure{
        .name = "pf18",
        .title = "Levels that follow the size on the screen keep the size of triangles",
        .settingName = "radius in pixels",
        .errorName = "deviation from the triangles at a radius of 64 pixels",
        .reference = "the mean area of a triangle at a radius of 64 pixels, from the captured triangles",
        .curves = {{"level by the radius"}, {"level 16"}},
        .alternatives = Alternatives::none};
    const auto area = [&](double radius, double level) {
        shader.set("uLevel", level);
        return 4 * std::numbers::pi * radius * radius / (8. * capturedPatches(shader, 1).primitives);
    };
    const auto levelFor = [&](double radius) {
        return std::clamp(std::round(std::numbers::pi / 2 * radius / kEdge), 1., static_cast<double>(most));
    };
    const auto deviation = [](double a, double b) { return std::max(a / b, b / a) - 1; };
    double worstAdaptive = 0, worstFixed = 0;
    for (const int radius : {16, 32, 64, 128, 256, 512, 1024}) {
        const double level = levelFor(radius);
        const double adaptive = deviation(area(radius, level), area(64, levelFor(64))),
                     fixed = deviation(area(radius, 16), area(64, 16));
        figure.curves[0].points.push_back(
            {1. * radius, fmt::format("{} pixels, level {:.0f}", radius, level), adaptive});
        figure.curves[1].points.push_back({1. * radius, fmt::format("{} pixels", radius), fixed});
        if (level >= most) continue;
        worstAdaptive = std::max(worstAdaptive, adaptive);
        worstFixed = std::max(worstFixed, fixed);
    }
    figure.note(
        "{} here up to the level {}: areas differ by a factor of at most {:.3g}, with one level by {:.3g}",
        worstAdaptive < .1 * worstFixed ? "true" : "false", most, 1 + worstAdaptive, 1 + worstFixed);
    figure.note("beyond a radius of {:.0f} pixels the level stays at {}, and triangles grow",
                most * kEdge * 2 / std::numbers::pi, most);
    return figure;
}

/// Half of the triangles of a closed mesh show their backs.
Figure culling(Bench& bench) {
    const Canvas canvas = meshCanvas(bench);
    const int rings = bench.pick(100, 600), vertices = 6 * rings * rings;
    const Shader torus(bench,
                       fmt::format(R"(out vec3 vPosition;
void main() {{
    int cell = gl_VertexID / 6, corner = gl_VertexID % 6;
    vec2 at = vec2(cell % {0} + (corner == 1 || corner == 2 || corner == 4 ? 1 : 0),
                   cell / {0} + (corner == 2 || corner > 3 ? 1 : 0)) * 6.283185307 / {0}.;
    float r = .6 + .25 * cos(at.y);
    vPosition = vec3(r * cos(at.x), r * sin(at.x), .25 * sin(at.y));
    gl_Position = vec4(vPosition, 1.);
}}
)",
                                   rings),
                       kPlainFragment);
    const auto drawing = [&](bool culls) -> Draw {
        return [=] {
            canvas.bind();
            glEnable(GL_DEPTH_TEST);
            glClear(GL_DEPTH_BUFFER_BIT);
            if (culls) glEnable(GL_CULL_FACE);
            glCullFace(GL_BACK);
            torus.draw(GL_TRIANGLES, vertices);
            glDisable(GL_CULL_FACE);
            glDisable(GL_DEPTH_TEST);
        };
    };
    return figureOf(bench, {.name = "a28",
                            .text = "Culling back faces saves half of the triangles of a closed mesh",
                            .work = fmt::format("a torus of {} triangles", vertices / 3),
                            .errorName = "error",
                            .reference = "the stress test CulledFaces: the same pictures",
                            .slower = {"all faces", drawing(false)},
                            .faster = {"back faces culled", drawing(true)}});
}

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
        const PairedTiming timing = timed(bench, one, dispatching(x, y));
        const std::string label = fmt::format("{} x {}", x, y);
        figure.add("time by the shape of the group", {1. * x * y, label, 0, timing.second, 4. * side * side});
        if (x == 8) figure.note("{}: 1 x 1 / 8 x 8", verdict(timing.ratio, false));
        if (x > 1) all += fmt::format("{}{} {:.2f}", all.empty() ? "" : ", ", label, timing.ratio.median);
    }
    figure.note("1 x 1 in times of the other shapes: {}", all);
    return figure;
}

}  // namespace

std::vector<Figure> measureClaims(Bench& bench) {
    std::vector<Figure> figures;
    addFragmentClaims(figures, bench);
    for (const auto measure : {proceduralOrTexture, bumpsOrGeometry, shadowLookups})
        figures.push_back(measure(bench));
    addColorClaims(figures, bench);
    for (const auto measure :
         {stripOrTriangles, adaptiveLevels, culling, geometryOrTessellation, patchOrOctants})
        figures.push_back(measure(bench));
    if (bench.capabilities().compute) figures.push_back(workGroups(bench));
    return figures;
}

}  // namespace glibra::bench
