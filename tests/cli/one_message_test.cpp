// One mistake in a scene of many programs gives one message, and nothing that only follows from it.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "program.h"

namespace glibra::test {
namespace {

const std::string kScene = R"(WindowSize 16 16
Camera eye LookAt 0 0 5  0 0 0  0 1 0  Perspective 40 .1 100
Texture2D glow 8 8 rgba8
Buffer places vec4 [0 0 0 1  .5 0 0 1]
Vertex inline
#version 430
in vec3 vertPos;
in vec3 vertNormal;
uniform mat4 viewProjection;
out vec3 vNormal;
void main() { vNormal = vertNormal; gl_Position = viewProjection * vec4(vertPos, 1.); }
EndVertex
Fragment inline
#version 430
in vec3 vNormal;
uniform vec3 uTint;
uniform float uBright;
out vec4 fColor;
void main() { fColor = vec4(uBright * uTint * abs(vNormal.z), 1.); }
EndFragment
Program Lit  uTint {1 .5 .25}  uBright 1
Vertex inline
#version 430
layout(std430) buffer Places { vec4 place[]; };
void main() { gl_Position = place[gl_VertexID]; }
EndVertex
Fragment inline
#version 430
out vec4 fColor;
void main() { fColor = vec4(1.); }
EndFragment
Program Dots
Fragment inline
#version 430
in vec2 vST;
out vec4 fColor;
void main() { fColor = vec4(vST, 0., 1.); }
EndFragment
Program Ramp
Fragment inline
#version 430
in vec2 vST;
uniform sampler2D uGlow;
out vec4 fColor;
void main() { fColor = texture(uGlow, vST); }
EndFragment
Program Show  uGlow glow
Fill glow with Ramp
Pass window clear {0 0 0} depth 1
    Use Lit
    Sphere 1 8 8
    Use Dots
    Set Places places
    Vertices points 2
EndPass
)";

/// The scene with one part replaced.
std::string with(const std::string& part, const std::string& other) {
    std::string scene = kScene;
    const std::size_t at = scene.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return scene.replace(at, part.size(), other);
}

/// The messages that are no notes, by what follows the file name.
std::string messagesOf(const std::string& scene) {
    const Folder folder;
    folder.write("a.glib", scene);
    const Finished ran = glibra(folder.path(), "check --run a.glib");
    std::string found;
    for (std::size_t begin = 0; begin < ran.err.size();) {
        const std::size_t end = ran.err.find('\n', begin);
        const std::string line = ran.err.substr(begin, end - begin);
        if (line.find(": note:") == std::string::npos) found += line.substr(line.find(':') + 1) + "\n";
        begin = end == std::string::npos ? ran.err.size() : end + 1;
    }
    return found;
}

/// Expects one message, which begins with that place and has these words.
void expectOne(const std::string& scene, const std::string& place, const std::string& words) {
    const std::string found = messagesOf(scene);
    EXPECT_EQ(std::count(found.begin(), found.end(), '\n'), 1) << found;
    EXPECT_EQ(found.substr(0, place.size()), place) << found;
    EXPECT_NE(found.find(words), std::string::npos) << found;
}

TEST(OneMessage, OfASceneWithoutMistakeIsNone) {
    EXPECT_EQ(messagesOf(kScene), "");
}

TEST(OneMessage, ForAPassThatIsNotRead) {
    expectOne(with("Pass window clear {0 0 0} depth 1", "Pass window clear 0 0 0 depth 1"), "49:19",
              "write {0 0 0}");
    expectOne(with("EndPass\n", ""), "49:1", "write EndPass");
    expectOne(with("Vertices points 2", "Vertices points from plcaes"), "54:26", "did you mean 'places'");
}

TEST(OneMessage, ForAFillThatIsMissingOrNotRead) {
    expectOne(with("Fill glow with Ramp", "Fill glow Ramp"), "48:1", "expected 'with'");
    const std::string shown = kScene + "Fill window with Show\n";
    EXPECT_EQ(messagesOf(shown), "");
    std::string forgotten = shown;
    forgotten.erase(forgotten.find("Fill glow with Ramp\n"), 20);
    expectOne(forgotten, "55:1", "nothing draws or writes into it");
}

TEST(OneMessage, ForAShaderUnderTheWordOfAnotherStage) {
    const std::string geometry =
        "#version 430\nlayout(points) in;\nlayout(points, max_vertices = 1) out;\n"
        "void main() { gl_Position = gl_in[0].gl_Position; EmitVertex(); }\n";
    const std::string vertex =
        "#version 430\nlayout(std430) buffer Places { vec4 place[]; };\n"
        "void main() { gl_Position = place[gl_VertexID]; }\n";
    expectOne(with(vertex, geometry), "26:51", "'EmitVertex' belongs to a geometry stage");
    expectOne(with("void main() { fColor = vec4(1.); }", "void main() { EmitVertex(); }"), "30:15",
              "write 'Geometry' before it");
    expectOne(with("void main() { vNormal = vertNormal;",
                   "void main() { vNormal = vertNormal; if (gl_FragCoord.x > 4.) discard;"),
              "11:41", "'gl_FragCoord' belongs to a fragment stage");
}

TEST(OneMessage, ForACallThatNoFunctionTakes) {
    expectOne(with("texture(uGlow, vST)", "texture(uGlow, vec3(vST, 0.))") + "Fill window with Show\n",
              "45:24", "no matching function");
}

TEST(OneMessage, ForAMisspeltInput) {
    std::string scene = with("in vec3 vNormal;\nuniform vec3 uTint", "in vec3 vNormla;\nuniform vec3 uTint");
    scene.replace(scene.find("abs(vNormal.z)"), 14, "abs(vNormla.z)");
    expectOne(scene, "15:9", "did you mean 'vNormal'");
}

TEST(OneMessage, ForAProgramStatementThatIsNotRead) {
    expectOne(with("uBright 1\n", "uBright 2*max(1, 2)\n"), "21:40", "write (2*max(1, 2))");
}

TEST(OneMessage, ForABufferThatIsNotRead) {
    expectOne(with("[0 0 0 1  .5 0 0 1]", "[[0 0 0 1] [.5 0 0 1]]"), "4:21", "brackets cannot be nested");
}

TEST(OneMessage, ForBlocksThatLayOutABufferDifferently) {
    expectOne(with("Program Dots\n",
                   "Program Dots\nCompute inline\n#version 430\nlayout(local_size_x = 1) in;\n"
                   "layout(std430) buffer Numbers { vec3 number[]; };\n"
                   "void main() { number[gl_GlobalInvocationID.x] = vec3(0.); }\nEndCompute\n"
                   "Program Zero  Numbers places\nDispatch Zero 8\n"),
              "4:1", "differently");
}

TEST(OneMessage, ForASamplerWithoutTexture) {
    expectOne(with("Program Show  uGlow glow", "Program Show") + "Fill window with Show\n", "47:1",
              "'uGlow' of 'Show' is not set");
}

}  // namespace
}  // namespace glibra::test
