#include "bench/draw/tessellator.h"

#include <fmt/format.h>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include "bench/draw/offscreen.h"

namespace glibra::bench {
namespace {

constexpr int kFloatsAVertex = 7;

// Patches are numbered over several draws.
constexpr std::string_view kPatchVertex =
    "uniform float uFirst;\n"
    "out float vPatch;\n"
    "void main() { vPatch = uFirst + float(gl_VertexID); gl_Position = vec4(0.); }\n";

constexpr std::string_view kControl =
    "layout(vertices = 1) out;\n"
    "in float vPatch[];\n"
    "out float cPatch[];\n"
    "uniform vec3 uLevels;\n"
    "void main() {\n"
    "    cPatch[gl_InvocationID] = vPatch[0];\n"
    "    float inner = uLevels.y + uLevels.z * mod(vPatch[0], 3.);\n"
    "    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = uLevels.x;\n"
    "    for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = inner;\n"
    "}\n";

// Start and end of all evaluation shaders; {0} is the layout, {1} the functions, among them `surface`.
constexpr std::string_view kEvaluation =
    "#version 410 core\n"
    "layout({0}, ccw) in;\n"
    "layout(std140) uniform Points {{ vec4 uPoints[1024]; }};\n"
    "in float cPatch[];\n"
    "out vec3 vPosition;\n"
    "out vec4 vWhere;\n"
    "int patchNumber;\n"
    "{1}"
    "void main() {{\n"
    "    patchNumber = int(cPatch[0]);\n"
    "    vPosition = surface();\n"
    "    vWhere = vec4(gl_TessCoord, float(patchNumber));\n"
    "    gl_Position = vec4(vPosition.xy * .4, vPosition.z * .1, 1.);\n"
    "}}\n";

constexpr std::string_view kBernstein =
    "vec4 weights(float t) {\n"
    "    float s = 1. - t;\n"
    "    return vec4(s * s * s, 3. * s * s * t, 3. * s * t * t, t * t * t);\n"
    "}\n"
    "vec3 surface() {\n"
    "    vec4 u = weights(gl_TessCoord.x), v = weights(gl_TessCoord.y);\n"
    "    vec3 sum = vec3(0.);\n"
    "    for (int row = 0; row < 4; ++row)\n"
    "        for (int column = 0; column < 4; ++column)\n"
    "            sum += u[column] * v[row] * uPoints[patchNumber * 16 + row * 4 + column].xyz;\n"
    "    return sum;\n"
    "}\n";

/// A patch as four curves along v and one along u; `curve` must precede it.
constexpr std::string_view kCurveOfCurves =
    "vec3 surface() {\n"
    "    vec3 along[4];\n"
    "    for (int column = 0; column < 4; ++column) {\n"
    "        int first = patchNumber * 16 + column;\n"
    "        along[column] = curve(uPoints[first].xyz, uPoints[first + 4].xyz, uPoints[first + 8].xyz,\n"
    "                              uPoints[first + 12].xyz, gl_TessCoord.y);\n"
    "    }\n"
    "    return curve(along[0], along[1], along[2], along[3], gl_TessCoord.x);\n"
    "}\n";

constexpr std::string_view kInterpolated =
    "vec3 curve(vec3 a, vec3 b, vec3 c, vec3 d, float t) {\n"
    "    vec3 ab = mix(a, b, t), bc = mix(b, c, t), cd = mix(c, d, t);\n"
    "    return mix(mix(ab, bc, t), mix(bc, cd, t), t);\n"
    "}\n";

constexpr std::string_view kSymmetric =
    "vec3 curve(vec3 a, vec3 b, vec3 c, vec3 d, float t) {\n"
    "    precise float s = 1. - t;\n"
    "    precise vec3 ends = s * s * s * a + t * t * t * d;\n"
    "    precise vec3 middle = s * s * t * b + t * t * s * c;\n"
    "    precise vec3 sum = ends + 3. * middle;\n"
    "    return sum;\n"
    "}\n";

constexpr std::string_view kSphereOctant = "vec3 surface() { return normalize(gl_TessCoord); }\n";

constexpr std::string_view kPnTriangle =
    "vec3 corner(int i) { return uPoints[patchNumber * 6 + i].xyz; }\n"
    "vec3 normal(int i) { return uPoints[patchNumber * 6 + 3 + i].xyz; }\n"
    "vec3 near(int i, int j) {\n"
    "    return (2. * corner(i) + corner(j) - dot(corner(j) - corner(i), normal(i)) * normal(i)) / 3.;\n"
    "}\n"
    "vec3 surface() {\n"
    "    float u = gl_TessCoord.x, v = gl_TessCoord.y, w = gl_TessCoord.z;\n"
    "    vec3 edges = near(0, 1) + near(1, 0) + near(1, 2) + near(2, 1) + near(2, 0) + near(0, 2);\n"
    "    vec3 middle = edges / 4. - (corner(0) + corner(1) + corner(2)) / 6.;\n"
    "    return corner(0) * u * u * u + corner(1) * v * v * v + corner(2) * w * w * w\n"
    "         + 3. * (near(0, 1) * u * u * v + near(1, 0) * u * v * v + near(1, 2) * v * v * w\n"
    "               + near(2, 1) * v * w * w + near(2, 0) * w * w * u + near(0, 2) * w * u * u)\n"
    "         + 6. * middle * u * v * w;\n"
    "}\n";

constexpr std::string_view kPatchFragment =
    "in vec3 vPosition;\n"
    "out vec4 fColor;\n"
    "void main() { fColor = vec4(fract(vPosition.z)); }\n";

std::string surfaceOf(Evaluation evaluation) {
    switch (evaluation) {
        case Evaluation::bernstein:
            return std::string(kBernstein);
        case Evaluation::interpolated:
            return std::string(kInterpolated) + std::string(kCurveOfCurves);
        case Evaluation::symmetric:
            return std::string(kSymmetric) + std::string(kCurveOfCurves);
        case Evaluation::sphereOctant:
            return std::string(kSphereOctant);
        case Evaluation::pnTriangle:
            break;
    }
    return std::string(kPnTriangle);
}

/// The word of GLSL's layouts: "equal_spacing".
std::string layoutWord(Spacing spacing) {
    std::string word(name(spacing));
    std::ranges::replace(word, ' ', '_');
    return word;
}

bool isTriangle(Evaluation evaluation) {
    return evaluation == Evaluation::sphereOctant || evaluation == Evaluation::pnTriangle;
}

/// The control points of one patch; an octant has none.
std::size_t pointsAPatch(Evaluation evaluation) {
    return evaluation == Evaluation::pnTriangle ? 6 : isTriangle(evaluation) ? 1 : 16;
}

/// An upper bound of what a patch with these levels gives: twice the squares of the largest, and a margin.
int mostVertices(const Levels& levels, int patches) {
    const auto side = static_cast<int>(std::max(levels.outer, levels.inner + 2 * levels.innerStep)) + 3;
    return patches * side * side * 6;
}

}  // namespace

std::string_view name(Spacing spacing) {
    switch (spacing) {
        case Spacing::fractionalEven:
            return "fractional even spacing";
        case Spacing::fractionalOdd:
            return "fractional odd spacing";
        case Spacing::equal:
            break;
    }
    return "equal spacing";
}

Result<Tessellator> Tessellator::create(const gpu::Capabilities& capabilities, Evaluation evaluation,
                                        Spacing spacing, std::span<const glm::vec3> points) {
    const std::string text = fmt::format(
        fmt::runtime(kEvaluation),
        fmt::format("{}, {}", isTriangle(evaluation) ? "triangles" : "quads", layoutWord(spacing)),
        surfaceOf(evaluation));
    const std::array<gpu::StageSource, 4> stages{{{GL_VERTEX_SHADER, kPatchVertex},
                                                  {GL_TESS_CONTROL_SHADER, kControl},
                                                  {GL_TESS_EVALUATION_SHADER, text},
                                                  {GL_FRAGMENT_SHADER, kPatchFragment}}};
    Result<gpu::Program> built = program(capabilities, stages, {"vPosition", "vWhere"});
    if (!built) return std::move(built.diagnostics);
    constexpr std::size_t kMostPoints = 1024;
    std::vector<glm::vec4> padded(kMostPoints, glm::vec4(0));
    for (std::size_t i = 0; i < std::min(points.size(), kMostPoints); ++i) padded[i] = {points[i], 1};
    Result<gpu::Buffer> buffer = gpu::Buffer::create(std::as_bytes(std::span(std::as_const(padded))));
    if (!buffer) return std::move(buffer.diagnostics);
    Tessellator made(std::move(*built), std::move(*buffer));
    made.capabilities_ = &capabilities;
    made.patches_ = static_cast<int>(std::max<std::size_t>(1, points.size() / pointsAPatch(evaluation)));
    return made;
}

void Tessellator::prepare(const Levels& levels) const {
    setFloats(program_, "uLevels", {levels.outer, levels.inner, levels.innerStep});
    points_.bindBase(GL_UNIFORM_BUFFER, 0);
    const GLuint block = glGetUniformBlockIndex(program_.id(), "Points");
    if (block != GL_INVALID_INDEX) glUniformBlockBinding(program_.id(), block, 0);
    glPatchParameteri(GL_PATCH_VERTICES, 1);
}

Result<std::vector<TessellatedVertex>> Tessellator::capture(const Levels& levels, int patchesPerDraw) const {
    prepare(levels);
    std::vector<TessellatedVertex> vertices;
    for (int first = 0; first < patches_; first += patchesPerDraw) {
        const int count = std::min(patchesPerDraw, patches_ - first);
        setFloats(program_, "uFirst", {static_cast<float>(first)});
        Result<Captured> captured = bench::capture(*capabilities_, program_, GL_PATCHES, count, GL_TRIANGLES,
                                                   kFloatsAVertex, mostVertices(levels, count));
        if (!captured) return std::move(captured.diagnostics);
        for (std::size_t i = 0; i + kFloatsAVertex <= captured->values.size(); i += kFloatsAVertex) {
            const float* from = captured->values.data() + i;
            vertices.push_back({.position = {from[0], from[1], from[2]},
                                .coordinate = {from[3], from[4], from[5]},
                                .patch = static_cast<int>(from[6])});
        }
    }
    return vertices;
}

void Tessellator::draw(const Levels& levels) const {
    prepare(levels);
    for (int first = 0; first < patches_; first += kPatchesPerDraw) {
        setFloats(program_, "uFirst", {static_cast<float>(first)});
        drawVertices(program_, GL_PATCHES, std::min(kPatchesPerDraw, patches_ - first));
    }
    glFinish();
}

}  // namespace glibra::bench
