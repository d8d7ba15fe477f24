// `Program Name const NAME value` (language, 12.1): values of the scene that shaders are compiled with.

#include <gtest/gtest.h>

#include <string>

#include "script_problems.h"

namespace glibra::test {
namespace {

std::string sized(const std::string& scene, const std::string& declaration, const std::string& given) {
    return scene + "Buffer numbers uint 64 (0)\nCompute inline\n#version 430\n" + declaration +
           "layout(local_size_x = SIZE) in;\nlayout(std430) buffer numbers { uint n[]; };\n"
           "shared uint s[SIZE];\n"
           "void main() {\n    s[gl_LocalInvocationIndex] = uint(SIZE);\n    barrier();\n"
           "    n[gl_GlobalInvocationID.x] = s[0] + 100u * uint(gl_NumWorkGroups.x);\n}\nEndCompute\n"
           "Program P const SIZE " +
           given + "\nDispatch P over numbers\nPass window\nEndPass\n";
}

TEST(ScriptConstants, DecideTheSizeOfWorkGroups) {
    for (const char* declaration : {"", "#define SIZE 4\n", "#ifndef SIZE\n#define SIZE 4\n#endif\n"})
        EXPECT_EQ(problemsOf(sized("Let size <1 16 64>\n", declaration, "(size)") +
                             "Expect (numbers[0] == 416 && numbers[63] == 416)\n"),
                  "")
            << declaration;
    RenderOptions options;
    options.set = {"size=32"};
    EXPECT_EQ(
        problemsOf(sized("Let size <1 16 64>\n", "", "size") + "Expect (numbers[63] == 232)\n", {}, options),
        "");
}

TEST(ScriptConstants, OfTwoProgramsMayDiffer) {
    const std::string fragment =
        "Fragment inline\n#version 330\nconst vec3 TINT = vec3(1.);\nout vec4 c;\n"
        "void main() { c = vec4(TINT, 1.); }\nEndFragment\n";
    EXPECT_EQ(problemsOf("Texture2D a 2 2 rgba8\nTexture2D b 2 2 rgba8\n" + fragment +
                         "Program Red const TINT {1 0 0}\nProgram Blue const TINT (vec3(0, 0, 1))\n"
                         "Program White\nFill a with Red\nFill b with Blue\nFill window with White\n"
                         "Expect pixel 0 0 {1 0 0 1} of a\nExpect pixel 0 0 {0 0 1 1} of b\n"
                         "Expect pixel 0 0 {1 1 1 1}\n"),
              "");
}

TEST(ScriptConstants, AreRefusedWhereTheyCannotBe) {
    const auto problems = [](const std::string& given) {
        return problemsOf(
            "Let a (time)\nCamera eye LookAt 0 0 5 0 0 0 0 1 0 Perspective 50 1 20\n"
            "Fragment inline\n#version 330\nout vec4 c;\nvoid main() { c = vec4(float(N)); }\n"
            "EndFragment\nProgram P " +
            given + "\nFill window with P\n");
    };
    const auto has = [&](const std::string& given, const std::string& message) {
        const std::string found = problems(given);
        EXPECT_NE(found.find(message), std::string::npos) << given << "\n" << found;
    };
    has("const N (time)",
        "const N follows the time, so the shaders would be compiled for every frame; make it a uniform "
        "variable: N (time) [glib-E39]");
    has("const N (a * 2)", "const N follows the time");
    has("const N (mouse.x)", "const N follows the mouse");
    has("const N (eye.position.x)", "const N follows the camera");
    has("const N 1 const N 2", "Program: 'N' given twice [glib-E18]");
    has("const N 1 N 2", "Program: 'N' given twice, as a constant and as a uniform variable [glib-E18]");
    has("const float 1 const N 1", "[glib-E");
    has("const for 1 const N 1", "'for' has a meaning of its own in GLSL; choose another name [glib-E36]");
    has("const gl_N 1 const N 1", "'gl_N' has a meaning of its own in GLSL");
    has("const int N 2.5", "const N: 2.5 is no int [glib-E33]");
    has("const vec3 N 2.5", "const N: 2.5 is no vec3 [glib-E33]");
    has("const N 1 const M 2", "no shader of Program 'P' has the name 'M', so 'const M' has no effect");
    has("const N", "[glib-E");
    EXPECT_EQ(problems("const N 1"), "");
}

}  // namespace
}  // namespace glibra::test
