// Claims about strips, geometry and tessellation stages, and culled faces.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "bench/core/fit.h"
#include "bench/draw/offscreen.h"
#include "bench/subjects/claim.h"
#include "gpu/object/buffer.h"
#include "gpu/object/vertex_array.h"

namespace glibra::bench {
namespace {

constexpr const char* kPlainFragment =
    "in vec3 vPosition;\nout vec4 fColor;\nvoid main() { fColor = vec4(fract(vPosition), 1.); }\n";

/// Gives each vertex its number, for the stages after it.
constexpr const char* kNumberVertex =
    "flat out int vNumber;\nvoid main() { vNumber = gl_VertexID; gl_Position = vec4(0.); }\n";

Result<std::shared_ptr<gpu::Target>> meshTarget(const ClaimSetup& setup) {
    return targetOf(setup, 512, gpu::TexelFormat::rgba8);
}

/// A grid of points as one strip, whose rows end with a restart, and as separate triangles.
Result<Figure> stripOrTriangles(const ClaimSetup& setup) {
    constexpr std::uint32_t kRestart = 0xFFFFFFFF;
    const int width = setup.bench.isQuick() ? 128 : 1024, height = setup.bench.isQuick() ? 71 : 569;
    const auto target = meshTarget(setup);
    if (!target) return target.diagnostics;
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
    const std::string vertex = fmt::format(
        "out vec3 vPosition;\nvoid main() {{\n"
        "    vec2 p = vec2(gl_VertexID % {0}, gl_VertexID / {0}) / vec2({0}, {1});\n"
        "    vPosition = vec3(2. * p - 1., .2 * sin(20. * p.x) * cos(15. * p.y));\n"
        "    gl_Position = vec4(vPosition.xy * .95, vPosition.z, 1.);\n}}\n",
        width, height);
    struct Grid {
        gpu::Program program;
        std::shared_ptr<gpu::Target> target;
        gpu::Buffer indices;
        GLsizei count;
        GLenum primitive;
        void draw() const {
            const gpu::VertexArray array{{}, &indices};
            target->bind();
            program.use();
            array.bind();
            glEnable(GL_PRIMITIVE_RESTART);
            glPrimitiveRestartIndex(kRestart);
            glDrawElements(primitive, count, GL_UNSIGNED_INT, nullptr);
            glDisable(GL_PRIMITIVE_RESTART);
        }
    };
    std::vector<std::shared_ptr<Grid>> grids;
    std::vector<std::vector<float>> pictures;
    for (const bool isStrip : {false, true}) {
        const std::vector<std::uint32_t>& indices = isStrip ? strip : triangles;
        Result<gpu::Program> built = program(setup.capabilities(), vertex, kPlainFragment);
        if (!built) return std::move(built.diagnostics);
        Result<gpu::Buffer> buffer = gpu::Buffer::create(std::as_bytes(std::span(indices)));
        if (!buffer) return std::move(buffer.diagnostics);
        grids.push_back(
            shared(Grid{std::move(*built), *target, std::move(*buffer), static_cast<GLsizei>(indices.size()),
                        static_cast<GLenum>(isStrip ? GL_TRIANGLE_STRIP : GL_TRIANGLES)}));
        (*target)->bind();
        (*target)->clearColor(0, {});
        grids.back()->draw();
        Result<std::vector<float>> picture = readFloats(setup.capabilities(), **target, 3);
        if (!picture) return std::move(picture.diagnostics);
        pictures.push_back(std::move(*picture));
    }
    double largest = 0;
    for (std::size_t i = 0; i < pictures[0].size(); ++i)
        largest = std::max(largest, static_cast<double>(std::abs(pictures[0][i] - pictures[1][i])));
    Figure figure = figureOf(
        setup, {.name = "pf02",
                .text = "A grid is faster as one strip with restarts than as separate triangles",
                .work = fmt::format("a grid of {} x {} points", width, height),
                .errorName = "largest difference",
                .errorUnit = "",
                .reference = "the picture of the other way",
                .slower = {"triangles", drawing(grids[0]), 0, 4. * static_cast<double>(triangles.size())},
                .faster = {"strip", drawing(grids[1]), largest, 4. * static_cast<double>(strip.size())}});
    const Timing frame = setup.bench.time([&] {
        grids[1]->draw();
        glFinish();
    });
    if (!setup.bench.isQuick())
        figure.findings.push_back(
            fmt::format("1000 such strips per second, as on a GTX 480, is {} here, by {:.2g}",
                        frame.median < 1e-3 ? "true" : "false",
                        frame.median < 1e-3 ? 1e-3 / frame.median : frame.median / 1e-3));
    return figure;
}

/// Part of a vertex shader: the corners of octant i of a sphere, moved so that many spheres stand in a grid.
constexpr const char* kOctants =
    "vec3 octantSigns(int i) { return vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1) * 2. - 1.; }\n"
    "vec3 placed(vec3 p, int ball) {\n"
    "    return vec3(vec2(ball % 8, ball / 8) * .24 - .84, 0.) + .11 * p;\n}\n";

/// Subdivides octants in a geometry stage: `level` rows of strips each.
Result<gpu::Program> geometryBalls(const ClaimSetup& setup, int level, bool captures) {
    const std::string geometry = fmt::format(
        "layout(points) in;\nlayout(triangle_strip, max_vertices = {0}) out;\nflat in int vNumber[];\n"
        "out vec3 vPosition;\n{1}"
        "void put(int row, int column, vec3 signs, int ball) {{\n"
        "    vec3 p = vec3(float({2} - row), float(row - column), float(column)) / {2}.;\n"
        "    vPosition = placed(signs * normalize(p), ball);\n"
        "    gl_Position = vec4(vPosition, 1.);\n    EmitVertex();\n}}\n"
        "void main() {{\n    vec3 signs = octantSigns(vNumber[0] % 8);\n    int ball = vNumber[0] / 8;\n"
        "    for (int row = 0; row < {2}; ++row) {{\n        put(row + 1, 0, signs, ball);\n"
        "        for (int column = 0; column <= row; ++column) {{\n            put(row, column, signs, "
        "ball);\n"
        "            put(row + 1, column + 1, signs, ball);\n        }}\n        EndPrimitive();\n    "
        "}}\n}}\n",
        level * (level + 2), kOctants, level);
    const std::vector<gpu::StageSource> stages{{GL_VERTEX_SHADER, kNumberVertex},
                                               {GL_GEOMETRY_SHADER, geometry},
                                               {GL_FRAGMENT_SHADER, kPlainFragment}};
    return program(setup.capabilities(), stages,
                   captures ? std::vector<std::string>{"vPosition"} : std::vector<std::string>{});
}

/// Spheres by tessellation: of octants, or of one rectangle of longitude and latitude. `atOrigin` leaves them
/// at the origin with radius 1, for captures.
Result<gpu::Program> tessellatedBalls(const ClaimSetup& setup, bool octants, double level, bool atOrigin) {
    const std::string control = fmt::format(
        "layout(vertices = 1) out;\nflat in int vNumber[];\nout int cNumber[];\nuniform float uLevel;\n"
        "void main() {{\n    cNumber[gl_InvocationID] = vNumber[0];\n"
        "    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = {0};\n"
        "    for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = {0};\n}}\n",
        level > 0 ? fmt::format("{:.3f}", level) : "uLevel");
    const std::string place =
        atOrigin ? "    vPosition = p;\n    gl_Position = vec4(.5 * p, 1.);\n"
                 : "    vPosition = placed(p, ball);\n    gl_Position = vec4(vPosition, 1.);\n";
    const std::string evaluation =
        octants
            ? fmt::format(
                  "layout(triangles, equal_spacing, ccw) in;\nin int cNumber[];\nout vec3 vPosition;\n{}"
                  "void main() {{\n    int ball = cNumber[0] / 8;\n"
                  "    vec3 p = octantSigns(cNumber[0] % 8) * normalize(gl_TessCoord);\n{}}}\n",
                  kOctants, place)
            : fmt::format(
                  "layout(quads, equal_spacing, ccw) in;\nin int cNumber[];\nout vec3 vPosition;\n{}"
                  "void main() {{\n    int ball = cNumber[0];\n"
                  "    float around = 6.283185307 * gl_TessCoord.x, up = 3.14159265 * (gl_TessCoord.y - "
                  ".5);\n    vec3 p = vec3(cos(up) * cos(around), sin(up), cos(up) * sin(around));\n{}}}\n",
                  kOctants, place);
    const std::vector<gpu::StageSource> stages{{GL_VERTEX_SHADER, kNumberVertex},
                                               {GL_TESS_CONTROL_SHADER, control},
                                               {GL_TESS_EVALUATION_SHADER, evaluation},
                                               {GL_FRAGMENT_SHADER, kPlainFragment}};
    return program(setup.capabilities(), stages,
                   atOrigin ? std::vector<std::string>{"vPosition"} : std::vector<std::string>{});
}

/// Balls that are drawn one by one, because llvmpipe numbers the vertices of one draw with 16 bits.
struct Balls {
    gpu::Program program;
    std::shared_ptr<gpu::Target> target;
    GLenum primitive;
    int perBall, balls;
    void draw() const {
        const gpu::VertexArray none{{}};
        target->bind();
        program.use();
        none.bind();
        if (primitive == GL_PATCHES) glPatchParameteri(GL_PATCH_VERTICES, 1);
        for (int i = 0; i < balls; ++i) glDrawArrays(primitive, i * perBall, perBall);
    }
};

/// The largest distance of the middles of captured triangles from the unit sphere.
double farthestInside(const Captured& captured) {
    double farthest = 0;
    for (std::size_t i = 0; i + 8 < captured.values.size(); i += 9) {
        std::array<double, 3> middle{};
        for (std::size_t k = 0; k < 9; ++k)
            middle.at(k % 3) += static_cast<double>(captured.values[i + k]) / 3;
        farthest = std::max(farthest, 1 - std::hypot(middle[0], middle[1], middle[2]));
    }
    return farthest;
}

int ballCount(const ClaimSetup& setup) {
    return setup.bench.isQuick() ? 4 : 32;
}

/// Spheres that a geometry stage subdivides, and those of a tessellation stage.
Result<Figure> geometryOrTessellation(const ClaimSetup& setup) {
    const auto target = meshTarget(setup);
    if (!target) return target.diagnostics;
    const int balls = ballCount(setup);
    constexpr int kRows = 10;  // 120 vertices of 7 components: below the 1024 that every driver has
    // Both have about 100 triangles per octant: 10 x 10, and 1.5 x 8 x 8.
    constexpr double kLevel = 8;
    Result<gpu::Program> byGeometry = geometryBalls(setup, kRows, false);
    if (!byGeometry) return std::move(byGeometry.diagnostics);
    Result<gpu::Program> byTessellation = tessellatedBalls(setup, true, kLevel, false);
    if (!byTessellation) return std::move(byTessellation.diagnostics);
    const auto geometry = shared(Balls{std::move(*byGeometry), *target, GL_POINTS, 8, balls});
    const auto tessellation = shared(Balls{std::move(*byTessellation), *target, GL_PATCHES, 8, balls});
    Figure figure =
        figureOf(setup, {.name = "pf16",
                         .text = "A geometry stage is slower than tessellation for subdividing surfaces",
                         .work = fmt::format("{} spheres of about 800 triangles", balls),
                         .errorName = "share of triangles too many or too few",
                         .errorUnit = "",
                         .reference = "10 x 10 triangles per octant",
                         .slower = {"geometry stage, 120 vertices per octant", drawing(geometry)},
                         .faster = {"tessellation, level 8", drawing(tessellation),
                                    std::abs(1.5 * kLevel * kLevel / (kRows * kRows) - 1)}});
    const int most = setup.capabilities().maxGeometryOutputVertices;
    const int components = setup.capabilities().maxGeometryTotalOutputComponents;
    figure.findings.push_back(
        fmt::format("a geometry stage may emit {} vertices and {} components here, so that an octant has at "
                    "most {} rows; "
                    "tessellation has levels up to {}",
                    most, components, static_cast<int>(std::sqrt(1. + std::min(most, components / 7)) - 1),
                    setup.capabilities().maxTessellationLevel));
    return figure;
}

/// Spheres of one patch of longitude and latitude, and of eight octants.
Result<Figure> patchOrOctants(const ClaimSetup& setup) {
    const auto target = meshTarget(setup);
    if (!target) return target.diagnostics;
    const int balls = ballCount(setup);
    // 8 x 1.5 x 26 x 26 and 2 x 64 x 64 triangles.
    std::vector<std::shared_ptr<Balls>> ways;
    std::vector<double> errors;
    std::vector<int> counts;
    for (const bool octants : {false, true}) {
        const double level = octants ? 26 : 64;
        Result<gpu::Program> drawn = tessellatedBalls(setup, octants, level, false);
        if (!drawn) return std::move(drawn.diagnostics);
        Result<gpu::Program> atOrigin = tessellatedBalls(setup, octants, level, true);
        if (!atOrigin) return std::move(atOrigin.diagnostics);
        glPatchParameteri(GL_PATCH_VERTICES, 1);
        const Result<Captured> captured =
            capture(setup.capabilities(), *atOrigin, GL_PATCHES, octants ? 8 : 1, GL_TRIANGLES, 3, 40'000);
        if (!captured) return captured.diagnostics;
        errors.push_back(farthestInside(*captured));
        counts.push_back(captured->primitives);
        ways.push_back(shared(Balls{std::move(*drawn), *target, GL_PATCHES, octants ? 8 : 1, balls}));
    }
    return figureOf(
        setup,
        {.name = "pf17",
         .text = "A sphere of eight octants is faster than one patch of longitude and latitude",
         .work = fmt::format("{} spheres of about 8000 triangles", balls),
         .errorName = "largest distance of a triangle's middle from the sphere",
         .errorUnit = "radii",
         .reference = "the sphere",
         .slower = {fmt::format("one patch, level 64: {} triangles", counts[0]), drawing(ways[0]), errors[0]},
         .faster = {fmt::format("octants, level 26: {} triangles", counts[1]), drawing(ways[1]), errors[1]}});
}

/// The size of triangles of a sphere of octants, whose level follows its radius in pixels.
Result<Figure> adaptiveLevels(const ClaimSetup& setup) {
    constexpr double kEdge = 8;  ///< pixels: what an edge of a triangle shall have
    Result<gpu::Program> made = tessellatedBalls(setup, true, 0, true);
    if (!made) return std::move(made.diagnostics);
    const int most = setup.capabilities().maxTessellationLevel;
    Figure figure{
        .name = "pf18",
        .title = "Levels that follow the size on the screen keep the size of triangles",
        .settingName = "radius in pixels",
        .errorName = "deviation from the triangles at a radius of 64 pixels",
        .errorUnit = "",
        .reference = "the mean area of a triangle at a radius of 64 pixels, from the captured triangles",
        .curves = {{"level by the radius"}, {"level 16"}},
        .alternatives = Alternatives::none};
    const auto area = [&](double radius, double level) -> Result<double> {
        setFloats(*made, "uLevel", {static_cast<float>(level)});
        glPatchParameteri(GL_PATCH_VERTICES, 1);
        const Result<Captured> captured =
            capture(setup.capabilities(), *made, GL_PATCHES, 1, GL_TRIANGLES, 3, 40'000);
        if (!captured) return captured.diagnostics;
        return 4 * std::numbers::pi * radius * radius / (8. * captured->primitives);
    };
    const auto levelFor = [&](double radius) {
        return std::clamp(std::round(std::numbers::pi / 2 * radius / kEdge), 1., static_cast<double>(most));
    };
    const Result<double> wanted = area(64, levelFor(64)), fixed = area(64, 16);
    if (!wanted) return wanted.diagnostics;
    if (!fixed) return fixed.diagnostics;
    double worstAdaptive = 0, worstFixed = 0;
    for (const int radius : {16, 32, 64, 128, 256, 512, 1024}) {
        const double level = levelFor(radius);
        const Result<double> adaptive = area(radius, level), still = area(radius, 16);
        if (!adaptive) return adaptive.diagnostics;
        if (!still) return still.diagnostics;
        const auto deviation = [](double a, double b) { return std::max(a / b, b / a) - 1; };
        const double byRadius = deviation(*adaptive, *wanted), without = deviation(*still, *fixed);
        const std::string label = fmt::format("{} pixels, level {:.0f}", radius, level);
        figure.curves[0].points.push_back({.setting = 1. * radius, .label = label, .error = byRadius});
        figure.curves[1].points.push_back(
            {.setting = 1. * radius, .label = fmt::format("{} pixels", radius), .error = without});
        if (level < most) {
            worstAdaptive = std::max(worstAdaptive, byRadius);
            worstFixed = std::max(worstFixed, without);
        }
    }
    figure.findings = {
        fmt::format("{} here up to the level {}: areas differ by a factor of at most {:.3g}, with one level "
                    "by {:.3g}",
                    worstAdaptive < .1 * worstFixed ? "true" : "false", most, 1 + worstAdaptive,
                    1 + worstFixed),
        fmt::format("beyond a radius of {:.0f} pixels the level stays at {}, and triangles grow",
                    most * kEdge * 2 / std::numbers::pi, most)};
    return figure;
}

/// Half of the triangles of a closed mesh show their backs.
Result<Figure> culling(const ClaimSetup& setup) {
    const auto target = meshTarget(setup);
    if (!target) return target.diagnostics;
    const int rings = setup.bench.isQuick() ? 100 : 600;
    Result<gpu::Program> built = program(
        setup.capabilities(),
        fmt::format(
            "out vec3 vPosition;\nvoid main() {{\n"
            "    int cell = gl_VertexID / 6, corner = gl_VertexID % 6;\n"
            "    vec2 at = vec2(cell % {0} + (corner == 1 || corner == 2 || corner == 4 ? 1 : 0),\n"
            "                   cell / {0} + (corner == 2 || corner > 3 ? 1 : 0)) * 6.283185307 / {0}.;\n"
            "    float r = .6 + .25 * cos(at.y);\n"
            "    vPosition = vec3(r * cos(at.x), r * sin(at.x), .25 * sin(at.y));\n"
            "    gl_Position = vec4(vPosition, 1.);\n}}\n",
            rings),
        kPlainFragment);
    if (!built) return std::move(built.diagnostics);
    const int vertices = 6 * rings * rings;
    const auto torus = shared(std::move(*built));
    const auto drawn = [torus, target = *target, vertices](bool culls) {
        return [torus, target, vertices, culls] {
            target->bind();
            glEnable(GL_DEPTH_TEST);
            glClear(GL_DEPTH_BUFFER_BIT);
            if (culls) glEnable(GL_CULL_FACE);
            glCullFace(GL_BACK);
            drawVertices(*torus, GL_TRIANGLES, vertices);
            glDisable(GL_CULL_FACE);
            glDisable(GL_DEPTH_TEST);
        };
    };
    return figureOf(setup, {.name = "a28",
                            .text = "Culling back faces saves half of the triangles of a closed mesh",
                            .work = fmt::format("a torus of {} triangles", vertices / 3),
                            .errorName = "error",
                            .errorUnit = "",
                            .reference = "the stress test CulledFaces: the same pictures",
                            .slower = {"all faces", drawn(false)},
                            .faster = {"back faces culled", drawn(true)}});
}

}  // namespace

Result<std::vector<Figure>> measureMeshClaims(const ClaimSetup& setup) {
    return measureEach({stripOrTriangles, adaptiveLevels, culling, geometryOrTessellation, patchOrOctants},
                       setup);
}

}  // namespace glibra::bench
