#include "render/supplied.h"

#include "scene/matrices.h"

namespace glibra::render {
namespace {

template <int N>
std::vector<double> numbers(const glm::mat<N, N, double>& matrix) {
    std::vector<double> values;
    for (int column = 0; column < N; ++column)
        for (int row = 0; row < N; ++row) values.push_back(matrix[column][row]);
    return values;
}

/// Without an interface every texture matrix, its inverse and its transpose are the identity.
std::vector<double> identities(int elements) {
    std::vector<double> values;
    const std::vector<double> one = numbers<4>(glm::dmat4(1.0));
    for (int i = 0; i < elements; ++i) values.insert(values.end(), one.begin(), one.end());
    return values;
}

}  // namespace

std::vector<double> suppliedValue(glsl::Builtin builtin, const DrawFacts& facts, int elements) {
    using glsl::Builtin;
    // In floats a matrix whose inverse they cannot hold is a singular one.
    const auto inverse = [](const glm::dmat4& m) {
        const glm::dmat4 inverted = scene::inverseOrZero(m);
        return scene::isFinite(inverted) ? inverted : glm::dmat4(0.0);
    };
    const auto modelViewProjection = [&] { return facts.projection * facts.modelView; };
    switch (builtin) {
        case Builtin::timer:
            return {facts.timer};
        case Builtin::noise2:
        case Builtin::noise3:
            return {};  // samplers: the plan chose their units
        case Builtin::modelView:
            return numbers<4>(facts.modelView);
        case Builtin::projection:
            return numbers<4>(facts.projection);
        case Builtin::modelViewProjection:
            return numbers<4>(modelViewProjection());
        case Builtin::normalMatrix:
            return numbers<3>(scene::normalMatrix(facts.modelView));
        case Builtin::modelViewInverse:
            return numbers<4>(inverse(facts.modelView));
        case Builtin::modelViewTranspose:
            return numbers<4>(glm::transpose(facts.modelView));
        case Builtin::modelViewInverseTranspose:
            return numbers<4>(glm::transpose(inverse(facts.modelView)));
        case Builtin::projectionInverse:
            return numbers<4>(inverse(facts.projection));
        case Builtin::projectionTranspose:
            return numbers<4>(glm::transpose(facts.projection));
        case Builtin::projectionInverseTranspose:
            return numbers<4>(glm::transpose(inverse(facts.projection)));
        case Builtin::modelViewProjectionInverse:
            return numbers<4>(inverse(modelViewProjection()));
        case Builtin::modelViewProjectionTranspose:
            return numbers<4>(glm::transpose(modelViewProjection()));
        case Builtin::modelViewProjectionInverseTranspose:
            return numbers<4>(glm::transpose(inverse(modelViewProjection())));
        case Builtin::textureMatrix:
        case Builtin::textureMatrixInverse:
        case Builtin::textureMatrixTranspose:
        case Builtin::textureMatrixInverseTranspose:
            return identities(elements);
        case Builtin::currentColor:
            return {facts.color.r, facts.color.g, facts.color.b, facts.color.a};
        case Builtin::pointSize:
            return {facts.pointSize};
    }
    return {};
}

}  // namespace glibra::render
