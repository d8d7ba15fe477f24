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

namespace {

using gpu::TexelFormat;

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
        const auto wanted =
            overPixels(side, side, [&](double x, double y) { return waves(.4 + size * x, .3 + size * y); });
        const auto error = [&](const Draw& draw) {
            draw();
            return largestDifference(canvas.pixels(1), wanted);
        };
        const PairedTiming timing = timedInTurn(bench, computed, read);
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
    const auto shader = [&](std::string_view macros) {
        return Shader(bench, fmt::format("{}{}", macros, bench_shaders::relief_vert()),
                      bench_shaders::relief_frag());
    };
    const int vertices = 6 * (width - 1) * (height - 1);
    const Draw geometry = reading(canvas, shader("#define MESH\n"), map, vertices),
               bumps = reading(canvas, shader(""), map, 6);
    const auto picture = [&](const Draw& draw) {
        canvas.clear();
        draw();
        return canvas.pixels(1);
    };
    const std::vector<float> wanted = picture(geometry), got = picture(bumps);
    return claimFigure(
        bench, {.name = "pf12",
                .text = "Terrain from one rectangle with bumps is faster than from geometry",
                .work = fmt::format("a map of {} x {} heights", width, height),
                .errorName = "difference (root of the mean square)",
                .reference = "the picture of the geometry: bumps move no outline",
                .slower = {fmt::format("geometry: {} triangles", vertices / 3), geometry, 0, map.bytes()},
                .faster = {"one rectangle with bumps", bumps, rootMeanSquare(got, wanted), map.bytes()}});
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
    const Shader shader(bench, bench_shaders::lookups_frag());
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
        const PairedTiming timing = timedInTurn(bench, drawWith(grid), drawWith(1));
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
        return Shader(bench, fmt::format("#define COLOR {}\n{}", color, bench_shaders::transfer_frag()));
    };
    const Shader computed = shader("transfer(texel.r)").set("uTurn", 2.);
    const Draw transfers = reading(canvas, computed, scalars),
               lookups = reading(canvas, shader("texel.rgb"), colors);
    const double texels = 1. * cells * cells * cells;
    const char* const notCompared =
        "not compared: interpolated colours are not the colours of interpolated values";
    figures.push_back(claimFigure(
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
        claimFigure(bench, {.name = "pf22-change",
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

}  // namespace

void addTextureClaims(std::vector<Figure>& figures, Bench& bench) {
    for (const auto measure : {proceduralOrTexture, bumpsOrGeometry, shadowLookups})
        figures.push_back(measure(bench));
    addColorClaims(figures, bench);
}

}  // namespace glibra::bench
