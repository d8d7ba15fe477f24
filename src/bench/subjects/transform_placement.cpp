// Points of an object seen by a nearby camera, both far from the origin or both small.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/ext/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <utility>

#include "bench/core/exact.h"
#include "bench/core/fit.h"
#include "bench/draw/offscreen.h"
#include "bench/draw/shader_values.h"
#include "bench/subjects/transforms.h"

namespace glibra::bench {
namespace {

constexpr int kPoints = 1024;

/// eye space = turnView * (turnModel * (size * p) + place - eye); p is in a cube of side 2.
struct Placement {
    glm::dmat3 turnModel, turnView;
    glm::dvec3 place{0}, eye{0};
    double size = 1;

    Placement(double distance, double objectSize) : size(objectSize) {
        turnModel = glm::dmat3(glm::rotate(glm::dmat4(1), .7, glm::dvec3(.3, 1, .2)));
        turnView = glm::dmat3(glm::rotate(glm::dmat4(1), -1.1, glm::dvec3(1, .4, -.1)));
        place = distance * glm::dvec3(1, 1. / 3, -1. / 7);
        eye = place + objectSize * glm::dvec3(.5, 1.3, 5);
    }

    template <class Number>
    [[nodiscard]] glm::mat<4, 4, Number> model() const {
        using Vector = glm::vec<3, Number>;
        using Matrix = glm::mat<4, 4, Number>;
        return glm::scale(
            glm::translate(Matrix(1), Vector(place)) * Matrix(glm::mat<3, 3, Number>(turnModel)),
            Vector(static_cast<Number>(size)));
    }
    template <class Number>
    [[nodiscard]] glm::mat<4, 4, Number> view() const {
        return glm::translate(glm::mat<4, 4, Number>(glm::mat<3, 3, Number>(turnView)),
                              -glm::vec<3, Number>(eye));
    }
};

/// Low-discrepancy points (Roberts, The Unreasonable Effectiveness of Quasirandom Sequences, 2018).
std::vector<glm::vec3> cubePoints() {
    std::vector<glm::vec3> points;
    for (int i = 0; i < kPoints; ++i) {
        const glm::dvec3 place = glm::fract(glm::dvec3(.8191725134, .6710436067, .5497004779) * (i + .5));
        points.emplace_back(2. * place - 1.);
    }
    return points;
}

std::vector<ExactVector> exactResults(const Placement& placement, const std::vector<glm::vec3>& points) {
    const ExactMatrix model = exact(placement.turnModel), view = exact(placement.turnView);
    const ExactVector apart = exact(placement.place) - exact(placement.eye);
    std::vector<ExactVector> results;
    results.reserve(points.size());
    for (const glm::vec3& p : points)
        results.push_back(view * (model * (Exact(placement.size) * exact(glm::dvec3(p))) + apart));
    return results;
}

using Results = std::vector<glm::dvec3>;

double largestError(const std::vector<ExactVector>& truth, const Results& results, double size) {
    double largest = 0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        largest = std::max(largest, distance(truth[i], results[i]) / size);
    return largest;
}

struct PlacementMethod {
    const char* name;
    void (*transform)(const Placement&, const std::vector<glm::vec3>&, Results&);
};

template <class Number>
void transformPoints(const glm::mat<4, 4, Number>& matrix, const std::vector<glm::vec3>& points,
                     Results& results) {
    for (std::size_t i = 0; i < points.size(); ++i)
        results[i] = glm::dvec3(matrix * glm::vec<4, Number>(points[i], 1));
}

constexpr PlacementMethod kPlacementMethods[] = {
    {"CPU, float matrices",
     [](const Placement& placement, const std::vector<glm::vec3>& points, Results& results) {
         transformPoints(placement.view<float>() * placement.model<float>(), points, results);
     }},
    {"CPU, product in double, rounded once",
     [](const Placement& placement, const std::vector<glm::vec3>& points, Results& results) {
         transformPoints(glm::mat4(placement.view<double>() * placement.model<double>()), points, results);
     }},
    {"CPU, double",
     [](const Placement& placement, const std::vector<glm::vec3>& points, Results& results) {
         transformPoints(placement.view<double>() * placement.model<double>(), points, results);
     }},
};

struct PlacementShader {
    const char* name;
    const char* glsl;
    bool isDouble;
};

constexpr PlacementShader kPlacementShaders[] = {
    {"shader, model then view",
     "uniform mat4 uFirst, uSecond;\n"
     "vec4 value() { return uSecond * (uFirst * vec4(given(0).xyz, 1.)); }\n",
     false},
    {"shader, product in double, rounded once",
     "uniform mat4 uFirst;\n"
     "vec4 value() { return uFirst * vec4(given(0).xyz, 1.); }\n",
     false},
    {"shader, double",
     "uniform dmat4 uFirst, uSecond;\n"
     "uniform int uHalf;\n"
     "vec4 value() {\n"
     "    dvec4 p = uSecond * (uFirst * dvec4(given(0).xyz, 1.));\n"
     "    precise vec4 high = vec4(p);\n"  // Mesa 25 takes dvec4(vec4(p)) for p otherwise
     "    precise dvec4 rest = p - dvec4(high);\n"
     "    return uHalf == 0 ? high : vec4(rest);\n"
     "}\n",
     true},
};

void setMatrices(const PlacementShader& method, const gpu::Program& program, const Placement& placement) {
    program.use();
    const GLint first = glGetUniformLocation(program.id(), "uFirst"),
                second = glGetUniformLocation(program.id(), "uSecond");
    const glm::dmat4 model = placement.model<double>(), view = placement.view<double>();
    if (method.isDouble) {
        glUniformMatrix4dv(first, 1, GL_FALSE, &model[0][0]);
        glUniformMatrix4dv(second, 1, GL_FALSE, &view[0][0]);
        return;
    }
    const bool isProduct = second < 0;
    const glm::mat4 one(isProduct ? view * model : model), other(view);
    glUniformMatrix4fv(first, 1, GL_FALSE, &one[0][0]);
    if (!isProduct) glUniformMatrix4fv(second, 1, GL_FALSE, &other[0][0]);
}

Result<Results> shaderResults(const PlacementShader& method, const ShaderValues& shader) {
    Results results(kPoints, glm::dvec3(0));
    for (int half = 0; half < (method.isDouble ? 2 : 1); ++half) {
        setInt(shader.program(), "uHalf", half);
        const Result<std::vector<Four>> values = shader.values();
        if (!values) return values.diagnostics;
        for (std::size_t i = 0; i < results.size(); ++i)
            results[i] += glm::dvec3((*values)[i][0], (*values)[i][1], (*values)[i][2]);
    }
    return results;
}

using PlacementOf = std::function<Placement(double setting)>;
using Settings = std::vector<std::pair<double, std::string>>;

Curve cpuPlacementCurve(const Bench& bench, const PlacementMethod& method, const Settings& settings,
                        const PlacementOf& placementOf) {
    const std::vector<glm::vec3> points = cubePoints();
    Results results(points.size());
    Curve curve{method.name, {}};
    for (const auto& [setting, label] : settings) {
        const Placement placement = placementOf(setting);
        method.transform(placement, points, results);
        curve.points.push_back(
            {.setting = setting,
             .label = label,
             .error = largestError(exactResults(placement, points), results, placement.size),
             .time = bench.time([&] { method.transform(placement, points, results); }),
             .memory = static_cast<double>(points.size() * (sizeof(points[0]) + sizeof(results[0])))});
    }
    return curve;
}

Result<Curve> shaderPlacementCurve(Bench& bench, const PlacementShader& method, const Settings& settings,
                                   const PlacementOf& placementOf) {
    const std::vector<glm::vec3> points = cubePoints();
    std::vector<Four> inputs;
    inputs.reserve(points.size());
    for (const glm::vec3& p : points) inputs.push_back({p.x, p.y, p.z, 1});
    const Result<ShaderValues> shader = ShaderValues::create(bench, method.glsl, inputs);
    if (!shader) return shader.diagnostics;
    Curve curve{method.name, {}};
    for (const auto& [setting, label] : settings) {
        const Placement placement = placementOf(setting);
        setMatrices(method, shader->program(), placement);
        const Result<Results> results = shaderResults(method, *shader);
        if (!results) return results.diagnostics;
        curve.points.push_back(
            {.setting = setting,
             .label = label,
             .error = largestError(exactResults(placement, points), *results, placement.size),
             .time = bench.time([&] { shader->compute(); }),
             .memory = shader->bytes()});
    }
    return curve;
}

}  // namespace

Figure placementFigure(Bench& bench, bool byDistance, Diagnostics& problems) {
    Figure figure;
    figure.name = byDistance ? "distance" : "size";
    figure.title =
        byDistance ? "Object and camera far from the origin" : "Objects of all sizes near the origin";
    figure.settingName = byDistance ? "distance from the origin in sizes of the object"
                                    : "size of an object at distance 1 from the origin";
    figure.errorName = "largest error in eye space";
    figure.errorUnit = "sizes";
    figure.reference =
        "the same positions with 100 digits (Boost.Multiprecision) from the same numbers; 1024 points";
    figure.alternatives = Alternatives::setting;

    const int first = byDistance ? 0 : -6, last = byDistance ? 7 : 6, step = bench.isQuick() ? 3 : 1;
    Settings settings;
    for (int decade = first; decade <= last; decade += step)
        settings.emplace_back(std::pow(10., decade),
                              fmt::format("{} 1e{}", byDistance ? "distance" : "size", decade));
    const PlacementOf placementOf = [&](double setting) {
        return byDistance ? Placement(setting, 1) : Placement(1, setting);
    };
    for (const PlacementMethod& method : kPlacementMethods) {
        figure.curves.push_back(cpuPlacementCurve(bench, method, settings, placementOf));
        figure.curves.back().isForScenes = false;
    }
    for (const PlacementShader& method : kPlacementShaders) {
        Result<Curve> curve = shaderPlacementCurve(bench, method, settings, placementOf);
        append(problems, std::move(curve.diagnostics));
        if (curve) figure.curves.push_back(std::move(*curve));
    }

    const Curve &floats = figure.curves[0], &once = figure.curves[1];
    const Point &worst = byDistance ? floats.points.back() : floats.points.front(),
                &saved = byDistance ? once.points.back() : once.points.front();
    for (const Curve& curve : figure.curves)
        figure.findings.push_back(byDistance ? orderSentence(curve, "distance", 10)
                                             : orderSentence(curve, "size", 0, .2));
    figure.findings.push_back(fmt::format(
        "at {}, float matrices are {} sizes off; the product made in double and rounded once, as "
        "for every scene, {} sizes: {:.2g} times better",
        worst.label, numberText(worst.error), numberText(saved.error), worst.error / saved.error));
    return figure;
}

}  // namespace glibra::bench
