// A rotation by a bit more than one degree, applied again and again.

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/ext/quaternion_double.hpp>
#include <glm/ext/quaternion_float.hpp>
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "base/text.h"
#include "bench/core/exact.h"
#include "bench/core/fit.h"
#include "bench/draw/offscreen.h"
#include "bench/draw/shader_values.h"
#include "bench/subjects/transforms.h"

namespace glibra::bench {
namespace {

constexpr double kTurn = .0179;  ///< radians
const glm::dvec3 kAxis(1, 2, 3);

/// The rotation by `count` steps with 100 digits (Rodrigues' formula).
ExactMatrix exactRotation(int count) {
    const Exact angle = Exact(kTurn) * count, c = cos(angle), s = sin(angle);
    const ExactVector direction = exact(kAxis);
    const ExactVector k = (1 / length(direction)) * direction;
    ExactMatrix m;
    for (std::size_t column = 0; column < 3; ++column)
        for (std::size_t row = 0; row < 3; ++row) m[column][row] = (1 - c) * k[column] * k[row];
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
        m[i][i] += c;
        m[i][next] += s * k[last];
        m[i][last] -= s * k[next];
    }
    return m;
}

double largestEntryError(const ExactMatrix& truth, const glm::dmat3& matrix) {
    Exact largest = 0;
    for (std::size_t column = 0; column < 3; ++column)
        for (std::size_t row = 0; row < 3; ++row) {
            const double entry = matrix[static_cast<glm::length_t>(column)][static_cast<glm::length_t>(row)];
            largest = std::max<Exact>(largest, abs(truth[column][row] - entry));
        }
    return static_cast<double>(largest);
}

template <class Number>
glm::mat<3, 3, Number> rotation(Number angle) {
    return glm::mat<3, 3, Number>(glm::rotate(glm::mat<4, 4, Number>(1), angle, glm::vec<3, Number>(kAxis)));
}

template <class Number>
glm::dmat3 multipliedMatrices(int count) {
    const glm::mat<3, 3, Number> step = rotation<Number>(static_cast<Number>(kTurn));
    glm::mat<3, 3, Number> m(1);
    for (int i = 0; i < count; ++i) m = step * m;
    return glm::dmat3(m);
}

/// Gram-Schmidt orthogonalisation after every step.
glm::dmat3 orthonormalised(int count) {
    const glm::mat3 step = rotation<float>(static_cast<float>(kTurn));
    glm::mat3 m(1);
    for (int i = 0; i < count; ++i) {
        m = step * m;
        m[0] = glm::normalize(m[0]);
        m[1] = glm::normalize(m[1] - glm::dot(m[0], m[1]) * m[0]);
        m[2] = glm::cross(m[0], m[1]);
    }
    return glm::dmat3(m);
}

glm::dmat3 quaternions(int count) {
    const glm::quat step = glm::angleAxis(static_cast<float>(kTurn), glm::normalize(glm::vec3(kAxis)));
    glm::quat q(1, 0, 0, 0);
    for (int i = 0; i < count; ++i) q = glm::normalize(step * q);
    return glm::dmat3(glm::mat3_cast(q));
}

glm::dmat3 summedAngle(int count) {
    float angle = 0;
    for (int i = 0; i < count; ++i) angle += static_cast<float>(kTurn);
    return glm::dmat3(rotation<float>(angle));
}

template <class Number>
glm::dmat3 computedAngle(int count) {
    return glm::dmat3(rotation<Number>(static_cast<Number>(count) * static_cast<Number>(kTurn)));
}

/// In double, reduced to one turn, and rounded once.
glm::dmat3 roundedOnce(int count) {
    return glm::dmat3(glm::mat3(rotation<double>(count * kTurn)));
}

struct ChainMethod {
    const char* name;
    glm::dmat3 (*rotate)(int count);
    std::size_t bytes;  ///< of the state between two rotations
};

constexpr ChainMethod kChainMethods[] = {
    {"float matrices multiplied", multipliedMatrices<float>, sizeof(glm::mat3)},
    {"float, orthonormalised each time", orthonormalised, sizeof(glm::mat3)},
    {"float quaternions", quaternions, sizeof(glm::quat)},
    {"float, angle summed up", summedAngle, sizeof(float)},
    {"float, angle = i * step", computedAngle<float>, sizeof(int)},
    {"angle in double, matrix rounded once", roundedOnce, sizeof(int)},
    {"double matrices multiplied", multipliedMatrices<double>, sizeof(glm::dmat3)},
};

constexpr const char* kChainShader = R"(uniform mat3 uStep;
uniform int uCount;
vec4 value() {
    mat3 m = mat3(1.);
    for (int i = 0; i < uCount; ++i) m = uStep * m;
    int column = int(given(0).x);
    return vec4(m[column], 0.);
}
)";

Point chainPoint(int count, double error, const Timing& time, double bytes) {
    return {.setting = static_cast<double>(count),
            .label = base::counted(count, "rotation"),
            .error = error,
            .time = time,
            .memory = bytes};
}

Result<Curve> shaderChainCurve(Bench& bench, const std::vector<int>& counts) {
    const std::vector<Four> columns{{0, 0, 0, 0}, {1, 0, 0, 0}, {2, 0, 0, 0}};
    const Result<ShaderValues> shader = ShaderValues::create(bench, kChainShader, columns);
    if (!shader) return shader.diagnostics;
    const glm::mat3 step(rotation<double>(kTurn));
    Curve curve{"shader, float matrices multiplied", {}};
    for (const int count : counts) {
        setInt(shader->program(), "uCount", count);
        glUniformMatrix3fv(glGetUniformLocation(shader->program().id(), "uStep"), 1, GL_FALSE, &step[0][0]);
        const Result<std::vector<Four>> values = shader->values();
        if (!values) return values.diagnostics;
        glm::dmat3 matrix;
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row)
                matrix[column][row] =
                    (*values)[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)];
        curve.points.push_back(chainPoint(count, largestEntryError(exactRotation(count), matrix),
                                          bench.time([&] { shader->compute(); }), shader->bytes()));
    }
    return curve;
}

}  // namespace

Figure chainFigure(Bench& bench, Diagnostics& problems) {
    Figure figure;
    figure.name = "chain";
    figure.title = "Chained rotations";
    figure.settingName = "rotations";
    figure.errorName = "largest error of an entry";
    figure.reference =
        "one rotation by the sum of the angles with 100 digits (Rodrigues' formula, Boost.Multiprecision)";
    figure.alternatives = Alternatives::setting;
    const std::vector<int> counts =
        bench.isQuick() ? std::vector{1, 100, 10000} : std::vector{1, 3, 10, 30, 100, 300, 1000, 3000, 10000};
    for (const ChainMethod& method : kChainMethods) {
        Curve& curve = figure.curves.emplace_back(Curve{method.name, {}});
        for (const int count : counts)
            curve.points.push_back(chainPoint(
                count, largestEntryError(exactRotation(count), method.rotate(count)), bench.time([&] {
                    // The result must reach memory, otherwise the compiler removes the work.
                    const volatile double kept = method.rotate(count)[1][0];
                    static_cast<void>(kept);
                }),
                static_cast<double>(method.bytes)));
    }
    Result<Curve> shader = shaderChainCurve(bench, counts);
    append(problems, std::move(shader.diagnostics));
    if (shader) figure.curves.push_back(std::move(*shader));
    for (const Curve& curve : figure.curves) figure.findings.push_back(orderSentence(curve, "rotations", 10));
    const auto last = [&](std::size_t curve) { return figure.curves[curve].points.back().error; };
    figure.findings.push_back(fmt::format(
        "after {}: {} multiplied in float, {} from one angle in float, {} from one angle in double",
        figure.curves[0].points.back().label, numberText(last(0)), numberText(last(4)), numberText(last(5))));
    return figure;
}

}  // namespace glibra::bench
