// Claims about textures in place of computations and geometry, and about lookups in shadow maps.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "bench/core/fit.h"
#include "bench/draw/offscreen.h"
#include "bench/subjects/claim.h"
#include "gpu/object/sampler.h"
#include "gpu/object/texture.h"

namespace glibra::bench {
namespace {

using gpu::TexelFormat;

gpu::Sampler samplerOf(base::Filter filter) {
    return gpu::Sampler(
        gpu::SamplerState{.filter = filter,
                          .wrap = {gpu::Wrap::clampToEdge, gpu::Wrap::clampToEdge, gpu::Wrap::clampToEdge},
                          .border = {}});
}

/// A program that reads one texture on unit 0 and covers or fills a target.
struct Reader {
    gpu::Program program;
    std::shared_ptr<gpu::Texture> texture;
    std::shared_ptr<gpu::Sampler> sampler;
    std::shared_ptr<gpu::Target> target;
    int vertices = 3;
    bool hasDepth = false;

    void draw() const {
        target->bind();
        if (texture) texture->bind(0);
        if (sampler) sampler->bind(0);
        if (hasDepth) {
            glEnable(GL_DEPTH_TEST);
            glClear(GL_DEPTH_BUFFER_BIT);
        }
        drawVertices(program, GL_TRIANGLES, vertices);
        glDisable(GL_DEPTH_TEST);
        glBindSampler(0, 0);
    }
};

Result<gpu::Texture> textureOf(const ClaimSetup& setup, gpu::TextureShape shape, TexelFormat format,
                               gpu::TextureSize size, std::span<const float> values, int components) {
    return gpu::Texture::create(setup.capabilities(), shape, format, size,
                                {std::as_bytes(values), components, gpu::TexelType::f32});
}

/// The pattern of pf11, for places 0..1.
double pattern(double x, double y) {
    return .5 + .5 * std::sin(40 * x + 6 * std::sin(30 * y));
}

/// A pattern that is computed, and the same from a texture of 512 x 512 floats, when zoomed in.
Result<Figure> proceduralOrTexture(const ClaimSetup& setup) {
    constexpr int kTexels = 512;
    const int side = setup.bench.isQuick() ? 128 : 512;
    const auto target = targetOf(setup, side, TexelFormat::r32f);
    if (!target) return target.diagnostics;
    std::vector<float> texels;
    for (int y = 0; y < kTexels; ++y)
        for (int x = 0; x < kTexels; ++x)
            texels.push_back(static_cast<float>(pattern((x + .5) / kTexels, (y + .5) / kTexels)));
    Result<gpu::Texture> texture =
        textureOf(setup, gpu::TextureShape::texture2D, TexelFormat::r8, {kTexels, kTexels, 1}, texels, 1);
    if (!texture) return std::move(texture.diagnostics);
    const std::string start =
        "in vec2 vPlace;\nout vec4 fColor;\nuniform float uZoom;\nuniform sampler2D uTexture;\nvoid main() "
        "{\n"
        "    vec2 p = vec2(.4, .3) + vPlace * uZoom;\n";
    Result<gpu::Program> computed =
        program(setup.capabilities(), kWholeTarget,
                start + "    fColor = vec4(.5 + .5 * sin(40. * p.x + 6. * sin(30. * p.y)));\n}\n");
    if (!computed) return std::move(computed.diagnostics);
    Result<gpu::Program> sampled = program(setup.capabilities(), kWholeTarget,
                                           start + "    fColor = vec4(texture(uTexture, p).r);\n}\n");
    if (!sampled) return std::move(sampled.diagnostics);
    const auto linear = shared(samplerOf(base::Filter::linear));
    const auto procedural = shared(Reader{std::move(*computed), nullptr, nullptr, *target});
    const auto read = shared(Reader{std::move(*sampled), shared(std::move(*texture)), linear, *target});
    Figure figure{.name = "pf11",
                  .title = "A computed pattern keeps its resolution and takes no texture memory",
                  .settingName = "zoom",
                  .errorName = "largest error",
                  .errorUnit = "",
                  .reference = "the formula in double",
                  .curves = {{"computed in the shader"}, {"texture of 512 x 512 bytes, linear"}},
                  .alternatives = Alternatives::setting};
    Timing ratio;
    for (const int zoom : {1, 4, 16, 64}) {
        const float size = .5F / static_cast<float>(zoom);
        for (const auto& each : {procedural, read}) {
            setFloats(each->program, "uZoom", {size});
            each->draw();
            const Result<std::vector<float>> values = readFloats(setup.capabilities(), **target, 1);
            if (!values) return values.diagnostics;
            double error = 0;
            for (int row = 0; row < side; ++row)
                for (int column = 0; column < side; ++column) {
                    const double x = .4 + size * (column + .5) / side,
                                 y = .3 + size * (side - row - .5) / side;
                    const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
                                    static_cast<std::size_t>(column);
                    error = std::max(error, std::abs(static_cast<double>((*values)[at]) - pattern(x, y)));
                }
            figure.curves[each == procedural ? 0 : 1].points.push_back(
                {.setting = static_cast<double>(zoom),
                 .label = fmt::format("zoom {}", zoom),
                 .error = error,
                 .memory = each == procedural ? 0. : 1. * kTexels * kTexels});
        }
        const PairedTiming timing = setup.time(drawing(procedural), drawing(read));
        figure.curves[0].points.back().time = timing.first;
        figure.curves[1].points.back().time = timing.second;
        ratio = timing.ratio;
    }
    const double exact = figure.curves[0].points.back().error,
                 filtered = figure.curves[1].points.back().error;
    figure.findings = {
        fmt::format("{} here: zoomed by 64 the computed pattern is off by {}, the texture by {}",
                    exact < filtered ? "true" : "false", numberText(exact), numberText(filtered)),
        fmt::format("it takes {:.2f} ({:.2f} .. {:.2f}) times as long as the texture", ratio.median,
                    ratio.low, ratio.high)};
    return figure;
}

/// Terrain as a mesh with a vertex per texel, and as one rectangle with normals from the same texture.
Result<Figure> bumpsOrGeometry(const ClaimSetup& setup) {
    const int width = setup.bench.isQuick() ? 256 : 2048, height = width * 9 / 16, side = 512;
    const auto target = targetOf(setup, side, TexelFormat::rgba8);
    if (!target) return target.diagnostics;
    std::vector<float> heights;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            heights.push_back(
                static_cast<float>(.05 * std::sin(25. * x / width) * std::cos(18. * y / height) +
                                   .01 * std::sin(140. * x / width)));
    Result<gpu::Texture> texture =
        textureOf(setup, gpu::TextureShape::texture2D, TexelFormat::r32f, {width, height, 1}, heights, 1);
    if (!texture) return std::move(texture.diagnostics);
    const auto map = shared(std::move(*texture));
    const auto linear = shared(samplerOf(base::Filter::linear));
    const std::string fragment =
        "in vec2 vST;\nout vec4 fColor;\nuniform sampler2D uTexture;\nvoid main() {\n"
        "    vec2 texel = 1. / vec2(textureSize(uTexture, 0));\n"
        "    float east = texture(uTexture, vST + vec2(texel.x, 0.)).r - texture(uTexture, vST - "
        "vec2(texel.x, "
        "0.)).r;\n"
        "    float north = texture(uTexture, vST + vec2(0., texel.y)).r - texture(uTexture, vST - vec2(0., "
        "texel.y)).r;\n"
        "    vec3 n = normalize(vec3(-east / (4. * texel.x), -north / (4. * texel.y), 1.));\n"
        "    fColor = vec4(vec3(max(dot(n, normalize(vec3(-.4, .5, .8))), 0.)), 1.);\n}\n";
    const std::string view =
        "void show(vec2 st, float height) {\n    vST = st;\n    vec2 p = 2. * st - 1.;\n"
        "    gl_Position = vec4(.9 * p.x, .8 * p.y + .6 * height, .3 * p.y - height, 1.);\n}\n";
    Result<gpu::Program> mesh =
        program(setup.capabilities(),
                "out vec2 vST;\nuniform sampler2D uTexture;\n" + view +
                    "void main() {\n    ivec2 size = textureSize(uTexture, 0);\n    int cell = gl_VertexID / "
                    "6, corner = "
                    "gl_VertexID % 6;\n"
                    "    ivec2 place = ivec2(cell % (size.x - 1), cell / (size.x - 1))\n"
                    "        + ivec2(corner == 1 || corner == 2 || corner == 4 ? 1 : 0, corner == 2 || "
                    "corner > 3 ? 1 : "
                    "0);\n"
                    "    show((vec2(place) + .5) / vec2(size), texelFetch(uTexture, place, 0).r);\n}\n",
                fragment);
    if (!mesh) return std::move(mesh.diagnostics);
    Result<gpu::Program> flat =
        program(setup.capabilities(),
                "out vec2 vST;\n" + view +
                    "void main() {\n"
                    "    show(vec2(gl_VertexID == 1 || gl_VertexID == 2 || gl_VertexID == 4 ? 1 : 0,\n"
                    "              gl_VertexID == 2 || gl_VertexID > 3 ? 1 : 0), 0.);\n}\n",
                fragment);
    if (!flat) return std::move(flat.diagnostics);
    const int vertices = 6 * (width - 1) * (height - 1);
    const auto geometry = shared(Reader{std::move(*mesh), map, linear, *target, vertices, true});
    const auto bumps = shared(Reader{std::move(*flat), map, linear, *target, 6, true});
    std::array<std::vector<float>, 2> pictures;
    for (const auto& each : {geometry, bumps}) {
        each->target->bind();
        each->target->clearColor(0, {});
        each->draw();
        Result<std::vector<float>> values = readFloats(setup.capabilities(), **target, 1);
        if (!values) return std::move(values.diagnostics);
        pictures[each == geometry ? 0 : 1] = std::move(*values);
    }
    double squares = 0;
    for (std::size_t i = 0; i < pictures[0].size(); ++i) {
        const double difference = static_cast<double>(pictures[0][i]) - static_cast<double>(pictures[1][i]);
        squares += difference * difference / static_cast<double>(pictures[0].size());
    }
    const double bytes = 4. * width * height;
    return figureOf(
        setup, {.name = "pf12",
                .text = "Terrain from one rectangle with bumps is faster than from geometry",
                .work = fmt::format("a map of {} x {} heights", width, height),
                .errorName = "difference (root of the mean square)",
                .errorUnit = "",
                .reference = "the picture of the geometry: bumps move no outline",
                .slower = {fmt::format("geometry: {} triangles", vertices / 3), drawing(geometry), 0, bytes},
                .faster = {"one rectangle with bumps", drawing(bumps), std::sqrt(squares), bytes}});
}

constexpr const char* kTransfer =
    "vec3 transfer(float t) {\n"
    "    float band = 4. * clamp(t, 0., 1.);\n"
    "    return clamp(vec3(band - uTurn, 2. - abs(band - 2.), uTurn - band), 0., 1.);\n"
    "}\n";

/// Colours from a texture, and values whose colours the shader computes.
Result<std::vector<Figure>> colorTexture(const ClaimSetup& setup) {
    const int cells = setup.bench.isQuick() ? 32 : 64, side = setup.bench.isQuick() ? 128 : 512;
    const auto target = targetOf(setup, side, TexelFormat::rgba8);
    if (!target) return target.diagnostics;
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
    const gpu::TextureSize size{cells, cells, cells};
    Result<gpu::Texture> scalars =
        textureOf(setup, gpu::TextureShape::texture3D, TexelFormat::r8, size, values, 1);
    if (!scalars) return std::move(scalars.diagnostics);
    Result<gpu::Texture> colors =
        textureOf(setup, gpu::TextureShape::texture3D, TexelFormat::rgba8, size, colorsFor(2), 4);
    if (!colors) return std::move(colors.diagnostics);
    const std::string start =
        "in vec2 vPlace;\nout vec4 fColor;\nuniform sampler3D uTexture;\nuniform float uTurn;\n";
    const std::string loop =
        "void main() {{\n    vec3 sum = vec3(0.);\n"
        "    for (int i = 0; i < 32; ++i) sum += {};\n    fColor = vec4(sum / 32., 1.);\n}}\n";
    const char* const place = "texture(uTexture, vec3(vPlace, (float(i) + .5) / 32.))";
    Result<gpu::Program> computed =
        program(setup.capabilities(), kWholeTarget,
                start + kTransfer + fmt::format(fmt::runtime(loop), fmt::format("transfer({}.r)", place)));
    if (!computed) return std::move(computed.diagnostics);
    Result<gpu::Program> stored =
        program(setup.capabilities(), kWholeTarget,
                start + fmt::format(fmt::runtime(loop), fmt::format("{}.rgb", place)));
    if (!stored) return std::move(stored.diagnostics);
    setFloats(*computed, "uTurn", {2});
    const auto linear = shared(samplerOf(base::Filter::linear));
    const auto transfers = shared(Reader{std::move(*computed), shared(std::move(*scalars)), linear, *target});
    const auto lookups = shared(Reader{std::move(*stored), shared(std::move(*colors)), linear, *target});
    const double texels = 1. * cells * cells * cells;
    std::vector<Figure> figures;
    figures.push_back(figureOf(
        setup, {.name = "pf22-picture",
                .text = "A texture of colours is faster to look up than values with a transfer function",
                .work = fmt::format("{0} x {0} pixels, 32 lookups in {1}^3 texels", side, cells),
                .errorName = "error",
                .errorUnit = "",
                .reference = "not compared: interpolated colours are not the colours of interpolated values",
                .slower = {"values and a transfer function", drawing(transfers), 0, texels},
                .faster = {"precomputed colours", drawing(lookups), 0, 4 * texels}}));
    const auto turn = shared(2.F);
    const auto change = [turn] { return *turn = *turn > 2.5F ? 1.5F : *turn + .01F; };
    figures.push_back(figureOf(
        setup, {.name = "pf22-change",
                .text = "A change of the transfer function is faster where the shader applies it",
                .work = fmt::format("one change and one picture of {0} x {0} pixels", side),
                .errorName = "error",
                .errorUnit = "",
                .reference = "not compared: interpolated colours are not the colours of interpolated values",
                .slower = {"precomputed colours: computed and uploaded again",
                           [lookups, change, colorsFor] {
                               const std::vector<float> anew = colorsFor(change());
                               (void)lookups->texture->upload(
                                   0, {std::as_bytes(std::span(anew)), 4, gpu::TexelType::f32});
                               lookups->draw();
                           },
                           0, 4 * texels},
                .faster = {"values and a transfer function: one uniform",
                           [transfers, change] {
                               setFloats(transfers->program, "uTurn", {change()});
                               transfers->draw();
                           },
                           0, texels}}));
    return figures;
}

/// n x n lookups of a shadow map with one straight edge, against the ramp of an area light.
Result<Figure> shadowLookups(const ClaimSetup& setup) {
    constexpr int kTexels = 1024;
    constexpr double kWidth = .2;
    const int side = setup.bench.isQuick() ? 128 : 512;
    const auto target = targetOf(setup, side, TexelFormat::r32f);
    if (!target) return target.diagnostics;
    std::vector<float> depths;
    for (int i = 0; i < kTexels * kTexels; ++i) depths.push_back(i % kTexels < kTexels / 2 ? .3F : 1.F);
    Result<gpu::Texture> texture =
        textureOf(setup, gpu::TextureShape::texture2D, TexelFormat::r32f, {kTexels, kTexels, 1}, depths, 1);
    if (!texture) return std::move(texture.diagnostics);
    Result<gpu::Program> built =
        program(setup.capabilities(), kWholeTarget,
                "in vec2 vPlace;\nout vec4 fColor;\nuniform sampler2D uTexture;\nuniform int uGrid;\n"
                "void main() {\n    float sum = 0.;\n    for (int i = 0; i < uGrid; ++i)\n"
                "        for (int j = 0; j < uGrid; ++j) {\n"
                "            vec2 at = (vec2(i, j) + .5) / float(uGrid) - .5;\n"
                "            sum += texture(uTexture, vPlace + .2 * at).r > .6 ? 1. : 0.;\n        }\n"
                "    fColor = vec4(sum / float(uGrid * uGrid));\n}\n");
    if (!built) return std::move(built.diagnostics);
    const auto reader = shared(Reader{std::move(*built), shared(std::move(*texture)),
                                      shared(samplerOf(base::Filter::nearest)), *target});
    Figure figure{.name = "a05",
                  .title = "Soft shadows: what more lookups per pixel cost and bring",
                  .settingName = "lookups per pixel",
                  .errorName = "error of the penumbra (root of the mean square)",
                  .errorUnit = "",
                  .reference = "the ramp of a square light above a straight edge",
                  .curves = {{"percentage-closer filtering"},
                             {.name = "theory: 1 / (n sqrt 12) for n x n", .theoryOf = 0}}};
    std::string ratios;
    const auto drawWith = [reader](int grid) {
        return [reader, grid] {
            setInt(reader->program, "uGrid", grid);
            reader->draw();
        };
    };
    for (const int grid : {1, 2, 4, 8}) {
        drawWith(grid)();
        const Result<std::vector<float>> values = readFloats(setup.capabilities(), **target, 1);
        if (!values) return values.diagnostics;
        double squares = 0;
        int count = 0;
        for (int column = 0; column < side; ++column) {
            const double x = (column + .5) / side - .5;
            if (std::abs(x) > kWidth / 2) continue;
            const auto at = static_cast<std::size_t>(side / 2) * static_cast<std::size_t>(side) +
                            static_cast<std::size_t>(column);
            const double error = static_cast<double>((*values)[at]) - (.5 + x / kWidth);
            squares += error * error;
            ++count;
        }
        const PairedTiming timing = setup.time(drawWith(grid), drawWith(1));
        const double setting = 1. * grid * grid;
        const std::string label = fmt::format("{} lookups", grid * grid);
        figure.curves[0].points.push_back({.setting = setting,
                                           .label = label,
                                           .error = std::sqrt(squares / count),
                                           .time = timing.first,
                                           .memory = 4. * kTexels * kTexels});
        figure.curves[1].points.push_back(
            {.setting = setting, .label = label, .error = 1 / (grid * std::sqrt(12.))});
        if (grid > 1)
            ratios += fmt::format("{}{} lookups {:.2f}", ratios.empty() ? "" : ", ", grid * grid,
                                  timing.ratio.median);
    }
    figure.findings = {orderSentence(figure.curves[0], "lookups"),
                       "in times of one lookup per pixel: " + ratios};
    return figure;
}

}  // namespace

Result<std::vector<Figure>> measureTextureClaims(const ClaimSetup& setup) {
    Result<std::vector<Figure>> figures =
        measureEach({proceduralOrTexture, bumpsOrGeometry, shadowLookups}, setup);
    if (!figures) return figures;
    Result<std::vector<Figure>> colors = colorTexture(setup);
    if (!colors) return colors;
    std::ranges::move(*colors, std::back_inserter(*figures));
    return figures;
}

}  // namespace glibra::bench
