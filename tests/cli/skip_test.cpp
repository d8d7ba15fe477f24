// --no-skip: every scene of the repository gives the same picture without the skip rules.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "program.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

TEST(NoSkip, EverySceneIsTheSameBitForBit) {
#if GLIBRA_SANITIZED
    GTEST_SKIP()
        << "every scene is drawn four times; Scenes.AreDrawnAndNotOneColour draws them with sanitizers";
#endif
    std::string scenes;
    std::size_t count = 0;
    for (const auto& each : fs::recursive_directory_iterator(GLIBRA_SOURCE_DIR "/glib")) {
        // A scene whose window draws have side effects is not drawn in tiles (memory-E10).
        const bool isExercise = each.path().parent_path().parent_path().filename() == "exercises";
        if (each.path().extension() != ".glib" || each.path().stem() == "glass_lists" || isExercise) continue;
        scenes += " '" + each.path().string() + "'";
        ++count;
    }
    ASSERT_GE(count, 19U);
    const Folder folder;
    const auto render = [&](const std::string& where, const std::string& options) {
        const Finished run =
            glibra(folder.path(), "render --size 96x80 --time 1.5 -o " + where + " " + options + scenes);
        EXPECT_EQ(run.status, 0) << run.err;
    };
    render("skipped", "");
    render("tiled", "--tile 48");
    render("whole", "--no-skip --tile 48");
    // Scenes of one name have pictures in folders.
    const auto compare = [&](const std::string& other) {
        std::size_t pictures = 0;
        for (const auto& each : fs::recursive_directory_iterator(folder / "whole")) {
            if (!each.is_regular_file()) continue;
            const fs::path name = fs::relative(each.path(), folder / "whole");
            EXPECT_TRUE(readFile(each.path()) == readFile(folder / other / name)) << name << " " << other;
            ++pictures;
        }
        return pictures;
    };
    EXPECT_EQ(compare("tiled"), count);
    render("whole", "--no-skip");
    EXPECT_EQ(compare("skipped"), count);
}

TEST(NoSkip, APictureOfNothingSaysWhyAndWhatElseToAsk) {
    const Folder folder;
    folder.write("a.vert",
                 "#version 330 core\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n");
    folder.write("a.frag", "#version 330 core\nvoid main() { missing = 1; }\n");
    folder.write("a.glib", "LookAt 0 0 3 0 0 0 0 1 0\nVertex a.vert\nFragment a.frag\nProgram P\nQuadXZ\n");
    const Finished run = glibra(folder.path(), "render a.glib -o a.png");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.err.find("nothing is in sight: line 5, QuadXZ: "), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("; 'glibra check' compiles its shaders too [draw-N02]"), std::string::npos)
        << run.err;
    const Finished check = glibra(folder.path(), "check a.glib");
    EXPECT_EQ(check.status, 3);
    EXPECT_NE(check.err.find("a.frag:2:"), std::string::npos) << check.err;
}

TEST(NoSkip, SuitesAreDrawnTheSameWay) {
    const Folder folder;
    folder.write("a.glib", "Sphere 1\n");
    folder.write("s.toml",
                 "[defaults]\nsize = [40, 30]\n[[shot]]\nname = \"a\"\nscript = \"a.glib\"\ntime = [0, 1]\n");
    EXPECT_EQ(glibra(folder.path(), "render --suite s.toml -o with").status, 0);
    EXPECT_EQ(glibra(folder.path(), "render --suite s.toml -o without --no-skip").status, 0);
    std::size_t compared = 0;
    for (const auto& each : fs::directory_iterator(folder / "with")) {
        EXPECT_TRUE(readFile(each.path()) == readFile(folder / "without" / each.path().filename()));
        ++compared;
    }
    EXPECT_EQ(compared, 2U);
    EXPECT_EQ(glibra(folder.path(), "test s.toml --update --no-skip").status, 0);
    EXPECT_EQ(glibra(folder.path(), "test s.toml").status, 0);
}

/// The files that the system loader opened for `glibra ARGUMENTS`.
std::string loaded(const Folder& folder, const std::string& arguments) {
    EXPECT_EQ(glibra(folder.path(), arguments, "LD_DEBUG=files LD_DEBUG_OUTPUT=loaded").status, 0);
    std::string all;
    for (const auto& each : fs::directory_iterator(folder.path()))
        if (each.path().filename().string().starts_with("loaded.")) {
            all += readFile(each.path());
            fs::remove(each.path());
        }
    return all;
}

TEST(NoSkip, NoLibraryOfWindowsGuisOrPicturesIsLoadedForAPng) {
    const Folder folder;
    folder.write("a.glib", "Sphere 1\n");
    const std::string png = loaded(folder, "render a.glib --size 32x32 -o a.png");
    EXPECT_NE(png.find("libEGL"), std::string::npos);
    for (const char* each : {"OpenImageIO", "openimageio", "libglfw", "imgui", "freetype", "fontconfig"})
        EXPECT_EQ(png.find(each), std::string::npos) << each;
    const std::string tiff = loaded(folder, "render a.glib --size 32x32 -o a.tif");
    EXPECT_NE(tiff.find("libOpenImageIO"), std::string::npos) << "another format needs it";
}

}  // namespace
}  // namespace glibra::test
