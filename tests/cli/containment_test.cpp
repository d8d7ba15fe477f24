// Input that crashes the driver, hangs a decoder or takes all memory: it costs its own scene or picture and
// nothing else, and every command ends with one message and status 3.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
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
    [[nodiscard]] static std::string longSum(int terms) {
        std::string text = "#version 330 core\nuniform float uA;\nout vec4 o;\nvoid main() { o = vec4(uA";
        for (int i = 0; i < terms; ++i) text += "+uA";
        return text + "); }\n";
    }
    /// A DDS file of 160 bytes that OpenImageIO reads for ever: a cube map with 2^31 levels.
    void writeEndlessPicture(const std::string& name) const {
        std::string file = "DDS ";
        const auto put = [&](std::initializer_list<std::uint32_t> values) {
            for (const std::uint32_t each : values)
                for (unsigned shift = 0; shift < 32; shift += 8)
                    file += static_cast<char>(static_cast<unsigned char>(each >> shift & 255U));
        };
        put({124, 0x21007, 4, 4, 16, 0, 0x7fffffff});
        file.resize(file.size() + 44);
        put({32, 0x41, 0, 32, 0xff0000, 0xff00, 0xff, 0xff000000, 0x401008, 0xfe00, 0, 0, 0});
        file.resize(160);
        folder.write(name, file);
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
    writeScene("deep", longSum(200'000));
    writeScene("wrong", "#version 330 core\nout vec4 o;\nvoid main() { o = nonsense; }\n");
    writeScene("good", "#version 330 core\nout vec4 o;\nvoid main() { o = vec4(1.); }\n");
    // A sanitizer would end the process by itself, without a signal.
    const std::string signals = "ASAN_OPTIONS=\"$ASAN_OPTIONS:handle_segv=0\"";
    for (const char* jobs : {"1", "3"}) {
        const Finished all = glibra(
            folder.path(), std::string("check deep.glib wrong.glib good.glib --jobs ") + jobs, signals);
        EXPECT_EQ(all.status, 3);
        expectContains(all.err, "deep.glib:1:1: error: the process that checked the scene ended with signal");
        expectContains(all.err, "wrong.frag:3:");
        EXPECT_LT(all.err.find("deep.glib"), all.err.find("wrong.frag")) << "not in the order of the scenes";
        EXPECT_EQ(all.err.find("good"), std::string::npos) << all.err;
    }
    EXPECT_EQ(run("check good.glib").status, 0);
    const Finished json = glibra(folder.path(), "check deep.glib good.glib --json", signals);
    expectContains(json.out, "\"id\": \"draw-E06\"");
    expectContains(json.out, "\"scene\": \"good.glib\",\n    \"good\": true");
}

TEST_F(Containment, CheckHasALimitOfTime) {
    writeScene("good", "#version 330 core\nout vec4 o;\nvoid main() { o = vec4(1.); }\n");
    writeEndlessPicture("a.dds");
    folder.write("endless.glib", "Texture2D 5 a.dds\nSphere\n");
    const Finished checked = run("check endless.glib good.glib --timeout 2");
    if (checked.err.find("not installed") != std::string::npos) GTEST_SKIP() << checked.err;
    EXPECT_EQ(checked.status, 3);
    expectContains(checked.err, "endless.glib:1:1: error: not checked within 2 seconds (--timeout)");
    EXPECT_EQ(linesOf(checked.err), 1) << checked.err;
}

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

TEST_F(Containment, CompareEndsADecoderThatNeverEnds) {
    writeEndlessPicture("a.dds");
    writePng("a.png");
    for (const char* pair : {"a.dds a.png", "a.png a.dds"}) {
        const Finished compared = run(std::string("compare --timeout 1 ") + pair);
        if (compared.err.find("not installed") != std::string::npos) GTEST_SKIP() << compared.err;
        EXPECT_EQ(compared.status, 3) << pair;
        EXPECT_EQ(compared.err, "a.dds:1:1: error: 'a.dds': not decoded within 1 seconds [file-E11]\n");
        EXPECT_EQ(compared.out, "");
    }
}

TEST_F(Containment, AMergeAndItsReportDecodeHostilePicturesWithinTheirLimits) {
    // Results as a stranger may send them: the pictures of the shot are DDS files under several names, in the
    // folder of the run and beside it.
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
    writeEndlessPicture("golden/endless.dds");
    const auto replaced = [&](const std::string& member, const std::string& value) {
        const std::size_t at = honest.find("\"" + member + "\":");
        EXPECT_NE(at, std::string::npos) << honest;
        const std::size_t begin = honest.find('"', at + member.size() + 3), end = honest.find('"', begin + 1);
        return honest.substr(0, begin + 1) + value + honest.substr(end);
    };
    for (const std::string name : {"endless.dds", "endless.png", "endless.exr"}) {
        writeEndlessPicture("run/s/" + name);
        folder.write("run/results.jsonl", replaced("got", "s/" + name));
        const Finished merged = shell(
            folder.path(), "timeout 40 '" GLIBRA_PROGRAM "' test --merge run --results all --report page");
        EXPECT_EQ(merged.status, 1) << merged.out << merged.err;
        expectContains(merged.err, "'s/" + name + "' is not a picture");
        expectContains(merged.out, "1 failed");
        EXPECT_TRUE(std::filesystem::exists(folder / "page/index.html"));
    }
    // Below a folder that the report may show, the picture is decoded, in a process of its own.
    folder.write("run/results.jsonl", replaced("expected", (folder / "golden/endless.dds").string()));
    const Finished shown =
        shell(folder.path(), "timeout 40 '" GLIBRA_PROGRAM
                             "' test --merge run --results all --report page --root golden "
                             "--timeout 1");
    if (shown.err.find("not installed") != std::string::npos) GTEST_SKIP() << shown.err;
    EXPECT_EQ(shown.status, 1) << shown.out << shown.err;
    expectContains(shown.err, "endless.dds': not decoded within 1 seconds");
    expectContains(readFile(folder / "page/index.html"), "not decoded within 1 seconds");
}

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
