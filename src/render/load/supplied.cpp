#include "render/load/supplied.h"

#include "scene/view.h"

namespace glibra::render {
namespace {

template <int N>
void addMatrix(const glm::mat<N, N, double>& matrix, SuppliedNumbers& to) {
    for (int column = 0; column < N; ++column)
        for (int row = 0; row < N; ++row) to.add(matrix[column][row]);
}

template <int N>
SuppliedNumbers numbers(const glm::mat<N, N, double>& matrix) {
    SuppliedNumbers values;
    addMatrix(matrix, values);
    return values;
}

/// The first texture matrix is the window's; the others are the identity.
SuppliedNumbers textureMatrices(const glm::dmat4& first, int elements) {
    SuppliedNumbers values = numbers<4>(first);
    for (int i = 1; i < elements; ++i) addMatrix(glm::dmat4(1.0), values);
    return values;
}

}  // namespace

SuppliedNumbers suppliedValue(glsl::Builtin builtin, const DrawFacts& facts, int elements) {
    using glsl::Builtin;
    // A matrix whose inverse overflows a float counts as singular.
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
            return {};  // samplers: the plan chooses their units
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
            return textureMatrices(facts.texture, elements);
        case Builtin::textureMatrixInverse:
            return textureMatrices(inverse(facts.texture), elements);
        case Builtin::textureMatrixTranspose:
            return textureMatrices(glm::transpose(facts.texture), elements);
        case Builtin::textureMatrixInverseTranspose:
            return textureMatrices(glm::transpose(inverse(facts.texture)), elements);
        case Builtin::currentColor:
            return {facts.color.r, facts.color.g, facts.color.b, facts.color.a};
        case Builtin::pointSize:
            return {facts.pointSize};
        case Builtin::model:
            return numbers<4>(facts.model);
        case Builtin::modelInverse:
            return numbers<4>(inverse(facts.model));
        case Builtin::modelInverseTranspose:
            return numbers<4>(glm::transpose(inverse(facts.model)));
        case Builtin::modelNormalMatrix:
            return numbers<3>(scene::normalMatrix(facts.model));
        case Builtin::view:
            return numbers<4>(facts.view);
        case Builtin::viewInverse:
            return numbers<4>(inverse(facts.view));
        case Builtin::viewProjection:
            return numbers<4>(facts.projection * facts.view);
        case Builtin::eyePosition: {
            const glm::dvec4 eye = inverse(facts.view)[3];
            return {eye.x, eye.y, eye.z};
        }
    }
    return {};
}

}  // namespace glibra::render
