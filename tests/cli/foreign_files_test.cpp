// Files that are something else than what the scene, the command line or an #include takes them for.

#include <gtest/gtest.h>

#include <string>

#include "program.h"

namespace glibra::test {
namespace {

using namespace std::string_literals;

/// The text in UTF-16, with its mark.
std::string utf16(std::string_view text) {
    std::string bytes = "\xff\xfe";
    for (const char each : text) bytes += std::string{each, '\0'};
    return bytes;
}

const std::string kShader = "#version 330\nout vec4 c;\nvoid main() { c = vec4(1.); }\n";

TEST(ForeignFile, InThePlaceOfASceneHasOneMessage) {
    const Folder folder;
    const std::pair<std::string, const char*> files[] = {
        {kShader, "this is a GLSL shader, not a scene"},
        {"// light\nuniform float uA;\nvec3 light(vec3 n) { return n * uA; }\n", "this is a GLSL shader"},
        {"{\n  \"asset\": { \"version\": \"2.0\" }\n}\n", "this is a glTF model, not a scene"},
        {"# cube\no Cube\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "this is an OBJ model"},
        {"ply\nformat ascii 1.0\nelement vertex 0\nend_header\n", "this is a PLY model"},
        {"\x89PNG\r\n\x1a\n\0\0\0\rIHDR"s, "this is a PNG picture"},
        {"%PDF-1.7\n1 0 obj\n", "this is a PDF document"},
        {utf16("Sphere 1\nTeapot\n"), "this is UTF-16 text; save it as UTF-8"},
        {"\1\2\3\0\4"s, "this is a binary file, not a scene"},
    };
    for (const auto& [content, message] : files) {
        folder.write("a.glib", content);
        const Finished checked = glibra(folder.path(), "check a.glib");
        EXPECT_NE(checked.status, 0) << message;
        EXPECT_TRUE(contains(checked.err + checked.out, message)) << checked.err << checked.out;
        EXPECT_FALSE(contains(checked.err + checked.out, "unknown command")) << checked.err << checked.out;
    }
    // Comments and misspelt words of a scene may be those that other files begin with.
    for (const char* begin : {"", "#version 2 of my scene\n", "#if it rains\n", "# a scene\nv 1\n"}) {
        folder.write("a.glib", std::string(begin) + "Spere 1\nBox 1\nTeapot\nTorus .1 .5\n");
        EXPECT_TRUE(contains(glibra(folder.path(), "check a.glib").err, "unknown command 'Spere'")) << begin;
    }
}

TEST(ForeignFile, InThePlaceOfAShaderOrModelIsNamed) {
    const Folder folder;
    folder.write("ok.vert", kVertexShader);
    folder.write("ok.frag", kShader);
    folder.write("u.frag", utf16(kShader));
    folder.write("p.frag", "\x89PNG\r\n\x1a\n\0\0\0\rIHDR"s);
    folder.write("k.glsl", utf16("float k;\n"));
    folder.write("i.frag", "#version 330\n#include \"k.glsl\"\nout vec4 c;\nvoid main() { c = vec4(1.); }\n");
    folder.write("m.ply", "ply\nformat ascii 1.0\nelement vertex 0\nend_header\n");
    folder.write("u.obj", utf16("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    folder.write("b.obj", "glTF\2\0\0\0"s);
    const std::pair<const char*, const char*> cases[] = {
        {"Vertex ok.vert\nFragment u.frag\nProgram P\nSphere 1\n",
         "'u.frag' is UTF-16 text; save it as UTF-8"},
        {"Vertex ok.vert\nFragment p.frag\nProgram P\nSphere 1\n", "'p.frag' is a PNG picture, not a shader"},
        {"Vertex ok.vert\nFragment i.frag\nProgram P\nSphere 1\n",
         "'k.glsl' is UTF-16 text; save it as UTF-8"},
        {"Obj m.ply\n", "'m.ply' is a PLY model, not an OBJ model"},
        {"Obj u.obj\n", "'u.obj' is UTF-16 text; save it as UTF-8"},
        {"Obj b.obj\n", "'b.obj' is a glTF model, not an OBJ model"},
    };
    for (const auto& [scene, message] : cases) {
        folder.write("a.glib", scene);
        const Finished checked = glibra(folder.path(), "check a.glib");
        EXPECT_NE(checked.status, 0) << message;
        EXPECT_TRUE(contains(checked.err, message)) << checked.err;
        EXPECT_FALSE(contains(checked.err, "has no faces")) << checked.err;
    }
}

TEST(ForeignCharacter, OfAShaderIsShownByItsNumberAndName) {
    const Folder folder;
    folder.write("ok.vert", kVertexShader);
    folder.write("a.glib", "Vertex ok.vert\nFragment a.frag\nProgram P\nSphere 1\n");
    const std::pair<const char*, const char*> characters[] = {
        {"\xc2\xa0", "'\\u00a0' (no-break space)"},
        {"\xe2\x80\x8b", "'\\u200b' (zero-width space)"},
        {"\xe3\x80\x80", "'\\u3000' (ideographic space)"},
        {"\xc3\xa9", "'\xc3\xa9' outside comments"}};
    for (const auto& [character, shown] : characters) {
        folder.write("a.frag", std::string("#version 330\nout vec4 c;\nvoid main() { c =") + character +
                                   "vec4(1.); }\n");
        const Finished checked = glibra(folder.path(), "check a.glib");
        EXPECT_TRUE(contains(checked.err, shown)) << checked.err;
    }
}

TEST(LargeNumber, IsAnErrorWithItsPlaceAtTheTimeThatItIsComputed) {
    const Folder folder;
    folder.write("ok.vert", kVertexShader);
    folder.write(
        "a.frag",
        "#version 430\nuniform float uA;\nuniform vec3 uV;\nuniform mat4 uM;\nuniform double uD;\nout "
        "vec4 c;\nvoid main() { c = vec4(uV * uA, float(uD)) * uM; }\n");
    const std::string head = "Let x <0 1 2>\nVertex ok.vert\nFragment a.frag\nProgram P ";
    const auto rendered = [&](const std::string& tags, const std::string& options = {}) {
        folder.write("a.glib", head + tags + "\nSphere 1\n");
        return glibra(folder.path(), "render a.glib --size 16x16 -o a.png " + options);
    };
    const std::string right = "uA 1 uV [1 1 1] uM (mat4(1)) uD (1e300)";
    EXPECT_EQ(rendered(right).status, 0) << rendered(right).err;
    for (const char* tags :
         {"uA (1e39) uV [1 1 1] uM (mat4(1)) uD 1", "uA 1 uV (vec3(1, 1e39, 1)) uM (mat4(1)) uD 1",
          "uA 1 uV [1 1 1] uM (mat4(1e39)) uD 1"}) {
        const Finished found = rendered(tags);
        EXPECT_NE(found.status, 0) << tags;
        EXPECT_TRUE(contains(found.err, "a.glib:4:")) << found.err;
        EXPECT_TRUE(contains(found.err, "is too large for a 32-bit float [glib-E31]")) << found.err;
    }
    const std::string moving = "uA (pow(10, time)) uV [1 1 1] uM (mat4(1)) uD 1";
    EXPECT_EQ(rendered(moving, "--time 38").status, 0);
    EXPECT_TRUE(contains(rendered(moving, "--time 39").err, "glib-E31"));
    EXPECT_TRUE(contains(rendered(right, "--set x=1e39").err, "'1e39' is too large"));
    EXPECT_TRUE(contains(rendered(right, "--set uV=1,,0").err, "a number is missing"));
    folder.write(
        "b.glib",
        head + right + "\nSphere 1\nBuffer b float [1 (1e39)]\nPrint b\nBuffer d double [1e300]\nPrint d\n");
    const Finished buffers = glibra(folder.path(), "check --run b.glib");
    EXPECT_TRUE(contains(buffers.err, "b.glib:6:1: error: buffer 'b'")) << buffers.err;
    EXPECT_FALSE(contains(buffers.err, "buffer 'd'")) << buffers.err;
}

TEST(IncludedScene, IsNamedInMessagesAboutItsTags) {
    const Folder folder;
    folder.write("ok.vert", kVertexShader);
    folder.write("ok.frag", kShader);
    folder.write("looks.glib",
                 "Vertex ok.vert\nFragment ok.frag\nProgram P uNope 1\nProgram Q uGone (2*x)\n");
    folder.write("a.glib", "Let x 1\n\n\n\nInclude looks.glib\nUse P\nSphere 1\nUse Q\nSphere 1\n");
    const Finished checked = glibra(folder.path(), "check a.glib");
    EXPECT_TRUE(contains(checked.err, "looks.glib:3:11: warning: no shader of 'P' has a uniform 'uNope'"))
        << checked.err;
    EXPECT_TRUE(contains(checked.err, "looks.glib:4:11: warning: no shader of 'Q' has a uniform 'uGone'"))
        << checked.err;
}

}  // namespace
}  // namespace glibra::test
