// The tables of names that glibra supplies, and of names that books and frameworks use.

#include <gtest/gtest.h>

#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glsl/read/words.h"
#include "glsl/types/builtins.h"

namespace glibra::glsl {
namespace {

/// The names that a search of books, courses and frameworks found, with blanks between them.
struct FoundUniforms {
    Builtin value;
    std::string_view type, names;
};

constexpr FoundUniforms kFoundUniforms[] = {
    {Builtin::modelView, "mat4",
     "mv_matrix mvMatrix mvMat mv modelView modelview modelViewMatrix modelviewMatrix modelViewMat ModelView "
     "ModelViewMatrix MVMatrix MV model_view modelview_matrix model_view_matrix u_modelView "
     "u_modelViewMatrix u_mvMatrix u_mv u_ModelView u_MVMatrix"},
    {Builtin::projection, "mat4",
     "p_matrix proj_matrix projection_matrix pMatrix pMat proj projMat projMatrix projection "
     "projectionMatrix Projection ProjectionMatrix PMatrix P u_projection u_projectionMatrix u_projMatrix "
     "u_proj u_pMatrix u_Projection u_ProjectionMatrix"},
    {Builtin::modelViewProjection, "mat4",
     "mvp mvp_matrix mvpMatrix mvpMat MVP MVPMatrix ModelViewProjection ModelViewProjectionMatrix "
     "modelViewProjection modelViewProjectionMatrix modelviewprojection model_view_projection u_mvp "
     "u_mvpMatrix u_MVP u_MVPMatrix u_modelViewProjection u_modelViewProjectionMatrix u_ModelViewProjection "
     "u_worldViewProjection worldViewProjection"},
    {Builtin::model, "mat4",
     "m_matrix mMatrix mMat M model modelMat modelMatrix model_matrix Model ModelMatrix ModelToWorld "
     "modelToWorld world worldMatrix u_model u_modelMatrix u_Model u_world"},
    {Builtin::view, "mat4",
     "v_matrix vMatrix vMat V view viewMat viewMatrix view_matrix View ViewMatrix u_view u_viewMatrix "
     "u_View"},
    {Builtin::viewProjection, "mat4",
     "vp_matrix vpMatrix vp VP viewProj viewProjection viewProjMatrix viewProjectionMatrix ViewProjection "
     "ViewProjectionMatrix view_projection u_viewProjection u_viewProjectionMatrix u_vp"},
    {Builtin::viewInverse, "mat4",
     "invView viewInv viewInverse inverseView viewMatrixInverse viewInverseMatrix inverseViewMatrix "
     "InverseViewMatrix inv_view invView_matrix u_inverseView u_viewInverse"},
    {Builtin::modelInverse, "mat4",
     "modelInverse inverseModel modelMatrixInverse inverseModelMatrix invModel"},
    {Builtin::modelViewProjectionInverse, "mat4", "inverseMVP invMVP modelViewProjectionInverse"},
    {Builtin::projectionInverse, "mat4",
     "invProjection projectionInverse inverseProjection projectionMatrixInverse inverseProjectionMatrix "
     "invProj"},
    {Builtin::modelInverseTranspose, "mat4",
     "invTrModelMat invTr_model modelInverseTranspose inverseTransposeModel worldInverseTranspose "
     "u_worldInverseTranspose"},
    {Builtin::modelNormalMatrix, "mat3", "invTrModelMat modelNormalMatrix worldNormalMatrix"},
    {Builtin::normalMatrix, "mat3",
     "norm_matrix normMatrix normMat normal_matrix normalMatrix normalMat NormalMatrix nMatrix NMatrix "
     "invtrMat invTrMat invTr_matrix invtr_matrix u_normalMatrix u_NormalMatrix u_normal_matrix u_nMatrix"},
    {Builtin::modelViewInverseTranspose, "mat4",
     "norm_matrix normMatrix normMat normal_matrix normalMatrix normalMat NormalMatrix nMatrix NMatrix "
     "invtrMat invTrMat invTr_matrix invtr_matrix u_normalMatrix u_NormalMatrix u_normal_matrix u_nMatrix "
     "modelViewInverseTranspose"},
    {Builtin::eyePosition, "vec3",
     "viewPos viewPosition cameraPos cameraPosition camPos camera_pos camera_position eyePos eyePosition "
     "eye_position EyePosition CameraPosition ViewPos u_cameraPosition u_eyePosition u_viewPosition"},
};

struct FoundInputs {
    std::string_view attribute, types, names;
};
constexpr FoundInputs kFoundInputs[] = {
    {"position", "vec4 vec3 vec2",
     "vertPos vertPosition vert_pos position Position pos coord coord3d coords vertex vert in_position "
     "in_Position in_pos in_vertex inPosition inPos inVertex a_position a_Position a_pos a_vertex aPos "
     "aPosition aVertexPosition a_vertexPosition vPosition vPos vertex_position vertexPosition vertexPos "
     "vertex_pos vertexPosition_modelspace VertexPosition MCvertex MCVertex mcVertex"},
    {"normal", "vec3 vec4",
     "vertNormal vertNorm vert_normal normal Normal norm in_normal in_Normal in_norm inNormal inNorm "
     "a_normal a_Normal a_norm aNorm aVertexNormal a_vertexNormal vNormal vNorm vertex_normal vertexNormal "
     "vertexNorm vertexNormal_modelspace VertexNormal MCnormal MCNormal mcNormal"},
    {"texCoord", "vec4 vec2 vec3",
     "texCoord texCoords texcoord texcoords tex_coord tex_coords texCoord0 TexCoord TexCoords TexCoord0 tc "
     "uv uv0 UV st texture_coord textureCoord in_texCoord in_texcoord in_texcoords in_texCoords in_tex_coord "
     "in_TexCoord in_uv in_tc inTexCoord inTexCoords inTexcoord inUV inUv inTC a_texCoord a_texcoord "
     "a_texCoords a_TexCoord a_tex_coord a_uv a_st aTexCoord aTexCoords aTexcoord aTex aUV aUv aTextureCoord "
     "vTexCoord vTexCoords vertTex vertTexCoord vert_uv vertexUV vertex_uv vertexTexCoord vertexTexCoords "
     "vertex_texcoord vertex_texCoord vertex_tex_coord VertexTexCoord MCtexCoord"},
    {"color", "vec4 vec3",
     "vertColor vertColour color Color colour in_color in_Color in_colour inColor inColour a_color a_Color "
     "a_colour aCol aColour aVertexColor vColor vertex_color vertexColor vertex_colour vertexColour "
     "VertexColor"},
    {"tangent", "vec3 vec4",
     "vertTangent tangent in_tangent inTangent a_tangent a_Tangent vTangent vertex_tangent vertexTangent "
     "VertexTangent"},
};

std::vector<std::string> wordsOf(std::string_view names) {
    std::istringstream text{std::string(names)};
    return {std::istream_iterator<std::string>(text), {}};
}

TEST(WellKnownNames, AreTheUniformsOfBooksAndFrameworks) {
    for (const FoundUniforms& row : kFoundUniforms)
        for (const std::string& name : wordsOf(row.names)) {
            EXPECT_EQ(row.value, wellKnownUniform(name, row.type)) << name;
            EXPECT_EQ(0, keywordSince(name)) << name;
        }
}

TEST(WellKnownNames, AreTheInputsOfBooksAndFrameworks) {
    for (const auto& [attribute, types, names] : kFoundInputs)
        for (const std::string& name : wordsOf(names)) {
            for (const std::string& type : wordsOf(types))
                EXPECT_EQ(attribute, wellKnownAttribute(name, type)) << name;
            EXPECT_EQ("", wellKnownAttribute(name, "ivec4"));
        }
}

TEST(WellKnownNames, MayHaveThePrefixAndCaseOfOtherFrameworks) {
    EXPECT_EQ(Builtin::model, wellKnownUniform("uModelMatrix", "mat4"));
    EXPECT_EQ(Builtin::modelViewProjection, wellKnownUniform("uMVPMatrix", "mat4"));
    EXPECT_EQ(Builtin::eyePosition, wellKnownUniform("uCameraPosition", "vec3"));
    EXPECT_EQ("position", wellKnownAttribute("vVertex", "vec3"));
    EXPECT_EQ("texCoord", wellKnownAttribute("a_UV", "vec2"));
    for (const char* name :
         {"inVertPosition", "IN_POSITION", "In_Pos", "aVertPos", "mcVertPosition", "A_VERTEX_POSITION"})
        EXPECT_EQ("position", wellKnownAttribute(name, "vec3")) << name;
    for (const char* name : {"U_MVP", "uMvp", "U_mvp_MATRIX", "MVP_Matrix"})
        EXPECT_EQ(Builtin::modelViewProjection, wellKnownUniform(name, "mat4")) << name;
}

TEST(WellKnownNames, AreNoOtherWords) {
    for (const char* name :
         {"", "u", "_", "mat", "matrix", "u_matrix", "um", "umbrella", "umvp", "uworld", "ups", "normals",
          "modelviews", "lightView", "shadowMatrix", "prevModelView", "viewport", "projector", "models"})
        for (const char* type : {"mat4", "mat3", "vec3"}) EXPECT_FALSE(wellKnownUniform(name, type)) << name;
    for (const char* name :
         {"", "a", "_", "in", "v_", "MC", "vertexId", "instance", "index", "ast", "inst", "INST",
          "inposition", "velocity", "apos", "offset", "colors", "normal2", "inNormals"})
        EXPECT_EQ("", wellKnownAttribute(name, "vec3")) << name;
}

TEST(WellKnownNames, ClassicNamesStayClassic) {
    for (const BuiltinUniform& row : builtinUniforms())
        EXPECT_FALSE(wellKnownUniform(row.name, row.type)) << row.name;
    for (const BuiltinInput& row : builtinInputs())
        for (const char* type : {"vec2", "vec3", "vec4"})
            EXPECT_EQ("", wellKnownAttribute(row.name, type)) << row.name;
}

TEST(WellKnownNames, AreFoundNearby) {
    EXPECT_EQ("vertNormal", inputNear("vertNorml", "vec3")) << "with the prefix of the name";
    EXPECT_EQ("aVertexPosition", inputNear("aVertexPostion", "vec3"));
    EXPECT_EQ("in_texCoord", inputNear("in_texCord", "vec2"));
    EXPECT_EQ("color", inputNear("colr", "vec4"));
    EXPECT_EQ("aVertex", inputNear("aVertx", "vec4")) << "the nearest word, not what it stands for";
    EXPECT_EQ("", inputNear("vertNorml", "vec2")) << "a normal has three components";
    EXPECT_EQ("", inputNear("velocity", "vec3"));
}

struct Known {
    const char *name, *type;
    Builtin value;
};

TEST(WellKnownNames, MatricesOfTheBooks) {
    using enum Builtin;
    const Known known[] = {
        // Gordon and Clevenger
        {"mv_matrix", "mat4", modelView},
        {"p_matrix", "mat4", projection},
        {"proj_matrix", "mat4", projection},
        {"m_matrix", "mat4", model},
        {"v_matrix", "mat4", view},
        {"norm_matrix", "mat4", modelViewInverseTranspose},
        {"mvp", "mat4", modelViewProjection},
        // learnopengl.com
        {"model", "mat4", model},
        {"view", "mat4", view},
        {"projection", "mat4", projection},
        {"viewPos", "vec3", eyePosition},
        // three.js
        {"modelViewMatrix", "mat4", modelView},
        {"projectionMatrix", "mat4", projection},
        {"normalMatrix", "mat3", normalMatrix},
        {"cameraPosition", "vec3", eyePosition},
        // Rost
        {"MVMatrix", "mat4", modelView},
        {"MVPMatrix", "mat4", modelViewProjection},
        {"NormalMatrix", "mat3", normalMatrix},
        // Wolff
        {"ModelViewMatrix", "mat4", modelView},
        {"ProjectionMatrix", "mat4", projection},
        {"MVP", "mat4", modelViewProjection},
        {"u_modelViewProjectionMatrix", "mat4", modelViewProjection},
        {"u_normalMatrix", "mat4", modelViewInverseTranspose},
    };
    for (const Known& each : known) {
        EXPECT_EQ(each.value, wellKnownUniform(each.name, each.type)) << each.name;
    }
    EXPECT_FALSE(wellKnownUniform("model", "mat3"));
    EXPECT_FALSE(wellKnownUniform("model", "int"));
    EXPECT_FALSE(wellKnownUniform("uModelViewMatrix", "mat4"));
}

TEST(WellKnownNames, NormalsAreInTheSpaceOfTheOtherMatrix) {
    const auto has = [](std::string_view wanted) {
        return [wanted](std::string_view name) { return name == wanted; };
    };
    EXPECT_EQ(Builtin::modelInverseTranspose, wellKnownUniform("norm_matrix", "mat4", has("m_matrix")));
    EXPECT_EQ(Builtin::modelViewInverseTranspose, wellKnownUniform("norm_matrix", "mat4", has("mv_matrix")));
}

TEST(WellKnownNames, VertexInputsOfTheBooks) {
    const std::pair<const char*, const char*> known[] = {
        {"vertPos", "position"},    {"vertNormal", "normal"},
        {"texCoord", "texCoord"},   {"tc", "texCoord"},
        {"MCvertex", "position"},   {"position", "position"},
        {"normal", "normal"},       {"uv", "texCoord"},
        {"texcoord", "texCoord"},   {"vertex_normal", "normal"},
        {"aPos", "position"},       {"aTexCoords", "texCoord"},
        {"inPosition", "position"}, {"VertexPosition", "position"}};
    for (const auto& [name, attribute] : known) {
        EXPECT_EQ(attribute, wellKnownAttribute(name, "vec3")) << name;
    }
    EXPECT_EQ("", wellKnownAttribute("normal", "vec2"));
    EXPECT_EQ("", wellKnownAttribute("aNormal", "vec3"));  // a classic name
}

}  // namespace
}  // namespace glibra::glsl
