// The names that books and frameworks give to what the runtime supplies.

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "glsl/types/builtins.h"

namespace glibra::glsl {
namespace {

using enum Builtin;

/// The spellings of a value, with blanks between them. They are listed, because a rule for prefixes, cases
/// and underscores would also give values to names that mean something else.
struct UniformSpellings {
    Builtin value;
    std::string_view type, names;
    std::string_view beside = {};  ///< WellKnownUniform::beside
};

constexpr UniformSpellings kUniformSpellings[] = {
    {modelInverseTranspose, "mat4", "norm_matrix", "m_matrix"},
    {modelView, "mat4",
     "mv_matrix mvMatrix mvMat mv modelView modelview modelViewMatrix modelviewMatrix modelViewMat "
     "ModelView ModelViewMatrix MVMatrix MV model_view modelview_matrix model_view_matrix u_modelView "
     "u_modelViewMatrix u_mvMatrix u_mv u_ModelView u_MVMatrix"},
    {projection, "mat4",
     "p_matrix proj_matrix projection_matrix pMatrix pMat proj projMat projMatrix projection "
     "projectionMatrix Projection ProjectionMatrix PMatrix P u_projection u_projectionMatrix u_projMatrix "
     "u_proj u_pMatrix u_Projection u_ProjectionMatrix"},
    {modelViewProjection, "mat4",
     "mvp mvp_matrix mvpMatrix mvpMat MVP MVPMatrix ModelViewProjection ModelViewProjectionMatrix "
     "modelViewProjection modelViewProjectionMatrix modelviewprojection model_view_projection u_mvp "
     "u_mvpMatrix u_MVP u_MVPMatrix u_modelViewProjection u_modelViewProjectionMatrix "
     "u_ModelViewProjection u_worldViewProjection worldViewProjection"},
    {model, "mat4",
     "m_matrix mMatrix mMat M model modelMat modelMatrix model_matrix Model ModelMatrix ModelToWorld "
     "modelToWorld world worldMatrix u_model u_modelMatrix u_Model u_world"},
    {view, "mat4",
     "v_matrix vMatrix vMat V view viewMat viewMatrix view_matrix View ViewMatrix u_view u_viewMatrix "
     "u_View"},
    {viewProjection, "mat4",
     "vp_matrix vpMatrix vp VP viewProj viewProjection viewProjMatrix viewProjectionMatrix ViewProjection "
     "ViewProjectionMatrix view_projection u_viewProjection u_viewProjectionMatrix u_vp"},
    {viewInverse, "mat4",
     "invView viewInv viewInverse inverseView viewMatrixInverse viewInverseMatrix inverseViewMatrix "
     "InverseViewMatrix inv_view invView_matrix u_inverseView u_viewInverse"},
    {modelInverse, "mat4", "modelInverse inverseModel modelMatrixInverse inverseModelMatrix invModel"},
    {modelViewProjectionInverse, "mat4", "inverseMVP invMVP modelViewProjectionInverse"},
    {projectionInverse, "mat4",
     "invProjection projectionInverse inverseProjection projectionMatrixInverse inverseProjectionMatrix "
     "invProj"},
    {modelInverseTranspose, "mat4",
     "invTrModelMat invTr_model modelInverseTranspose inverseTransposeModel worldInverseTranspose "
     "u_worldInverseTranspose"},
    {modelNormalMatrix, "mat3", "invTrModelMat modelNormalMatrix worldNormalMatrix"},
    {normalMatrix, "mat3",
     "norm_matrix normMatrix normMat normal_matrix normalMatrix normalMat NormalMatrix nMatrix NMatrix "
     "invtrMat invTrMat invTr_matrix invtr_matrix u_normalMatrix u_NormalMatrix u_normal_matrix u_nMatrix"},
    {modelViewInverseTranspose, "mat4",
     "norm_matrix normMatrix normMat normal_matrix normalMatrix normalMat NormalMatrix nMatrix NMatrix "
     "invtrMat invTrMat invTr_matrix invtr_matrix u_normalMatrix u_NormalMatrix u_normal_matrix u_nMatrix "
     "modelViewInverseTranspose"},
    {eyePosition, "vec3",
     "viewPos viewPosition cameraPos cameraPosition camPos camera_pos camera_position eyePos eyePosition "
     "eye_position EyePosition CameraPosition ViewPos u_cameraPosition u_eyePosition u_viewPosition"},
};

constexpr std::pair<std::string_view, std::string_view> kInputSpellings[] = {
    {"position",
     "vertPos vertPosition vert_pos position Position pos coord coord3d coords vertex vert in_position "
     "in_Position in_pos in_vertex inPosition inPos inVertex a_position a_Position a_pos a_vertex aPos "
     "aPosition aVertexPosition a_vertexPosition vPosition vPos vertex_position vertexPosition vertexPos "
     "vertex_pos vertexPosition_modelspace VertexPosition MCvertex MCVertex mcVertex"},
    {"normal",
     "vertNormal vertNorm vert_normal normal Normal norm in_normal in_Normal in_norm inNormal inNorm "
     "a_normal a_Normal a_norm aNorm aVertexNormal a_vertexNormal vNormal vNorm vertex_normal "
     "vertexNormal vertexNorm vertexNormal_modelspace VertexNormal MCnormal MCNormal mcNormal"},
    {"texCoord",
     "texCoord texCoords texcoord texcoords tex_coord tex_coords texCoord0 TexCoord TexCoords TexCoord0 "
     "tc uv uv0 UV st texture_coord textureCoord in_texCoord in_texcoord in_texcoords in_texCoords "
     "in_tex_coord in_TexCoord in_uv in_tc inTexCoord inTexCoords inTexcoord inUV inUv inTC a_texCoord "
     "a_texcoord a_texCoords a_TexCoord a_tex_coord a_uv a_st aTexCoord aTexCoords aTexcoord aTex aUV aUv "
     "aTextureCoord vTexCoord vTexCoords vertTex vertTexCoord vert_uv vertexUV vertex_uv vertexTexCoord "
     "vertexTexCoords vertex_texcoord vertex_texCoord vertex_tex_coord VertexTexCoord MCtexCoord"},
    {"color",
     "vertColor vertColour color Color colour in_color in_Color in_colour inColor inColour a_color "
     "a_Color a_colour aCol aColour aVertexColor vColor vertex_color vertexColor vertex_colour "
     "vertexColour VertexColor"},
    {"tangent",
     "vertTangent tangent in_tangent inTangent a_tangent a_Tangent vTangent vertex_tangent vertexTangent "
     "VertexTangent"},
};

// A texture coordinate or colour may be read with fewer components than the mesh has. A normal or tangent
// that is read as a vec4 has w = 1, as GL fills it.
constexpr std::array<std::string_view, 3> kPositionTypes{"vec4", "vec3", "vec2"};
constexpr std::array<std::string_view, 2> kDirectionTypes{"vec3", "vec4"};
constexpr std::array<std::string_view, 3> kTexCoordTypes{"vec4", "vec2", "vec3"};
constexpr std::array<std::string_view, 2> kColorTypes{"vec4", "vec3"};

/// Calls `use` with each word.
template <class Use>
void forEachWord(std::string_view words, const Use& use) {
    while (!words.empty()) {
        const std::size_t end = std::min(words.find(' '), words.size());
        use(words.substr(0, end));
        words.remove_prefix(std::min(end + 1, words.size()));
    }
}

}  // namespace

std::span<const WellKnownUniform> wellKnownUniforms() {
    static const std::vector<WellKnownUniform> kRows = [] {
        std::vector<WellKnownUniform> rows;
        for (const UniformSpellings& each : kUniformSpellings)
            forEachWord(each.names, [&](std::string_view name) {
                rows.push_back({name, each.type, each.value, each.beside});
            });
        return rows;
    }();
    return kRows;
}

std::span<const WellKnownInput> wellKnownInputs() {
    static const std::vector<WellKnownInput> kRows = [] {
        std::vector<WellKnownInput> rows;
        for (const auto& [attribute, names] : kInputSpellings)
            forEachWord(names, [&](std::string_view name) { rows.push_back({name, attribute}); });
        return rows;
    }();
    return kRows;
}

const WellKnownUniform* findWellKnownUniform(std::string_view name, std::string_view type,
                                             const std::function<bool(std::string_view)>& isUniform) {
    for (const WellKnownUniform& row : wellKnownUniforms())
        if (row.name == name && row.type == type &&
            (row.beside.empty() || (isUniform && isUniform(row.beside))))
            return &row;
    return nullptr;
}

const WellKnownInput* findWellKnownInput(std::string_view name, std::string_view type) {
    for (const WellKnownInput& row : wellKnownInputs()) {
        if (row.name != name) continue;
        const auto types = inputTypes(row.attribute);
        return std::find(types.begin(), types.end(), type) == types.end() ? nullptr : &row;
    }
    return nullptr;
}

std::span<const std::string_view> inputTypes(std::string_view attribute) {
    if (attribute == "position") return kPositionTypes;
    if (attribute == "normal" || attribute == "tangent") return kDirectionTypes;
    if (attribute == "texCoord") return kTexCoordTypes;
    if (attribute == "color") return kColorTypes;
    return {};
}

}  // namespace glibra::glsl
