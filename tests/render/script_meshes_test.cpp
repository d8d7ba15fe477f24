// Mesh: shapes as buffers (language, 12.7).

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "geometry/shapes/primitive.h"
#include "glib/statement_table.h"
#include "modern_text.h"
#include "script_problems.h"

namespace glibra::test {
namespace {

const std::string kShowMesh =
    "Camera eye LookAt 1 2 5  0 0 0  0 1 0  Perspective 40 .1 100\n"
    "Vertex inline\n#version 330\nin vec4 aPlace;\nin vec4 aDirection;\nuniform mat4 mvp;\nout vec3 "
    "vNormal;\n"
    "void main() { vNormal = aDirection.xyz; gl_Position = mvp*aPlace; }\nEndVertex\n"
    "Fragment inline\n#version 330\nin vec3 vNormal;\nout vec4 c;\nvoid main() { c = vec4(.5 + .5*vNormal, "
    "1.); }\n"
    "EndFragment\nProgram Show\nBackground 0 0 0\n";

TEST(ScriptMeshes, TheBuffersOfAShapeDrawTheShape) {
    for (const char* shape : {"Teapot", "Sphere 1 20 10", "Torus .3 1 8 12", "Box 1 2 1", "Soccerball 1"}) {
        TextScene buffers("Mesh m " + std::string(shape) + "\n" + kShowMesh +
                          "Attribute aPlace m.position\nAttribute aDirection m.normal\n"
                          "Vertices triangles indices m.index\n");
        TextScene direct(kShowMesh + "Attribute aPlace as position\nAttribute aDirection as normal\n" +
                         shape + "\n");
        const image::Image a = buffers.draw(), b = direct.draw();
        EXPECT_EQ(a.data, b.data) << shape;
        EXPECT_GT(std::set(a.data.begin(), a.data.end()).size(), 2U) << shape;
    }
}

TEST(ScriptMeshes, TheNumbersOfEachShapeAreThoseOfItsMesh) {
    for (const geometry::PrimitiveSpec* each : geometry::primitives()) {
        const std::string name(each->names.front());
        const geometry::Mesh mesh = each->make(geometry::completeNumbers(*each, {}));
        if (mesh.vertexCount() == 0) continue;
        const auto taken =
            static_cast<std::size_t>(geometry::verticesPerPrimitive(mesh.topology, mesh.patchVertices));
        EXPECT_EQ(problemsOf("Mesh m " + name +
                             "\nPass window\nEndPass\nExpect (m.position.count == m.vertices)\n" +
                             "Expect (m.index.count == " + std::to_string(taken) + " * m.primitives)\n"),
                  "")
            << name;
    }
}

TEST(ScriptMeshes, ChecksReadTheElements) {
    EXPECT_EQ(problemsOf("Mesh m QuadXY .5 2 1 1\nPass window\nEndPass\n"
                         "Expect (m.vertices == 4 && m.primitives == 2 && m.index.count == 6)\n"
                         "Expect buffer m.position [-2 -2 .5 1]\n"
                         "Expect (m.position[3] == vec4(2, 2, .5, 1))\n"
                         "Expect range m.index 0 3\nExpect sum m.normal [0 0 4 0]\n"
                         "Expect buffer m.texCoord at 3 [1 1 0 1]\n"),
              "");
}

TEST(ScriptMeshes, AModelComesFromItsFile) {
    EXPECT_EQ(
        problemsOf("Mesh m Obj a.obj\nPass window\nEndPass\nExpect (m.vertices == 3 && m.primitives == 1)\n"
                   "Expect buffer m.position [0 0 0 1  1 0 0 1  0 1 0 1]\n",
                   {{"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}}),
        "");
}

TEST(ScriptMeshes, MistakesAreReportedAtTheirPlace) {
    const auto of = [](const std::string& text) { return problemsOf(text + "\nPass window\nEndPass\n"); };
    EXPECT_NE(
        of("Mesh m Spher 1")
            .find("scene.glib:1:8: error: Mesh: 'Spher' is no shape; did you mean 'Sphere'? [glib-E16]"),
        std::string::npos);
    EXPECT_NE(of("Mesh m Obj none.obj").find("file-E01"), std::string::npos);
    EXPECT_NE(of("Mesh m Obj").find("Obj needs a file [glib-E32]"), std::string::npos);
    EXPECT_NE(of("Mesh m Sphere a.obj").find("takes no file [glib-E32]"), std::string::npos);
    EXPECT_NE(of("Mesh m Teapot\nClear m.normals").find("the mesh has m.index, m.normal, m.position"),
              std::string::npos);
    EXPECT_NE(of("Mesh m Teapot\nClear m").find("'m' is no buffer"), std::string::npos);
    EXPECT_NE(of("Mesh m Teapot\nTexture2D m 4 4 rgba8").find("declared on line 1 already, as a mesh"),
              std::string::npos);
}

}  // namespace
}  // namespace glibra::test
