#pragma once
// The values that the runtime supplies to shaders by name (language, 6): one table row per name.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace glibra::glsl {

/// The value of a built-in uniform. Matrices are set per draw, other values when they change.
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
    currentColor,  ///< gl_Color in a fragment stage if no earlier stage writes it
    pointSize,     ///< gl_Point.size
    // Only well-known names have these:
    model,  ///< the product of the transforms below the camera
    modelInverse,
    modelInverseTranspose,  ///< 4 x 4; for normals in world space
    modelNormalMatrix,      ///< the inverse transpose of the upper left 3 x 3 of the model matrix
    view,                   ///< of the camera: world to eye
    viewInverse,
    viewProjection,  ///< projection * view
    eyePosition,     ///< of the camera, in world space
};

/// The name of a uniform as it appears in a linked program, its GLSL type and its value.
struct BuiltinUniform {
    std::string_view name;  ///< "uModelViewMatrix", "glibra_ProjectionMatrixInverse", "Timer", ...
    std::string_view
        type;  ///< GLSL type word. A uniform that the user declares with another type is an ordinary one.
    Builtin value;
};

/// The name of a vertex input as it appears in a linked program, and the mesh attribute that it reads.
struct BuiltinInput {
    std::string_view name;  ///< "aVertex", "glibra_Vertex", "aTexCoord0", "Tangent", "aFaceIndex", ...
    /// The attribute's name in geometry ("position", ...); empty: the input is constant (0, 0, 0, 1).
    std::string_view attribute;
};

/// The name as emitted ("glibra_NormalMatrix") of a name as the user writes it ("gl_NormalMatrix").
std::string emittedName(std::string_view name);

/// Every name once. The *TextureMatrix* names are arrays of 8 matrices: element 0 has the value, the others
/// are identities.
std::span<const BuiltinUniform> builtinUniforms();
std::span<const BuiltinInput> builtinInputs();

/// The row of a name as emitted ("glibra_NormalMatrix") or as the user writes it ("gl_NormalMatrix"); null
/// for other names.
const BuiltinUniform* findBuiltinUniform(std::string_view name);
const BuiltinInput* findBuiltinInput(std::string_view name);

// Names that books and frameworks give the same values, in any case, with and without underscores, prefixes
// and the word matrix. They count only in scenes with modern statements, and only if the scene binds nothing
// of that name. Names of the tables above are none of them.

/// The value of a uniform of this name ("mv_matrix", "u_modelView", "normalMatrix") and GLSL type.
/// `isUniform` says whether the program has a uniform of a name; null: it has no others.
std::optional<Builtin> wellKnownUniform(std::string_view name, std::string_view type,
                                        const std::function<bool(std::string_view)>& isUniform = {});
/// The attribute of a vertex input of this name ("vertPos", "aTexCoords", "in_normal") and GLSL type:
/// "position", "normal", "texCoord", "color" or "tangent" in geometry; empty for other names and types.
std::string_view wellKnownAttribute(std::string_view name, std::string_view type);
/// The name that may have been meant by one that is none, with the same prefix; empty if none is near.
std::string inputNear(std::string_view name, std::string_view type);

// The runtime does the following for translated programs:
// - It compares names with these tables as the linked program spells them, before it applies
//   TranslatedProgram::userNames.
// - It binds inputs by the locations of the linked program, because the translator gives none. Inputs of type
// int
//   (FaceIndex) take integer attributes. A missing attribute reads (0, 0, 0, 1).
// - It sets glibra_CurrentColor and glibra_PointSize like the other uniforms, where the linked program has
// them.
// - It sets uniforms without an initialiser to 0 and leaves those with one (GLSL initialisers stay in the
// source).
// - It applies TranslatedProgram::textureBindings at every target, unless a tag gives another unit.
// - It leaves the tessellation levels at GL's initial 1 for programs without a control stage.
// - It enables the clip distances and draw buffers that TranslatedProgram counts.

}  // namespace glibra::glsl
