// Every scene of the repository renders without messages to a picture of more than one colour, also on GL
// 4.1. A second compiler accepts its translated shaders.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <vector>

#include <sstream>

#include "image/compare/compare.h"
#include "image/image.h"
#include "image/read.h"
#include "program.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> scenes() {
    std::vector<fs::path> found;
    for (const auto& each : fs::recursive_directory_iterator(GLIBRA_SOURCE_DIR "/glib"))
        if (each.path().extension() == ".glib") found.push_back(each.path());
    std::sort(found.begin(), found.end());
    return found;
}

std::string allScenes() {
    std::string names;
    for (const fs::path& each : scenes()) names += "'" + each.string() + "' ";
    return names;
}

TEST(Scenes, AreThereAndFreeOfMessages) {
    EXPECT_GE(scenes().size(), 19U);
    const Folder folder;
    const Finished run = glibra(folder.path(), "check --strict " + allScenes());
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err, "");
}

TEST(Scenes, AreDrawnAndNotOneColour) {
    const Folder folder;
    const Finished run =
        glibra(folder.path(), "render --strict --size 150x120 --time 2.5 --jobs 2 " + allScenes());
    EXPECT_EQ(run.status, 0) << run.err;
    std::size_t pictures = 0;
    for (const auto& each : fs::recursive_directory_iterator(folder.path())) {
        if (each.path().extension() != ".png") continue;
        const auto picture = image::readImage(each.path());
        ASSERT_TRUE(picture) << each.path();
        EXPECT_EQ(picture->width, 150);
        EXPECT_FALSE(image::isOneColor(*picture)) << each.path();
        ++pictures;
    }
    EXPECT_EQ(pictures, scenes().size());
}

TEST(Scenes, LookTheSameOnGl41) {
#if GLIBRA_SANITIZED
    GTEST_SKIP() << "every scene is drawn twice; AreDrawnAndNotOneColour draws them with sanitizers";
#endif
    const Folder folder;
    ASSERT_EQ(glibra(folder.path(), "render -o new --size 150x120 --jobs 2 " + allScenes()).status, 0);
    const Finished run = glibra(folder.path(), "render -o old --size 150x120 --jobs 2 " + allScenes(),
                                "MESA_GL_VERSION_OVERRIDE=4.1");
    // Scenes with compute stages and the like may need more, and each says what.
    std::istringstream errors(run.err);
    for (std::string line; std::getline(errors, line);) {
        const bool isMissing = line.find("this one has 4.1") != std::string::npos ||
                               line.find("this driver has 4.1") != std::string::npos;
        EXPECT_TRUE(isMissing || line.find(": error: ") == std::string::npos) << line;
    }
    for (const auto& each : fs::recursive_directory_iterator(folder / "new")) {
        if (each.path().extension() != ".png") continue;
        if (!fs::exists(folder / "old" / fs::relative(each.path(), folder / "new"))) continue;
        const auto expected = image::readImage(each.path());
        const auto got = image::readImage(folder / "old" / fs::relative(each.path(), folder / "new"));
        ASSERT_TRUE(expected && got) << each.path();
        const image::Comparison difference = image::compare(*expected, *got);
        // A few pixels on edges and thresholds may change.
        EXPECT_LE(static_cast<double>(difference.differingPixels), 0.01 * 150 * 120) << each.path();
    }
}

TEST(Scenes, TranslatedShadersAreAcceptedByGlslang) {
#if GLIBRA_SANITIZED
    GTEST_SKIP() << "AreThereAndFreeOfMessages translates every shader with sanitizers";
#endif
    // Each stage is compiled alone, because linking depends on the driver, and once, because scenes share
    // shaders. Two processes of the compiler share the work: its start costs more than a shader.
    const Folder folder;
    std::set<std::string> known;
    for (const fs::path& each : scenes()) {
        const fs::path shaders = folder / "shaders";
        const Finished run = glibra(folder.path(), "check --translated shaders '" + each.string() + "'");
        ASSERT_EQ(run.status, 0) << each << run.err;
        if (!fs::exists(shaders)) continue;
        for (const auto& shader : fs::directory_iterator(shaders)) {
            if (!known.insert(readFile(shader.path())).second) continue;
            const fs::path half = folder / (known.size() % 2 == 0 ? "even" : "odd");
            fs::create_directories(half);
            fs::rename(shader.path(), half / (each.stem().string() + "-" + std::to_string(known.size()) +
                                              shader.path().extension().string()));
        }
        fs::remove_all(shaders);
    }
    ASSERT_GT(known.size(), scenes().size());
    const std::string compile = "cd '" + folder.path().string() +
                                "' && (cd odd && glslangValidator *.* >../odd.txt 2>&1) & odd=$!; (cd '" +
                                folder.path().string() +
                                "/even' && glslangValidator *.* >../even.txt 2>&1) && wait $odd";
    EXPECT_EQ(std::system(compile.c_str()), 0);
    for (const char* each : {"odd.txt", "even.txt"}) {
        std::istringstream said(readFile(folder / each));
        int files = 0;
        for (std::string line; std::getline(said, line); ++files)  // a file name, or what is wrong with it
            EXPECT_EQ(line.find("ERROR"), std::string::npos) << line;
        EXPECT_GE(files, static_cast<int>(known.size() / 2)) << each;
    }
}

TEST(Program, LinksNeitherWindowNorPictureLibraries) {
    const Folder folder;
    const std::string command = "ldd '" GLIBRA_PROGRAM "' >'" + (folder / "libraries").string() + "'";
    ASSERT_EQ(std::system(command.c_str()), 0);
    const std::string libraries = readFile(folder / "libraries");
    EXPECT_NE(libraries.find("libc.so"), std::string::npos);
    for (const char* name : {"OpenImageIO", "glfw", "imgui", "libX11", "freetype", "fontconfig", "libEGL",
                             "OSMesa", "libGL.", "libLLVM", "jpeg", "tiff"})
        EXPECT_EQ(libraries.find(name), std::string::npos) << name << " in\n" << libraries;
}

}  // namespace
}  // namespace glibra::test
