// Which vertex stages are known to place their vertices by the model-view-projection alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <string>

#include "support.h"

namespace glibra::glsl::test {
namespace {

Placement placementOf(const std::string& vertex, const std::string& fragment = kPlainFragment) {
    const TranslatedProgram translated =
        translateStages({{Stage::vertex, vertex}, {Stage::fragment, fragment}});
    EXPECT_FALSE(hasError(translated.diagnostics)) << vertex;
    return translated.placement;
}
/// The placement of a stage with these statements in main and this text before it.
Placement placementOfMain(const std::string& statements, const std::string& before = {}) {
    return placementOf("#version 330 compatibility\n" + before + "void main() {\n" + statements + "\n}\n");
}

TEST(Placement, UsualSpellingsAreKnown) {
    for (const char* each : {
             "gl_Position = uModelViewProjectionMatrix * aVertex;",
             "gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;",
             "gl_Position = ftransform();",
             "gl_Position = (uModelViewProjectionMatrix * (aVertex));",
             "gl_Position = uProjectionMatrix * uModelViewMatrix * aVertex;",
             "gl_Position = uProjectionMatrix * (uModelViewMatrix * aVertex);",
             "gl_Position = (gl_ProjectionMatrix * gl_ModelViewMatrix) * gl_Vertex;",
             "gl_Position = uModelViewProjectionMatrix * vec4(aVertex);",
             "vec4 eye = uModelViewMatrix * aVertex; gl_Position = uProjectionMatrix * eye;",
             "vec4 place = gl_Vertex; vec4 eye = gl_ModelViewMatrix * place; gl_Position = "
             "gl_ProjectionMatrix * "
             "eye;",
             "mat4 m = uProjectionMatrix * uModelViewMatrix; gl_Position = m * aVertex;",
             "if (aVertex.x > 0.) { gl_PointSize = 2.; } gl_Position = uModelViewProjectionMatrix * aVertex;",
             "gl_Position = uModelViewProjectionMatrix * aVertex; if (aVertex.x > 0.) return;",
         })
        EXPECT_EQ(placementOfMain(each), Placement::vertex) << each;
}

TEST(Placement, VertexWithOneAsLastCoordinateIsAPoint) {
    for (const char* each : {
             "gl_Position = uModelViewProjectionMatrix * vec4(aVertex.xyz, 1.);",
             "gl_Position = uProjectionMatrix * uModelViewMatrix * vec4(gl_Vertex.xyz, 1.0);",
             "vec4 place = vec4(aVertex.xyz, 1); gl_Position = uModelViewProjectionMatrix * place;",
         })
        EXPECT_EQ(placementOfMain(each), Placement::point) << each;
}

TEST(Placement, MacrosAndOwnDeclarationsAreFollowed) {
    EXPECT_EQ(placementOfMain("gl_Position = MVP * P;",
                              "#define MVP uModelViewProjectionMatrix\n#define P aVertex\n"),
              Placement::vertex);
    EXPECT_EQ(placementOfMain("gl_Position = uModelViewProjectionMatrix * aVertex;",
                              "uniform mat4 uModelViewProjectionMatrix;\nin vec4 aVertex;\n"),
              Placement::vertex);
}

TEST(Placement, OtherPositionsAreUnknown) {
    for (const char* each : {
             "gl_Position = aVertex;",
             "gl_Position = uModelViewMatrix * aVertex;",
             "gl_Position = aVertex * uModelViewProjectionMatrix;",
             "gl_Position = uModelViewMatrix * uProjectionMatrix * aVertex;",
             "gl_Position = uModelViewProjectionMatrix * aVertex * 2.;",
             "gl_Position = 2. * uModelViewProjectionMatrix * aVertex;",
             "gl_Position = uModelViewProjectionMatrix * (aVertex + vec4(1.));",
             "gl_Position = uModelViewProjectionMatrix * aVertex + vec4(1.);",
             "gl_Position = uModelViewProjectionMatrix * -aVertex;",
             "gl_Position = uModelViewProjectionMatrix * aVertex.xyzw;",
             "gl_Position = uModelViewProjectionMatrix * vec4(aVertex.xyz, 2.);",
             "gl_Position = uModelViewProjectionMatrix * vec4(aVertex.xzy, 1.);",
             "gl_Position = uModelViewProjectionMatrix * vec4(aNormal.xyz, 1.);",
             "gl_Position = uModelViewProjectionMatrix * gl_Color;",
             "gl_Position = inverse(uModelViewProjectionMatrix) * aVertex;",
             "gl_Position = uModelViewProjectionMatrix * aVertex; gl_Position.x += 1.;",
             "gl_Position = uModelViewProjectionMatrix * aVertex; gl_Position = aVertex;",
             "gl_Position.xyzw = uModelViewProjectionMatrix * aVertex;",
             "gl_Position += uModelViewProjectionMatrix * aVertex;",
             "if (aVertex.x > 0.) gl_Position = uModelViewProjectionMatrix * aVertex;",
             "if (aVertex.x > 0.) { gl_Position = uModelViewProjectionMatrix * aVertex; }",
             "if (aVertex.x > 0.) gl_PointSize = 2.; else gl_Position = uModelViewProjectionMatrix * "
             "aVertex;",
             "for (int i = 0; i < 2; ++i) gl_Position = uModelViewProjectionMatrix * aVertex;",
             "if (aVertex.x > 0.) return; gl_Position = uModelViewProjectionMatrix * aVertex;",
             "vec4 p = aVertex; p.x += 1.; gl_Position = uModelViewProjectionMatrix * p;",
             "vec4 p = aVertex; ++p.x; gl_Position = uModelViewProjectionMatrix * p;",
             "vec4 p = aVertex; { vec4 p = vec4(1.); } gl_Position = uModelViewProjectionMatrix * p;",
             "vec4 p; p = aVertex; gl_Position = uModelViewProjectionMatrix * p;",
             "vec4 p = aVertex, q = modf(aVertex, p); gl_Position = uModelViewProjectionMatrix * p;",
             "mat4 m[1] = mat4[1](uModelViewProjectionMatrix); gl_Position = m[0] * aVertex;",
             "vec3 p = aVertex.xyz; gl_Position = uModelViewProjectionMatrix * vec4(p, 1.);",
         })
        EXPECT_EQ(placementOfMain(each), Placement::unknown) << each;
}

TEST(Placement, NamesWithOtherMeaningsAreUnknown) {
    const std::string plain = "gl_Position = uModelViewProjectionMatrix * aVertex;";
    EXPECT_EQ(placementOfMain(plain, "mat4 uModelViewProjectionMatrix = mat4(1.);\n"), Placement::unknown);
    EXPECT_EQ(placementOfMain(plain, "const vec4 aVertex = vec4(1.);\n"), Placement::unknown);
    EXPECT_EQ(placementOfMain("vec4 aVertex = vec4(1.); " + plain), Placement::unknown);
    EXPECT_EQ(placementOfMain("mat4 uModelViewProjectionMatrix = mat4(2.); " + plain), Placement::unknown);
    EXPECT_EQ(placementOfMain("gl_Position = ftransform();", "vec4 ftransform() { return vec4(0.); }\n"),
              Placement::unknown);
    EXPECT_EQ(placementOfMain(plain + " move();", "void move() { gl_Position.y = 0.; }\n"),
              Placement::unknown);
    EXPECT_EQ(placementOfMain(plain + " move(gl_Position);", "void move(inout vec4 p) { p.y = 0.; }\n"),
              Placement::unknown);
    EXPECT_EQ(placementOfMain("vec4 p = aVertex; move(p); gl_Position = uModelViewProjectionMatrix * p;",
                              "void move(inout vec4 p) { p.y = 0.; }\n"),
              Placement::unknown);
}

TEST(Placement, MoreStagesOrOtherEffectsAreUnknown) {
    const std::string vertex =
        "#version 330\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n";
    ASSERT_EQ(placementOf(vertex), Placement::vertex);
    EXPECT_EQ(
        translateStages({{Stage::vertex, vertex},
                         {Stage::geometry,
                          "#version 330\nlayout(triangles) in;\nlayout(points, max_vertices = 1) out;\nvoid "
                          "main() { gl_Position = vec4(0.); EmitVertex(); }\n"},
                         {Stage::fragment, kPlainFragment}})
            .placement,
        Placement::unknown);
    EXPECT_EQ(
        placementOf(vertex,
                    "#version 430\nlayout(rgba8) uniform image2D uImage;\nout vec4 fColor;\nvoid main() { "
                    "imageStore(uImage, ivec2(0), vec4(1.)); fColor = vec4(1.); }\n"),
        Placement::unknown);
    ProgramRequest asIs = program({{Stage::vertex, vertex}, {Stage::fragment, kPlainFragment}});
    asIs.shim = false;
    EXPECT_EQ(translate(asIs).placement, Placement::unknown) << "nobody supplies the names";
}

TEST(Placement, WellKnownNamesAreFollowedAndListed) {
    struct Row {
        const char* vertex;  ///< the declarations and the position
        Placement placement;
    };
    const auto translated = [](const char* vertex, bool supplies) {
        const std::string text(vertex);
        const std::size_t position = text.find('|');
        ProgramRequest asked = program(
            {{Stage::vertex, "#version 330\n" + text.substr(0, position) +
                                 "void main() { gl_Position = " + text.substr(position + 1) + "; }\n"},
             {Stage::fragment, kPlainFragment}});
        asked.suppliesMatrices = supplies;
        return translate(asked);
    };
    for (const Row& each : std::initializer_list<Row>{
             {"uniform mat4 mvp; in vec4 aVertex;|mvp * aVertex", Placement::vertex},
             {"uniform mat4 u_MVPMatrix; in vec3 position;|u_MVPMatrix * vec4(position, 1.0)",
              Placement::point},
             {"uniform mat4 proj; uniform mat4 mv_matrix; layout(location = 0) in vec4 vPosition;|"
              "proj * mv_matrix * vPosition",
              Placement::vertex},
             {"uniform mat4 model, view, projection; in vec3 aPos;|projection * view * model * vec4(aPos, "
              "1.0)",
              Placement::point},
             {"uniform mat4 model, view, projection; in vec3 aPos;|projection * (view * (model * vec4(aPos, "
              "1)))",
              Placement::point},
             {"uniform mat4 viewProj, world; in vec4 vert;|viewProj * world * vert", Placement::vertex},
             {"uniform mat4 mvp; in vec2 position;|mvp * vec4(position, 0., 1.)", Placement::unknown},
             {"uniform mat4 mvp; in vec3 position;|mvp * vec4(position, 2.)", Placement::unknown},
             {"uniform mat4 mvp; in vec3 normal;|mvp * vec4(normal, 1.)", Placement::unknown},
             {"uniform mat4 mvp = mat4(1); in vec4 aVertex;|mvp * aVertex", Placement::unknown},
             {"uniform mat4 mvp[2]; in vec4 aVertex;|mvp[0] * aVertex", Placement::unknown},
             {"uniform mat4 view; in vec4 aVertex;|view * aVertex", Placement::unknown},
             {"uniform mat4 projection; in vec4 aVertex;|projection * aVertex", Placement::unknown},
             {"uniform mat4 mvp; in vec4 aVertex;|aVertex * mvp", Placement::unknown},
             {"uniform mat4 turn; in vec4 aVertex;|turn * aVertex", Placement::unknown},
         }) {
        const TranslatedProgram modern = translated(each.vertex, true);
        EXPECT_EQ(modern.placement, each.placement) << each.vertex;
        EXPECT_EQ(modern.knownPlacement(), Placement::unknown)
            << "the scene may set the names: " << each.vertex;
        EXPECT_EQ(modern.stages.front().source.find("invariant"), std::string::npos) << each.vertex;
        EXPECT_EQ(translated(each.vertex, false).placement, Placement::unknown) << "classic scenes";
    }
    const char* product =
        "uniform mat4 model, view, projection; in vec3 aPos;|projection * view * model * vec4(aPos, 1.0)";
    EXPECT_EQ(std::ranges::count(translated(product, true).placementNames, "model"), 1);
    EXPECT_EQ(translated(product, true).placementNames.size(), 4U);
    const TranslatedProgram classic =
        translated("in vec4 aVertex;|uModelViewProjectionMatrix * aVertex", true);
    EXPECT_EQ(classic.knownPlacement(), Placement::vertex);
    EXPECT_TRUE(classic.placementNames.empty());
}

}  // namespace
}  // namespace glibra::glsl::test
