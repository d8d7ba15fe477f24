#pragma once
// The values that the runtime supplies to shaders by name (language, section 6): one table row a name.

#include <span>
#include <string_view>

namespace glibra::glsl {

/// What a built-in uniform holds. Matrix values are filled a draw, the others when they change.
enum class Builtin {
    timer,
    noise2,
    noise3,
    modelView,
    projection,
    modelViewProjection,
    normalMatrix,
    modelViewInverse,
    modelViewTranspose,
    modelViewInverseTranspose,
    projectionInverse,
    projectionTranspose,
    projectionInverseTranspose,
    modelViewProjectionInverse,
    modelViewProjectionTranspose,
    modelViewProjectionInverseTranspose,
    textureMatrix,
    textureMatrixInverse,
    textureMatrixTranspose,
    textureMatrixInverseTranspose,
    currentColor,  ///< gl_Color in a fragment stage that no earlier stage feeds
    pointSize,     ///< gl_Point.size
};

/// A uniform name as it appears in a linked program, its GLSL type and what fills it.
struct BuiltinUniform {
    std::string_view name;  ///< "uModelViewMatrix", "glibra_ProjectionMatrixInverse", "Timer", ...
    std::string_view type;  ///< GLSL type word: a user's declaration with another type is an ordinary uniform
    Builtin value;
};

/// A vertex input name as it appears in a linked program and the mesh attribute that feeds it.
struct BuiltinInput {
    std::string_view name;  ///< "aVertex", "glibra_Vertex", "aTexCoord0", "Tangent", "aFaceIndex", ...
    std::string_view
        attribute;  ///< geometry's attribute name ("position", ...); empty: constant (0, 0, 0, 1)
};

/// Every name once; the *TextureMatrix* names are arrays of 8, of which element 0 counts and the others are
/// identities.
std::span<const BuiltinUniform> builtinUniforms();
std::span<const BuiltinInput> builtinInputs();

/// The row of a name as emitted ("glibra_NormalMatrix") or as the user writes it ("gl_NormalMatrix"), or
/// null.
const BuiltinUniform* findBuiltinUniform(std::string_view name);
const BuiltinInput* findBuiltinInput(std::string_view name);

// What else the runtime does for translated programs:
// - compares names with these tables as the linked program spells them, before TranslatedProgram::userNames
// is applied;
// - binds inputs by the locations of the linked program (the translator gives none); inputs of int type
//   (FaceIndex) take integer attributes; a missing attribute reads (0, 0, 0, 1);
// - feeds glibra_CurrentColor, glibra_PointSize like the other uniforms, where the linked program has them;
// - sets uniforms without initialiser to 0, leaves those with one (GLSL initialisers stay in the source);
// - applies TranslatedProgram::textureBindings where no tag says otherwise, at every target;
// - leaves the tessellation levels at GL's initial 1 for programs without control stage;
// - enables the clip distances and draw buffers that TranslatedProgram counts.

}  // namespace glibra::glsl
