#include "glsl/types/builtins.h"

#include <algorithm>
#include <array>
#include <vector>

#include "base/suggest.h"
#include "base/text.h"

namespace glibra::glsl {
namespace {

using enum Builtin;

constexpr std::array kUniforms = std::to_array<BuiltinUniform>({
    {"Timer", "float", timer},
    {"Noise2", "sampler2D", noise2},
    {"Noise3", "sampler3D", noise3},
    {"uModelViewMatrix", "mat4", modelView},
    {"uProjectionMatrix", "mat4", projection},
    {"uModelViewProjectionMatrix", "mat4", modelViewProjection},
    {"uNormalMatrix", "mat3", normalMatrix},
    {"uModelViewMatrixInverse", "mat4", modelViewInverse},
    {"uModelViewMatrixTranspose", "mat4", modelViewTranspose},
    {"uModelViewMatrixInverseTranspose", "mat4", modelViewInverseTranspose},
    {"glibra_ModelViewMatrix", "mat4", modelView},
    {"glibra_ProjectionMatrix", "mat4", projection},
    {"glibra_ModelViewProjectionMatrix", "mat4", modelViewProjection},
    {"glibra_NormalMatrix", "mat3", normalMatrix},
    {"glibra_ModelViewMatrixInverse", "mat4", modelViewInverse},
    {"glibra_ModelViewMatrixTranspose", "mat4", modelViewTranspose},
    {"glibra_ModelViewMatrixInverseTranspose", "mat4", modelViewInverseTranspose},
    {"glibra_ProjectionMatrixInverse", "mat4", projectionInverse},
    {"glibra_ProjectionMatrixTranspose", "mat4", projectionTranspose},
    {"glibra_ProjectionMatrixInverseTranspose", "mat4", projectionInverseTranspose},
    {"glibra_ModelViewProjectionMatrixInverse", "mat4", modelViewProjectionInverse},
    {"glibra_ModelViewProjectionMatrixTranspose", "mat4", modelViewProjectionTranspose},
    {"glibra_ModelViewProjectionMatrixInverseTranspose", "mat4", modelViewProjectionInverseTranspose},
    {"glibra_TextureMatrix", "mat4", textureMatrix},
    {"glibra_TextureMatrixInverse", "mat4", textureMatrixInverse},
    {"glibra_TextureMatrixTranspose", "mat4", textureMatrixTranspose},
    {"glibra_TextureMatrixInverseTranspose", "mat4", textureMatrixInverseTranspose},
    {"glibra_CurrentColor", "vec4", currentColor},
    {"glibra_PointSize", "float", pointSize},
});

constexpr std::array kInputs = std::to_array<BuiltinInput>({
    {"aVertex", "position"},
    {"glibra_Vertex", "position"},
    {"aNormal", "normal"},
    {"glibra_Normal", "normal"},
    {"aColor", "color"},
    {"glibra_Color", "color"},
    {"aTexCoord0", "texCoord"},
    {"glibra_MultiTexCoord0", "texCoord"},
    {"aTexCoord1", ""},
    {"glibra_MultiTexCoord1", ""},
    {"aTexCoord2", ""},
    {"glibra_MultiTexCoord2", ""},
    {"aTexCoord3", ""},
    {"glibra_MultiTexCoord3", ""},
    {"aTexCoord4", ""},
    {"glibra_MultiTexCoord4", ""},
    {"aTexCoord5", ""},
    {"glibra_MultiTexCoord5", ""},
    {"aTexCoord6", ""},
    {"glibra_MultiTexCoord6", ""},
    {"aTexCoord7", ""},
    {"glibra_MultiTexCoord7", ""},
    {"Tangent", "tangent"},
    {"aTangent", "tangent"},
    {"FaceIndex", "faceIndex"},
    {"aFaceIndex", "faceIndex"},
    {"glibra_SecondaryColor", ""},
    {"glibra_FogCoord", ""},
});

}  // namespace

std::string emittedName(std::string_view name) {
    return name.starts_with("gl_") ? "glibra_" + std::string(name.substr(3)) : std::string(name);
}

std::span<const BuiltinUniform> builtinUniforms() {
    return kUniforms;
}

std::span<const BuiltinInput> builtinInputs() {
    return kInputs;
}

const BuiltinUniform* findBuiltinUniform(std::string_view name) {
    const std::string key = emittedName(name);
    const auto* const found =
        std::ranges::find_if(kUniforms, [&](const auto& row) { return row.name == key; });
    return found == kUniforms.end() ? nullptr : found;
}

const BuiltinInput* findBuiltinInput(std::string_view name) {
    const std::string key = emittedName(name);
    const auto* const found = std::ranges::find_if(kInputs, [&](const auto& row) { return row.name == key; });
    return found == kInputs.end() ? nullptr : found;
}

// The names that books and frameworks give to what the runtime supplies.

namespace {

using enum Builtin;

bool isUpper(char letter) {
    return letter >= 'A' && letter <= 'Z';
}

/// Takes the first of the prefixes off that is a word of its own, in any case: "inPos", "in_pos" and "MCpos",
/// not "int".
std::string_view withoutPrefix(std::string_view name, std::span<const std::string_view> prefixes) {
    for (const std::string_view each : prefixes) {
        if (name.size() <= each.size() || !base::sameWord(name.substr(0, each.size()), each)) continue;
        const char last = name[each.size() - 1], next = name[each.size()];
        if (next == '_') return name.substr(each.size() + 1);
        if (isUpper(last) ? each == "mc" : isUpper(next)) return name.substr(each.size());
    }
    return name;
}

/// In lower case, without underscores.
std::string plain(std::string_view name) {
    std::string letters = base::lower(name);
    std::erase(letters, '_');
    return letters;
}

void replaceAll(std::string& text, std::string_view what, std::string_view by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
}

/// What is left of "u_modelViewMatrix", "ModelViewMat" and "modelview" is the same.
std::string plainUniform(std::string_view name) {
    constexpr std::string_view kPrefixes[] = {"u"};
    std::string letters = plain(withoutPrefix(name, kPrefixes));
    replaceAll(letters, "matrix", "");
    replaceAll(letters, "inverse", "inv");
    if (letters.ends_with("mat")) letters.resize(letters.size() - 3);
    return letters;
}

/// What is left of "in_position" and "aVertexPosition" is "position" and "Position".
std::string_view ownWordOfInput(std::string_view name) {
    constexpr std::string_view kPrefixes[] = {"in", "a", "v", "mc"}, kOwners[] = {"vertex", "vert"};
    return withoutPrefix(withoutPrefix(name, kPrefixes), kOwners);
}

/// A value's names as plainUniform() makes them, with blanks around each.
struct UniformNames {
    Builtin value;
    std::string_view type, names;
};

constexpr UniformNames kUniformNames[] = {
    {modelView, "mat4", " mv modelview "},
    {projection, "mat4", " p proj projection "},
    {modelViewProjection, "mat4", " mvp modelviewprojection worldviewprojection "},
    {model, "mat4", " m model modeltoworld world "},
    {view, "mat4", " v view "},
    {viewProjection, "mat4", " vp viewproj viewprojection "},
    {viewInverse, "mat4", " invview viewinv "},
    {modelInverse, "mat4", " invmodel modelinv "},
    {modelViewProjectionInverse, "mat4", " invmvp modelviewprojectioninv "},
    {projectionInverse, "mat4", " invproj invprojection projectioninv "},
    {modelInverseTranspose, "mat4", " invtrmodel modelinvtranspose invtransposemodel worldinvtranspose "},
    {modelNormalMatrix, "mat3", " invtrmodel modelnormal worldnormal "},
    {normalMatrix, "mat3", " n norm normal invtr "},
    {modelViewInverseTranspose, "mat4", " n norm normal invtr modelviewinvtranspose "},
    {eyePosition, "vec3", " viewpos viewposition camerapos cameraposition campos eyepos eyeposition "},
};

/// An attribute of a mesh, its plain names without prefixes, with blanks around each, and the types that can
/// take it: floats, the first one with all its components.
struct InputNames {
    std::string_view attribute, names;
    std::span<const std::string_view> types;
};

// A texture coordinate or colour may be read with fewer components than the mesh has. A normal or tangent
// that is read as a vec4 has w = 1, as GL fills it.
constexpr std::array<std::string_view, 3> kPositionTypes{"vec4", "vec3", "vec2"};
constexpr std::array<std::string_view, 2> kDirectionTypes{"vec3", "vec4"};
constexpr std::array<std::string_view, 3> kTexCoordTypes{"vec4", "vec2", "vec3"};
constexpr std::array<std::string_view, 2> kColorTypes{"vec4", "vec3"};

constexpr InputNames kInputNames[] = {
    {"position", " pos position positionmodelspace coord coords coord3d vertex vert ", kPositionTypes},
    {"normal", " norm normal normalmodelspace ", kDirectionTypes},
    {"texCoord", " texcoord texcoords texcoord0 texturecoord tex tc uv uv0 st ", kTexCoordTypes},
    {"color", " col color colour ", kColorTypes},
    {"tangent", " tangent ", kDirectionTypes},
};

bool hasName(std::string_view names, const std::string& plainName) {
    return !plainName.empty() && names.find(' ' + plainName + ' ') != std::string_view::npos;
}

bool canTake(std::span<const std::string_view> types, std::string_view type) {
    return std::ranges::find(types, type) != types.end();
}

}  // namespace

std::optional<Builtin> wellKnownUniform(std::string_view name, std::string_view type,
                                        const std::function<bool(std::string_view)>& isUniform) {
    if (findBuiltinUniform(name) != nullptr) return std::nullopt;
    // The books use norm_matrix in world space beside m_matrix, and in eye space beside mv_matrix.
    if (name == "norm_matrix" && type == "mat4" && isUniform && isUniform("m_matrix"))
        return modelInverseTranspose;
    const std::string letters = plainUniform(name);
    for (const UniformNames& row : kUniformNames)
        if (row.type == type && hasName(row.names, letters)) return row.value;
    return std::nullopt;
}

std::string_view wellKnownAttribute(std::string_view name, std::string_view type) {
    if (findBuiltinInput(name) != nullptr) return {};
    const std::string letters = plain(ownWordOfInput(name));
    for (const InputNames& row : kInputNames)
        if (canTake(row.types, type) && hasName(row.names, letters)) return row.attribute;
    return {};
}

std::string inputNear(std::string_view name, std::string_view type) {
    std::vector<std::string_view> words, attributes;
    for (const InputNames& row : kInputNames) {
        if (!canTake(row.types, type)) continue;
        words.push_back(row.attribute);  // first, if others are as near
        attributes.push_back(row.attribute);
        for (std::size_t begin = 1, end = 0; begin < row.names.size(); begin = end + 1) {
            end = row.names.find(' ', begin);
            words.push_back(row.names.substr(begin, end - begin));
            attributes.push_back(row.attribute);
        }
    }
    const std::string_view own = ownWordOfInput(name);
    const auto found = std::ranges::find(words, base::nearestName(plain(own), words));
    if (found == words.end()) return {};
    const std::string_view attribute = attributes[static_cast<std::size_t>(found - words.begin())];
    std::string near(plain(attribute) == *found ? attribute : *found);
    if (isUpper(own.front())) near.front() = static_cast<char>(near.front() - 'a' + 'A');
    return std::string(name.substr(0, name.size() - own.size())) + near;
}

}  // namespace glibra::glsl
