// Input that crashes the driver, hangs a decoder or takes all memory: it costs its own scene or picture and
// nothing else, and every command ends with one message and status 3.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <sstream>
#include <string>

#include "image/png/png_writer.h"
#include "program.h"

namespace glibra::test {
namespace {

class Containment : public testing::Test {
  protected:
    /// A scene with one program, whose fragment shader is the text.
    void writeScene(const std::string& name, const std::string& fragment) const {
        folder.write(
            name + ".vert",
            "#version 330 core\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n");
        folder.write(name + ".frag", fragment);
        folder.write(name + ".glib",
                     "Vertex " + name + ".vert\nFragment " + name + ".frag\nProgram P\nSphere\n");
    }
    [[nodiscard]] static std::string doublingMacros(int count) {
        std::string text = "#version 330 core\n#define M0 1.\n";
        for (int i = 1; i <= count; ++i)
            text += "#define M" + std::to_string(i) + " M" + std::to_string(i - 1) + "+M" +
                    std::to_string(i - 1) + "\n";
        return text + "out vec4 o;\nvoid main() { o = vec4(M" + std::to_string(count) + "); }\n";
    }
    /// So many functions that call each other that the driver's compiler runs out of stack.
    [[nodiscard]] static std::string deepCalls(int functions) {
        std::string text =
            "#version 330 core\nuniform float uA;\nout vec4 o;\nfloat f0(float a) { return a; }\n";
        for (int i = 1; i < functions; ++i)
            text += fmt::format("float f{}(float a) {{ return f{}(a) + 1.; }}\n", i, i - 1);
        return text + fmt::format("void main() {{ o = vec4(f{}(uA)); }}\n", functions - 1);
    }
    /// A WebP picture of 2 x 2 pixels, which the preloaded library decodes for ever.
    void writeEndlessPicture(const std::string& name) const {
        constexpr std::string_view kFile(
            "RIFF\x24\0\0\0WEBPVP8L\x11\0\0\0\x2f\x01\x40\0\0\x07\x50\x84\x26\xf4\xa0\xff\x81\x88\xe8\x7f\0\0"
            "\0\0\0\0\0\0",
            44);
        folder.write(name, std::string(kFile));
    }
    void writePng(const std::string& name) const {
        const auto file = image::encodePng({2, 2, 1, image::Component::u8, std::vector<std::byte>(4)});
        folder.write(name, {reinterpret_cast<const char*>(file.data()), file.size()});
    }
    [[nodiscard]] Finished run(const std::string& arguments) const {
        return glibra(folder.path(), arguments);
    }
    static void expectContains(const std::string& text, std::string_view part) {
        EXPECT_NE(text.find(part), std::string::npos) << part << "\nin\n" << text.substr(0, 4000);
    }
    static std::ptrdiff_t linesOf(const std::string& text) {
        return std::count(text.begin(), text.end(), '\n');
    }

    Folder folder;
};

TEST_F(Containment, CheckGoesOnAfterASceneThatCrashesTheDriver) {
    writeScene("deep", deepCalls(8'000));
    writeScene("wrong", "#version 330 core\nout vec4 o;\nvoid main() { o = nonsense; }\n");
    writeScene("good", "#version 330 core\nout vec4 o;\nvoid main() { o = vec4(1.); }\n");
    // A sanitizer would end the process by itself, without a signal.
    const std::string signals = "ASAN_OPTIONS=\"$ASAN_OPTIONS:handle_segv=0\"";
    // What ends it first depends on the driver: its stack, or the 12 GB that it wants for this.
    const char* const kEnd = GLIBRA_SANITIZED ? "ended " : "ended with signal";
    const std::string memory = GLIBRA_SANITIZED ? "" : " --memory 2G";
    for (const char* jobs : {"1", "3"}) {
        const Finished all =
            glibra(folder.path(), std::string("check deep.glib wrong.glib good.glib --jobs ") + jobs + memory,
                   signals);
        EXPECT_EQ(all.status, 3);
        expectContains(all.err,
                       std::string("deep.glib:1:1: error: the process that checked the scene ") + kEnd);
        expectContains(all.err, "wrong.frag:3:");
        EXPECT_LT(all.err.find("deep.glib"), all.err.find("wrong.frag")) << "not in the order of the scenes";
        EXPECT_EQ(all.err.find("good"), std::string::npos) << all.err;
    }
    EXPECT_EQ(run("check good.glib").status, 0);
    const Finished json = glibra(folder.path(), "check deep.glib good.glib --json" + memory, signals);
    expectContains(json.out, "\"id\": \"draw-E06\"");
    expectContains(json.out, "\"scene\": \"good.glib\",\n    \"good\": true");
}

#ifdef GLIBRA_ENDLESS_DECODER
TEST_F(Containment, ADecoderThatNeverEndsCostsItsOwnScene) {
    writeScene("good", "#version 330 core\nout vec4 o;\nvoid main() { o = vec4(1.); }\n");
    writeEndlessPicture("a.webp");
    folder.write(
        "picture.frag",
        "#version 330 core\nuniform sampler2D uPicture;\nout vec4 o;\nvoid main() { o = texture(uPicture, "
        "vec2(.5)); }\n");
    folder.write(
        "endless.glib",
        "Texture2D 5 a.webp\nVertex good.vert\nFragment picture.frag\nProgram P uPicture 5\nSphere\n");
    const std::string endless = preload(GLIBRA_ENDLESS_DECODER);
    for (const char* command :
         {"check --run endless.glib good.glib --timeout 3", "render endless.glib good.glib --timeout 3"}) {
        const Finished ran = glibra(folder.path(), command, endless);
        if (ran.err.find("not installed") != std::string::npos) GTEST_SKIP() << ran.err;
        EXPECT_EQ(ran.status, 3) << command;
        expectContains(ran.err,
                       "endless.glib:1:1: error: 'a.webp': not decoded within 3 seconds (--timeout)");
        EXPECT_EQ(ran.err.find("[draw-E07]"), std::string::npos) << ran.err;
        std::istringstream lines(ran.err);
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with("good.glib:")) {
                EXPECT_NE(line.find(": note:"), std::string::npos) << line;
            }
        }
    }
    const Finished confined =
        glibra(folder.path(), "check --run endless.glib good.glib --timeout 3 --untrusted", endless);
    if (confined.err.find("--untrusted") == std::string::npos)
        expectContains(confined.err, "'a.webp': not decoded within 3 seconds (--timeout)");
}
#endif

TEST_F(Containment, MacrosThatGrowWithoutBoundAreRefused) {
    writeScene("macros", doublingMacros(40));
    writeScene("good", doublingMacros(4));
    for (const char* command : {"check macros.glib good.glib", "render macros.glib good.glib"}) {
        const Finished all = run(command);
        EXPECT_EQ(all.status, 3);
        expectContains(all.err, "macros.frag:1:1: error: the macros expand to more than 2,000,000 tokens");
        expectContains(all.err, "[glsl-E11]");
    }
    EXPECT_EQ(folder.listing().find("macros.png"), std::string::npos);
    EXPECT_NE(folder.listing().find("good.png"), std::string::npos);
}

#ifdef GLIBRA_ENDLESS_DECODER
TEST_F(Containment, CompareEndsADecoderThatNeverEnds) {
    writeEndlessPicture("a.webp");
    writePng("a.png");
    for (const char* pair : {"a.webp a.png", "a.png a.webp"}) {
        const Finished compared = glibra(folder.path(), std::string("compare --timeout 1 ") + pair,
                                         preload(GLIBRA_ENDLESS_DECODER));
        if (compared.err.find("not installed") != std::string::npos) GTEST_SKIP() << compared.err;
        EXPECT_EQ(compared.status, 3) << pair;
        EXPECT_EQ(compared.err, "a.webp:1:1: error: 'a.webp': not decoded within 1 seconds [file-E11]\n");
        EXPECT_EQ(compared.out, "");
    }
}

TEST_F(Containment, AMergeAndItsReportDecodeHostilePicturesWithinTheirLimits) {
    // Results as a stranger may send them: the pictures of the shot are WebP files under several names, in
    // the folder of the run and beside it.
    folder.write("a.vert", "#version 330 core\nvoid main() { gl_Position = vec4(aVertex.xy, 0., 1.); }\n");
    folder.write("a.frag",
                 "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(gl_FragCoord.x / 30.); }\n");
    folder.write("a.glib", "Vertex a.vert\nFragment a.frag\nProgram P\nQuadXY 0 1 1 1\n");
    folder.write("s.toml",
                 "goldens = \"golden\"\n[defaults]\nsize = [30, 20]\n[[shot]]\nscript = \"a.glib\"\n");
    ASSERT_EQ(run("test s.toml --update").status, 0);
    folder.write("a.frag",
                 "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(gl_FragCoord.y / 30.); }\n");
    ASSERT_EQ(run("test s.toml --results run").status, 1);
    const std::string honest = readFile(folder / "run/results.jsonl");
    const std::string endless = preload(GLIBRA_ENDLESS_DECODER);
    writeEndlessPicture("golden/endless.webp");
    const auto replaced = [&](const std::string& member, const std::string& value) {
        const std::size_t at = honest.find("\"" + member + "\":");
        EXPECT_NE(at, std::string::npos) << honest;
        const std::size_t begin = honest.find('"', at + member.size() + 3), end = honest.find('"', begin + 1);
        return honest.substr(0, begin + 1) + value + honest.substr(end);
    };
    for (const std::string name : {"endless.webp", "endless.png", "endless.exr"}) {
        writeEndlessPicture("run/s/" + name);
        folder.write("run/results.jsonl", replaced("got", "s/" + name));
        const Finished merged =
            shell(folder.path(),
                  endless + " timeout 40 '" GLIBRA_PROGRAM "' test --merge run --results all --report page");
        EXPECT_EQ(merged.status, 1) << merged.out << merged.err;
        expectContains(merged.err, "'s/" + name + "' is not a picture");
        expectContains(merged.out, "1 failed");
        EXPECT_TRUE(std::filesystem::exists(folder / "page/index.html"));
    }
    // Below a folder that the report may show, the picture is decoded, in a process of its own.
    folder.write("run/results.jsonl", replaced("expected", (folder / "golden/endless.webp").string()));
    const Finished shown =
        shell(folder.path(), endless + " timeout 40 '" GLIBRA_PROGRAM
                                       "' test --merge run --results all --report page --root golden "
                                       "--timeout 1");
    if (shown.err.find("not installed") != std::string::npos) GTEST_SKIP() << shown.err;
    EXPECT_EQ(shown.status, 1) << shown.out << shown.err;
    expectContains(shown.err, "endless.webp': not decoded within 1 seconds");
    expectContains(readFile(folder / "page/index.html"), "not decoded within 1 seconds");
}

#endif

TEST_F(Containment, CompareHasALimitOfMemory) {
    image::Image large{6000, 6000, 3, image::Component::u8, {}};
    large.data.resize(std::size_t{6000} * 6000 * 3);
    const auto file = image::encodePng(large);
    folder.write("a.png", {reinterpret_cast<const char*>(file.data()), file.size()});
    folder.write("b.png", readFile(folder / "a.png") + " ");  // not equal byte for byte
    EXPECT_EQ(run("compare a.png b.png --memory 2G").status, 0);
#if GLIBRA_SANITIZED
    GTEST_SKIP() << "under the address sanitizer, an allocation that fails ends the process";
#endif
    const Finished small = run("compare a.png b.png --memory 64M");
    EXPECT_EQ(small.status, 3);
    expectContains(small.err, "there is not enough memory to read it");
}

TEST_F(Containment, ASceneThatNeedsMoreThanItsMemoryIsAnErrorOfItsOwn) {
    folder.write("large.glib", "Noise3D 400\nVertex n.vert\nFragment n.frag\nProgram P\nSphere\n");
    folder.write("n.vert",
                 "#version 330 core\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n");
    folder.write(
        "n.frag",
        "#version 330 core\nuniform sampler3D Noise3;\nout vec4 o;\nvoid main() { o = texture(Noise3, "
        "vec3(gl_FragCoord)); }\n");
    folder.write("good.glib", "Sphere\n");
    const Finished all = run("render large.glib good.glib --memory 256M");
    EXPECT_EQ(all.status, 3) << all.err;
    expectContains(all.err, "large.glib");
    expectContains(all.err, "memory");
    expectContains(all.err, "1 of 2 scenes rendered, failed: large.glib");
}

/// Memory may end where the text is read, where it runs and where a shape is made.
TEST_F(Containment, ALackOfMemoryIsSaidInPlainWordsAtTheStatement) {
#if GLIBRA_SANITIZED
    GTEST_SKIP() << "under the address sanitizer, an allocation that fails ends the process";
#endif
    std::string statements = "WindowSize 32 32\n";
    for (int i = 0; i < 190'000; ++i) statements += "Sphere 1 3 3 [a 1]\n";
    for (const auto& [text, place] :
         {std::pair<std::string, std::string>{"Sphere 1\nTeapot 500\n", "a.glib:2:1"},
          {"Sphere 1\nRepeat 190000\n    Sphere 1 3 3\nEndRepeat\n", "a.glib:3:5"},
          {statements, "a.glib:1:1"}}) {
        folder.write("a.glib", text);
        const Finished ended = run("render a.glib --size 32x32 --memory 80M");
        EXPECT_EQ(ended.status, 3);
        expectContains(ended.err, place + ": error: ");
        expectContains(ended.err, "out of memory (--memory)");
        EXPECT_FALSE(contains(ended.err, "bad_alloc")) << ended.err;
    }
}

TEST_F(Containment, AnAnimationIsReadWithinItsLimitOfTime) {
    // The search for Timer looks each of these up, although the compiler skips them.
    std::string fragment = "#version 330 core\nout vec4 o;\n#if 0\n";
    for (int i = 0; i < 200'000; ++i) fragment += "#include \"n" + std::to_string(i) + ".h\"\n";
    writeScene("film", fragment + "#endif\nvoid main() { o = vec4(1.); }\n");
    const Finished film = run("render film.glib --frames 64 --jobs 2 --timeout 1 --size 16x16");
    EXPECT_EQ(film.status, 3);
    expectContains(film.err, "film.glib:1:1: error: not drawn within 1 seconds (--timeout)");
}

TEST_F(Containment, AFileThatIsLargerThanTheShellAllowsIsAnError) {
    folder.write("scene.glib", "WindowSize 400 400\nSphere\n");
    const Finished limited =
        shell(folder.path(), "(ulimit -f 1; '" GLIBRA_PROGRAM "' render scene.glib -o scene.bmp)");
    EXPECT_EQ(limited.status, 3) << limited.err;
    expectContains(limited.err, "cannot write");
    EXPECT_EQ(folder.listing(), "scene.glib\n");
}

TEST_F(Containment, AMemoryThatIsNoSizeIsWrongUsage) {
    folder.write("scene.glib", "Sphere\n");
    for (const char* size : {"", "12", "1M", "2g", "-1", "2GB", "99999999999999999999", "nan"}) {
        const Finished wrong = run(std::string("check scene.glib --memory '") + size + "'");
        EXPECT_EQ(wrong.status, 2) << size;
    }
    for (const char* size : {"0", "1G", "2048M"})
        EXPECT_EQ(run(std::string("check scene.glib --memory ") + size).status, 0) << size;
}

}  // namespace
}  // namespace glibra::test
