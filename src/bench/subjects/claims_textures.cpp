#include <algorithm>
#include <cmath>

#include "bench/core/device.h"
#include "bench/subjects/claims.h"
#include "embedded/bench_shaders.h"

namespace glibra::bench {
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
