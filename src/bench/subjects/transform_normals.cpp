// Normals under scales that differ by axis.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <utility>

#include "bench/core/exact.h"
#include "bench/core/fit.h"
#include "bench/draw/shader_values.h"
#include "bench/reference/triangle_net.h"
#include "bench/subjects/transforms.h"

namespace glibra::bench {
namespace {

constexpr int kNormals = 512;

/// Rotates an object, scales it by 1, sqrt(ratio) and ratio along its axes, and rotates it again.
glm::dmat3 modelOf(double ratio) {
    const glm::dmat3 first(glm::rotate(glm::dmat4(1), .6, glm::dvec3(1, -.3, .8))),
        second(glm::rotate(glm::dmat4(1), 2.1, glm::dvec3(.2, 1, .5)));
    glm::dmat3 scale(1);
    scale[1][1] = std::sqrt(ratio);
    scale[2][2] = ratio;
    return first * scale * second;
}

/// Normals spread over the sphere (Fibonacci lattice), as floats, as in a mesh.
std::vector<glm::vec3> normals() {
    std::vector<glm::vec3> all;
    for (int i = 0; i < kNormals; ++i) {
        const double z = 1 - (2 * i + 1.) / kNormals, around = 2 * std::numbers::pi * i * std::numbers::phi;
        const double across = std::sqrt(1 - z * z);
        all.emplace_back(across * std::cos(around), across * std::sin(around), z);
    }
    return all;
}

/// Cofactors: the inverse transpose up to a factor, without a division.
template <class Number>
glm::mat<3, 3, Number> cofactors(const glm::mat<3, 3, Number>& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

ExactMatrix exactCofactors(const ExactMatrix& m) {
    return {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
}

struct NormalMethod {
    const char* name;
    glm::mat3 (*matrix)(const glm::dmat3& model);
};

constexpr NormalMethod kNormalMethods[] = {
    {"the model matrix itself", [](const glm::dmat3& model) { return glm::mat3(model); }},
    {"float inverse transpose",
     [](const glm::dmat3& model) { return glm::transpose(glm::inverse(glm::mat3(model))); }},
    {"float cofactors", [](const glm::dmat3& model) { return cofactors(glm::mat3(model)); }},
    {"double inverse transpose, rounded once",
     [](const glm::dmat3& model) { return glm::mat3(glm::transpose(glm::inverse(model))); }},
    {"double cofactors, rounded once", [](const glm::dmat3& model) { return glm::mat3(cofactors(model)); }},
};

constexpr const char* kNormalShader = R"(uniform mat3 uModel;
vec4 value() { return vec4(normalize(transpose(inverse(uModel)) * given(0).xyz), 0.); }
)";

/// The exact normals, in the order of normals().
std::vector<ExactVector> exactNormals(const glm::dmat3& model) {
    const ExactMatrix matrix = exactCofactors(exact(model));
    std::vector<ExactVector> all;
    for (const glm::vec3& normal : normals()) all.push_back(matrix * exact(glm::dvec3(normal)));
    return all;
}

Point normalsPoint(double ratio, double error, const Timing& time, double bytes) {
    return {.setting = ratio,
            .label = fmt::format("1 : {:.0f}", ratio),
            .error = error,
            .time = time,
            .memory = bytes};
}

void transformNormals(const NormalMethod& method, const glm::dmat3& model, const std::vector<glm::vec3>& all,
                      std::vector<glm::vec3>& results) {
    const glm::mat3 matrix = method.matrix(model);
    for (std::size_t i = 0; i < all.size(); ++i) results[i] = glm::normalize(matrix * all[i]);
}

Result<Curve> shaderNormalsCurve(Bench& bench, const std::vector<double>& ratios) {
    std::vector<Four> inputs;
    for (const glm::vec3& each : normals()) inputs.push_back({each.x, each.y, each.z, 0});
    const Result<ShaderValues> shader = ShaderValues::create(bench, kNormalShader, inputs);
    if (!shader) return shader.diagnostics;
    Curve curve{"shader, inverse transpose", {}};
    for (const double ratio : ratios) {
        const glm::mat3 model(modelOf(ratio));
        shader->program().use();
        glUniformMatrix3fv(glGetUniformLocation(shader->program().id(), "uModel"), 1, GL_FALSE, &model[0][0]);
        const Result<std::vector<Four>> values = shader->values();
        if (!values) return values.diagnostics;
        const std::vector<ExactVector> truth = exactNormals(modelOf(ratio));
        double largest = 0;
        for (std::size_t i = 0; i < truth.size(); ++i)
            largest = std::max(largest,
                               degreesBetween(truth[i], {(*values)[i][0], (*values)[i][1], (*values)[i][2]}));
        curve.points.push_back(
            normalsPoint(ratio, largest, bench.time([&] { shader->compute(); }), shader->bytes()));
    }
    return curve;
}

}  // namespace

Figure normalMatrixFigure(Bench& bench, Diagnostics& problems) {
    Figure figure;
    figure.name = "normal-matrix";
    figure.title = "Normals of objects scaled unevenly";
    figure.settingName = "largest scale over smallest";
    figure.errorName = "largest angle";
    figure.errorUnit = "degrees";
    figure.reference =
        "the cofactor matrix of the same double matrix with 100 digits (Boost.Multiprecision); 512 normals";
    figure.alternatives = Alternatives::setting;
    const std::vector<double> ratios =
        bench.isQuick() ? std::vector{1., 30., 1000.} : std::vector{1., 3., 10., 30., 100., 300., 1000.};
    const std::vector<glm::vec3> all = normals();
    std::vector<glm::vec3> results(all.size());
    for (const NormalMethod& method : kNormalMethods) {
        Curve& curve = figure.curves.emplace_back(Curve{method.name, {}});
        for (const double ratio : ratios) {
            const glm::dmat3 model = modelOf(ratio);
            const std::vector<ExactVector> truth = exactNormals(model);
            transformNormals(method, model, all, results);
            double largest = 0;
            for (std::size_t i = 0; i < truth.size(); ++i)
                largest = std::max(largest, degreesBetween(truth[i], glm::dvec3(results[i])));
            curve.points.push_back(normalsPoint(
                ratio, largest, bench.time([&] { transformNormals(method, model, all, results); }),
                static_cast<double>(2 * all.size() * sizeof(all[0]) + sizeof(glm::mat3))));
        }
    }
    Result<Curve> shader = shaderNormalsCurve(bench, ratios);
    append(problems, std::move(shader.diagnostics));
    if (shader) figure.curves.push_back(std::move(*shader));
    for (std::size_t i = 1; i < figure.curves.size(); ++i)
        figure.findings.push_back(orderSentence(figure.curves[i], "ratio", 10));
    const auto at = [&](std::size_t curve) { return figure.curves[curve].points.back().error; };
    figure.findings.push_back(fmt::format(
        "at {}: the model matrix itself is {} degrees off, the inverse transpose in float {}, in double and "
        "rounded once {}",
        figure.curves[0].points.back().label, numberText(at(0)), numberText(at(1)), numberText(at(3))));
    return figure;
}

}  // namespace glibra::bench
