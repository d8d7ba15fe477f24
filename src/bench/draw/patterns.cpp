#include "bench/draw/patterns.h"

#include <array>
#include <cmath>
#include <numbers>

#include "bench/draw/offscreen.h"
#include "bench/reference/coverage.h"

namespace glibra::bench {
namespace {

constexpr int kSpokes = 17;
constexpr double kSquareWidth = .83, kSquareHeight = .61;  // pixels
constexpr double kOffset = .377;                           // squares

constexpr std::string_view kStarVertex =
    "layout(location = 0) in vec2 aPosition;\n"
    "void main() { gl_Position = vec4(aPosition * 2. - 1., 0., 1.); }\n";
constexpr std::string_view kStarFragment =
    "out vec4 fColor;\n"
    "void main() { fColor = vec4(1.); }\n";

constexpr std::string_view kCheckerFragment =
    "in vec2 vPlace;\n"
    "uniform float uSide;\n"
    "out vec4 fColor;\n"
    "void main() {\n"
    "    ivec2 square = ivec2(floor(vPlace * uSide / vec2(.83, .61) + .377));\n"
    "    fColor = vec4(float((square.x + square.y) & 1));\n"
    "}\n";

constexpr std::string_view kPlaneFragment =
    "in vec2 vPlace;\n"
    "uniform float uSide;\n"
    "out vec4 fColor;\n"
    "void main() {\n"
    "    float distance = 1. / (1.1 - vPlace.y);\n"
    "    vec2 place = vec2((vPlace.x - .4) * distance, distance) * uSide / 12.;\n"
    "    ivec2 square = ivec2(floor(place + .377));\n"
    "    fColor = vec4(float((square.x + square.y) & 1));\n"
    "}\n";

// Periods decrease from 24 to 1.3 pixels along the direction of 20 degrees. With q(t) = -1/2 for fract(t) <
// 1/2 and 1/2 above, `once` is the integral of q and `twice` that of `once`; both are periodic.
constexpr std::string_view kStripes =
    "in vec2 vPlace;\n"
    "uniform float uSide;\n"
    "out vec4 fColor;\n"
    "float once(float t) { return .5 * abs(fract(t) - .5) - .125; }\n"
    "float twice(float t) {\n"
    "    float u = fract(t), v = u - .5;\n"
    "    return u < .5 ? .125 * u - .25 * u * u : .25 * v * v - .125 * v;\n"
    "}\n"
    "float phase() {\n"
    "    const vec2 direction = vec2(.93969, .34202);\n"
    "    float size = direction.x + direction.y;\n"
    "    float t = dot(vPlace, direction) / size;\n"
    "    return uSide * size * (t / 24. + .5 * (1. / 1.3 - 1. / 24.) * t * t);\n"
    "}\n";
constexpr std::string_view kHardStep = "void main() { fColor = vec4(step(.5, fract(phase()))); }\n";
constexpr std::string_view kSmoothStep =
    "void main() {\n"
    "    float p = phase(), width = length(vec2(dFdx(p), dFdy(p)));\n"
    "    float fromMiddle = abs(fract(p - .25) - .5);\n"
    "    fColor = vec4(1. - smoothstep(.25 - width / 2., .25 + width / 2., fromMiddle));\n"
    "}\n";
constexpr std::string_view kAlongGradient =
    "void main() {\n"
    "    float p = phase(), width = length(vec2(dFdx(p), dFdy(p)));\n"
    "    fColor = vec4(.5 + (once(p + width / 2.) - once(p - width / 2.)) / width);\n"
    "}\n";
constexpr std::string_view kOverSquare =
    "void main() {\n"
    "    float p = phase(), a = abs(dFdx(p)), b = abs(dFdy(p)), s = (a + b) / 2., d = (a - b) / 2.;\n"
    "    fColor = vec4(.5 + (twice(p + s) - twice(p + d) - twice(p - d) + twice(p - s)) / (a * b));\n"
    "}\n";

/// Corners in 0..1; (0, 0) is at the lower left.
std::vector<glm::vec2> star() {
    std::vector<glm::vec2> corners;
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
        const double angle = (spoke + .13) * 2 * std::numbers::pi / kSpokes;
        const auto at = [](double direction, double radius) {
            return glm::vec2(.5 + radius * std::cos(direction), .5 + radius * std::sin(direction));
        };
        corners.push_back(at(angle, .05));
        corners.push_back(at(angle - .08, .47));
        corners.push_back(at(angle + .08, .47));
    }
    return corners;
}

std::vector<double> starCoverage(int side) {
    const std::vector<glm::vec2> corners = star();
    std::vector<FlatTriangle> triangles(kSpokes);
    for (std::size_t i = 0; i < corners.size(); ++i)
        triangles[i / 3][i % 3] = {static_cast<double>(corners[i].x) * side,
                                   (1. - static_cast<double>(corners[i].y)) * side};
    return coverage(triangles, side, side);
}

/// The mean over from..to of a wave that is 1 in even cells of length 1 and -1 in odd ones.
double meanOfWave(double from, double to) {
    const auto integral = [](double t) {
        const double inPeriod = t - 2 * std::floor(t / 2);
        return inPeriod < 1 ? inPeriod : 2 - inPeriod;
    };
    return (integral(to) - integral(from)) / (to - from);
}

std::vector<double> checkerMeans(int side) {
    std::vector<double> means;
    for (int row = side - 1; row >= 0; --row)
        for (int column = 0; column < side; ++column)
            means.push_back(
                .5 - .5 * meanOfWave(column / kSquareWidth + kOffset, (column + 1) / kSquareWidth + kOffset) *
                         meanOfWave(row / kSquareHeight + kOffset, (row + 1) / kSquareHeight + kOffset));
    return means;
}

}  // namespace

void Pattern::draw(const PatternProgram& program, int side) const {
    setFloats(program.program, "uSide", {static_cast<float>(side)});
    if (!corners) return drawWhole(program.program);
    const std::array<gpu::AttributeSource, 1> sources{{{.buffer = &*corners, .components = 2}}};
    const gpu::VertexArray array{sources};
    array.bind();
    glDrawArrays(GL_TRIANGLES, 0, cornerCount);
}

Result<std::vector<Pattern>> patterns(const gpu::Capabilities& capabilities) {
    struct Text {
        std::string_view name, vertex;
        std::string fragment;
    };
    const auto stripes = [](std::string_view main) { return std::string(kStripes) + std::string(main); };
    const std::array<std::vector<Text>, 4> texts{{
        {{"", kStarVertex, std::string(kStarFragment)}},
        {{"", kWholeTarget, std::string(kCheckerFragment)}},
        {{"", kWholeTarget, std::string(kPlaneFragment)}},
        {{"step", kWholeTarget, stripes(kHardStep)},
         {"smooth step", kWholeTarget, stripes(kSmoothStep)},
         {"integral along the gradient", kWholeTarget, stripes(kAlongGradient)},
         {"integral over the pixel", kWholeTarget, stripes(kOverSquare)}},
    }};
    constexpr std::array<std::array<std::string_view, 2>, 4> kNames{{
        {"edges", "A star of 17 narrow triangles"},
        {"checkerboard", "A checkerboard of .83 x .61 pixels per square"},
        {"checkerboard-plane", "A checkerboard on a plane in perspective"},
        {"stripes", "Stripes of 24 to 1.3 pixels per period"},
    }};
    std::vector<Pattern> all;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        Pattern& pattern = all.emplace_back();
        pattern.name = kNames[i][0];
        pattern.title = kNames[i][1];
        for (const Text& text : texts[i]) {
            Result<gpu::Program> built = program(capabilities, text.vertex, text.fragment);
            if (!built) return std::move(built.diagnostics);
            pattern.programs.push_back({text.name, std::move(*built)});
        }
    }
    const std::vector<glm::vec2> corners = star();
    Result<gpu::Buffer> buffer = gpu::Buffer::create(std::as_bytes(std::span(corners)));
    if (!buffer) return std::move(buffer.diagnostics);
    all[0].corners = std::move(*buffer);
    all[0].cornerCount = static_cast<int>(corners.size());
    all[0].exact = starCoverage;
    all[1].exact = checkerMeans;
    return all;
}

}  // namespace glibra::bench
