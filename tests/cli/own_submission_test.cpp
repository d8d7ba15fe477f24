// `glibra class --hand-out` and `--mine`: a teacher hands out the pictures of a solution, and a student
// checks his own folder against them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "program.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOwnVertex =
    "#version 330 core\nout vec3 vN;\nvoid main() { vN = uNormalMatrix * aNormal; gl_Position = "
    "uModelViewProjectionMatrix * aVertex; }\n";
constexpr const char* kOwnName = "theTeachersOwnName";
constexpr const char* kOwnRubric = R"([[check]]
drawn = true
[[check]]
name = "looks right"
like = 0.95
points = 4
[[check]]
reacts = "uTone"
points = 2
[[check]]
slider = "uTone"
range = [0, 1]
[[check]]
uses = "smoothstep"
bonus = true
[[check]]
name = "report"
by-hand = true
points = 3
)";

std::string ownScene(const std::string& shader) {
    return "LookAt 0 0 4 0 0 0 0 1 0\nVertex " + shader + ".vert\nFragment " + shader +
           ".frag\nProgram P uTone <0. .5 1.>\nSphere 1 40 40\n";
}

std::string ownFragment(const std::string& value, const std::string& name = "shade") {
    return fmt::format(
        "#version 330 core\nin vec3 vN;\nuniform float uTone;\nout vec4 f;\nvoid main() {{\n    float {0} = "
        ".1 "
        "+ .8 * {1} * abs(normalize(vN).z);\n    f = vec4({0});\n}}\n",
        name, value);
}

/// The types of the chunks of a PNG file.
std::vector<std::string> pngChunksOf(const std::string& png) {
    std::vector<std::string> types;
    for (std::size_t at = 8; at + 8 <= png.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length << 8U | static_cast<unsigned char>(png[at + i]);
        types.push_back(png.substr(at + 4, 4));
        at += length + 12;
    }
    return types;
}

class OwnSubmission : public testing::Test {
  protected:
    void SetUp() override {
        folder.write("course/solution.vert", kOwnVertex);
        folder.write("course/solution.frag", ownFragment("uTone", kOwnName));
        folder.write("course/solution.glib", "# " + std::string(kOwnName) + "\n" + ownScene("solution"));
        folder.write("course/class.toml", kOwnRubric);
        hand("ana", ownFragment("uTone"));
        hand("bob", ownFragment("(1. - uTone) * .3"));
        hand("cem", ownFragment("uNowhere"));
    }
    void hand(const std::string& student, const std::string& shader) const {
        folder.write("all/" + student + "/a.vert", kOwnVertex);
        folder.write("all/" + student + "/a.frag", shader);
        folder.write("all/" + student + "/a.glib", ownScene("a"));
    }
    [[nodiscard]] Finished handOut(const std::string& more = "") const {
        return glibra(folder.path(),
                      "class --reference course/solution.glib --rubric course/class.toml "
                      "--size 64x48 --sweep 'uTone = [0, 0.5, 1]' --hand-out reference " +
                          more);
    }
    /// The teacher's folder is gone, as on the machine of a student.
    void takeCourseAway() const { fs::rename(folder / "course", folder / "elsewhere"); }
    [[nodiscard]] Finished mine(const std::string& student, const std::string& more = "") const {
        return glibra(folder / ("all/" + student),
                      "class . --mine --reference ../../reference -o ../../mine " + more);
    }
    /// The fields of a submission in a table, by its columns; those of its code and name are left out.
    [[nodiscard]] std::string figures(const std::string& table, const std::string& student) const {
        std::istringstream lines(readFile(folder / table));
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with(student + ",")) return line;
        return "nobody";
    }

    Folder folder;
};

TEST_F(OwnSubmission, GetsThePointsThatTheTeachersRunGives) {
    ASSERT_EQ(handOut().status, 0);
    ASSERT_EQ(glibra(folder.path(),
                     "class all --reference course/solution.glib --rubric course/class.toml "
                     "--size 64x48 --sweep 'uTone = [0, 0.5, 1]' -o site")
                  .status,
              0);
    takeCourseAway();
    for (const char* student : {"ana", "bob"}) {
        ASSERT_LE(mine(student).status, 1) << student;
        EXPECT_EQ(figures("mine/grades.csv", student), figures("site/grades.csv", student));
    }
    ASSERT_EQ(mine("cem").status, 1);
    // Messages name other folders.
    const auto end = [](const std::string& line) { return line.substr(line.find(",a.glib,")); };
    EXPECT_EQ(end(figures("mine/grades.csv", "cem")), end(figures("site/grades.csv", "cem")));
}

TEST_F(OwnSubmission, SaysOneLinePerCheckAndWhatToDo) {
    ASSERT_EQ(handOut().status, 0);
    takeCourseAway();
    const Finished right = mine("ana");
    EXPECT_EQ(right.status, 0) << right.err;
    EXPECT_TRUE(contains(right.err, "4 of 4  looks right")) << right.err;
    EXPECT_TRUE(contains(right.err, "8 of 8 automatic points")) << right.err;
    EXPECT_TRUE(contains(right.err, "by hand, not judged here: report (3 points)")) << right.err;
    EXPECT_TRUE(contains(right.err, "compares the code with that of others")) << right.err;
    const Finished wrong = mine("bob");
    EXPECT_EQ(wrong.status, 1) << wrong.err;
    EXPECT_TRUE(contains(wrong.err, " of 4  looks right: at worst likeness 0.000 at uTone=")) << wrong.err;
    EXPECT_TRUE(contains(wrong.err, "compare the two pictures on the page")) << wrong.err;
    EXPECT_TRUE(fs::exists(folder / "mine/index.html"));
    const Finished broken = mine("cem");
    EXPECT_EQ(broken.status, 1) << broken.err;
    EXPECT_TRUE(contains(broken.err, "a.frag:6:")) << broken.err;
    // A bonus that is missing, and points by hand, do not make the run fail.
    EXPECT_TRUE(contains(right.err, "0 of 1  uses smoothstep (bonus)")) << right.err;
}

TEST_F(OwnSubmission, NothingOfTheSolutionIsHandedOut) {
    ASSERT_EQ(handOut().status, 0);
    std::size_t pictures = 0;
    for (const fs::directory_entry& each : fs::recursive_directory_iterator(folder / "reference")) {
        ASSERT_TRUE(each.is_regular_file()) << each.path();
        const std::string content = readFile(each.path());
        EXPECT_FALSE(contains(content, kOwnName)) << each.path();
        EXPECT_FALSE(contains(content, folder.path().string())) << each.path();
        if (each.path().extension() != ".png") continue;
        ++pictures;
        for (const std::string& type : pngChunksOf(content))
            EXPECT_TRUE(type == "IHDR" || type == "IDAT" || type == "IEND") << type;
    }
    EXPECT_EQ(pictures, 3U);
    EXPECT_EQ(readFile(folder / "reference/rubric.toml"), kOwnRubric);
}

TEST_F(OwnSubmission, MayBeAFileOrAZipFileAndTheReferenceASuiteOrAnExercise) {
    folder.write("course/task.toml", "solution = \"solution.glib\"\nsweep = [\"uTone=[0, 1]\"]\n");
    folder.write("course/suite.toml",
                 "[[shot]]\nscript = \"solution.glib\"\nsize = [32, 32]\ntime = 2\n"
                 "sweep = { uTone = [0, 1] }\n");
    ASSERT_EQ(glibra(folder.path(), "class --reference course/task.toml --hand-out reference").status, 0);
    const Finished solved = mine("ana");
    EXPECT_EQ(solved.status, 0) << solved.err;
    EXPECT_TRUE(contains(solved.err, "1 of 1  is solved")) << solved.err;
    EXPECT_EQ(mine("bob").status, 1);
    // Where many pictures are right, what they have goes along.
    folder.write("course/dark.toml",
                 "solution = \"solution.glib\"\nsweep = [\"uTone=[0]\"]\nhas = { color = [0, 0, "
                 "0], within = 0.15, least = 0.99 }\n");
    ASSERT_EQ(glibra(folder.path(), "class --reference course/dark.toml --hand-out reference").status, 0);
    EXPECT_EQ(mine("ana").status, 0);
    EXPECT_EQ(mine("bob").status, 1) << "it is not dark at uTone=0";
    // The pictures of before go.
    ASSERT_EQ(glibra(folder.path(),
                     "class --reference course/suite.toml --rubric course/class.toml "
                     "--hand-out reference")
                  .status,
              0);
    std::vector<std::string> files;
    for (const fs::directory_entry& each : fs::directory_iterator(folder / "reference"))
        files.push_back(each.path().filename().string());
    std::sort(files.begin(), files.end());
    EXPECT_EQ(files, (std::vector<std::string>{"reference.json", "rubric.toml", "solution@uTone=0.png",
                                               "solution@uTone=1.png"}));
    takeCourseAway();
    const Finished file = glibra(folder.path(), "class all/ana/a.glib --mine --reference reference -o mine");
    EXPECT_EQ(file.status, 0) << file.err;
    ASSERT_EQ(shell(folder / "all/ana", "python3 -m zipfile -c ../ana.zip a.vert a.frag a.glib").status, 0);
    EXPECT_EQ(glibra(folder.path(), "class all/ana.zip --mine --reference reference -o mine").status, 0);
}

TEST_F(OwnSubmission, AZipFileAloneIsReadAnewInEachRun) {
    ASSERT_EQ(handOut().status, 0);
    takeCourseAway();
    fs::create_directory(folder / "me");
    for (const auto& [student, status] : {std::pair("bob", 1), {"bob", 1}, {"ana", 0}, {"ana", 0}}) {
        fs::remove(folder / "me/hand.zip");
        ASSERT_EQ(shell(folder / ("all/" + std::string(student)),
                        "python3 -m zipfile -c ../../me/hand.zip a.vert a.frag a.glib")
                      .status,
                  0);
        const Finished done = glibra(folder / "me", "class . --mine --reference ../reference");
        EXPECT_EQ(done.status, status) << done.err;
        EXPECT_FALSE(contains(done.err, "cannot find")) << done.err;
    }
}

TEST_F(OwnSubmission, ResultsAreNotWrittenOverWhatIsRead) {
    ASSERT_EQ(handOut().status, 0);
    const std::string own = "class all/ana --mine -o mine --reference reference --results github=";
    for (const char* each : {"all/ana/a.frag", "all/ana/./a.glib", "reference/rubric.toml",
                             "reference/reference.json", "reference/uTone=0.png"}) {
        const std::string before = readFile(folder / each);
        ASSERT_FALSE(before.empty()) << each;
        const Finished done = glibra(folder.path(), own + each);
        EXPECT_EQ(done.status, 3) << each << done.err;
        EXPECT_TRUE(contains(done.err, "--results: '" + std::string(each) + "' is not written over"))
            << done.err;
        EXPECT_EQ(readFile(folder / each), before);
    }
    for (int i = 0; i < 2; ++i) EXPECT_EQ(glibra(folder.path(), own + "all/ana/results.json").status, 0) << i;
}

TEST_F(OwnSubmission, WrongInputIsOneMessage) {
    ASSERT_EQ(handOut().status, 0);
    const auto says = [&](const std::string& arguments, int status, const std::string& words) {
        const Finished done = glibra(folder.path(), "class " + arguments);
        EXPECT_EQ(done.status, status) << arguments << "\n" << done.err;
        EXPECT_TRUE(contains(done.err, words)) << arguments << "\n" << done.err;
        EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), contains(done.err, "--help") ? 2 : 1)
            << done.err;
    };
    const std::string own = "all/ana --mine -o mine --reference ";
    says("--reference course/solution.glib", 2, "SUBMISSIONS is missing");
    says("nowhere --mine --reference reference -o mine", 2, "there is no 'nowhere'");
    says("course/class.toml --mine --reference reference -o mine", 2, "this is no submission");
    says(own + "course", 2, "--hand-out course' writes them");
    says(own + "course/solution.glib", 2, "--mine needs the checks");
    says(own + "reference --time 3", 2, "do not go with the pictures");
    says(own + "reference --serve", 2, "--mine cannot be given together with --serve");
    says("all --reference reference --results gradescope=x.json", 2, "--results needs --mine");
    says(own + "reference --results moodle=x.json", 2, "found 'moodle=x.json'");
    says(own + "reference --results github=-", 2, "'-' does not mean standard output here");
    says(own + "reference --results github=x.json --results gradescope=./x.json", 2,
         "'./x.json' is named twice");
    says("--hand-out all --reference course/solution.glib", 2, "it has other files");
    says("all --hand-out new --reference course/solution.glib", 2, "leave out the folder");
    says("--hand-out new --reference reference", 2, "--hand-out draws the scene");
    EXPECT_FALSE(fs::exists(folder / "new"));
    folder.write("reference/reference.json", "{\"scene\": 3}");
    says(own + "reference", 2, "reference/reference.json:1:1");
    folder.write(
        "reference/reference.json",
        "{\"scene\": \"s.glib\", \"pictures\": [{\"file\": \"../course/class.toml\", \"label\": \"\", "
        "\"options\": [], \"has\": null}]}");
    folder.write("reference/rubric.toml", "[[check]]\ndrawn = true\n");
    says(own + "reference", 3, "cannot find 'class.toml'");
    folder.write("reference/reference.json",
                 "{\"scene\": \"s.glib\", \"pictures\": [{\"file\": \"rubric.toml\", \"label\": \"\", "
                 "\"options\": [\"--library\", \"/etc\"], \"has\": null}]}");
    says(own + "reference", 2, "'--library' is no option of a picture");
}

}  // namespace
}  // namespace glibra::test
