// The options of a picture as `glibra render` reads them, over all rows of their table.

#include <gtest/gtest.h>

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
    std::string all;
    for (const OptionRow& row : suite::optionTable())
        if (row.needs.empty()) all += sampleArguments(row);
    const Finished finished = glibra(folder.path(), "render missing.glib --override-counts" + all);
    EXPECT_EQ(finished.status, 3) << "a missing scene, not a wrong command line: " << finished.err;
    EXPECT_NE(finished.err.find("missing.glib"), std::string::npos) << finished.err;
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

}  // namespace
}  // namespace glibra::test
