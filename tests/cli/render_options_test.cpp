// The options of a picture as `glibra render` reads them, over all rows of their table.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "../suite/option_samples.h"
#include "program.h"
#include "suite/options/option_words.h"

namespace glibra::test {
namespace {

using suite::OptionRow;

/// An option with a sample value, for a shell: "--size 320x200".
std::string sampleArguments(const OptionRow& row) {
    suite::Shot shot;
    suite::test::setSample(row, shot);
    std::string text;
    for (const std::string& word : suite::optionWords(row, shot)) text += " " + suite::shellWord(word);
    return text;
}

TEST(RenderOptions, EveryOptionIsUnderstood) {
    const Folder folder;
    for (const char* each : {"lib one", "lib two"}) std::filesystem::create_directory(folder / each);
    std::string all;
    for (const OptionRow& row : suite::optionTable())
        if (row.needs.empty()) all += sampleArguments(row);
    const Finished finished = glibra(folder.path(), "render missing.glib --override-counts" + all);
    EXPECT_EQ(finished.status, 3) << "a missing scene, not a wrong command line: " << finished.err;
    EXPECT_NE(finished.err.find("missing.glib"), std::string::npos) << finished.err;
}

TEST(RenderOptions, AValueThatDoesNotFitItsVariableIsReported) {
    const Folder folder;
    folder.write("a.glib",
                 "WindowSize 32 16\nLet size <0. .5 1.>\nLet tint {1 0 0}\nLet twice (size*2)\n"
                 "Translate (size + twice) 0 0\nSphere .2\n");
    const Finished finished =
        glibra(folder.path(), "render a.glib --set size=1,2 --set tint=1 --set twice=1,2 --set tint2=1");
    EXPECT_EQ(finished.status, 0) << finished.err;
    for (const char* text : {"--set size=1,2: 2 values; 'size' takes 1, so it keeps its own [glib-W15]",
                             "--set tint=1: 1 value; 'tint' takes 3, so it keeps its own [glib-W15]",
                             "--set twice=1,2: 2 values; 'twice' takes 1, so it keeps its own [glib-W15]",
                             "'tint2'; did you mean 'tint'? [glib-W23]"})
        EXPECT_NE(finished.err.find(text), std::string::npos) << text << finished.err;
    EXPECT_FALSE(
        contains(glibra(folder.path(), "render a.glib --set size=.25 --set tint=1,0,1").err, "warning"));
}

TEST(RenderOptions, AFolderThatCannotBeSearchedIsReported) {
    const Folder folder;
    folder.write("a.glib", "Sphere\n");
    for (const char* command : {"render a.glib", "check a.glib", "gallery .", "class ."}) {
        const Finished missing = glibra(folder.path(), std::string(command) + " --library . --library none");
        EXPECT_EQ(missing.status, 2) << command;
        EXPECT_TRUE(contains(missing.err, "--library: there is no folder 'none'")) << missing.err;
        const Finished file = glibra(folder.path(), std::string(command) + " --library a.glib");
        EXPECT_EQ(file.status, 2) << command;
        EXPECT_TRUE(contains(file.err, "--library: 'a.glib' is not a folder")) << file.err;
    }
    EXPECT_EQ(folder.listing(), "a.glib\n");
    EXPECT_EQ(glibra(folder.path(), "check a.glib", "GLIBRA_PATH=none:a.glib").status, 0)
        << "the variable may name folders of other machines";
}

TEST(RenderOptions, ASuiteRefusesWhatItStatesItself) {
    const Folder folder;
    for (const OptionRow& row : suite::optionTable()) {
        if (row.name.empty() || !row.needs.empty()) continue;
        const Finished finished = glibra(folder.path(), "render --suite missing.toml" + sampleArguments(row));
        EXPECT_EQ(finished.status, row.withSuite ? 3 : 2) << row.name << ": " << finished.err;
    }
}

TEST(RenderOptions, HelpAndDocumentationListEveryOption) {
    const Folder folder;
    const std::string help = glibra(folder.path(), "render --help-all").out;
    const std::string page = glibra(folder.path(), "language --markdown").out;
    for (const OptionRow& row : suite::optionTable()) {
        const std::string name = "--" + std::string(row.name);
        if (!row.name.empty()) {
            EXPECT_NE(help.find(name), std::string::npos) << name;
            EXPECT_NE(page.find("| `" + name), std::string::npos) << name;
        }
        const std::string key = "| `" + std::string(row.key) + "` |";
        EXPECT_TRUE(row.key.empty() || page.find(key) != std::string::npos) << row.key;
    }
}

TEST(RenderOptions, TheCommandOfAReportDrawsThePictureOfTheShot) {
    const Folder folder;
    folder.write("scene/a.glib",
                 "LookAt 0 0 4 0 0 0 0 1 0\nVertex far.vert\nFragment far.frag\nProgram P uKd <0. .1 1.>\n"
                 "Sphere 1\nTranslate 1 0 0\nBox\n");
    folder.write("lib of ours/shaders/far.vert",
                 "#version 330 core\nout vec3 vN;\nvoid main() { vN = uNormalMatrix * aNormal; gl_Position = "
                 "uModelViewProjectionMatrix * aVertex; }\n");
    folder.write("lib of ours/shaders/far.frag",
                 "#version 330 core\nin vec3 vN;\nuniform float uKd;\nout vec4 f;\nvoid main() { f = "
                 "vec4(abs(normalize(vN)) * uKd, 1.); }\n");
    folder.write("s.toml",
                 "[[shot]]\nname = \"one\"\nscript = \"scene/a.glib\"\nlibrary = \"lib of ours\"\n"
                 "size = [96, 64]\nset = { uKd = 0.7 }\nsamples = 4\nbackground = [0.2, 0.1, 0]\n"
                 "eye-transform = [0.8, 0.6, 0, 0, -0.6, 0.8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]\n"
                 "object-transform = { 7 = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0.5, 0, 1] }\n"
                 "projection = \"orthographic\"\naxes = true\nalpha = true\ntile = 48\n");
    ASSERT_EQ(glibra(folder.path(), "render --suite s.toml -o drawn").status, 0);
    EXPECT_EQ(glibra(folder.path(), "test s.toml").status, 1) << "no golden";
    std::istringstream lines(readFile(folder / "glibra-results/results.jsonl"));
    std::string line;
    std::getline(lines, line);  // the run
    std::getline(lines, line);
    const std::string command = nlohmann::json::parse(line).at("reproduce");
    ASSERT_TRUE(command.starts_with("glibra ")) << command;
    const Finished again = glibra(folder.path(), command.substr(7));
    ASSERT_EQ(again.status, 0) << command << "\n" << again.err;
    EXPECT_TRUE(readFile(folder / "one.png") == readFile(folder / "drawn/one.png")) << command;
}

/// A scene that draws a picture over the window.
void writeSceneWithPicture(const Folder& folder, const std::string& picture) {
    folder.write("red.glib", "WindowSize 8 8\nBackground 1 0 0\n");
    ASSERT_EQ(glibra(folder.path(), "render red.glib -o '" + picture + "'").status, 0);
    folder.write("a.glib", "WindowSize 8 8\nTexture2D 5 " + picture +
                               "\nVertex a.vert\nFragment a.frag\nProgram P uMap 5\nQuadXY 0 1\n");
    folder.write("a.vert",
                 "#version 330 core\nout vec2 vST;\nvoid main() { vST = aTexCoord0.st; gl_Position = "
                 "uModelViewProjectionMatrix * aVertex; }\n");
    folder.write("a.frag",
                 "#version 330 core\nin vec2 vST;\nuniform sampler2D uMap;\nout vec4 f;\nvoid main() { f = "
                 "texture(uMap, vST).gbra; }\n");
}

TEST(RenderOutput, AFileThatTheSceneReadsIsNeverWritten) {
    const Folder folder;
    writeSceneWithPicture(folder, "a.png");
    const std::string before = readFile(folder / "a.png");
    const std::string scene = (folder / "a.glib").string();
    for (const std::string& arguments :
         {std::string("render a.glib"), std::string("render a.glib -o ./a.png"),
          "render '" + scene + "' -o '" + (folder / "a.png").string() + "'",
          std::string("render a.glib -o b.png --incomplete"), std::string("render a.glib --untrusted")}) {
        const bool isOther = arguments.find("b.png") != std::string::npos;
        const Finished run = glibra(folder.path(), arguments);
        if (run.status == 4) continue;  // no sandbox on this machine
        EXPECT_EQ(run.status, isOther ? 0 : 3) << arguments << run.err;
        EXPECT_EQ(run.err.find("a.glib:2:13: error: the scene reads 'a.png', so nothing is written over it; "
                               "choose another output name (-o, --save) [file-E13]") == std::string::npos,
                  isOther)
            << arguments << run.err;
        EXPECT_TRUE(readFile(folder / "a.png") == before) << arguments;
    }
}

TEST(RenderOutput, FramesAndSavedTexturesAreComparedUnderTheirFinalNames) {
    const Folder folder;
    writeSceneWithPicture(folder, "film_0002.png");
    const std::string before = readFile(folder / "film_0002.png");
    const Finished film = glibra(folder.path(), "render a.glib -o film.png --frames 3");
    EXPECT_EQ(film.status, 3) << film.err;
    EXPECT_NE(film.err.find("file-E13"), std::string::npos) << film.err;
    EXPECT_EQ(glibra(folder.path(), "render a.glib -o film.png --frames 2").status, 0) << "it ends before";
    EXPECT_EQ(glibra(folder.path(), "render a.glib -o film_0002.png --frames 2").status, 0)
        << "it writes film_0002_0000.png";
    folder.write(
        "m.glib",
        "WindowSize 8 8\nTexture2D picture film_0002.png\nFragment inline\n#version 330 core\nin vec2 "
        "vST;\nuniform sampler2D m;\nout vec4 f;\nvoid main() { f = texture(m, vST); "
        "}\nEndFragment\nProgram P m picture\nFill window with P\n");
    const Finished save = glibra(folder.path(), "render m.glib -o b.png --save picture=film_0002.png");
    EXPECT_EQ(save.status, 3) << save.err;
    EXPECT_NE(save.err.find("file-E13"), std::string::npos) << save.err;
    EXPECT_TRUE(readFile(folder / "film_0002.png") == before);
}

}  // namespace
}  // namespace glibra::test
