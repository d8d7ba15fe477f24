#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>

#include "bench/core/device.h"
#include "bench/subjects/claims.h"
#include "embedded/bench_shaders.h"

namespace glibra::bench {
namespace {

using gpu::TexelFormat;

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
    const Shader shader(
        bench,
        fmt::format("#define WIDTH {}\n#define HEIGHT {}\n{}", width, height, bench_shaders::grid_vert()),
        bench_shaders::plain_frag());
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
        claimFigure(bench, {.name = "pf02",
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

/// Subdivides octants in a geometry stage.
Shader geometryBalls(Bench& bench, int rows) {
    const std::string geometry =
        fmt::format("#define ROWS {}\n#define VERTICES {}\n{}{}", rows, rows * (rows + 2),
                    bench_shaders::octants_glsl(), bench_shaders::balls_geom());
    return {bench, std::array{gpu::StageSource{GL_VERTEX_SHADER, bench_shaders::number_vert()},
                              gpu::StageSource{GL_GEOMETRY_SHADER, geometry},
                              gpu::StageSource{GL_FRAGMENT_SHADER, bench_shaders::plain_frag()}}};
}

/// Spheres by tessellation, as shaders/balls.tese has them. A level of 0 is that of the uniform.
Shader tessellatedBalls(Bench& bench, bool octants, double level, bool atOrigin) {
    const std::string control =
        fmt::format("#define LEVEL {}\n{}", level > 0 ? fmt::format("{:.3f}", level) : "uLevel",
                    bench_shaders::balls_tesc());
    const std::string evaluation =
        fmt::format("{}{}{}{}", octants ? "#define OCTANTS\n" : "", atOrigin ? "#define AT_ORIGIN\n" : "",
                    bench_shaders::octants_glsl(), bench_shaders::balls_tese());
    return {bench,
            std::array{gpu::StageSource{GL_VERTEX_SHADER, bench_shaders::number_vert()},
                       gpu::StageSource{GL_TESS_CONTROL_SHADER, control},
                       gpu::StageSource{GL_TESS_EVALUATION_SHADER, evaluation},
                       gpu::StageSource{GL_FRAGMENT_SHADER, bench_shaders::plain_frag()}},
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
    const Draw drawnByGeometry = drawnBalls(canvas, geometryBalls(bench, kRows), GL_POINTS, 8, balls);
    const Draw drawnByTessellation =
        drawnBalls(canvas, tessellatedBalls(bench, true, kLevel, false), GL_PATCHES, 8, balls);
    Figure figure =
        claimFigure(bench, {.name = "pf16",
                            .text = "A geometry stage is slower than tessellation for subdividing surfaces",
                            .work = fmt::format("{} spheres of about 800 triangles", balls),
                            .errorName = "share of triangles too many or too few",
                            .reference = "10 x 10 triangles per octant",
                            .slower = {"geometry stage, 120 vertices per octant", drawnByGeometry},
                            .faster = {"tessellation, level 8", drawnByTessellation,
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
    const Claim::Way one = way(false), eight = way(true);
    return claimFigure(
        bench, {.name = "pf17",
                .text = "A sphere of eight octants is faster than one patch of longitude and latitude",
                .work = fmt::format("{} spheres of about 8000 triangles", balls),
                .errorName = "largest distance of a triangle's middle from the sphere",
                .errorUnit = "radii",
                .reference = "the sphere",
                .slower = one,
                .faster = eight});
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
    const Shader torus(bench, fmt::format("#define RINGS {}\n{}", rings, bench_shaders::torus_vert()),
                       bench_shaders::plain_frag());
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
    return claimFigure(bench, {.name = "a28",
                               .text = "Culling back faces saves half of the triangles of a closed mesh",
                               .work = fmt::format("a torus of {} triangles", vertices / 3),
                               .errorName = "error",
                               .reference = "the stress test CulledFaces: the same pictures",
                               .slower = {"all faces", drawing(false)},
                               .faster = {"back faces culled", drawing(true)}});
}

}  // namespace

void addMeshClaims(std::vector<Figure>& figures, Bench& bench) {
    for (const auto measure :
         {stripOrTriangles, adaptiveLevels, culling, geometryOrTessellation, patchOrOctants})
        figures.push_back(measure(bench));
}

}  // namespace glibra::bench
