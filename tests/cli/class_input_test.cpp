// `glibra class` with what learning platforms export, with free colours, models and cameras, and with
// rubrics.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "image/image.h"
#include "image/read.h"
#include "image/write.h"
#include "program.h"
#include "system/sandbox.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

/// Dots of an assignment: their sizes are sliders.
std::string dots(const std::string& ground, const std::string& spot, const std::string& size = "uAd",
                 const std::string& shade = ".3 + .7 * abs(normalize(vN).z)") {
    return "#version 330 core\nin vec3 vN; in vec2 vST; out vec4 f;\nuniform float uAd, uTol;\nvoid main() "
           "{\n"
           "  float d = " +
           size +
           ";\n"
           "  vec2 at = (floor(vST / d) + .5) * d;\n  float e = length((vST - at) / (d / 2.));\n"
           "  float t = 1. - smoothstep(1. - uTol, 1. + uTol, e);\n"
           "  f = vec4((" +
           shade + ") * mix(vec3(" + ground + "), vec3(" + spot + "), t), 1.);\n}\n";
}

class ClassInput : public testing::Test {
  protected:
    static std::string sceneWith(const std::string& model = "Sphere 1 60 60",
                                 const std::string& eye = "0 0 2.6") {
        return "Perspective 70\nLookAt " + eye +
               " 0 0 0 0 1 0\nVertex a.vert\nFragment a.frag\n"
               "Program P uAd <.01 .12 .5> uTol <0. .05 1.>\n" +
               model + "\n";
    }
    void writeScene(const std::string& where, const std::string& fragment,
                    const std::string& scene = sceneWith()) const {
        folder.write(where + "a.vert",
                     "#version 330 core\nout vec3 vN; out vec2 vST;\nvoid main() { vN = uNormalMatrix * "
                     "aNormal; vST = "
                     "aTexCoord0.st; gl_Position = uModelViewProjectionMatrix * aVertex; }\n");
        folder.write(where + "a.frag", fragment);
        folder.write(where + "a.glib", scene);
    }
    void SetUp() override { writeScene("ref/", kReference); }
    [[nodiscard]] Finished run(const std::string& more,
                               const std::string& reference = "--reference ref/a.glib ") const {
        return glibra(folder.path(), "class all " + reference + "-o site --size 128x128 " + more);
    }
    /// The fields of the table by submission and column. The names of this file have no commas.
    [[nodiscard]] std::map<std::string, std::map<std::string, std::string>> grades() const {
        std::map<std::string, std::map<std::string, std::string>> all;
        std::vector<std::vector<std::string>> rows;
        std::string text = readFile(folder / "site/grades.csv");
        if (text.starts_with("\xEF\xBB\xBF")) text = text.substr(3);
        bool quoted = false;
        rows.push_back({""});
        for (const char each : text) {
            if (each == '"')
                quoted = !quoted;
            else if (each == ',' && !quoted)
                rows.back().emplace_back();
            else if (each == '\n')
                rows.push_back({""});
            else if (each != '\r')
                rows.back().back() += each;
        }
        for (std::size_t i = 1; i + 1 < rows.size(); ++i)
            for (std::size_t k = 0; k < std::min(rows[0].size(), rows[i].size()); ++k)
                all[rows[i][0]][rows[0][k]] = rows[i][k];
        return all;
    }
    [[nodiscard]] std::string page() const { return readFile(folder / "site/index.html"); }

    const std::string kReference = dots("1.,.5,0.", "1.,1.,1.");
    Folder folder;
};

TEST_F(ClassInput, LikenessOrdersSubmissionsAsAPersonDoes) {
    // The best first; those of one letter are about as good.
    writeScene("all/a1 same/", kReference);
    writeScene("all/a2 other colours/", dots(".1,.2,.7", ".9,.9,.1"));
    writeScene("all/a3 inverted/", dots("1.,1.,1.", ".1,.4,.1"));
    writeScene("all/b1 camera/", kReference, sceneWith("Sphere 1 60 60", "1.6 1.2 1.8"));
    writeScene("all/b2 farther/", kReference, sceneWith("Sphere 1 60 60", "0 0 4"));
    writeScene("all/b3 torus/", dots(".2,.3,.9", "1.,1.,1."), sceneWith("Torus 1 .5 40 60", "0 0 3.2"));
    writeScene("all/c1 half as large/", dots("1.,.5,0.", "1.,1.,1.", "(uAd * 2.5)"));
    writeScene("all/d1 plain/", dots("1.,.5,0.", "1.,.5,0."));
    writeScene("all/d2 one colour/", dots("1.,.5,0.", "1.,.5,0.", "uAd", "1."));
    writeScene("all/e1 nothing/",
               "#version 330 core\nuniform float uAd, uTol;\nout vec4 f;\nvoid main() { discard; }\n");
    writeScene("all/e2 behind/", kReference, sceneWith("Translate 0 0 30\nSphere 1 60 60"));
    const Finished done = run("--sweep 'uAd = [.12, .2]'");
    ASSERT_EQ(done.status, 0) << done.err;
    auto table = grades();
    std::map<char, std::pair<double, double>> range;  // of each letter
    for (auto& [name, row] : table) {
        if (name[0] == 'e') {
            EXPECT_EQ(row["state"], "nothing") << name;
            EXPECT_EQ(row["likeness"], "0.00000") << name;
            continue;
        }
        EXPECT_EQ(row["state"], "drawn") << name;
        const double value = std::stod(row["likeness"]);
        auto [known, isNew] = range.try_emplace(name[0], value, value);
        known->second.first = std::min(known->second.first, value);
        known->second.second = std::max(known->second.second, value);
    }
    for (char each = 'a'; each < 'd'; ++each)
        EXPECT_GT(range[each].first, range[static_cast<char>(each + 1)].second)
            << each << "\n"
            << readFile(folder / "site/grades.csv");
    EXPECT_EQ(table["a1 same"]["likeness"], "1.00000");
    EXPECT_GT(range['a'].first, .85);
    EXPECT_LT(range['d'].second, .35);
    for (const char* each : {"a2 other colours", "b3 torus", "c1 half as large"})
        EXPECT_EQ(table[each]["reacts uAd"], "yes") << each;
    EXPECT_EQ(table["d1 plain"]["reacts uAd"], "no");
    EXPECT_TRUE(contains(done.err, "2 drawn without anything to see")) << done.err;
    // FLIP alone prefers the empty picture to other colours: that is why there is a verdict.
    EXPECT_TRUE(contains(page(), "it draws nothing that is seen"));
}

TEST_F(ClassInput, ReactionsAreMeasuredAgainstTheSubmissionItself) {
    writeScene("all/ana/", dots(".2,.2,.8", "1.,1.,0."));
    writeScene("all/bob/", dots("1.,.5,0.", "1.,1.,1.", ".12"));
    writeScene("all/cem/", dots("1.,.5,0.", "1.,1.,1.", "uAd + 0. * uTol"));
    const Finished done = run("--sweep 'uAd = [.12, .25]' --sweep 'uTol = [0, .6]'");
    ASSERT_EQ(done.status, 0) << done.err;
    auto table = grades();
    EXPECT_EQ(table["ana"]["reacts uAd"], "yes");
    EXPECT_EQ(table["ana"]["reacts uTol"], "yes");
    EXPECT_EQ(table["bob"]["reacts uAd"], "no");
    EXPECT_EQ(table["bob"]["reacts uTol"], "yes");
}

TEST_F(ClassInput, AMisspeltSliderEndsTheRunBeforeAnythingIsDrawn) {
    writeScene("all/ana/", kReference);
    ASSERT_EQ(run("").status, 0);
    const std::string before = folder.listing(), html = page();
    for (const char* wrong : {"--set uAdd=.3", "--sweep 'uAdd = [.1, .2]'", "--set P:uAdd=.3",
                              "--sweep 'uTol = [0, 1]' --sweep 'uAdd = [.1, .2]'"}) {
        const Finished done = run(wrong);
        EXPECT_EQ(done.status, 2) << wrong << done.err;
        EXPECT_TRUE(contains(done.err, "suite-E19")) << done.err;
        EXPECT_TRUE(contains(done.err, "did you mean 'uAd'?")) << done.err;
        EXPECT_EQ(folder.listing(), before) << wrong;
        EXPECT_EQ(page(), html) << wrong;
    }
    EXPECT_EQ(run("--set uAdd=.3", "").status, 2) << "without a reference, after drawing";
    EXPECT_EQ(page(), "") << "its pictures would not be those of the page";
    writeScene("all/bob/", "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(1.); }\n");
    EXPECT_EQ(run("--set uAd=.3").status, 0) << "one that a student lacks is no mistake of the teacher";
}

TEST_F(ClassInput, WithoutAReferenceThePageIsAContactSheet) {
    writeScene("all/ana/", kReference);
    writeScene("all/bob/", dots(".1,.2,.7", ".9,.9,.1"));
    const Finished done = run("--time 0 --time 1", "");
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_TRUE(contains(done.err, "2 submissions: 2 drawn"));
    EXPECT_FALSE(contains(page(), "the reference\""));
    EXPECT_FALSE(contains(page(), "id=\"reference\""));
    EXPECT_FALSE(contains(page(), "{{"));
    EXPECT_TRUE(fs::exists(folder / "site/pictures/0002-2.png"));
    EXPECT_FALSE(fs::exists(folder / "site/pictures/0000-1.png"));
    EXPECT_EQ(grades()["ana"]["flip"], "");
}

TEST_F(ClassInput, IncompleteScenesAreShownAsFarAsTheyCanBeDrawn) {
    writeScene("all/ana/", kReference, sceneWith("Sphere 1 60 60\nObj missing.obj"));
    const Finished done = run("");
    ASSERT_EQ(done.status, 0) << done.err;
    auto table = grades();
    EXPECT_EQ(table["ana"]["state"], "failed");
    EXPECT_EQ(table["ana"]["likeness"], "");
    EXPECT_TRUE(fs::exists(folder / "site/pictures/0001-1.png"));
    EXPECT_TRUE(contains(page(), "incomplete: the scene has errors"));
    const std::string html = page();
    EXPECT_LT(html.find("missing.obj"), html.find("pictures/0001-1.png")) << "the error comes first";
    EXPECT_TRUE(contains(html, "class=\"named\">Obj missing.obj")) << "the line of the message";
}

TEST_F(ClassInput, AnExportOfMoodleBecomesATableThatMoodleImports) {
    writeScene("all/Ana Lee_1001_assignsubmission_file_/", kReference);
    writeScene("all/Bob Ray_1002_assignsubmission_file_/", dots(".1,.2,.7", ".9,.9,.1", ".12"));
    folder.write("all/Cem \xC3\x96z_1003_assignsubmission_file_/a.glib.txt", "Sphere\n");
    folder.write("grades.csv",
                 "Identifier,Full name,Email address,Grade,Feedback comments,submitted\r\n"
                 "Participant 1001,Ana Lee,ana@x.org,,,2026-11-20 12:00\r\n"
                 "Participant 1002,Bob Ray,bob@x.org,,,2026-11-22 12:00\r\n"
                 "Participant 1003,Cem \xC3\x96z,cem@x.org,,,\r\nParticipant 1004,Zoe,zoe@x.org,,,\r\n");
    folder.write(
        "class.toml",
        "[[check]]\nname = \"dots\"\nlike = 0.8\npoints = 5\n[[check]]\nreacts = \"uAd\"\npoints = 3\n"
        "[[check]]\nslider = \"uTol\"\nrange = [0, 1]\npoints = 2\n"
        "[late]\ndue = \"2026-11-20 23:59\"\nper-day = 0.1\n");
    const Finished done = run(
        "--names moodle --roster grades.csv --rubric class.toml --sweep 'uAd = [.12, .3]' --student-pages");
    ASSERT_EQ(done.status, 0) << done.err;
    auto table = grades();
    EXPECT_EQ(table["Ana Lee"]["points"], "10.00000");
    EXPECT_EQ(table["Ana Lee"]["number"], "1001");
    EXPECT_EQ(table["Bob Ray"]["points changes with uAd"], "0.00000");
    EXPECT_EQ(table["Bob Ray"]["late"], "2 days late, 20 % less");
    EXPECT_EQ(table["Cem \xC3\x96z"]["points"], "0.00000");
    EXPECT_TRUE(readFile(folder / "site/grades.csv").starts_with("\xEF\xBB\xBF"));
    const std::string import = readFile(folder / "site/import-moodle.csv");
    EXPECT_TRUE(
        import.starts_with("Identifier,Full name,Email address,Grade,Feedback comments,submitted\r\n"));
    EXPECT_TRUE(contains(import, "Participant 1001,Ana Lee,ana@x.org,10.00,")) << import;
    EXPECT_TRUE(contains(import, "Participant 1004,Zoe,zoe@x.org,,,\r\n")) << import;
    EXPECT_TRUE(contains(page(), "These students of the roster handed in nothing"));
    // Bob's own page says nothing of the others.
    const std::string own = readFile(folder / "site/students/Bob Ray.html");
    EXPECT_TRUE(contains(own, "data:image/png;base64,iVBOR"));
    EXPECT_TRUE(contains(own, "2 days late"));
    for (const char* each :
         {"Ana", "Cem", "like that of", "<script", "src=\"pictures", folder.path().c_str()})
        EXPECT_FALSE(contains(own, each)) << each;
}

TEST_F(ClassInput, ZipFilesAndFlatFilesAreDrawnInASandboxToo) {
    writeScene("flat/", kReference);
    for (const char* each : {"a.glib", "a.frag", "a.vert"})
        folder.write(fmt::format("all/leeana_12_{}_{}", 30 + each[2], each),
                     readFile(folder / ("flat/" + std::string(each))));
    ASSERT_EQ(shell(folder / "flat",
                    "python3 -m zipfile -c ../all/rayb_LATE_13_99_hand-in.zip a.glib a.frag a.vert")
                  .status,
              0);
    ASSERT_EQ(shell(folder / "flat", "python3 -m zipfile -c ../all/cem.zip a.glib a.frag a.vert").status, 0);
    std::vector<std::string> ways{""};
    if (system::missingForSandbox().empty()) ways.emplace_back("--untrusted ");
    for (const std::string& each : ways) {
        const Finished done = run(each + "--names canvas --assignment 'P2 (7)'");
        ASSERT_EQ(done.status, 0) << done.err;
        auto table = grades();
        for (const char* name : {"leeana", "rayb", "cem"})
            EXPECT_EQ(table[name]["likeness"], "1.00000") << each << name << table[name]["reason"];
        EXPECT_EQ(table["leeana"]["number"], "12");
        EXPECT_TRUE(readFile(folder / "site/import-canvas.csv")
                        .starts_with("Student,ID,SIS User ID,SIS Login ID,Section,P2 (7)\r\n"));
    }
}

TEST_F(ClassInput, TheTeachersPointsSurviveANewRun) {
    writeScene("all/ana/", kReference);
    folder.write(
        "class.toml",
        "[[check]]\ndrawn = true\npoints = 4\n[[check]]\nname = \"report\"\nby-hand = true\npoints = 6\n");
    ASSERT_EQ(run("--rubric class.toml").status, 0);
    EXPECT_EQ(grades()["ana"]["points"], "4.00000");
    folder.write("site/marks.json",
                 "{\"ana\": {\"points\": {\"report\": 5.5}, \"comment\": \"a <b>good</b> text\"}}");
    ASSERT_EQ(run("--rubric class.toml").status, 0);
    EXPECT_EQ(grades()["ana"]["points"], "9.50000");
    EXPECT_EQ(grades()["ana"]["comment"], "a <b>good</b> text");
    EXPECT_TRUE(contains(page(), "a &lt;b&gt;good&lt;/b&gt; text"));
    folder.write("site/marks.json", "not JSON");
    EXPECT_EQ(run("--rubric class.toml").status, 3) << "what was typed is not overwritten";
    EXPECT_EQ(readFile(folder / "site/marks.json"), "not JSON");
}

TEST_F(ClassInput, PointsThatFindNoPlaceAreNamedAndFollowTheStudent) {
    const std::string rubric =
        "[[check]]\ndrawn = true\npoints = 4\n[[check]]\nname = \"report\"\nby-hand = true\npoints = 6\n";
    writeScene("all/Ana Lee_12_assignsubmission_file_/", kReference);
    folder.write("class.toml", rubric);
    const Finished first = run("--rubric class.toml --grade-book moodle");
    ASSERT_EQ(first.status, 0);
    EXPECT_TRUE(contains(first.err, "1 field is not yet marked by hand: 'report' of 1")) << first.err;
    EXPECT_FALSE(contains(readFile(folder / "site/import-moodle.csv"), "4.00"))
        << "no grade that is not whole";
    folder.write("site/marks.json",
                 "{\"Ana Lee_12_assignsubmission_file_\": {\"points\": {\"report\": 5}},"
                 " \"zed\": {\"points\": {\"report\": 3}}}");
    const Finished second = run("--rubric class.toml --names moodle");
    ASSERT_EQ(second.status, 0);
    EXPECT_EQ(grades()["Ana Lee"]["points"], "9.00000") << "by what was handed in";
    EXPECT_TRUE(contains(second.err, "no submission is 'zed', which has 3 points for 'report'"))
        << second.err;
    EXPECT_TRUE(contains(page(), "no submission is &#39;zed&#39;") ||
                contains(page(), "no submission is 'zed'"));
    EXPECT_TRUE(contains(readFile(folder / "site/import-moodle.csv"), "9.00"));
    folder.write("class.toml", rubric + "[[check]]\nname = \"essay\"\nby-hand = true\nbonus = true\n");
    EXPECT_FALSE(contains(run("--rubric class.toml --names moodle").err, "not yet marked"))
        << "a bonus may stay";
    std::string renamed = rubric;
    renamed.replace(renamed.find("report"), 6, "write-up");
    folder.write("class.toml", renamed);
    const Finished third = run("--rubric class.toml --names moodle");
    EXPECT_TRUE(contains(third.err, "the rubric has no check for the 5 points for 'report' of 'Ana Lee'"))
        << third.err;
    EXPECT_TRUE(contains(readFile(folder / "site/marks.json"), "zed"));
}

TEST_F(ClassInput, PointsInsteadOfACheckEndWhenAStudentHandsInAgain) {
    writeScene("all/ana/", kReference);
    writeScene("all/bob/", kReference);
    folder.write("class.toml", "[[check]]\ndrawn = true\npoints = 4\n");
    ASSERT_EQ(run("--rubric class.toml").status, 0);
    folder.write("site/marks.json",
                 "{\"ana\": {\"points\": {\"is drawn\": 1}}, \"bob\": {\"points\": {\"is drawn\": 2}}}");
    writeScene("all/ana/", dots("0.,.5,0.", "1.,1.,1."));
    for (int i = 0; i < 2; ++i) {
        const Finished again = run("--rubric class.toml");
        EXPECT_TRUE(contains(again.err, "'ana' was handed in again after you typed 1 point for 'is drawn'"))
            << again.err;
        EXPECT_EQ(grades()["ana"]["points"], "4.00000");
        EXPECT_EQ(grades()["bob"]["points"], "2.00000");
        EXPECT_FALSE(contains(again.err, "'bob' was handed in again"));
    }
}

/// A photograph, and a lens over a part of it.
std::string lens(const std::string& change) {
    return "#version 330 core\nuniform sampler2D uImage;\nuniform float uMag;\nin vec2 vST;\nout vec4 f;\n"
           "void main() {\n  vec2 d = vST - .5;\n" +
           change + "}\n";
}

TEST_F(ClassInput, AnEffectOnAPartOfThePictureDecidesAboutLikeness) {
    const auto write = [&](const std::string& where, const std::string& change,
                           const char* camera = "Ortho -5 5 -5 5\nLookAt 0 0 2 0 0 0 0 1 0\n") {
        folder.write(where + "a.vert",
                     "#version 330 core\nout vec2 vST;\nvoid main() { vST = aTexCoord0.st; "
                     "gl_Position = uModelViewProjectionMatrix * aVertex; }\n");
        folder.write(where + "a.frag", lens(change));
        folder.write(where + "image.png", readFile(GLIBRA_SOURCE_DIR "/textures/village.png"));
        folder.write(where + "a.glib", std::string(camera) +
                                           "Texture2D 5 image.png\nVertex a.vert\nFragment a.frag\n"
                                           "Program P uImage 5 uMag <1. 1. 25.>\nQuadXY .2 5.\n");
    };
    const std::string show = "  f = texture(uImage, d + .5);\n";
    write("ref/", "  if (length(d) < .2) d /= uMag;\n" + show);
    // The lens works, works in part, or there is none.
    write("all/a1 same/", "  if (length(d) < .2) d /= uMag;\n" + show);
    write("all/a2 square/", "  if (max(abs(d.x), abs(d.y)) < .18) d /= uMag;\n" + show);
    write("all/a3 larger/", "  if (length(d) < .24) d /= uMag;\n" + show);
    write("all/a4 rim/", "  float r = length(d);\n  if (r < .2) d /= uMag;\n" + show +
                             "  if (abs(r - .2) < .01) f = vec4(1.);\n");
    write("all/a5 camera/", "  if (length(d) < .2) d /= uMag;\n" + show,
          "Perspective 60\nLookAt 1 .6 9 0 0 0 0 1 0\n");
    write("all/b1 half/", "  if (length(d) < .2 && d.x > 0.) d /= uMag;\n" + show);
    write("all/b2 weak/", "  if (length(d) < .2) d /= 1. + .25 * (uMag - 1.);\n" + show);
    write("all/b3 small/", "  if (length(d) < .06) d /= uMag;\n" + show);
    write("all/c1 plain/", "  d *= 1. + 1e-9 * uMag;\n" + show);
    write("all/c2 tint/", "  d *= 1. + 1e-9 * uMag;\n" + show + "  f.b *= .7;\n");
    write("all/c3 fixed/", "  if (length(d) < .2) d /= 2. + 1e-9 * uMag;\n" + show);
    write("all/c4 disc/", show + "  if (length(d) < .2) f.rgb = vec3(uMag / 25., .3, .8);\n");
    folder.write("class.toml",
                 "[[check]]\nname = \"looks\"\nlike = 0.8\npoints = 4\n[[check]]\nreacts = \"uMag\"\n");
    ASSERT_EQ(run("--rubric class.toml --sweep 'uMag = [1, 2, 4]'").status, 0);
    auto table = grades();
    ASSERT_EQ(table.size(), 12U);
    std::size_t wrong = 0, all = 0;
    for (auto& [name, row] : table) {
        const double points = std::stod(row["points looks"]);
        const std::string& reacts = row["reacts uMag"];
        EXPECT_GE(points, name[0] == 'a' ? 3 : 0) << name;
        EXPECT_LE(points, name[0] == 'c' ? 1 : 4) << name;
        EXPECT_EQ(reacts == "yes", name[0] != 'c') << name;
        for (auto& [other, its] : table) {
            if (other[0] <= name[0]) continue;
            ++all;
            wrong += std::stod(row["likeness"]) > std::stod(its["likeness"]) ? 0 : 1;
        }
    }
    EXPECT_LE(wrong, all / 10) << wrong << " of " << all << " pairs";
    // One picture of each shows no effect, which is said.
    folder.write("looks.toml", "[[check]]\nname = \"looks\"\nlike = 0.8\n");
    EXPECT_TRUE(contains(run("--rubric looks.toml").err, "the check 'looks' compares whole pictures"));
}

TEST_F(ClassInput, APictureOfTheSolutionIsNamed) {
    writeScene("all/ana/", kReference);
    ASSERT_EQ(run("").status, 0);
    folder.write("all/bob/mine.png", readFile(folder / "site/pictures/0000-1.png"));
    folder.write("all/bob/a.vert", "#version 330 core\nvoid main() { gl_Position = aVertex; }\n");
    folder.write("all/bob/a.frag",
                 "#version 330 core\nuniform sampler2D uP;\nout vec4 f;\nvoid main() { f = texture(uP, "
                 "gl_FragCoord.xy / 128.); }\n");
    folder.write("all/bob/a.glib",
                 "Texture2D 5 mine.png\nVertex a.vert\nFragment a.frag\nProgram P uP 5\nQuadXY 0. 1.\n");
    ASSERT_EQ(run("").status, 0);
    EXPECT_TRUE(contains(page(), "It reads a picture that looks like the reference's: mine.png") ||
                contains(page(), "It reads a picture that looks like the reference&#39;s: mine.png"));
}

TEST_F(ClassInput, APartOfThePictureOfTheSolutionIsNamed) {
    writeScene("ref/", kReference, sceneWith("Sphere 1 60 60", "0 0 1.6"));
    writeScene("all/ana/", kReference);
    ASSERT_EQ(run("").status, 0);
    const Finished cropped = glibra(
        folder.path(), "render '" GLIBRA_SOURCE_DIR "/glib/start/teapot.glib' --size 48x40 -o other.png");
    ASSERT_EQ(cropped.status, 0) << cropped.err;
    const auto solution = image::readImage(folder / "site/pictures/0000-1.png");
    ASSERT_TRUE(solution) << solution.message();
    ASSERT_TRUE(image::writeImage(image::partOf(image::withComponents(*solution, 3), {40, 44, 88, 84}),
                                  folder / "cut.png")
                    .empty());
    for (const char* each : {"cut", "other"}) {
        const std::string own = std::string("all/") + each + "/";
        folder.write(own + each + ".png", readFile(folder / (std::string(each) + ".png")));
        folder.write(own + "a.vert", "#version 330 core\nvoid main() { gl_Position = aVertex; }\n");
        folder.write(own + "a.frag",
                     "#version 330 core\nuniform sampler2D uP;\nout vec4 f;\nvoid main() { f = texture(uP, "
                     "gl_FragCoord.xy / 128.); }\n");
        folder.write(own + "a.glib",
                     std::string("Texture2D 5 ") + each +
                         ".png\nVertex a.vert\nFragment a.frag\nProgram P uP 5\nQuadXY 0. 1.\n");
    }
    ASSERT_EQ(run("").status, 0);
    EXPECT_TRUE(contains(page(), "s: cut.png"));
    EXPECT_FALSE(contains(page(), "s: other.png"));
}

/// A scene that lies alone among the submissions is handed in with the files that it uses.
TEST_F(ClassInput, PointsEndWhenAShaderOfALoneSceneChanges) {
    writeScene("all/", kReference);
    fs::rename(folder / "all/a.glib", folder / "all/ana.glib");
    writeScene("all/shaders/", kReference);
    folder.write("all/bob.frag", kReference);
    folder.write("all/bob.glib", "Vertex a.vert\nFragment bob.frag\nProgram P\nSphere\n");
    folder.write("class.toml", "[[check]]\ndrawn = true\npoints = 4\n");
    const auto digests = [&] {
        EXPECT_EQ(run("--rubric class.toml").status, 0);
        return readFile(folder / "site/handed-in.json");
    };
    const std::string first = digests();
    const auto own = [](const std::string& all, const char* name) {
        const std::size_t at = all.find(name);
        return at == std::string::npos ? std::string() : all.substr(at, all.find('\n', at) - at);
    };
    ASSERT_FALSE(own(first, "\"ana\"").empty()) << first;
    folder.write("all/unused.frag", "void main() {}\n");
    folder.write("all/shaders/a.frag", "void main() {}\n");
    EXPECT_EQ(digests(), first) << "what nobody reads, and what was given to all";
    folder.write("all/a.frag", dots(".1,.2,.7", ".9,.9,.1", ".12"));
    const std::string second = digests();
    EXPECT_NE(own(second, "\"ana\""), own(first, "\"ana\""));
    EXPECT_EQ(own(second, "\"bob\""), own(first, "\"bob\""));
}

TEST_F(ClassInput, RubricAndRosterMayComeFromPipes) {
    writeScene("all/ana/", kReference);
    folder.write("class.toml", "[[check]]\ndrawn = true\npoints = 4\n");
    folder.write("list.csv", "name,number\nana,1001\n");
    for (const char* each : {"rubric", "roster"}) ASSERT_EQ(::mkfifo((folder / each).c_str(), 0600), 0);
    const std::string in = "cd '" + folder.path().string() + "' && ";
    ASSERT_EQ(std::system((in + "(cat list.csv > roster & cat class.toml > rubric) &").c_str()), 0);
    const Finished done = run("--rubric rubric --roster roster");
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(grades()["ana"]["points"], "4.00000");
    EXPECT_EQ(grades()["ana"]["number"], "1001");
}

TEST_F(ClassInput, ProgramsThatDrawNothingCountForNoCheck) {
    writeScene("all/ana/", kReference, sceneWith() + "Fragment never.frag\nProgram Never\n");
    folder.write("all/ana/never.frag",
                 "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(cos(gl_FragCoord.x)); }\n");
    writeScene("all/bob/", kReference, sceneWith() + "Geometry g.geom\nProgram Never\n");
    folder.write("all/bob/g.geom",
                 "#version 330 core\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) "
                 "out;\nvoid main() {}\n");
    writeScene("all/cyd/", kReference, sceneWith() + "Geometry g.geom\nProgram Never\nQuadXY 0 1\n");
    folder.write("all/cyd/g.geom",
                 "#version 330 core\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) "
                 "out;\nvoid main() { if (false) EmitVertex(); }\n");
    folder.write("class.toml",
                 "[[check]]\nuses = \"cos\"\n[[check]]\nuses = \"smoothstep\"\n[[check]]\nstage = "
                 "\"geometry\"\n[[check]]\nstage = \"fragment\"\n");
    ASSERT_EQ(run("--rubric class.toml").status, 0);
    EXPECT_EQ(grades()["ana"]["points uses cos"], "0.00000");
    EXPECT_EQ(grades()["ana"]["points uses smoothstep"], "1.00000");
    EXPECT_EQ(grades()["bob"]["points has a geometry shader"], "0.00000");
    EXPECT_EQ(grades()["cyd"]["points has a geometry shader"], "0.00000") << "it emits nothing";
    EXPECT_EQ(grades()["bob"]["points has a fragment shader"], "1.00000");
    EXPECT_TRUE(contains(page(), "nothing is drawn with the geometry shader of program"));
}

TEST_F(ClassInput, WithoutAPictureThereIsNoPointForAStage) {
    writeScene("all/missing/", kReference, sceneWith() + "Geometry missing.geom\nProgram Q\nSphere .1\n");
    writeScene("all/huge/", kReference, "WindowSize 60000 60000\n" + sceneWith());
    writeScene("all/broken/", dots("1.,.5,0.", "nothing"));
    folder.write("class.toml",
                 "[[check]]\nstage = \"geometry\"\n[[check]]\nstage = \"fragment\"\n[[check]]\nuses = "
                 "\"smoothstep\"\n[[check]]\navoids = \"cos\"\n[[check]]\nwithout = \"glsl-*\"\n");
    ASSERT_EQ(glibra(folder.path(), "class all -o site --rubric class.toml").status, 0);
    for (const char* student : {"missing", "huge", "broken"})
        for (const char* check :
             {"has a geometry shader", "has a fragment shader", "uses smoothstep", "does not use cos"})
            EXPECT_EQ(grades()[student]["points " + std::string(check)], "0.00000") << student << check;
    EXPECT_EQ(grades()["broken"]["points has no glsl-*"], "0.50000") << "one error";
}

TEST_F(ClassInput, WhoIsNotInTheRosterIsNamed) {
    writeScene("all/ana/", kReference);
    writeScene("all/zed/", kReference);
    folder.write("class.csv", "name,number\nAna,7\nBob,8\n");
    const Finished done = run("--roster class.csv");
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_TRUE(contains(done.err, "1 student not in the roster: zed\n")) << done.err;
    const std::size_t at = page().find("These students handed something in and are not in the roster.");
    ASSERT_NE(at, std::string::npos);
    EXPECT_TRUE(contains(page().substr(at, 200), "zed"));
    ASSERT_EQ(run("--roster class.csv --anonymous").status, 0);
    EXPECT_FALSE(contains(page(), "not in the roster"));
    // A roster that lies where the page would replace it.
    fs::rename(folder / "class.csv", folder / "site/grades.csv");
    const Finished refused = run("--roster site/grades.csv");
    EXPECT_EQ(refused.status, 3);
    EXPECT_TRUE(contains(refused.err, "[file-E13]")) << refused.err;
    EXPECT_TRUE(contains(readFile(folder / "site/grades.csv"), "Bob,8"));
}

TEST_F(ClassInput, PointsTypedOnTheServedPageAreKept) {
    writeScene("all/ana/", kReference);
    writeScene("all/bob/", kReference);
    folder.write("class.toml", "[[check]]\nname = \"report\"\nby-hand = true\npoints = 6\n");
    // A browser, and what is none: another origin, a form, a path of the disk, an entry that does not exist.
    folder.write("browser.py", R"(
import json, re, signal, subprocess, sys, urllib.error, urllib.request
run = subprocess.Popen(sys.argv[1:], stderr=subprocess.PIPE, text=True)
for line in run.stderr:
    found = re.search(r"http://127.0.0.1:[0-9]+/[0-9a-f]+/", line)
    if found: break
else: sys.exit("no address")
address = found.group()
def ask(path, body=None, **headers):
    data = None if body is None else json.dumps(body).encode() if isinstance(body, dict) else body
    if data is not None: headers.setdefault("Content_Type", "application/json")
    headers = {name.replace("_", "-"): value for name, value in headers.items()}
    try:
        with urllib.request.urlopen(urllib.request.Request(address + path, data, headers)) as reply:
            return reply.status, reply.read()
    except urllib.error.HTTPError as problem: return problem.code, problem.read()
page = ask("")[1].decode()
assert "grade.js" in page and "connect-src 'self'" in page, page[:800]
assert ask("grade.js")[0] == ask("class.js")[0] == ask("grades.csv")[0] == 200
assert ask("pictures/0001-1.png")[1][1:4] == b"PNG"
change = {"entry": 1, "check": "report", "points": 4.5}
assert ask("marks", change, Origin="http://example.org")[0] >= 400
assert ask("marks", b"entry=1", Content_Type="application/x-www-form-urlencoded")[0] >= 400
for path in ("../class.toml", "marks.json", "class.toml", "%2e%2e/class.toml", "pictures/..%2fmarks.json"):
    assert ask(path)[0] >= 400, path
for wrong in ({"entry": 7, "comment": ""}, {"entry": -1, "comment": ""}, {"entry": 1, "check": "x", "points": 1},
              {"entry": 1, "check": "report"}, {"entry": 1, "check": "report", "points": "many"}, {}):
    assert ask("marks", wrong)[0] == 400, wrong
status, reply = ask("marks", change)
assert status == 200 and json.loads(reply)["entries"][0]["points"] == 4.5, reply
assert ask("marks", {"entry": 0, "comment": "well <done>"})[0] == 200
assert "well &lt;done&gt;" in ask("")[1].decode()
run.send_signal(signal.SIGINT)
assert run.wait(20) == 0
)");
    const std::string command =
        fmt::format("class all --reference ref/a.glib -o site --size 64x64 --rubric class.toml --serve");
    const Finished done =
        shell(folder.path(), "timeout 60 python3 browser.py '" GLIBRA_BINARY_DIR "/glibra' " + command);
    ASSERT_EQ(done.status, 0) << done.out << done.err;
    EXPECT_EQ(grades()["bob"]["points"], "4.50000") << "the table of the server";
    EXPECT_TRUE(contains(page(), "well &lt;done&gt;"));
    ASSERT_EQ(run("--rubric class.toml").status, 0);
    EXPECT_EQ(grades()["bob"]["points"], "4.50000");
    EXPECT_EQ(grades()["ana"]["comment"], "well <done>");
    EXPECT_FALSE(contains(page(), "grade.js"));
}

TEST_F(ClassInput, AnonymousPagesShowNoNames) {
    writeScene("all/ana-lee/", kReference);
    writeScene("all/bob-ray/", "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(nothing); }\n");
    folder.write("all/cem-oz/readme.txt", "");
    const Finished done = run("--anonymous");
    ASSERT_EQ(done.status, 0) << done.err;
    for (const char* each : {"ana-lee", "bob-ray", "cem-oz"}) {
        EXPECT_FALSE(contains(page(), each)) << each;
        EXPECT_TRUE(contains(readFile(folder / "site/names.csv"), each));
        EXPECT_TRUE(contains(readFile(folder / "site/grades.csv"), each));
    }
    for (const char* each : {"Submission 01", "Submission 02", "Submission 03"})
        EXPECT_TRUE(contains(page(), each));
}

TEST_F(ClassInput, TheSceneOfAStudentIsOfSomebodyWhoHandedSomethingIn) {
    for (const char* name : {"one", "two"}) {
        writeScene("all/leeana/", kReference);
        fs::rename(folder / "all/leeana/a.glib", folder / "all/leeana" / (std::string(name) + ".glib"));
    }
    writeScene("all/bob/", kReference);
    folder.write("class.csv", "name,number\nAna Lee,7\nBob,8\nZoe,9\n");
    const Finished wrong = run("--scene-of 'bbo=a.glib'");
    EXPECT_EQ(wrong.status, 2);
    EXPECT_TRUE(contains(wrong.err, "--scene-of 'bbo=a.glib': nobody is called 'bbo'; did you mean 'bob'?"))
        << wrong.err;
    EXPECT_EQ(run("--scene-of 'Nobody=x.glib' --roster class.csv").status, 2);
    EXPECT_FALSE(fs::exists(folder / "site/index.html"));
    EXPECT_EQ(run("--scene-of 'Zoe=x.glib' --scene-of 'Ana Lee=two.glib' --roster class.csv").status, 0);
    EXPECT_EQ(grades()["Ana Lee"]["scene"], "two.glib") << "as the roster calls leeana";
    // The column of the roster does the same, by whatever it knows the student, and the command line comes
    // first.
    for (const char* roster :
         {"name,scene\nleeana,one.glib\n", "name,number,scene\n\"Lee, Ana\",7,one.glib\n",
          "name,number,scene\nLee Ana,,one.*\n", "number,scene\nleeana,one.glib\n"}) {
        folder.write("class.csv", roster);
        ASSERT_EQ(run("--roster class.csv").status, 0) << roster;
        const std::string table = readFile(folder / "site/grades.csv");
        EXPECT_TRUE(contains(table, ",one.glib,")) << roster;
        EXPECT_FALSE(contains(table, ",two.glib,")) << roster;
        ASSERT_EQ(run("--roster class.csv --scene-of 'leeana=two.glib'").status, 0) << roster;
        EXPECT_TRUE(contains(readFile(folder / "site/grades.csv"), ",two.glib,")) << roster;
    }
}

TEST_F(ClassInput, WrongNamesAndRubricsAreMistakesOfTheCommandLine) {
    writeScene("all/ana/", kReference);
    folder.write("bad.toml", "[[check]]\ndrawn = true\nuses = \"mix\"\n");
    folder.write("sweepless.toml", "[[check]]\nreacts = \"uAd\"\n");
    folder.write("bad.csv", "colour\nred\n");
    for (const char* each : {"--names moodel", "--scene-of ana", "--roster bad.csv", "--roster missing.csv",
                             "--rubric bad.toml", "--rubric sweepless.toml", "--rubric missing.toml"})
        EXPECT_EQ(run(each).status, 2) << each;
    EXPECT_FALSE(fs::exists(folder / "site/index.html"));
}

}  // namespace
}  // namespace glibra::test
