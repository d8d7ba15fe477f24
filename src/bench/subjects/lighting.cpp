#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "bench/core/fit.h"
#include "bench/draw/lit_mesh.h"
#include "bench/draw/offscreen.h"
#include "bench/reference/analytic_lighting.h"
#include "bench/subjects/subjects.h"
#include "geometry/shapes/cylinders.h"
#include "geometry/shapes/spheres.h"

namespace glibra::bench {
namespace {

constexpr double kExponent = 32;

/// The light for sphere and torus, neither along the view nor in a plane of symmetry.
glm::dvec3 obliqueLight() {
    return glm::normalize(glm::dvec3(.5, .7, 1));
}

struct Difference {
    double rootMeanSquare = 0;
    double brightest = 0, wanted = 0;  ///< largest intensity of the drawn picture and of the reference
};

/// Compares the pixels that both cover.
Difference difference(const std::vector<float>& drawn, const std::vector<std::optional<double>>& reference) {
    Difference found;
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        if (!reference[i] || drawn[2 * i + 1] < .5F) continue;
        const double value = drawn[2 * i], error = value - *reference[i];
        sum += error * error;
        ++count;
        found.brightest = std::max(found.brightest, value);
        found.wanted = std::max(found.wanted, *reference[i]);
    }
    if (count > 0) found.rootMeanSquare = std::sqrt(sum / static_cast<double>(count));
    return found;
}

/// A value of the normal at each pixel that shows the surface, in a picture that reaches to `seen` in x and
/// y.
template <class Value>
std::vector<std::optional<double>> overPixels(LitSurface surface, int side, double seen, const Value& value) {
    std::vector<std::optional<double>> values;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const double x = seen * ((2 * column + 1.0) / side - 1), y = seen * (1 - (2 * row + 1.0) / side);
            const std::optional<glm::dvec3> normal = normalAt(surface, x, y);
            values.push_back(normal ? std::optional(value(*normal)) : std::nullopt);
        }
    return values;
}

geometry::Mesh meshOf(LitSurface surface, int slices) {
    return surface == LitSurface::sphere ? geometry::sphere(1, slices, slices / 2)
                                         : geometry::torus(kRingRadius, kTubeRadius, slices / 2, slices);
}

struct NamedMethod {
    LightingMethod method;
    std::string_view name;
};
constexpr std::array<NamedMethod, 4> kNamedMethods{
    {{LightingMethod::perVertex, "per vertex (Gouraud)"},
     {LightingMethod::interpolated, "per fragment, normals as interpolated"},
     {LightingMethod::renormalised, "per fragment, normals renormalised"},
     {LightingMethod::analytic, "per fragment, analytic normals"}}};

template <LitSurface surface>
Result<Figure> surfaceFigure(Bench& bench, const gpu::Capabilities& capabilities) {
    const bool isSphere = surface == LitSurface::sphere;
    Figure figure{
        .name = isSphere ? "sphere" : "torus",
        .title = isSphere ? "Lit sphere: by vertex and by fragment" : "Lit torus: by vertex and by fragment",
        .settingName = "slices",
        .errorName = "root mean square over the pixels",
        .errorUnit = "of full intensity",
        .reference =
            "Phong lighting in double at the point of the analytic surface that each pixel's ray "
            "meets; no mesh, no interpolation"};
    const int side = bench.isQuick() ? 96 : 384, most = bench.isQuick() ? 64 : 512;
    const auto wanted = overPixels(surface, side, kSeen, [](const glm::dvec3& normal) {
        return intensity(Highlight::reflection, normal, obliqueLight(), kExponent);
    });
    Result<gpu::Target> target = gpu::Target::window(capabilities, side, side, gpu::TexelFormat::rgba32f);
    if (!target) return std::move(target.diagnostics);
    for (const NamedMethod& method : kNamedMethods) {
        Result<gpu::Program> program =
            lightingProgram(capabilities, surface, method.method, obliqueLight(), kExponent);
        if (!program) return std::move(program.diagnostics);
        Curve curve{.name = std::string(method.name)};
        for (int slices = 8; slices <= most; slices *= 2) {
            const Result<LitMesh> mesh = LitMesh::create(meshOf(surface, slices));
            if (!mesh) return mesh.diagnostics;
            const Timing time = bench.time([&] {
                mesh->draw(*program, *target);
                glFinish();
            });
            const Result<std::vector<float>> drawn = readFloats(capabilities, *target, 2);
            if (!drawn) return drawn.diagnostics;
            const Difference found = difference(*drawn, wanted);
            curve.points.push_back({.setting = static_cast<double>(slices),
                                    .label = fmt::format("{} slices", slices),
                                    .error = found.rootMeanSquare,
                                    .time = time,
                                    .memory = mesh->bytes()});
            if (slices == 16)
                figure.findings.push_back(
                    fmt::format("{}: with 16 slices the brightest pixel is {:.3f}, exactly {:.3f}",
                                method.name, found.brightest, found.wanted));
        }
        figure.findings.push_back(orderSentence(curve, "slices"));
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

double targetBytes(const gpu::Target& target) {
    return static_cast<double>(target.width()) * target.height() * 4 * sizeof(float);
}

/// The light at that angle (degrees) to the view, tilted so that no row or column is special.
glm::dvec3 lightAt(double angle) {
    const double a = angle * std::numbers::pi / 180;
    return {std::sin(a) * .8, std::sin(a) * .6, std::cos(a)};
}

std::vector<std::optional<double>> highlights(int side, const glm::dvec3& light, double exponent) {
    return overPixels(LitSurface::sphere, side, 1, [&](const glm::dvec3& normal) {
        return highlight(Highlight::reflection, normal, light, exponent);
    });
}

/// The root mean square of highlights alone over the sphere drawn as a rectangle.
Result<double> highlightError(const gpu::Capabilities& capabilities, const gpu::Program& program,
                              const gpu::Target& target, const glm::dvec3& light, double exponent,
                              const std::vector<std::optional<double>>& wanted) {
    setVector(program, "uLight", light);
    setFloats(program, "uExponent", {static_cast<float>(exponent)});
    target.bind();
    drawWhole(program);
    const Result<std::vector<float>> drawn = readFloats(capabilities, target, 2);
    if (!drawn) return drawn.diagnostics;
    return difference(*drawn, wanted).rootMeanSquare;
}

std::string bestFactor(const Curve& curve) {
    const auto best = std::ranges::min_element(curve.points, {}, &Point::error);
    return fmt::format("{}: a factor of {} is best; {} remains, {} with the exponent unchanged", curve.name,
                       best->setting, numberText(best->error), numberText(curve.points.front().error));
}

Result<Figure> halfVectorFigure(Bench& bench, const gpu::Capabilities& capabilities) {
    Figure figure{.name = "half-vector",
                  .title = "Highlight by the half vector: which exponent matches the reflection",
                  .settingName = "factor on the exponent",
                  .errorName = "root mean square over the sphere",
                  .errorUnit = "of the highlight",
                  .reference = "the reflection's highlight in double on the analytic sphere",
                  .alternatives = Alternatives::none};
    const int side = bench.isQuick() ? 64 : 192;
    const int stepsAUnit = bench.isQuick() ? 2 : 8;
    Result<gpu::Target> target = gpu::Target::window(capabilities, side, side, gpu::TexelFormat::rgba32f);
    if (!target) return std::move(target.diagnostics);
    Result<gpu::Program> half = highlightProgram(capabilities, Highlight::halfVector);
    if (!half) return std::move(half.diagnostics);
    for (const double angle : {20., 90.})
        for (const double exponent : {8., 32., 128.}) {
            Curve curve{.name = fmt::format("exponent {}, light at {} degrees", exponent, angle)};
            const glm::dvec3 light = lightAt(angle);
            const auto wanted = highlights(side, light, exponent);
            for (int i = 0; i <= 5 * stepsAUnit; ++i) {
                const double factor = 1 + static_cast<double>(i) / stepsAUnit;
                const Result<double> error =
                    highlightError(capabilities, *half, *target, light, exponent * factor, wanted);
                if (!error) return error.diagnostics;
                curve.points.push_back({.setting = factor,
                                        .label = fmt::format("{} times", factor),
                                        .error = *error,
                                        .memory = targetBytes(*target)});
            }
            figure.findings.push_back(bestFactor(curve));
            figure.curves.push_back(std::move(curve));
        }
    return figure;
}

Result<Figure> modelFigure(Bench& bench, const gpu::Capabilities& capabilities) {
    Figure figure{.name = "highlight-models",
                  .title = "Reflection and half vector by the angle of the light, exponent 32",
                  .settingName = "angle between light and view, degrees",
                  .errorName = "root mean square over the sphere",
                  .errorUnit = "of the highlight",
                  .reference = "the reflection's highlight in double on the analytic sphere",
                  .alternatives = Alternatives::setting};
    const int side = bench.isQuick() ? 64 : 256;
    Result<gpu::Target> target = gpu::Target::window(capabilities, side, side, gpu::TexelFormat::rgba32f);
    if (!target) return std::move(target.diagnostics);
    struct Row {
        Highlight model;
        double factor;
        std::string name;
    };
    for (const Row& row :
         {Row{Highlight::reflection, 1, "reflection"}, Row{Highlight::halfVector, 1, "half vector"},
          Row{Highlight::halfVector, 4, "half vector, exponent times 4"}}) {
        Result<gpu::Program> program = highlightProgram(capabilities, row.model);
        if (!program) return std::move(program.diagnostics);
        Curve curve{.name = row.name};
        for (const double angle : {10., 30., 50., 70., 90., 110., 130., 150.}) {
            const glm::dvec3 light = lightAt(angle);
            const Result<double> error =
                highlightError(capabilities, *program, *target, light, kExponent * row.factor,
                               highlights(side, light, kExponent));
            if (!error) return error.diagnostics;
            curve.points.push_back({.setting = angle,
                                    .label = fmt::format("{} degrees", angle),
                                    .error = *error,
                                    .time = bench.time([&] {
                                        target->bind();
                                        drawWhole(*program);
                                        glFinish();
                                    }),
                                    .memory = targetBytes(*target)});
        }
        figure.curves.push_back(std::move(curve));
    }
    const auto medianOf = [&](std::size_t curve) { return figure.curves[curve].points[1].time->median; };
    figure.findings.push_back(fmt::format("a frame by the half vector takes {:.2f} times that by reflection",
                                          medianOf(1) / medianOf(0)));
    return figure;
}

}  // namespace

Result<std::vector<Figure>> measureLighting(Bench& bench) {
    const Result<gpu::Context*> context = bench.context();
    if (!context) return context.diagnostics;
    return measureEach(
        {surfaceFigure<LitSurface::sphere>, surfaceFigure<LitSurface::torus>, halfVectorFigure, modelFigure},
        bench, (*context)->capabilities());
}

}  // namespace glibra::bench
