// `glibra class`, run as a teacher runs it: two hundred submissions, some of which are hostile.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <sstream>
#include <vector>

#include "program.h"
#include "system/sandbox.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = GLIBRA_SOURCE_DIR;
constexpr const char* kSecret = "vec3 theTeachersSecret";

std::size_t countOf(const std::string& text, std::string_view part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++count;
    return count;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    if (const std::size_t at = text.find(from); at != std::string::npos) text.replace(at, from.size(), to);
    return text;
}

/// The fields of each line of a table.
std::vector<std::vector<std::string>> rowsOf(const std::string& csv) {
    std::vector<std::vector<std::string>> rows(1, {""});
    bool quoted = false;
    for (std::size_t i = 0; i < csv.size(); ++i) {
        const char each = csv[i];
        if (each == '"' && quoted && i + 1 < csv.size() && csv[i + 1] == '"')
            rows.back().back() += csv[++i];
        else if (each == '"')
            quoted = !quoted;
        else if (each == ',' && !quoted)
            rows.back().emplace_back();
        else if (each == '\n' && !quoted)
            rows.push_back({""});
        else if (each != '\r' || quoted)
            rows.back().back() += each;
    }
    rows.pop_back();
    return rows;
}

class ClassCommand : public testing::Test {
  protected:
    void SetUp() override {
        folder.write("solution.vert", kVertex);
        folder.write("solution.frag", fragment("uTone"));
        folder.write("solution.glib", scene("solution"));
        folder.write("secret.glsl", std::string(kSecret) + " = vec3(1.);\n");
    }

    static std::string scene(const std::string& shader) {
        return "LookAt 0 0 4 0 0 0 0 1 0\nVertex " + shader + ".vert\nFragment " + shader +
               ".frag\nProgram P uTone <0. .5 1.>\nSphere 1 40 40\n";
    }
    static std::string fragment(const std::string& value) {
        return "#version 330 core\nin vec3 vN;\nuniform float uTone;\nout vec4 f;\nvoid main() {\n"
               "    float shade = .1 + .8 * " +
               value + " * abs(normalize(vN).z);\n    f = vec4(shade);\n}\n";
    }
    /// A folder of a student with such a fragment shader.
    void hand(const std::string& student, const std::string& fragmentShader) const {
        folder.write("all/" + student + "/a.vert", kVertex);
        folder.write("all/" + student + "/a.frag", fragmentShader);
        folder.write("all/" + student + "/a.glib", scene("a"));
    }
    [[nodiscard]] Finished run(const std::string& more) const {
        return glibra(folder.path(), "class all --reference solution.glib -o site --size 64x64 " + more);
    }
    [[nodiscard]] std::string page() const { return readFile(folder / "site/index.html"); }
    [[nodiscard]] std::vector<std::vector<std::string>> grades() const {
        return rowsOf(readFile(folder / "site/grades.csv"));
    }
    /// The field of a submission, by the name of the column.
    [[nodiscard]] std::string grade(const std::string& student, const std::string& column) const {
        const std::vector<std::vector<std::string>> rows = grades();
        const auto at = std::find(rows[0].begin(), rows[0].end(), column) - rows[0].begin();
        for (const std::vector<std::string>& each : rows)
            if (each[0] == student) return each[static_cast<std::size_t>(at)];
        return "no such submission";
    }
    /// No file of the site has the text.
    void expectNowhere(std::string_view text) const {
        for (const fs::directory_entry& each : fs::recursive_directory_iterator(folder / "site")) {
            ASSERT_FALSE(each.is_symlink()) << each.path();
            if (!each.is_regular_file()) continue;
            EXPECT_FALSE(contains(readFile(each.path()), text)) << each.path();
        }
    }

    static constexpr const char* kVertex =
        "#version 330 core\nout vec3 vN;\nvoid main() { vN = uNormalMatrix * aNormal; gl_Position = "
        "uModelViewProjectionMatrix * aVertex; }\n";
    Folder folder;
};

TEST_F(ClassCommand, DrawsEveryoneBesideTheReferenceAndScoresThem) {
    hand("ana", fragment("uTone"));
    hand("bob", fragment("(1. - uTone) * .3"));
    hand("cem", fragment("uNowhere"));
    folder.write("all/dora.glib", "Sphere 1 20 20\n");
    folder.write("all/readme.txt", "hello");
    const Finished done = run("");
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_TRUE(contains(done.err, "4 submissions: 3 drawn, 1 failed")) << done.err;
    EXPECT_EQ(grade("ana", "state"), "drawn");
    EXPECT_EQ(grade("ana", "flip"), "0.00000");
    EXPECT_EQ(grade("ana", "structure"), "0.00000");
    EXPECT_GT(std::stod(grade("bob", "flip")), 0.01);
    EXPECT_EQ(grade("bob", "uniforms"), "uTone");
    EXPECT_EQ(grade("bob", "stages"), "vertex fragment");
    EXPECT_EQ(grade("cem", "state"), "failed");
    EXPECT_TRUE(contains(grade("cem", "reason"), "uNowhere")) << grade("cem", "reason");
    EXPECT_EQ(grade("cem", "flip"), "");
    EXPECT_EQ(grade("dora", "state"), "drawn");
    const std::string html = page();
    EXPECT_TRUE(contains(html, "a.frag:6"));
    EXPECT_TRUE(contains(html, "readme.txt"));
    // The pictures are as large as the reference's; what can be drawn of cem's is one of them.
    EXPECT_EQ(countOf(html, "width=\"64\" height=\"64\""), 1 + 3 * 2 + 2);
    EXPECT_TRUE(fs::exists(folder / "site/pictures/0001-1.png"));
}

TEST_F(ClassCommand, SweepsAndTimesMakeAPictureEach) {
    hand("ana", fragment("uTone"));
    hand("bob", fragment(".5"));
    const Finished done = run("--sweep 'uTone = [0, 0.5, 1]' --time 0 --time 1");
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(grade("bob", "pictures"), "6");
    EXPECT_EQ(grade("bob", "drawn"), "6");
    EXPECT_EQ(grade("bob", "flip uTone=0.5, time=0"), "0.00000");
    EXPECT_GT(std::stod(grade("bob", "flip uTone=0, time=1")), 0.01);
    EXPECT_EQ(grade("ana", "worst flip"), "0.00000");
}

TEST_F(ClassCommand, SweepsHaveNumbersAsScenesHaveThem) {
    hand("ana", fragment("uTone"));
    const Finished done = run("--sweep 'uTone = [.5, 1., +.25, 1.e-1, \".75\"]'");
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(grade("ana", "drawn"), "5");
    for (const char* each : {"0.5", "1", "0.25", "0.1", "0.75"})
        EXPECT_EQ(grade("ana", fmt::format("flip uTone={}", each)), "0.00000");
    EXPECT_EQ(run("--sweep 'uTone = [.]'").status, 2);
}

TEST_F(ClassCommand, AnExerciseGivesItsVerdictWithoutARubric) {
    hand("ana", fragment("uTone"));
    hand("bob", fragment("(uTone * uTone)"));  // right at 0 and 1
    hand("eve", "this is no shader");
    folder.write("task.toml", "solution = \"solution.glib\"\nsweep = [\"uTone=[0, 0.5, 1]\"]\n");
    const std::string command = "class all --reference task.toml -o site ";
    ASSERT_EQ(glibra(folder.path(), command).status, 0);
    for (const auto& [student, points] : {std::pair{"ana", "1"}, {"bob", "0"}, {"eve", "0"}})
        EXPECT_EQ(std::stod(grade(student, "points is solved")), std::stod(points)) << student;
    EXPECT_TRUE(contains(page(), "at uTone=0.5 its picture differs from the solution"));
    folder.write("class.toml", "[[check]]\nsolved = true\nname = \"right\"\npoints = 4\n");
    ASSERT_EQ(glibra(folder.path(), command + "--rubric class.toml").status, 0);
    EXPECT_EQ(std::stod(grade("ana", "points right")), 4);
    EXPECT_EQ(std::stod(grade("bob", "points right")), 0);
    EXPECT_EQ(glibra(folder.path(), "class all -o site --rubric class.toml").status, 2) << "no reference";
}

TEST_F(ClassCommand, AReferenceMayBeASuite) {
    hand("ana", fragment("uTone"));
    folder.write("class.toml",
                 "[[shot]]\nscript = \"solution.glib\"\nsize = [32, 32]\nsweep = { uTone = [0, 1] }\n");
    const Finished done = glibra(folder.path(), "class all --reference class.toml -o site");
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(grade("ana", "flip solution@uTone=1"), "0.00000");
    EXPECT_TRUE(contains(page(), "width=\"32\" height=\"32\""));
    EXPECT_EQ(glibra(folder.path(), "class all --reference class.toml --time 3 -o site").status, 2);
}

TEST_F(ClassCommand, SimilarCodeIsShownSideBySideButNotWhatWasGiven) {
    const std::string given =
        "float hill(float x) { float s = smoothstep(0., .3, x) * smoothstep(0., .3, 1. - x); return s * s * "
        "x; }\n";
    const std::string copied =
        "vec3 tint(vec3 at, float by) {\n    vec3 sum = vec3(0.);\n    for (int i = 0; i < 4; ++i) {\n"
        "        sum += mix(at, at.zxy, by) * float(i) / 6.;\n        at = reflect(at, normalize(sum + "
        ".1));\n    }\n"
        "    return clamp(sum, 0., 1.);\n}\n";
    std::string renamed = copied;
    for (std::size_t at = renamed.find("sum"); at != std::string::npos; at = renamed.find("sum"))
        renamed.replace(at, 3, "all");
    const auto with = [&](const std::string& own) {
        return replaced(fragment(own.empty() ? "hill(uTone)" : "tint(vec3(hill(uTone)), uTone).x"),
                        "void main", given + own + "void main");
    };
    folder.write("handout/start.glsl", with(""));
    hand("ana", with(copied));
    hand("bob", with(renamed));
    hand("cem", with(""));
    hand("dora", with(""));
    const Finished done = run("--template handout");
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(grade("ana", "most similar"), "bob");
    EXPECT_EQ(grade("bob", "most similar"), "ana");
    EXPECT_EQ(grade("cem", "most similar"), "");
    EXPECT_GT(std::stod(grade("ana", "similarity")), 0.8);
    const std::string html = page();
    EXPECT_TRUE(contains(html, "sum += mix(at, at.zxy, by)"));
    EXPECT_TRUE(contains(html, "all += mix(at, at.zxy, by)"));
    const Finished without = run("");
    ASSERT_EQ(without.status, 0) << without.err;
    EXPECT_NE(grade("cem", "most similar"), "");
}

TEST_F(ClassCommand, NothingFromOutsideOfASubmissionIsReadOrShown) {
    hand("ana", fragment("uTone"));
    const auto steals = [&](const std::string& student, const std::string& sceneText,
                            const std::string& shader) {
        hand(student, shader);
        folder.write("all/" + student + "/a.glib", sceneText);
    };
    steals("absolute",
           replaced(scene("a"), "Fragment a.frag", "Fragment \"" + (folder / "secret.glsl").string() + "\""),
           "");
    steals("above", replaced(scene("a"), "Fragment a.frag", "Fragment ../../secret.glsl"), "");
    steals("friend", replaced(scene("a"), "Fragment a.frag", "Fragment ../ana/a.frag"), "");
    steals("passwd", replaced(scene("a"), "Fragment a.frag", "Fragment \"/etc/passwd\""), "");
    steals("include", scene("a"), "#version 330 core\n#include \"../../secret.glsl\"\nvoid main() {}\n");
    steals("script", "Include ../../solution.glib\n" + scene("a"), fragment("uTone"));
    steals("linked", scene("a"), fragment("uTone"));
    fs::remove(folder / "all/linked/a.frag");
    fs::create_symlink(folder / "secret.glsl", folder / "all/linked/a.frag");
    fs::create_symlink(folder / "secret.glsl", folder / "all/link.glib");
    fs::create_directory_symlink(folder / "all/ana", folder / "all/linkfolder");
    const Finished done = run("");
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(grade("ana", "state"), "drawn");
    for (const char* each : {"absolute", "above", "friend", "passwd", "linked", "script"}) {
        EXPECT_EQ(grade(each, "state"), "failed") << each;
        EXPECT_TRUE(contains(grade(each, "reason"), "file-E12")) << grade(each, "reason");
    }
    EXPECT_EQ(grade("include", "state"), "failed");
    EXPECT_EQ(grade("link", "state"), "no-scene");
    EXPECT_EQ(grade("linkfolder", "state"), "no-scene");
    expectNowhere(kSecret);
    expectNowhere("root:x:");
    EXPECT_FALSE(contains(done.out + done.err, kSecret));
}

TEST_F(ClassCommand, WhatLiesAboveTheSubmissionsIsNoLibraryOfTheirs) {
    // The reference uses shaders of a folder that the look-up of its own scene finds.
    folder.write("shaders/solution.vert", kVertex);
    folder.write("shaders/solution.frag", fragment("uTone"));
    fs::remove(folder / "solution.vert");
    fs::remove(folder / "solution.frag");
    for (const char* name : {"solution.vert", "solution.frag"})
        EXPECT_TRUE(fs::exists(folder / "shaders" / name));
    hand("ana", fragment("uTone"));
    folder.write("all/eve/a.glib", scene("solution"));
    folder.write("all/eva.glib", scene("solution"));
    folder.write("all/ivy/a.glib", scene("solution"));
    folder.write("all/ivy/textures/none.txt", "a library of its own");
    const Finished done = run("");
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(grade("ana", "flip"), "0.00000");
    for (const char* each : {"eve", "eva", "ivy"}) {
        EXPECT_EQ(grade(each, "state"), "failed") << each;
        EXPECT_TRUE(contains(grade(each, "reason"), "file-E01")) << grade(each, "reason");
    }
    // What the hand-out and the folder of submissions give is theirs, and so is a library that is named.
    folder.write("handout/shaders/given.vert", kVertex);
    folder.write("all/shaders/common.frag", fragment("uTone"));
    folder.write("all/eve/a.glib", replaced(scene("given"), "given.frag", "common.frag"));
    const Finished given = run("--template handout");
    ASSERT_EQ(given.status, 0) << given.err;
    EXPECT_EQ(grade("eve", "flip"), "0.00000") << grade("eve", "reason");
    EXPECT_TRUE(contains(grade("eve", "not compared"), "'given.vert' is of the library"))
        << grade("eve", "not compared");
    EXPECT_TRUE(contains(page(), "Not compared with other submissions: ")) << page();
    EXPECT_EQ(run("--library .").status, 0);
    EXPECT_EQ(grade("eva", "flip"), "0.00000");
}

TEST_F(ClassCommand, ALibraryOfTheirOwnHidesNotWhatWasGivenToAll) {
    folder.write("all/shaders/given.vert", kVertex);
    folder.write("all/shaders/a.frag", fragment("0."));
    for (const char* own : {"shaders", "textures"}) {
        const std::string student = "all/" + std::string(own) + "Of/";
        folder.write(student + "a.glib", replaced(scene("a"), "a.vert", "given.vert"));
        folder.write(student + own + "/none.txt", "");
    }
    folder.write("all/texturesOf/a.frag", fragment("uTone"));
    folder.write("all/shadersOf/shaders/a.frag", fragment("uTone"));
    const Finished done = run("");
    ASSERT_EQ(done.status, 0) << done.err;
    for (const char* each : {"shadersOf", "texturesOf"})
        EXPECT_EQ(grade(each, "flip"), "0.00000") << each << ": " << grade(each, "reason");
}

TEST_F(ClassCommand, AfterALatePictureOthersAreNotTried) {
    hand("ana", fragment("uTone"));
    hand("eve",
         "#version 330 core\nuniform float uTone;\nout vec4 f;\n"
         "float more(float x) { return sin(sin(sin(sin(sin(sin(sin(sin(x)))))))); }\n"
         "void main() {\n    float s = uTone < .15 ? 2e30 : 0.;\n"
         "    while (s < 1e30) s += 1e-20 * uTone * more(more(more(more(s))));\n    f = vec4(s);\n}\n");
    std::string values = "0";
    for (int i = 1; i < 20; ++i) values += fmt::format(", {}", .05 * i);
    const auto start = std::chrono::steady_clock::now();
    const Finished done = run("--jobs 1 --timeout 3 --sweep 'uTone = [" + values + "]'");
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(grade("ana", "drawn"), grade("ana", "pictures"));
    EXPECT_EQ(grade("eve", "state"), "timed-out");
    EXPECT_LT(seconds, 30) << "more than ten of its pictures had their time";
}

TEST_F(ClassCommand, NobodyTakesTheCodeOfOthersOutOfTheComparison) {
    const std::string copied =
        "vec3 tint(vec3 at, float by) {\n    vec3 sum = vec3(0.);\n    for (int i = 0; i < 4; ++i) {\n"
        "        sum += mix(at, at.zxy, by) * float(i) / 6.;\n        at = reflect(at, normalize(sum + "
        ".1));\n    }\n    return clamp(sum, 0., 1.);\n}\n";
    const std::string shader =
        replaced(fragment("tint(vec3(uTone), uTone).x"), "void main", copied + "void main");
    // Scenes in one folder; eve uses the files of the two others, one of whom has copied from the other.
    folder.write("all/a.vert", kVertex);
    for (const std::string each : {"ana", "bob"}) {
        folder.write("all/" + each + ".frag", shader);
        folder.write("all/" + each + ".glib", replaced(scene("a"), "a.frag", each + ".frag"));
    }
    folder.write("all/eve.glib",
                 replaced(scene("a"), "Program P", "Program Q\nFragment ana.frag\nProgram P") +
                     "Fragment bob.frag\nProgram R\nSphere .1\n");
    folder.write("all/a.frag", fragment(".5"));
    const Finished done = run("");
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(grade("ana", "most similar"), "bob");
    EXPECT_EQ(grade("bob", "most similar"), "ana");
    EXPECT_GT(std::stod(grade("ana", "similarity")), .8);
    EXPECT_TRUE(contains(page(), "sum += mix(at, at.zxy, by)"));
    for (const char* each : {"ana", "bob"})
        EXPECT_TRUE(contains(grade(each, "not compared"), std::string("'") + each + ".frag' with eve"))
            << grade(each, "not compared");
    EXPECT_TRUE(contains(grade("eve", "not compared"), "'ana.frag' with ana"))
        << grade("eve", "not compared");
}

TEST_F(ClassCommand, PaddingHidesNoCopy) {
    const std::string copied =
        "vec3 tint(vec3 at, float by) {\n    vec3 sum = vec3(0.);\n    for (int i = 0; i < 4; ++i) {\n"
        "        sum += mix(at, at.zxy, by) * float(i) / 6.;\n        at = reflect(at, normalize(sum + "
        ".1));\n    }\n    return clamp(sum, 0., 1.);\n}\n";
    const auto padded = [&](std::size_t tokens) {
        std::string text = "#version 330 core\n#if 0\n";
        for (std::size_t i = 0; i < tokens / 4; ++i) text += "a+b;\n";
        return replaced(replaced(fragment("tint(vec3(uTone), uTone).x"), "void main", copied + "void main"),
                        "#version 330 core\n", text + "#endif\n");
    };
    hand("ana", padded(0));
    hand("bob", padded(100'000));
    hand("cem", std::string(fragment("uTone")) + "// " + std::string(2'000'000, 'x') + "\n");
    const Finished done = run("");
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(grade("ana", "most similar"), "bob");
    EXPECT_EQ(grade("bob", "not compared"), "");
    EXPECT_EQ(grade("cem", "not compared"), "");
}

TEST_F(ClassCommand, NamesPathsAndMessagesStayText) {
    const std::string name = "<b onmouseover='alert(1)'>&amp;\"";
    hand(name, "#version 330 core\n#error <script>alert(2)</script>\nvoid main() {}\n");
    hand("=1+1", fragment("uTone"));
    hand("line\nbreak", fragment("uTone"));
    hand("\x1b]0;title\x07\xff", fragment("uTone"));
    const Finished done = run("");
    ASSERT_EQ(done.status, 0) << done.err;
    const std::string html = page();
    EXPECT_FALSE(contains(html, "<b onmouseover"));
    EXPECT_EQ(countOf(html, "<script"), 1U) << "only its own";
    EXPECT_FALSE(contains(html + done.err, "\x1b"));
    EXPECT_TRUE(contains(html, "&lt;b onmouseover=&#39;alert(1)&#39;&gt;&amp;amp;&quot;"));
    EXPECT_EQ(grade(name, "state"), "failed");
    EXPECT_EQ(grade("'=1+1", "state"), "drawn");
    EXPECT_EQ(grade("line break", "state"), "drawn");
    EXPECT_EQ(grades().size(), 5U);
}

TEST_F(ClassCommand, AWrongReferenceIsAnErrorAndTheSiteStaysAsItWas) {
    hand("ana", fragment("uTone"));
    ASSERT_EQ(run("").status, 0);
    const std::string before = page();
    folder.write("solution.frag", fragment("uNowhere"));
    const Finished wrong = run("");
    EXPECT_EQ(wrong.status, 3);
    EXPECT_TRUE(contains(wrong.err, "the reference cannot be drawn")) << wrong.err;
    EXPECT_EQ(countOf(wrong.err, "uNowhere"), 1U) << wrong.err;
    EXPECT_EQ(page(), before);
    EXPECT_TRUE(fs::exists(folder / "site/pictures/0000-1.png"));
    EXPECT_TRUE(fs::exists(folder / "site/pictures/0001-1.png"));
    EXPECT_EQ(run("--sweep 'uTone = 3'").status, 2);
    EXPECT_EQ(run("--template nowhere").status, 2);
    EXPECT_EQ(glibra(folder.path(), "class nowhere --reference solution.glib").status, 2);
}

TEST_F(ClassCommand, CodeOfEarlierClassesIsComparedAndNamedAsTheirs) {
    const std::string own =
        "vec3 tint(vec3 at, float by) {\n    vec3 sum = vec3(0.);\n    for (int i = 0; i < 4; ++i) {\n"
        "        sum += mix(at, at.zxy, by) * float(i) / 6.;\n        at = reflect(at, normalize(sum + "
        ".1));\n    }\n    return clamp(sum, 0., 1.);\n}\nvoid main() {\n    f = vec4(tint(vN, uTone), "
        "1.);\n}\n";
    const std::string head = "#version 330 core\nin vec3 vN;\nuniform float uTone;\nout vec4 f;\n";
    hand("ana", head + own);
    hand("bob", fragment("uTone"));
    for (const char* each : {"dora", "emil"}) {
        folder.write("2025/" + std::string(each) + "/a.vert", kVertex);
        folder.write("2025/" + std::string(each) + "/a.frag",
                     head + (each == std::string("dora") ? own : "void main() { f = vec4(uTone); }\n"));
        folder.write("2025/" + std::string(each) + "/a.glib", scene("a"));
    }
    folder.write("2025/fred/readme.txt", "no scene");
    ASSERT_EQ(run("").status, 0);
    EXPECT_EQ(grade("ana", "most similar"), "");
    const Finished done = run("--earlier 2025/");
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(grade("ana", "most similar"), "2025/dora");
    EXPECT_EQ(grade("ana", "similarity"), "1.00000");
    EXPECT_EQ(grade("bob", "most similar"), "");
    EXPECT_EQ(grades().size(), 3U) << "earlier submissions are none of the class";
    EXPECT_TRUE(contains(done.err, "1 earlier submission without a scene cannot be compared: 2025/fred"))
        << done.err;
    const std::string html = page();
    EXPECT_TRUE(contains(html, "100 % of <bdi>ana</bdi>, 100 % of <bdi>2025/dora</bdi>"));
    EXPECT_TRUE(contains(html, "<h4><bdi>2025/dora</bdi>, a.frag</h4>")) << "its lines are shown";
    EXPECT_FALSE(contains(html, "data-name=\"2025/dora\""));
    ASSERT_EQ(run("--earlier 2025 --anonymous").status, 0);
    EXPECT_FALSE(contains(page(), "dora"));
    EXPECT_TRUE(contains(page(), "Earlier submission 01"));
    // An export as a zip file, with a zip file in it.
    ASSERT_EQ(shell(folder / "2025/dora", "python3 -m zipfile -c ../../dora.zip a.vert a.frag a.glib").status,
              0);
    ASSERT_EQ(shell(folder.path(), "python3 -m zipfile -c old.zip dora.zip").status, 0);
    ASSERT_EQ(run("--earlier old.zip").status, 0);
    EXPECT_EQ(grade("ana", "most similar"), "old/dora");
    EXPECT_EQ(run("--earlier all").status, 2);
    EXPECT_EQ(run("--earlier nowhere").status, 2);
    // Beside this year's it is none of this year's submissions.
    fs::rename(folder / "2025", folder / "all/2025");
    ASSERT_EQ(run("--earlier all/2025").status, 0);
    EXPECT_EQ(grades().size(), 3U);
    EXPECT_EQ(grade("ana", "most similar"), "2025/dora");
}

TEST_F(ClassCommand, PicturesOfAnEarlierRunDoNotStay) {
    hand("ana", fragment("uTone"));
    hand("bob", fragment("uTone"));
    ASSERT_EQ(run("").status, 0);
    folder.write("site/pictures/mine.png", "mine");
    fs::remove_all(folder / "all/bob");
    fs::create_symlink(folder / "secret.glsl", folder / "site/pictures/0009-1.png");
    ASSERT_EQ(run("").status, 0);
    EXPECT_TRUE(fs::exists(folder / "site/pictures/mine.png"));
    EXPECT_FALSE(fs::exists(fs::symlink_status(folder / "site/pictures/0009-1.png")));
    EXPECT_FALSE(fs::exists(folder / "site/pictures/0002-1.png"));
    EXPECT_TRUE(contains(readFile(folder / "secret.glsl"), kSecret));
}

TEST_F(ClassCommand, ConfinedWorkersGiveTheSamePage) {
    if (const std::string missing = system::missingForSandbox(); !missing.empty()) GTEST_SKIP() << missing;
    hand("ana", fragment("uTone"));
    hand("bob", fragment(".2"));
    hand("cem", "#version 330 core\n#include \"../../secret.glsl\"\nvoid main() {}\n");
    folder.write("handout/start.glsl", "void main() { discard; }\n");
    ASSERT_EQ(run("--template handout").status, 0);
    const std::vector<std::vector<std::string>> free = grades();
    const Finished confined = run("--template handout --untrusted");
    ASSERT_EQ(confined.status, 0) << confined.err;
    EXPECT_EQ(grades(), free);
    expectNowhere(kSecret);
}

/// Two hundred submissions: copies of the shipped scenes with changes, and hostile ones.
class WholeClass : public ClassCommand {
  protected:
    static constexpr std::size_t kStudents = 200;

    void SetUp() override {
        ClassCommand::SetUp();
        makeHostile();
        makeCopies();
    }

    /// Copies a shipped scene with the shaders that it names.
    void copy(const fs::path& from, const std::string& student, std::size_t change) {
        const std::string text = readFile(from);
        folder.write("all/" + student + "/" + from.filename().string(), text);
        const fs::path shaders = kRoot / "shaders" / from.parent_path().filename();
        for (const fs::directory_entry& each : fs::directory_iterator(shaders)) {
            const std::string name = each.path().filename().string();
            if (!contains(text, name) && each.path().extension() != ".glsl") continue;
            std::string source = replaced(readFile(each.path()), "../common/", "common/");
            if (each.path().extension() == ".frag" && change > 0)
                source =
                    replaced(std::move(source), "void main",
                             fmt::format("float own{0}(float x) {{ return x * {0}.; }}\nvoid main", change));
            if (change == 5 && each.path().extension() == ".frag") {
                source = replaced(std::move(source), "void main", "vecc3 wrong;\nvoid main");
                mistaken_.insert(student);
            }
            folder.write("all/" + student + "/" + name, source);
        }
        for (const fs::directory_entry& each : fs::directory_iterator(kRoot / "shaders/common"))
            folder.write("all/" + student + "/common/" + each.path().filename().string(),
                         readFile(each.path()));
        expected_.insert(student);
    }

    void makeCopies() {
        std::vector<fs::path> scenes;
        for (const char* topic : {"start", "noise", "patterns", "shading", "bump", "geometry", "projection"})
            for (const fs::directory_entry& each : fs::directory_iterator(kRoot / "glib" / topic))
                if (each.path().extension() == ".glib") scenes.push_back(each.path());
        std::sort(scenes.begin(), scenes.end());
        for (std::size_t i = 0; expected_.size() < kStudents; ++i)
            copy(scenes[i % scenes.size()], fmt::format("student{:03}", i), i / scenes.size());
    }

    void hostile(const std::string& student, const std::string& fragmentShader,
                 const std::string& text = scene("a")) {
        hand(student, fragmentShader);
        folder.write("all/" + student + "/a.glib", text);
        expected_.insert(student);
    }

    void makeHostile() {
        // Some drivers end a loop after many rounds, so each round takes long.
        const std::string endless =
            "#version 330 core\nuniform float uTone;\nout vec4 f;\n"
            "float more(float x) { return sin(sin(sin(sin(sin(sin(sin(sin(x)))))))); }\n"
            "void main() {\n    float s = 0.;\n"
            "    while (s < 1e30) s += 1e-20 * uTone * more(more(more(more(s))));\n"
            "    f = vec4(s);\n}\n";
        hostile("endless", endless);
        hostile("endless again", endless);
        hostile("missing file", fragment("uTone"), replaced(scene("a"), "a.frag", "nowhere.frag"));
        hostile("passwd", "#version 330 core\n#include \"../../etc/passwd\"\nvoid main() {}\n");
        hostile("passwd2", "", replaced(scene("a"), "a.frag", "../../../../../../../../etc/passwd"));
        hostile("secret", "#version 330 core\n#include \"../../secret.glsl\"\nvoid main() {}\n");
        hostile("<script>alert('x')<", fragment("uTone"));
        hostile("\" onerror=\"alert(1)", fragment("uTone"));
        hostile("=cmd|' -C calc'!A0", fragment("uTone"));
        hostile("two\nlines", fragment("uTone"));
        hostile("\xE2\x80\xAEright to left", fragment("uTone"));
        hostile("..hidden not", fragment("uTone"));
        // The expected name begins with "." and is left out, like every hidden one.
        expected_.erase("..hidden not");
        hostile("huge texture", fragment("uTone"), "Texture 5 huge.png\n" + scene("a"));
        // A PNG file that promises 60,000 x 60,000 pixels.
        const std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\xea\x60\0\0\xea\x60\x08\x06\0\0\0\0\0\0\0",
                              33);
        folder.write("all/huge texture/huge.png", png);
        hostile("huge targets", fragment("uTone"),
                "Texture 5 16384 16384\nTexture 6 16384 16384\n" + scene("a"));
        hostile("huge sphere", fragment("uTone"), replaced(scene("a"), "40 40", "100000 100000"));
        std::string macros = "#version 330 core\n#define M0 1.\n";
        for (int i = 1; i < 40; ++i) macros += fmt::format("#define M{} M{}+M{}\n", i, i - 1, i - 1);
        hostile("macros", macros + "out vec4 o;\nvoid main() { o = vec4(M39); }\n");
        hostile("garbage", std::string("\0\1\2\xff\xfe garbage", 13),
                std::string("\0\xff\x80\n\n\x1b[2J", 9));
        hostile("empty", "", "");
        std::string sum =
            "#version 330 core\nuniform float uTone;\nout vec4 o;\nvoid main() { o = vec4(uTone";
        for (int i = 0; i < 100'000; ++i) sum += "+uTone";
        hostile("long sum", sum + "); }\n");
        fs::create_directories(folder / "all/no scene");
        expected_.insert("no scene");
        fs::create_directory_symlink("/etc", folder / "all/etc");
        expected_.insert("etc");
        folder.write("all/two scenes/a.glib", scene("a"));
        folder.write("all/two scenes/b.glib", scene("a"));
        expected_.insert("two scenes");
        fs::create_directories(folder / "all/pipe");
        ASSERT_EQ(::mkfifo((folder / "all/pipe/a.frag").c_str(), 0600), 0);
        folder.write("all/pipe/a.vert", kVertex);
        folder.write("all/pipe/a.glib", scene("a"));
        expected_.insert("pipe");
    }

    std::set<std::string> expected_, mistaken_;
};

TEST_F(WholeClass, OfTwoHundredNobodyIsLostAndTheHostileCostOnlyThemselves) {
    const Finished done = glibra(
        folder.path(), "class all --reference solution.glib -o site --size 160x120 --timeout 4 --memory 1G",
        "GLIBRA_PATH='" + kRoot.string() + "'");
    ASSERT_EQ(done.status, 0) << done.err;
    const std::vector<std::vector<std::string>> rows = grades();
    ASSERT_EQ(rows.size(), kStudents + 1) << done.err;
    const std::string html = page();
    EXPECT_EQ(countOf(html, "<article class=\"card\""), kStudents);
    std::set<std::string> pictures;
    for (const fs::directory_entry& each : fs::directory_iterator(folder / "site/pictures"))
        pictures.insert(each.path().filename().string());
    std::size_t drawn = 0, good = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        ASSERT_EQ(rows[i].size(), rows[0].size()) << i;
        const bool isDrawn = rows[i][1] == "drawn";
        drawn += isDrawn ? 1 : 0;
        // Whoever has no picture has a reason, and whoever has one has a score.
        const bool hasScore = isDrawn || rows[i][1] == "nothing";
        EXPECT_NE(rows[i][2].empty(), !isDrawn) << rows[i][0];
        EXPECT_EQ(rows[i][6].empty(), !hasScore) << rows[i][0];
        // One with errors may have a picture, as far as it can be drawn.
        EXPECT_TRUE(!hasScore || pictures.contains(fmt::format("{:04}-1.png", i))) << rows[i][0];
        if (!rows[i][0].starts_with("student")) continue;
        ++good;
        // Every copy is drawn, except those with a mistake.
        EXPECT_EQ(isDrawn, !mistaken_.contains(rows[i][0])) << rows[i][0] << ": " << rows[i][2];
    }
    EXPECT_GT(good, 170U);
    EXPECT_GT(drawn, 140U);
    EXPECT_EQ(grade("endless", "state"), "timed-out");
    EXPECT_EQ(grade("endless again", "state"), "timed-out");
    EXPECT_EQ(grade("two scenes", "state"), "no-scene");
    EXPECT_EQ(grade("pipe", "state"), "failed");
    for (const char* each :
         {"<script>alert('x')<", "\" onerror=\"alert(1)", "two lines", "'=cmd|' -C calc'!A0"})
        EXPECT_EQ(grade(each, "state"), "drawn") << each;
    EXPECT_EQ(countOf(html, "<script"), 1U) << "only its own";
    EXPECT_FALSE(contains(html, "\" onerror=\"alert"));
    expectNowhere(kSecret);
    expectNowhere("root:x:");
    // The copies of one scene are similar to each other.
    EXPECT_TRUE(contains(grade("student000", "most similar"), "student"));
}

}  // namespace
}  // namespace glibra::test
