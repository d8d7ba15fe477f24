// --untrusted: scenes draw the same pictures, and reach nothing but their own files.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "program.h"
#include "system/sandbox.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTimerFragment =
    "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(fract(gl_FragCoord.xy / 17.), fract(Timer), 1.); "
    "}\n";

class Untrusted : public testing::Test {
  protected:
    void SetUp() override {
        if (const std::string missing = system::missingForSandbox(); !missing.empty())
            GTEST_SKIP() << missing;
        folder.write("in/a.vert", kVertexShader);
        folder.write("in/a.frag", kTimerFragment);
        folder.write("in/a.glib", "WindowSize 60 40\nVertex a.vert\nFragment a.frag\nProgram P\nTeapot\n");
        folder.write("secret.frag", kTimerFragment);
        folder.write("lib/shaders/l.frag", kTimerFragment);
    }
    Finished run(const std::string& arguments, const std::string& environment = {}) {
        return glibra(folder.path(), arguments, environment);
    }
    void expectSame(const std::string& first, const std::string& second) {
        const std::string bytes = readFile(folder / first);
        EXPECT_FALSE(bytes.empty()) << first;
        EXPECT_EQ(readFile(folder / second), bytes) << first << ", " << second;
    }
    /// Names in the folder and below that begin with ".glibra".
    std::string leftovers() {
        std::string names;
        for (const auto& each : fs::recursive_directory_iterator(folder.path()))
            if (each.path().filename().string().starts_with(".glibra")) names += each.path().string() + "\n";
        return names;
    }

    Folder folder;
};

TEST_F(Untrusted, ScenesDrawTheSameBytesWithEveryDriver) {
    for (const std::string driver : {"egl", "osmesa"}) {
        // OSMesa is missing in newer Mesa, and draws only where the environment names none of its other
        // drivers.
        if (driver == "osmesa" && run("info --driver osmesa").status != 0) continue;
        const std::string scenes = "in/a.glib '" GLIBRA_SOURCE_DIR
                                   "/glib/start/teapot.glib' '" GLIBRA_SOURCE_DIR
                                   "/glib/noise/marble.glib' --size 90x60 --driver " +
                                   driver;
        ASSERT_EQ(run("render " + scenes + " -o free").status, 0);
        const Finished confined = run("render " + scenes + " -o confined --untrusted");
        EXPECT_EQ(confined.status, 0) << confined.err;
        for (const char* each : {"a.png", "teapot.png", "marble.png"})
            expectSame(std::string("free/") + each, std::string("confined/") + each);
        EXPECT_EQ(leftovers(), "");
        for (const char* each : {"free", "confined"}) fs::remove_all(folder / each);
    }
}

TEST_F(Untrusted, DriversOverVulkanFindTheirFiles) {
    fs::path lavapipe;
    std::error_code none;
    for (const auto& each : fs::directory_iterator("/usr/share/vulkan/icd.d", none))
        if (each.path().filename().string().starts_with("lvp_icd")) lavapipe = each.path();
    if (lavapipe.empty()) GTEST_SKIP() << "needs lavapipe";
    const std::string zink =
        "XDG_RUNTIME_DIR=. LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=zink MESA_LOADER_DRIVER_OVERRIDE=zink "
        "VK_ICD_FILENAMES=" +
        lavapipe.string() + " VK_DRIVER_FILES=" + lavapipe.string();
    if (run("render in/a.glib -o free.png --driver egl", zink).status != 0) GTEST_SKIP() << "needs zink";
    const Finished confined = run("render in/a.glib -o confined.png --driver egl --untrusted", zink);
    // Lavapipe of Mesa 25 keeps its memory in files without a name, which the sandbox refuses, because no
    // limit of memory counts them; that of Mesa 22 does not.
    const std::string driver = run("info --driver egl", zink).out;
    const std::size_t mesa = driver.find("Mesa 2");
    if (confined.status != 0 && mesa != std::string::npos && std::atof(driver.c_str() + mesa + 5) >= 23) {
        EXPECT_TRUE(contains(confined.err, "draw-E06")) << confined.err;
        return;
    }
    EXPECT_EQ(confined.status, 0) << confined.err;
    expectSame("free.png", "confined.png");
}

TEST_F(Untrusted, EveryKindOfOutputIsWritten) {
    ASSERT_EQ(run("render in/a.glib -o free.png").status, 0);
    EXPECT_EQ(run("render in/a.glib --untrusted").status, 0);
    expectSame("free.png", "a.png");
    EXPECT_EQ(run("render in/a.glib --untrusted -o new/b.png").status, 0);
    expectSame("free.png", "new/b.png");
    EXPECT_EQ(run("render in/a.glib --untrusted -o - > stdout.png; exit $?").status, 0);
    EXPECT_EQ(run("render in/a.glib -o f.bmp").status, 0);
    EXPECT_EQ(run("render in/a.glib --untrusted -o u.bmp").status, 0);
    expectSame("f.bmp", "u.bmp");
    ASSERT_EQ(run("render in/a.glib --frames 20 --fps 7 -o free/f.png").status, 0);
    EXPECT_EQ(run("render in/a.glib --frames 20 --fps 7 -o film/f.png --untrusted --jobs 2").status, 0);
    for (const char* each : {"f_0000.png", "f_0007.png", "f_0019.png"})
        expectSame(std::string("free/") + each, std::string("film/") + each);
    EXPECT_EQ(leftovers(), "");
}

TEST_F(Untrusted, APictureOfAnotherFormatNeedsTheImageModule) {
    const Finished free = run("render in/a.glib -o f.tif");
    if (free.status != 0) GTEST_SKIP() << "the image module is not built";
    EXPECT_EQ(run("render in/a.glib --untrusted -o u.tif").status, 0);
    EXPECT_EQ(run("compare f.tif u.tif --exact").status, 0);
    folder.write("in/t.glib",
                 "Vertex a.vert\nFragment t.frag\nTexture 5 t.tif\nProgram P uUnit 5\nQuadXY 0 1 1 1\n");
    folder.write("in/t.frag",
                 "#version 330 core\nuniform sampler2D uUnit;\nout vec4 f;\nvoid main() { f = texture(uUnit, "
                 "gl_FragCoord.xy / 60.); }\n");
    fs::copy_file(folder / "f.tif", folder / "in/t.tif");
    ASSERT_EQ(run("render in/t.glib -o free.png").status, 0);
    EXPECT_EQ(run("render in/t.glib -o confined.png --untrusted").status, 0);
    expectSame("free.png", "confined.png");
}

TEST_F(Untrusted, FilesOfLibrariesAreRead) {
    folder.write("in/l.glib", "Vertex a.vert\nFragment l.frag\nProgram P\nTeapot\n");
    EXPECT_EQ(run("render in/l.glib --untrusted", "GLIBRA_PATH=lib").status, 0);
    EXPECT_EQ(run("render in/l.glib --untrusted --library lib").status, 0);
    EXPECT_EQ(run("check in/l.glib --untrusted", "GLIBRA_PATH=lib").status, 0);
}

TEST_F(Untrusted, NoOtherFileIsRead) {
    fs::create_symlink(folder / "secret.frag", folder / "in/link.frag");
    fs::create_directory_symlink(folder.path(), folder / "in/up");
    const std::string absolute = (folder / "secret.frag").string();
    for (const std::string& name :
         std::vector<std::string>{absolute, "../secret.frag", "link.frag", "up/secret.frag",
                                  "/proc/self/cwd/secret.frag", "/proc/self/root" + absolute}) {
        folder.write("in/b.glib", "Vertex a.vert\nFragment \"" + name + "\"\nProgram P\nTeapot\n");
        EXPECT_EQ(run("render in/b.glib -o free.png").status, 0)
            << name << " is not found even without a sandbox";
        for (const char* command : {"render", "check"}) {
            const Finished confined = run(std::string(command) + " in/b.glib --untrusted");
            EXPECT_EQ(confined.status, 3) << command << " " << name;
            EXPECT_TRUE(contains(confined.err, "[file-E")) << confined.err;
        }
        EXPECT_FALSE(fs::exists(folder / "b.png"));
    }
    folder.write("in/c.glib", "Vertex a.vert\nFragment \"/etc/passwd\"\nProgram P\nTeapot\n");
    const Finished passwd = run("render in/c.glib --untrusted");
    EXPECT_EQ(passwd.status, 3);
    EXPECT_FALSE(contains(passwd.err, "root")) << passwd.err;
    folder.write("in/d.frag", "#version 330 core\n#include \"../secret.frag\"\n");
    folder.write("in/d.glib", "Vertex a.vert\nFragment d.frag\nProgram P\nTeapot\n");
    EXPECT_EQ(run("render in/d.glib --untrusted").status, 3);
}

TEST_F(Untrusted, LinksThatAreFoldersOfALibraryAreNotFollowed) {
    // The library beside a scene, above it, and in a folder that the user names: all three are searched.
    const Folder elsewhere;
    elsewhere.write("private.frag", kTimerFragment);
    elsewhere.write("private.raw", std::string(64, 'x'));
    folder.write("in/b.glib", "Vertex a.vert\nFragment private.frag\nProgram P\nTeapot\n");
    struct Case {
        fs::path link;
        std::string options;
    };
    for (const Case& each :
         {Case{"in/shaders", ""}, Case{"in/textures", ""}, Case{"shaders", ""},
          Case{"named/shaders", " --library named"}, Case{"named/textures", " --library named"},
          Case{"named/scenes/models", " --library named"}, Case{"named/shaders/in", " --library named"}}) {
        fs::create_directories((folder / each.link.string()).parent_path());
        fs::create_directory_symlink(elsewhere.path(), folder / each.link.string());
        ASSERT_EQ(run("render in/b.glib -o free.png" + each.options).status, 0) << each.link;
        for (const char* command : {"render", "check"}) {
            const Finished confined = run(std::string(command) + " in/b.glib --untrusted" + each.options);
            EXPECT_EQ(confined.status, 3) << command << each.link << confined.err;
            EXPECT_TRUE(contains(confined.err, "file-W18")) << confined.err;
            EXPECT_TRUE(contains(confined.err, each.link.string())) << confined.err;
        }
        // As a library that the user names, the place is one that may be read.
        EXPECT_EQ(run("render in/b.glib --untrusted -o x.png --library '" + elsewhere.path().string() + "'" +
                      each.options)
                      .status,
                  3)
            << "its files lie beside its folder 'shaders'";
        fs::remove(folder / each.link.string());
    }
    // A link that is the library itself is the user's.
    fs::create_directory_symlink(folder / "lib", folder / "linked");
    folder.write("in/l.glib", "Vertex a.vert\nFragment l.frag\nProgram P\nTeapot\n");
    EXPECT_EQ(run("render in/l.glib --untrusted --library linked").status, 0);
    // Buffers, pictures and models are found in the same folders.
    fs::create_directory_symlink(elsewhere.path(), folder / "in/textures");
    folder.write("in/m.glib",
                 "Vertex inline\n#version 430 core\nvoid main() { gl_Position = vec4(0., 0., 0., 1.); "
                 "}\nEndVertex\nFragment a.frag\nProgram P\nBuffer stolen uint private.raw\nVertices "
                 "points 1\nExpect sum stolen 0\n");
    EXPECT_EQ(run("check --run in/m.glib").status, 1) << "the sum is that of a file that was read";
    const Finished stolen = run("check --run in/m.glib --untrusted");
    EXPECT_EQ(stolen.status, 3) << stolen.err;
    EXPECT_TRUE(contains(stolen.err, "private.raw")) << stolen.err;
}

TEST_F(Untrusted, AFolderOrALinkOfTheNameOfTheStagingFolderIsNotUsed) {
    // The process id is not known before the command runs, so the shell that becomes the command prepares it.
    const Folder elsewhere;
    elsewhere.write("kept/0/a.png", "kept");
    for (const std::string& prepare :
         {std::string("mkdir -p .glibra-$$-untrusted/0 && echo mine > .glibra-$$-untrusted/0/a.png"),
          "ln -s '" + (elsewhere / "kept").string() + "' .glibra-$$-untrusted"}) {
        const Finished done =
            shell(folder.path(), prepare + " && exec '" GLIBRA_PROGRAM "' render in/a.glib --untrusted");
        EXPECT_EQ(done.status, 0) << done.err;
        ASSERT_EQ(run("render in/a.glib -o free.png").status, 0);
        expectSame("free.png", "a.png");
        EXPECT_EQ(readFile(elsewhere / "kept/0/a.png"), "kept");
        EXPECT_NE(leftovers(), "") << "what somebody else made stays";
        for (const auto& each : fs::directory_iterator(folder.path()))
            if (each.path().filename().string().starts_with(".glibra")) fs::remove_all(each.path());
    }
}

TEST_F(Untrusted, AGoodSuiteNeedsNoFolderOfGoldens) {
    folder.write("in/s.toml", "[[shot]]\nscript = \"a.glib\"\nexpect-error = \"glsl-E01\"\n");
    folder.write("in/a.frag", "#version 330 core\nvoid main() { nonsense; }\n");
    for (const char* command : {"test in/s.toml --untrusted", "test s.toml --untrusted"}) {
        if (std::string(command).find("in/") == std::string::npos)
            folder.write("s.toml", "[[shot]]\nscript = \"in/a.glib\"\nexpect-error = \"glsl-E01\"\n");
        const Finished good = run(command);
        EXPECT_EQ(good.status, 0) << command << good.out << good.err;
    }
    folder.write("in/s.toml", "goldens = \"none/yet\"\n[[shot]]\nscript = \"a.glib\"\nexpect-error = true\n");
    EXPECT_EQ(run("test in/s.toml --untrusted").status, 0);
}

TEST_F(Untrusted, ASuiteReachesNothingThroughALink) {
    const Folder elsewhere;
    elsewhere.write("b.glib", "Sphere\n");
    fs::create_directory_symlink(elsewhere.path(), folder / "in/out");
    fs::create_directory_symlink(folder / "lib", folder / "in/inside");
    for (const std::string suite :
         {"[[shot]]\nscript = \"out/b.glib\"\n", "goldens = \"out\"\n[[shot]]\nscript = \"a.glib\"\n",
          "[[shot]]\nscript = \"a.glib\"\nlibrary = [\"out\"]\n",
          "[[shot]]\nscript = \"a.glib\"\nlibrary = [\"inside\"]\n"}) {
        folder.write("in/s.toml", suite);
        for (const char* command :
             {"test in/s.toml --untrusted", "render --suite in/s.toml -o drawn --untrusted"}) {
            const Finished refused = run(command);
            EXPECT_EQ(refused.status, 3) << command << suite;
            EXPECT_TRUE(contains(refused.err, "error: --untrusted: ")) << command << suite << refused.err;
        }
    }
    // The folder that a run writes to is no way out either.
    folder.write("in/s.toml", "[[shot]]\nscript = \"a.glib\"\nexpect-error = true\n");
    fs::create_directory(folder / "results");
    fs::create_directory_symlink(elsewhere.path(), folder / "results/s");
    EXPECT_EQ(run("test in/s.toml --untrusted --results results").status, 3);
}

TEST_F(Untrusted, SuitesAreTestedAndDrawn) {
    folder.write("in/s.toml",
                 "[[shot]]\nscript = \"a.glib\"\n[[shot]]\nname = \"b\"\nscript = \"a.glib\"\ntime = 0.3\n");
    ASSERT_EQ(run("test in/s.toml --update").status, 0);
    const Finished good = run("test in/s.toml --untrusted");
    EXPECT_EQ(good.status, 0) << good.out << good.err;
    folder.write(
        "in/a.frag",
        "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(fract(gl_FragCoord.yx / 5.), 0., 1.); }\n");
    const Finished bad = run("test in/s.toml --untrusted --report report");
    EXPECT_EQ(bad.status, 1) << bad.out << bad.err;
    EXPECT_TRUE(contains(bad.out, "2 failed")) << bad.out;
    EXPECT_TRUE(fs::exists(folder / "glibra-results/s/b.got.png"));
    EXPECT_EQ(run("render --suite in/s.toml -o drawn --untrusted").status, 0);
    EXPECT_TRUE(fs::exists(folder / "drawn/b.png"));
    EXPECT_EQ(run("test in/s.toml --update --untrusted").status, 2);
}

TEST_F(Untrusted, ASuiteCannotNameFoldersElsewhere) {
    const Folder elsewhere;
    elsewhere.write("b.glib", "Sphere\n");
    const std::string other = elsewhere.path().string();
    for (const std::string& suite : {"[[shot]]\nscript = \"" + other + "/b.glib\"\n",
                                     "goldens = \"" + other + "\"\n[[shot]]\nscript = \"a.glib\"\n",
                                     "[[shot]]\nscript = \"a.glib\"\nlibrary = [\"" + other + "\"]\n"}) {
        folder.write("in/s.toml", suite);
        for (const char* command :
             {"test in/s.toml --untrusted", "render --suite in/s.toml -o drawn --untrusted"}) {
            const Finished refused = run(command);
            EXPECT_EQ(refused.status, 3) << command << suite;
            EXPECT_TRUE(contains(refused.err, "error: --untrusted: ")) << command << suite << refused.err;
        }
    }
    folder.write("in/s.toml", "[[shot]]\nscript = \"a.glib\"\n");
    EXPECT_TRUE(contains(run("render --suite in/s.toml -o . --untrusted").err, "error: --untrusted: "));
}

TEST_F(Untrusted, OnlyOrdinaryFilesAreReplaced) {
    fs::create_directory(folder / "a.png");
    EXPECT_EQ(run("render in/a.glib --untrusted").status, 3);
    EXPECT_TRUE(fs::is_directory(folder / "a.png"));
    const Finished device = run("render in/a.glib -o /dev/null --untrusted");
    EXPECT_EQ(device.status, 3) << device.err;
    EXPECT_FALSE(fs::is_regular_file("/dev/null"));
    folder.write("old.png", "old");
    fs::create_symlink("old.png", folder / "link.png");
    EXPECT_EQ(run("render in/a.glib -o link.png --untrusted").status, 0);
    EXPECT_TRUE(fs::is_symlink(folder / "link.png"));
    EXPECT_GT(fs::file_size(folder / "old.png"), 100U);
}

TEST_F(Untrusted, AScenesEndsAreReportedAsWithoutASandbox) {
    folder.write(
        "in/e.frag",
        "#version 330 core\nuniform int uMany;\nout vec4 f;\nvoid main() { float s = 0.; for (int i = "
        "0; i < 2000000000 && s >= 0.; i++) s += abs(sin(float(i + uMany))); f = vec4(s); }\n");
    folder.write("in/e.glib",
                 "WindowSize 3000 3000\nVertex a.vert\nFragment e.frag\nProgram P uMany 1\nQuadXY 0 2 2 2\n");
    const Finished late = run("render in/a.glib in/e.glib --timeout 8 -o out --untrusted");
    EXPECT_EQ(late.status, 3);
    EXPECT_TRUE(contains(late.err, "draw-E07")) << late.err;
    EXPECT_TRUE(fs::exists(folder / "out/a.png"));
    EXPECT_EQ(leftovers(), "");
}

#ifdef GLIBRA_REMOVE_CALL
TEST_F(Untrusted, AKernelWithoutASandboxIsNamedAndNothingIsDrawn) {
    for (const char* call : {"landlock", "seccomp"}) {
        const std::string without =
            std::string("GLIBRA_REMOVE_CALL=") + call + " " + preload(GLIBRA_REMOVE_CALL);
        for (const char* command : {"render in/a.glib -o x.png --untrusted", "check in/a.glib --untrusted",
                                    "test in --untrusted"}) {
            const Finished refused = run(command, without);
            EXPECT_EQ(refused.status, 4) << command << refused.err;
            EXPECT_TRUE(contains(refused.err, call[0] == 'l' ? "Landlock" : "seccomp")) << refused.err;
        }
        EXPECT_FALSE(fs::exists(folder / "x.png"));
        EXPECT_EQ(run("render in/a.glib -o y.png", without).status, 0)
            << "without --untrusted nothing is missed";
    }
}
#endif

}  // namespace
}  // namespace glibra::test
