// Wrong input, one test each: one clear message with file, line and column, the right exit status, and no
// half-written file.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "program.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWhiteFragment =
    "#version 330 core\nout vec4 fColor;\nvoid main() { fColor = vec4(1.); }\n";

class BadInput : public testing::Test {
  protected:
    /// Renders scene.glib and expects status 3, no picture, and all `parts` in the messages.
    void expectRefused(std::string_view scene, std::initializer_list<const char*> parts,
                       const std::string& arguments = {}) {
        folder.write("scene.glib", scene);
        const std::string before = folder.listing();
        const Finished run = glibra(folder.path(), "render scene.glib " + arguments);
        EXPECT_EQ(run.status, 3) << run.err;
        for (const char* part : parts)
            EXPECT_NE(run.err.find(part), std::string::npos) << part << "\nin\n" << run.err;
        EXPECT_EQ(run.out, "");
        EXPECT_EQ(folder.listing(), before) << "something was left behind";
    }

    void writeShaders() const {
        folder.write("a.vert", kVertexShader);
        folder.write("a.frag", kWhiteFragment);
    }

    Folder folder;
};

TEST_F(BadInput, UnknownCommand) {
    expectRefused("Perspective 50\nSpere 1\n",
                  {"scene.glib:2:1: error:", "'Spere'", "'Sphere'", "[glib-E01]"});
}

TEST_F(BadInput, WrongArgument) {
    expectRefused("Perspective 190\n", {"scene.glib:1:", "190", "[glib-E05]"});
}

TEST_F(BadInput, InvalidErrorBound) {
    folder.write("scene.glib", "Sphere\n");
    for (const char* bound : {"0", "-1", "nan", "inf", "1e-10", "1e7", "px", "1mm", "0x1p3", "1,5"}) {
        const Finished run = glibra(folder.path(), std::string("render scene.glib --max-error=") + bound);
        EXPECT_EQ(run.status, 2) << bound << run.err;
        EXPECT_NE(run.err.find("expected a number from 1e-09 to 1e+06, as 0.25px, found"), std::string::npos)
            << bound << run.err;
    }
    EXPECT_EQ(glibra(folder.path(), "render scene.glib --override-counts").status, 2);
    EXPECT_EQ(folder.listing(), "scene.glib\n");
}

TEST_F(BadInput, AnUnreachableErrorBoundIsReportedAndDrawn) {
    folder.write("scene.glib", "LookAt 0 0 4 0 0 0 0 1 0\nSphere\n");
    const Finished run = glibra(folder.path(), "render scene.glib --size 64x64 --max-error 1e-9px");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.err.find("scene.glib:1:1: warning: the driver has"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("scene.glib:2:1: warning: Sphere with"), std::string::npos) << run.err;
    EXPECT_TRUE(std::filesystem::exists(folder / "scene.png"));
}

TEST_F(BadInput, MissingScene) {
    const Finished run = glibra(folder.path(), "render nowhere.glib");
    EXPECT_EQ(run.status, 3);
    EXPECT_NE(run.err.find("nowhere.glib"), std::string::npos);
    EXPECT_NE(run.err.find("[glib-E14]"), std::string::npos) << run.err;
}

TEST_F(BadInput, SceneIsAFolder) {
    std::filesystem::create_directory(folder / "scene.glib");
    const Finished run = glibra(folder.path(), "render scene.glib");
    EXPECT_EQ(run.status, 3);
    EXPECT_NE(run.err.find("[glib-E14]"), std::string::npos) << run.err;
}

TEST_F(BadInput, BinaryScene) {
    expectRefused(std::string_view("Sphere\n\0\0\1", 10), {"scene.glib:2:1: error:", "[glib-E03]"});
}

TEST_F(BadInput, MissingShader) {
    expectRefused("Vertex none.vert\nFragment none.frag\nProgram P\nSphere\n",
                  {"scene.glib:1:", "none.vert", "[file-E01]", "scene.glib:2:"});
}

TEST_F(BadInput, EmptyShader) {
    writeShaders();
    folder.write("a.frag", "");
    expectRefused("Vertex a.vert\nFragment a.frag\nProgram P\nSphere\n", {"a.frag", "[file-E02]"});
}

TEST_F(BadInput, ShaderIsAFolder) {
    writeShaders();
    std::filesystem::create_directory(folder / "b.frag");
    expectRefused("Vertex a.vert\nFragment b.frag\nProgram P\nSphere\n", {"scene.glib:2:", "b.frag"});
}

TEST_F(BadInput, ShaderErrorNamesItsOwnLine) {
    writeShaders();
    folder.write("a.frag",
                 "#version 330 core\nout vec4 fColor;\n\nvoid main() {\n    fColor = nonsense;\n}\n");
    expectRefused("Vertex a.vert\nFragment a.frag\nProgram P\nSphere\n",
                  {"a.frag:5:", "error:", "nonsense", "[glsl-E01]"});
}

TEST_F(BadInput, ShaderErrorInAnIncludedFileNamesThatFile) {
    writeShaders();
    folder.write("common.glsl", "float one() {\n    return missing;\n}\n");
    folder.write(
        "a.frag",
        "#version 330 core\n#include \"common.glsl\"\nout vec4 f;\nvoid main() { f = vec4(one()); }\n");
    expectRefused("Vertex a.vert\nFragment a.frag\nProgram P\nSphere\n",
                  {"common.glsl:2:", "missing", "[glsl-E01]"});
}

TEST_F(BadInput, LinkError) {
    folder.write("a.vert",
                 "#version 330 core\nout vec3 vN;\nvoid main() { vN = aNormal; gl_Position = "
                 "uModelViewProjectionMatrix * aVertex; }\n");
    folder.write("a.frag", "#version 330 core\nin vec4 vN;\nout vec4 f;\nvoid main() { f = vN; }\n");
    expectRefused("Vertex a.vert\nFragment a.frag\nProgram P\nSphere\n",
                  {"vN", "a.vert", "a.frag", "[glsl-E02]"});
}

TEST_F(BadInput, ASceneThatIsALinkToAnotherKindOfFileIsNotRead) {
    folder.write("secret", "TOP_SECRET 1\n");
    folder.write("real.glib", "Sphere 1\n");
    fs::create_symlink("secret", folder / "a.glib");
    fs::create_symlink("real.glib", folder / "b.glib");
    const Finished refused = glibra(folder.path(), "check a.glib");
    EXPECT_EQ(refused.status, 3);
    EXPECT_NE(refused.err.find("glib-E14"), std::string::npos) << refused.err;
    EXPECT_EQ(refused.err.find("TOP_SECRET"), std::string::npos) << refused.err;
    EXPECT_EQ(glibra(folder.path(), "check b.glib").status, 0);
}

TEST_F(BadInput, TheTextOfAFileOutsideOfTheSceneIsNeverQuoted) {
    folder.write("outside/secret.txt", "TOP_SECRET_token = hunter2;\n");
    folder.write("outside/good.frag",
                 "#version 330 core\nout vec4 f;\n// TOP_SECRET\nvoid main() { f = vec4(1.); }\n");
    folder.write("outside/secret.obj",
                 "v TOP_SECRET 1 2\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\nf TOP_SECRET 1 2\n");
    folder.write("scenes/a.vert", "#version 330 core\nvoid main() { gl_Position = aVertex; }\n");
    folder.write("scenes/a.frag",
                 "#version 330 core\n#include \"../outside/secret.txt\"\nout vec4 f;\nvoid main() { f = "
                 "vec4(1.); }\n");
    const std::string secret = (folder / "outside/secret.txt").string();
    const auto scene = [&](const std::string& fragment, const std::string& shape) {
        folder.write("scenes/a.glib",
                     "Vertex a.vert\nFragment \"" + fragment + "\"\nProgram P\n" + shape + "\n");
    };
    for (const std::string& fragment : {secret, std::string("../outside/secret.txt"), std::string("a.frag"),
                                        std::string("../outside/good.frag")})
        for (const char* command :
             {"check scenes/a.glib --translated out", "check scenes/a.glib --json",
              "render scenes/a.glib -o a.png", "render scenes/a.glib -o a.png --explain"}) {
            scene(fragment, "QuadXY 0 1 1 1");
            const Finished finished = glibra(folder.path(), command);
            EXPECT_EQ(finished.status, fragment.ends_with("good.frag") ? 0 : 3)
                << fragment << command << finished.err;
            for (const std::string& text : {finished.out, finished.err}) {
                EXPECT_EQ(text.find("TOP_SECRET"), std::string::npos) << fragment << command << text;
                EXPECT_EQ(text.find("hunter2"), std::string::npos) << fragment << command << text;
            }
        }
    scene("../outside/good.frag", "Obj ../outside/secret.obj");
    const Finished finished = glibra(folder.path(), "render scenes/a.glib -o a.png");
    EXPECT_EQ((finished.out + finished.err).find("TOP_SECRET"), std::string::npos) << finished.err;
    folder.write("outside/web.frag",
                 "#version 330 core\nuniform float TOP_SECRET = sin(1.);\nout vec4 f;\nvoid main() { f = "
                 "vec4(TOP_SECRET); }\n");
    scene("../outside/web.frag", "QuadXY 0 1 1 1");
    const Finished web = glibra(folder.path(), "check scenes/a.glib --web");
    EXPECT_EQ(web.status, 3);
    EXPECT_NE(web.err.find("web-E05"), std::string::npos) << web.err;
    EXPECT_EQ(web.err.find("TOP_SECRET"), std::string::npos) << web.err;
    EXPECT_EQ(glibra(folder.path(), "check scenes/a.glib --web --no-shim").status, 2);
    scene("../outside/good.frag", "Obj ../outside/secret.obj");
    ASSERT_EQ(glibra(folder.path(), "check scenes/a.glib --translated out").status, 0);
    std::string translated;
    for (const auto& each : fs::directory_iterator(folder / "out")) translated += readFile(each.path());
    EXPECT_NE(translated.find("#error not shown"), std::string::npos);
    EXPECT_EQ(translated.find("TOP_SECRET"), std::string::npos);
    fs::create_directory_symlink(folder / "outside", folder / "scenes/shaders");
    ASSERT_EQ(glibra(folder.path(), "check scenes/a.glib --translated out").status, 0);
    translated.clear();
    for (const auto& each : fs::directory_iterator(folder / "out")) translated += readFile(each.path());
    EXPECT_NE(translated.find("#error"), std::string::npos) << "a link beside the scene makes no library";
    fs::remove(folder / "scenes/shaders");
    fs::create_directories(folder / "lib/shaders");
    fs::copy(folder / "outside/good.frag", folder / "lib/shaders/good.frag");
    scene("../lib/shaders/good.frag", "QuadXY 0 1 1 1");
    ASSERT_EQ(glibra(folder.path(), "check scenes/a.glib --translated out", "GLIBRA_PATH=lib").status, 0);
    translated.clear();
    for (const auto& each : fs::directory_iterator(folder / "out")) translated += readFile(each.path());
    EXPECT_EQ(translated.find("#error"), std::string::npos) << "a library root may be shown";
}

TEST_F(BadInput, TheTextOfAnIncludedSceneOutsideOfTheSceneIsNeverQuoted) {
    writeShaders();
    fs::create_directories(folder / "scenes");
    for (const char* each : {"a.vert", "a.frag"}) fs::rename(folder / each, folder / "scenes" / each);
    folder.write("scenes/own.glib", "Let own (1)\n");
    fs::create_directories(folder / "outside");
    fs::create_symlink("../outside/secret.txt", folder / "scenes/link.glib");
    const std::string program = "Vertex a.vert\nFragment a.frag\nProgram P ";
    for (const std::string& secret :
         {std::string("TOP-SECRET 1 2\n"), std::string("MessageBox TOP_SECRET\n"),
          std::string("Sphere TOP_SECRET\n"), std::string("Let x (TOP_SECRET + 1)\n"),
          std::string("Texture2D 5 TOP_SECRET.png\n"), std::string("Obj TOP_SECRET.obj\n"),
          std::string("Print (TOP_SECRET)\n"), std::string("Draw TOP_SECRET\n"),
          program + "TOP_SECRET 1\nSphere\n", program + "\nSphere\nSet TOP_SECRET 1\n"}) {
        folder.write("outside/secret.txt", secret);
        for (const char* name : {"../outside/secret.txt", "link.glib"})
            for (const char* command :
                 {"check scenes/a.glib", "check scenes/a.glib --run", "check scenes/a.glib --json",
                  "render scenes/a.glib -o a.png", "test scenes --results r --report p --junit j.xml"}) {
                folder.write("scenes/a.glib",
                             std::string("Include ") + name + "\n" + program + "\nSphere 1\n");
                Finished finished = glibra(folder.path(), command);
                if (std::string_view(command).starts_with("test"))
                    for (const char* each : {"r/results.jsonl", "j.xml", "p/index.html"})
                        finished.out += readFile(folder / each);
                const std::string text = finished.out + finished.err;
                for (const char* word : {"TOP_SECRET", "TOP-SECRET"})
                    EXPECT_FALSE(contains(text, word)) << secret << name << command << text;
                EXPECT_TRUE(!std::string_view(command).ends_with("--run") ||
                            contains(text, "the text of this message is not shown"))
                    << secret << name << command << text;
            }
    }
    folder.write("scenes/own.glib", "TOP_SECRET 1 2\n");
    folder.write("scenes/a.glib", "Include own.glib\nSphere 1\n");
    EXPECT_TRUE(contains(glibra(folder.path(), "check scenes/a.glib").err, "TOP_SECRET"));
    fs::create_directories(folder / "lib/shaders");
    fs::copy(folder / "scenes/own.glib", folder / "lib/shaders/other.glib");
    folder.write("scenes/a.glib", "Include other.glib\nSphere 1\n");
    EXPECT_TRUE(contains(glibra(folder.path(), "check scenes/a.glib", "GLIBRA_PATH=lib").err, "TOP_SECRET"));
    folder.write("outside/a.hdr", "#?RADIANCE\nFORMAT=TOP_SECRET\n\n-Y 1 +X 1\n1234");
    folder.write("scenes/b.frag",
                 "#version 330 core\nuniform sampler2D uImage;\nout vec4 f;\nvoid main() { f = "
                 "texture(uImage, vec2(.5)); }\n");
    folder.write("scenes/a.glib",
                 "Texture2D 5 ../outside/a.hdr\nVertex a.vert\nFragment b.frag\nProgram P uImage "
                 "5\nSphere 1\n");
    const Finished picture = glibra(folder.path(), "render scenes/a.glib -o a.png");
    EXPECT_TRUE(contains(picture.err, "[file-E04]")) << picture.err;
    EXPECT_FALSE(contains(picture.err, "TOP_SECRET")) << picture.err;
}

TEST_F(BadInput, MessagesAboutTheScenesOwnShadersAreShownWithoutWordsOfFilesOutside) {
    folder.write(
        "common/light.glsl",
        "// function type undeclared hunter2\n#define TOKEN hunter2\n#define SHORT qz\n"
        "#define JOIN(a, b) a##b\nfloat secretDepth;\nvec3 light(vec3 n, float power) { return n * power; "
        "}\n");
    folder.write("scenes/a.vert", "#version 330 core\nvoid main() { gl_Position = aVertex; }\n");
    folder.write("scenes/a.glib", "Vertex a.vert\nFragment a.frag\nProgram P\nQuadXY 0 1 1 1\n");
    const auto contains = [](const std::string& text, std::string_view part) {
        return text.find(part) != std::string::npos;
    };
    const auto messages = [&](const std::string& line) {
        folder.write(
            "scenes/a.frag",
            "#version 330 core\n#include \"../common/light.glsl\"\nout vec4 f;\nvoid main() {\n    " + line +
                "\n    f = vec4(1.);\n}\n");
        const Finished finished = glibra(folder.path(), "render scenes/a.glib -o a.png");
        EXPECT_EQ(finished.status, 3) << line << finished.err;
        for (const char* secret : {"hunter2", "qz", "secretDepth", "power"})
            EXPECT_EQ(finished.err.find(secret), std::string::npos) << line << finished.err;
        return finished.err;
    };
    for (const char* line :
         {"float x = bas(2.);", "vec3 c = light(1);", "float x = undeclaredName;", "float x = ;"}) {
        const std::string shown = messages(line);
        EXPECT_TRUE(contains(shown, "a.frag:5:")) << shown;
        EXPECT_FALSE(contains(shown, "is not shown")) << shown;
    }
    EXPECT_TRUE(contains(messages("float x = bas(2.);"), "bas"));
    EXPECT_TRUE(contains(messages("float x = undeclaredName;"), "`undeclaredName' undeclared"));
    // Words that come from the other file, alone and joined with one of the shader.
    for (const char* line : {"float x = TOKEN;", "float x = JOIN(my, TOKEN);", "float x = SHORT;",
                             "float x = secretDepht;", "float secretDept = secretDepht; x"}) {
        const std::string shown = messages(line);
        EXPECT_TRUE(contains(shown, "a.frag:5:")) << shown;
    }
    EXPECT_TRUE(contains(messages("float x = TOKEN;"), "stands for words of '"))
        << messages("float x = TOKEN;");
}

TEST_F(BadInput, IncludeRecursion) {
    writeShaders();
    folder.write("x.glsl", "#include \"y.glsl\"\n");
    folder.write("y.glsl", "#include \"x.glsl\"\n");
    folder.write("a.frag",
                 "#version 330 core\n#include \"x.glsl\"\nout vec4 f;\nvoid main() { f = vec4(1.); }\n");
    expectRefused("Vertex a.vert\nFragment a.frag\nProgram P\nSphere\n", {"[glsl-E04]", "x.glsl", "y.glsl"});
}

TEST_F(BadInput, TruncatedBmp) {
    writeShaders();
    folder.write("a.frag",
                 "#version 330 core\nuniform sampler2D uUnit;\nout vec4 f;\nvoid main() { f = texture(uUnit, "
                 "vec2(.5)); }\n");
    std::string bmp = "BM";
    const auto add32 = [&](unsigned value) {
        for (int i = 0; i < 4; ++i) bmp += static_cast<char>(value >> (8 * i));
    };
    const unsigned header[] = {54 + 64 * 64 * 3, 0, 54, 40, 64, 64, 1 + (24 << 16), 0,
                               64 * 64 * 3,      0, 0,  0,  0};
    for (const unsigned each : header) add32(each);
    bmp.append(1920, 'x');  // ten of the 64 rows
    folder.write("wood.bmp", bmp);
    expectRefused("Texture2D 5 wood.bmp\nVertex a.vert\nFragment a.frag\nProgram P uUnit 5\nSphere\n",
                  {"scene.glib:1:", "wood.bmp", "[file-E04]"});
}

TEST_F(BadInput, RawTextureWithALyingHeader) {
    writeShaders();
    folder.write("a.frag",
                 "#version 330 core\nuniform sampler3D uUnit;\nout vec4 f;\nvoid main() { f = texture(uUnit, "
                 "vec3(.5)); }\n");
    folder.write("lie.tex", std::string_view("\xff\xff\xff\x7f\xff\xff\xff\x7f\xff\xff\xff\x7f texels", 19));
    expectRefused("Texture3D 5 lie.tex\nVertex a.vert\nFragment a.frag\nProgram P uUnit 5\nSphere\n",
                  {"scene.glib:1:", "lie.tex", "[file-E05]"});
}

TEST_F(BadInput, ObjIndexOutOfRangeDropsTheFaceOrRefusesTheModel) {
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 1000000000\n");
    expectRefused("Obj a.obj\n", {"a.obj", "[file-E07]"});
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\nf 1 2 3\n");
    folder.write("scene.glib", "Obj a.obj\n");
    const Finished run = glibra(folder.path(), "render scene.glib");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.err.find("[file-W05]"), std::string::npos) << run.err;
}

TEST_F(BadInput, AbsurdSizes) {
    expectRefused("Sphere 1 1000000 1000000\n", {"scene.glib:1:", "Sphere", "[glib-E"});
    expectRefused("Sphere 1 65000 65000\n", {"scene.glib:1:", "8,388,608", "[glib-E15]"});
    expectRefused("Noise3D 100000\n", {"scene.glib:1:", "Noise3D", "[glib-E"});
    expectRefused("WindowSize 0 0\n", {"scene.glib:1:", "WindowSize", "[glib-E05]"});
    expectRefused("Translate 1e999 0 0\n", {"scene.glib:1:", "[glib-E31]"});
}

TEST_F(BadInput, AShaderThatNeverEndsEndsTheSceneAlone) {
    writeShaders();
    folder.write("a.frag",
                 "#version 330 core\nuniform float uStep;\nout vec4 f;\nvoid main() { float x = 0.; while (x "
                 "< 1.) x += "
                 "uStep; f = vec4(x); }\n");
    folder.write("endless.glib", "Vertex a.vert\nFragment a.frag\nProgram P uStep 0.\nSphere\n");
    folder.write("good.glib", "Sphere\n");
    const Finished run = glibra(folder.path(), "render endless.glib good.glib --timeout 2");
    EXPECT_EQ(run.status, 3) << run.err;
    EXPECT_NE(run.err.find("endless.glib:1:1: error: not drawn within 2 seconds"), std::string::npos)
        << run.err;
    EXPECT_NE(run.err.find("1 of 2 scenes rendered, failed: endless.glib"), std::string::npos) << run.err;
    EXPECT_EQ(folder.listing(), "a.frag\na.vert\nendless.glib\ngood.glib\ngood.png\n");
}

TEST_F(BadInput, UnwritableOutput) {
    folder.write("scene.glib", "Sphere\n");
    const Finished run = glibra(folder.path(), "render scene.glib -o /proc/none/a.png");
    EXPECT_EQ(run.status, 3) << run.err;
    EXPECT_NE(run.err.find("/proc/none/a.png"), std::string::npos) << run.err;
    folder.write("taken.png/inside", "a folder where the picture should go");
    const Finished taken = glibra(folder.path(), "render scene.glib -o taken.png/../taken.png/");
    EXPECT_EQ(taken.status, 0) << "a folder is a place for pictures: " << taken.err;
}

TEST_F(BadInput, AnOutputWhosePathCannotBeLookedUpIsReported) {
    folder.write("scene.glib", "Sphere\n");
    fs::create_symlink("there", folder / "here");
    fs::create_symlink("here", folder / "there");
    const std::string listing = folder.listing();
    const std::string longName(300, 'n');
    for (const std::string& output : {std::string("here/x.png"), std::string("here"), longName + ".png",
                                      longName + "/x.png", std::string("here/x.gif --frames 2")}) {
        const Finished run = glibra(folder.path(), "render scene.glib -o " + output);
        EXPECT_EQ(run.status, 3) << output;
        EXPECT_TRUE(contains(run.err, "error: cannot write '")) << run.err;
        EXPECT_FALSE(contains(run.err, "filesystem error")) << run.err;
        EXPECT_TRUE(contains(run.err, "[file-E10]")) << run.err;
    }
    EXPECT_EQ(folder.listing(), listing);
}

TEST_F(BadInput, UnknownOutputFormat) {
    folder.write("scene.glib", "Sphere\n");
    const Finished run = glibra(folder.path(), "render scene.glib -o a.xyz");
    EXPECT_EQ(run.status, 3);
    EXPECT_NE(run.err.find("a.xyz"), std::string::npos) << run.err;
    EXPECT_EQ(folder.listing(), "scene.glib\n");
}

TEST_F(BadInput, WrongUsageIsStatusTwo) {
    folder.write("scene.glib", "Sphere\n");
    for (const char* arguments :
         {"paint scene.glib", "render", "render scene.glib --size 0x10", "render scene.glib --size 600",
          "render scene.glib --size 99999999999x1", "render scene.glib --driver vulkan",
          "render scene.glib --frames 0", "render scene.glib --nonsense", "render scene.glib --time later",
          "render scene.glib --set uKd"}) {
        const Finished run = glibra(folder.path(), arguments);
        EXPECT_EQ(run.status, 2) << arguments << "\n" << run.err;
        EXPECT_FALSE(run.err.empty()) << arguments;
    }
    EXPECT_EQ(folder.listing(), "scene.glib\n");
}

TEST_F(BadInput, ANoiseOptionThatChangesNothingIsRefused) {
    for (const auto& [arguments, why] : std::vector<std::pair<const char*, const char*>>{
             {"1 --height 3=1 --height 999=1", "--height 999=1: the points are 0 to 7"},
             {"1 --gradient 4=.5 --points 4", "--gradient 4=0.5: the points are 0 to 3"},
             {"2 --curvature 64=1", "--curvature 64=1: the points are 0 to 63"},
             {"1 --smooth cubic --curvature 1=1", "take --smooth quintic"},
             {"1 --height 3=1 --height 3=.5", "--height: point 3 has a value already"},
             {"1 --colors fire", "--colors: only a picture of two dimensions has colors"},
             {"2 --colors fire -o n.tex", "--colors: only a picture of two dimensions has colors"},
             {"1 --lattice both --gradients catmull-rom", "--gradients: only --lattice value takes"}}) {
        const Finished run = glibra(folder.path(), std::string("noise ") + arguments);
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_TRUE(contains(run.err, why)) << run.err;
    }
    EXPECT_EQ(folder.listing(), "");
    EXPECT_EQ(glibra(folder.path(), "noise 2 --height 63=1 --colors fire").status, 0);
}

TEST_F(BadInput, NoDriverIsStatusFour) {
    folder.write("scene.glib", "Sphere\n");
    const Finished run = glibra(folder.path(), "render scene.glib --driver egl-device",
                                "__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json");
    EXPECT_EQ(run.status, 4) << run.err;
    EXPECT_NE(run.err.find("error:"), std::string::npos);
}

TEST_F(BadInput, ADriverThatIsTooOldIsNamed) {
    folder.write("scene.glib", "Sphere\n");
    for (const char* version : {"3.3", "2.1"})
        for (const char* driver : {"egl", "osmesa"}) {
            if (driver == std::string("osmesa") && !hasOsmesa()) continue;
            const Finished run = glibra(folder.path(), std::string("render scene.glib --driver ") + driver,
                                        std::string("MESA_GL_VERSION_OVERRIDE=") + version);
            EXPECT_EQ(run.status, 4) << run.err;
            EXPECT_NE(run.err.find(std::string("no OpenGL 4.1; it is ") + version), std::string::npos)
                << run.err;
        }
}

TEST_F(BadInput, StrictTurnsWarningsIntoErrors) {
    folder.write("scene.glib", "Sphere 1 2\n");
    EXPECT_EQ(glibra(folder.path(), "render scene.glib").status, 0);
    const Finished run = glibra(folder.path(), "render scene.glib --strict -o strict.png");
    EXPECT_EQ(run.status, 3);
    EXPECT_NE(run.err.find("error: Sphere: 2 slices raised to 3 [glib-W28]"), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "strict.png"));
}

TEST_F(BadInput, NanIsReportedOnceInTheFirstFrameThatHasItAndStrictRefusesIt) {
    folder.write("nan.frag",
                 "#version 330 core\nuniform float Timer;\nout vec4 f;\n"
                 "void main() { f = vec4(sqrt(.25 - Timer), gl_FragCoord.x, 0., 1.); }\n");
    folder.write("scene.glib",
                 "WindowSize 8 8\nTimer 1\nVertex whole.vert\nFragment nan.frag\nProgram P\nQuadXY 0 1\n");
    folder.write(
        "whole.vert",
        "#version 330 core\nin vec4 aVertex;\nvoid main() { gl_Position = vec4(aVertex.xy, 0., 1.); }\n");
    const std::string frames = "render scene.glib --frames 4 --fps 5 -o f.exr";  // 0, .2, .4, .6 seconds
    const Finished run = glibra(folder.path(), frames);
    EXPECT_EQ(run.status, 0) << run.err;
    const std::size_t first = run.err.find("[draw-W06]");
    EXPECT_NE(first, std::string::npos) << run.err;
    EXPECT_EQ(run.err.find("[draw-W06]", first + 1), std::string::npos) << run.err;
    EXPECT_EQ(glibra(folder.path(), "render scene.glib --strict -o good.exr").status, 0);
    EXPECT_EQ(glibra(folder.path(), "render scene.glib --strict --time .5 -o bad.exr").status, 3);
    EXPECT_FALSE(std::filesystem::exists(folder / "bad.exr"));
}

TEST_F(BadInput, AllMistakesOfAFileComeAtOnce) {
    expectRefused("Spere\nLookAt 1 2\nPopMatrix\n", {"[glib-E01]", "[glib-E04]", "[glib-E06]"});
}

}  // namespace
}  // namespace glibra::test
