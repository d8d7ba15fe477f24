// Fifty submissions of one assignment, made by changes of one scene, as a learning platform exports them:
// their order, verdicts, similar code and tables.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "../classroom/strict_csv.h"
#include "program.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;
using Row = std::map<std::string, std::string>;

constexpr const char* kDotsVertex =
    "#version 330 core\nout vec3 vN; out vec2 vST;\nvoid main() {\n    vN = uNormalMatrix * aNormal;\n"
    "    vST = aTexCoord0.st;\n    gl_Position = uModelViewProjectionMatrix * aVertex;\n}\n";

/// The shader that a third of the class has from the lecture. `own` are functions before main.
std::string dotsShader(const std::string& ground, const std::string& spot, const std::string& size = "uAd",
                       const std::string& pattern = "1. - smoothstep(1. - uTol, 1. + uTol, e)",
                       const std::string& own = {}) {
    return fmt::format(
        "#version 330 core\nin vec3 vN; in vec2 vST;\nuniform float uAd, uTol;\nout vec4 f;\n{}"
        "void main() {{\n    float d = {};\n    vec2 at = (floor(vST / d) + .5) * d;\n"
        "    float e = length((vST - at) / (d / 2.)) * 1.25;\n    float t = {};\n"
        "    float shade = .3 + .7 * abs(normalize(vN).z);\n"
        "    f = vec4(shade * mix(vec3({}), vec3({}), t), 1.);\n}}\n",
        own, size, pattern, ground, spot);
}

std::string withChange(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (at != std::string::npos) text.replace(at, from.size(), to);
    return text;
}

std::string dotsScene(const std::string& model = "Sphere 1 60 60", const std::string& eye = "0 0 2.6") {
    return fmt::format(
        "Perspective 70\nLookAt {} 0 0 0 0 1 0\nVertex dots.vert\nFragment dots.frag\n"
        "Program Dots uAd <.01 .12 .5> uTol <0. .05 1.>\n{}\n",
        eye, model);
}

class FiftySubmissions : public testing::Test {
  protected:
    void SetUp() override {
        put("solution/", dotsShader("1.,.5,0.", "1.,1.,1."));
        folder.write(
            "class.toml",
            "[[check]]\nname = \"dots\"\nlike = 0.8\npoints = 6\n[[check]]\nreacts = \"uAd\"\npoints = 2\n"
            "[[check]]\nslider = \"uTol\"\nrange = [0, 1]\npoints = 2\n[late]\ndue = \"2026-11-20 23:59\"\n");
    }
    void put(const std::string& where, const std::string& shader, const std::string& scene = dotsScene(),
             const std::string& name = "dots") const {
        folder.write(where + "dots.vert", kDotsVertex);
        folder.write(where + "dots.frag", shader);
        folder.write(where + name + ".glib", scene);
    }
    /// The folder of the next student in Moodle's export; the kind is the student's first name.
    std::string next(const std::string& kind) {
        const int number = 1000 + static_cast<int>(count_++);
        const std::string name = fmt::format("{} {:02}", kind, count_);
        roster_ += fmt::format(
            "Participant {},{},s{}@x.org,Submitted for grading,,\"Friday, 20 November 2026, 6:{:02} "
            "PM\",-,\n",
            number, name, number, count_ % 60);
        numbers_[name] = std::to_string(number);
        return fmt::format("export/{}_{}_assignsubmission_file_/", name, number);
    }
    void zip(const std::string& name, const std::string& what) const {
        ASSERT_EQ(shell(folder.path(), "python3 -m zipfile -c " + name + " " + what).status, 0);
    }
    /// The table of the run by submission.
    [[nodiscard]] std::map<std::string, Row> grades() const {
        std::string text = readFile(folder / "site/grades.csv");
        if (text.starts_with("\xEF\xBB\xBF")) text = text.substr(3);
        std::map<std::string, Row> rows;
        for (Row& row : classroom::strictly(text)) rows[row.at("submission")] = row;
        return rows;
    }
    void makeGood();
    void makeWrong();
    void makeCopies();
    void makeOddFiles();

    Folder folder;
    std::size_t count_ = 0;
    std::string roster_ =
        "Identifier,Full name,Email address,Status,Grade,Last modified (submission),Last modified "
        "(grade),Feedback "
        "comments\n";
    std::map<std::string, std::string> numbers_;
};

/// The dots in other colours, on other models, from elsewhere.
void FiftySubmissions::makeGood() {
    for (const char* each : {".1,.2,.7", ".9,.9,.9", ".2,.6,.3", ".5,.1,.5", ".1,.1,.1", ".9,.8,.2"})
        put(next("A colours"), dotsShader(each, each[1] == '9' ? ".6,.1,.1" : "1.,.9,.6"));
    for (const char* each :
         {"Torus 1 .5 40 60", "Sphere .8 60 60", "Cone 1 1.6 60 60", "Cylinder .8 1.6 60 60"})
        put(next("B model"), dotsShader("1.,.5,0.", "1.,1.,1."), dotsScene(each, "0 .4 3.2"));
    for (const char* each : {"1.6 1.2 1.8", "-1.4 .6 2", "0 0 4", "0 2 2.4"})
        put(next("B camera"), dotsShader(".2,.3,.8", "1.,1.,1."), dotsScene("Sphere 1 60 60", each));
    for (const char* each : {"uAd * .5", "uAd * 2.", "uAd * .6"})
        put(next("C size"), dotsShader("1.,.5,0.", "1.,1.,1.", each));
}

void FiftySubmissions::makeWrong() {
    for (const char* each : {"mod(floor(vST.s / d) + floor(vST.t / d), 2.)", "step(.5, fract(vST.s / d))",
                             "step(.5, fract((vST.s + vST.t) / d))", "step(.5, fract(vST.t / d))"})
        put(next("D pattern"), dotsShader("1.,.5,0.", "1.,1.,1.", "uAd", each));
    for (const char* each : {"0.", "1.", "0. * e"})
        put(next("E plain"), dotsShader("1.,.5,0.", "1.,1.,1.", "uAd", each));
    put(next("F nothing"), "#version 330 core\nout vec4 f;\nvoid main() { discard; }\n");
    put(next("F nothing"), dotsShader("1.,.5,0.", "1.,1.,1."), dotsScene("Translate 0 0 30\nSphere 1 60 60"));
    put(next("F nothing"), dotsShader("1.,.5,0.", "1.,1.,1."), dotsScene("Spere 1"));
    put(next("G error"), dotsShader("1.,.5,0.", "wrong"));
    put(next("G error"), dotsShader("1.,.5,0.", "1.,1.,1.", "uAdd"));
    put(next("G error"), dotsShader("1.,.5,0.", "1.,1.,1."), dotsScene("Obj nowhere.obj"));
    // Right, but without sliders.
    put(next("H fixed"), dotsShader("1.,.5,0.", "1.,1.,1.", ".12"));
    put(next("H fixed"), dotsShader("1.,.5,0.", "1.,1.,1.", ".12", "1. - smoothstep(.95, 1.05, e)"));
}

/// One student's own idea, and four that have taken it over.
void FiftySubmissions::makeCopies() {
    const std::string own =
        "float wave(vec2 at, float by) {\n    float sum = 0.;\n    for (int i = 1; i < 5; ++i) {\n"
        "        sum += sin(at.x * float(i) * by) / float(i);\n        at = at.yx + sum * vec2(.3, -.2);\n   "
        " }\n"
        "    return clamp(.5 + sum * .1, 0., 1.);\n}\n";
    const std::string renamed =
        "// My idea.\nfloat ripple(vec2 p, float k) {\n  float s = 0.;\n  for (int n = 1; n < 5; ++n) {\n"
        "    s += sin(p.x * float(n) * k) / float(n);\n    p = p.yx + s * vec2(.4, -.1);\n  }\n"
        "  return clamp(.5 + s * .2, 0., 1.);\n}\n";
    const std::string evaded =
        "float ripple(vec2 p, float k) {\n  float unused = 3. * k;\n  float s = 0.;\n  if (false) { s = 7.; "
        "}\n"
        "  for (int n = 1; n < 5; ++n) {\n    float alsoUnused = s * 2.;\n"
        "    s = s + sin(k * float(n) * p.x) / float(n);\n    p = vec2(.3, -.2) * s + p.yx;\n  }\n"
        "  return clamp(s * .1 + .5, 0., 1.);\n}\n";
    const auto with = [&](const std::string& function, const char* name) {
        return dotsShader("1.,.5,0.", "1.,1.,1.", "uAd",
                          fmt::format("{}(vST, 3.) * (1. - smoothstep(.95, 1.05, e))", name), function);
    };
    put(next("I idea"), with(own, "wave"));
    put(next("I idea"), with(own, "wave"));
    put(next("I idea"), with(renamed, "ripple"));
    put(next("I idea"), with(evaded, "ripple"));
}

void FiftySubmissions::makeOddFiles() {
    std::string where = next("J several");  // the one with the reference's name
    put(where, dotsShader(".3,.3,.8", "1.,1.,1."));
    folder.write(where + "old/try.glib", "Sphere 1\n");
    where = next("J several");  // nothing decides
    put(where, dotsShader(".3,.3,.8", "1.,1.,1."), dotsScene(), "one");
    folder.write(where + "two.glib", dotsScene());
    where = next("J pattern");  // --scene decides
    put(where, dotsShader(".3,.3,.8", "1.,1.,1."), dotsScene(), "final");
    folder.write(where + "draft.glib", "Sphere 1\n");
    put("packed/", dotsShader(".8,.3,.3", "1.,1.,1."));
    where = next("K zip");
    fs::create_directories(folder / where);
    zip("'" + where + "hand-in.zip'", "packed/dots.glib packed/dots.vert packed/dots.frag");
    where = next("K nested");
    zip("inner.zip", "packed/dots.glib");
    fs::create_directories(folder / where);
    zip("'" + where + "outer.zip'", "inner.zip");
    folder.write(next("K damaged") + "hand-in.zip", "PK\x03\x04 this ends too early");
    folder.write(next("L ending") + "dots.glib.txt", dotsScene());
    folder.write(next("L none") + "report.pdf", "%PDF-");
    put(next("L upper"), dotsShader(".3,.3,.8", "1.,1.,1."), dotsScene(), "DOTS.GLIB");
}

TEST_F(FiftySubmissions, AreOrderedComparedAndGradedAsAPersonDoes) {
    makeGood();
    makeWrong();
    makeCopies();
    makeOddFiles();
    while (count_ < 50)
        put(next("A colours"),
            dotsShader(fmt::format("{:.2f},.2,.6", .01 * static_cast<double>(count_)), "1.,1.,.8"));
    ASSERT_EQ(count_, 50U);
    folder.write("roster.csv",
                 withChange(roster_ + "Participant 7,Nobody 99,n@x.org,No submission,3.00,-,-,kept\n",
                            "6:01 PM", "11:59 PM"));
    // Two came late, one of them with an extension.
    std::string roster = readFile(folder / "roster.csv");
    roster = withChange(
        roster, "s1001@x.org,Submitted for grading,,\"Friday, 20 November 2026, 6:02 PM\"",
        "s1001@x.org,Submitted for grading - 1 day 3 hours late,,\"Sunday, 22 November 2026, 3:00 AM\"");
    roster = withChange(
        roster, "s1002@x.org,Submitted for grading,,\"Friday, 20 November 2026, 6:03 PM\"",
        "\"s1002@x.org\",\"Submitted for grading - Extension granted until: Monday, 23 November 2026, 6:00 "
        "PM\",,\"Sunday, 22 November 2026, 3:00 AM\"");
    folder.write("roster.csv", roster);
    ASSERT_EQ(shell(folder / "export", "python3 -m zipfile -c ../CG1-Dots-1234.zip *").status, 0);
    const Finished done =
        glibra(folder.path(),
               "class CG1-Dots-1234.zip --reference solution/dots.glib -o site --size 128x128 --names moodle "
               "--roster roster.csv --rubric class.toml --scene final.glib --sweep 'uAd = [.12, .2]'");
    ASSERT_EQ(done.status, 0) << done.err;
    std::map<std::string, Row> rows = grades();
    ASSERT_EQ(rows.size(), 50U) << done.err;
    std::map<std::string, std::vector<double>> likeness;
    std::map<std::string, std::string> states;
    for (auto& [name, row] : rows) {
        const std::string kind = name.substr(0, name.rfind(' '));
        if (!row["likeness"].empty()) likeness[kind].push_back(std::stod(row["likeness"]));
        states[kind] += row["state"] + " ";
    }
    const auto least = [&](const char* kind) {
        return *std::min_element(likeness[kind].begin(), likeness[kind].end());
    };
    const auto most = [&](const char* kind) {
        return *std::max_element(likeness[kind].begin(), likeness[kind].end());
    };
    std::string figures;
    for (const auto& [name, row] : rows)
        figures += fmt::format("{} {} {}\n", row.at("likeness"), name, row.at("state"));
    // A person's order: other colours, other models and cameras, other sizes, other patterns, no pattern.
    EXPECT_GT(least("A colours"), most("B camera") - .02) << figures;
    EXPECT_GT(least("B camera"), most("C size")) << figures;
    EXPECT_GT(least("B model"), most("D pattern")) << figures;
    EXPECT_GT(least("C size"), most("D pattern")) << figures;
    EXPECT_GT(least("D pattern"), most("E plain") - .02) << figures;
    EXPECT_GT(least("A colours"), .85) << figures;
    EXPECT_LT(most("D pattern"), .5) << figures;
    EXPECT_EQ(states["F nothing"], "nothing nothing nothing ");
    EXPECT_EQ(states["G error"], "failed failed failed ");
    for (const char* each :
         {"A colours", "B model", "B camera", "C size", "D pattern", "E plain", "H fixed", "I idea"})
        for (const char* other : {"failed", "crashed", "timed-out", "nothing", "no-scene"})
            EXPECT_FALSE(contains(states[each], other)) << each << ": " << states[each];
    EXPECT_EQ(states["J several"], "drawn no-scene ");
    EXPECT_EQ(states["J pattern"] + states["K zip"] + states["L upper"], "drawn drawn drawn ");
    EXPECT_EQ(states["K nested"] + states["K damaged"] + states["L ending"] + states["L none"],
              "no-scene no-scene no-scene no-scene ");
    for (const auto& [name, row] : rows) {
        const bool isDrawn = row.at("state") == "drawn";
        EXPECT_NE(row.at("reason").empty(), !isDrawn) << name;
        if (name.starts_with("H ")) {
            EXPECT_EQ(row.at("reacts uAd"), "no") << name;
        }
        if (name.starts_with("A ")) {
            EXPECT_EQ(row.at("reacts uAd"), "yes") << name;
        }
        // The lecture's code marks nobody; the idea and its three copies are found.
        const double share = row.at("similarity").empty() ? 0 : std::stod(row.at("similarity"));
        if (name.starts_with("I ")) {
            EXPECT_GT(share, .8) << name << row.at("most similar");
        } else {
            EXPECT_LT(share, .5) << name << row.at("most similar");
        }
    }
    // Moodle's own table with the grades in it.
    const std::string table = readFile(folder / "site/import-moodle.csv");
    const auto graded = classroom::moodleGrades(table);
    EXPECT_EQ(graded.size(), 51U);
    EXPECT_EQ(graded.at("7"), 3) << "who handed nothing in keeps the grade";
    EXPECT_EQ(graded.at(numbers_["A colours 01"]), 10);
    EXPECT_EQ(graded.at(numbers_["A colours 02"]), 8) << "two days late";
    EXPECT_EQ(graded.at(numbers_["A colours 03"]), 10) << "late with an extension";
    for (const auto& [name, number] : numbers_)
        if (name.starts_with("F ") || name.starts_with("K nested") || name.starts_with("L none")) {
            EXPECT_LE(graded.at(number), 2) << name;
        }
    EXPECT_TRUE(contains(readFile(folder / "site/index.html"), "Nobody 99"));
}

TEST_F(FiftySubmissions, AreGradedAsCanvasAndGradescopeExportThemToo) {
    const std::vector<std::string> colors{".1,.2,.7", ".9,.9,.9", ".2,.6,.3"};
    std::string metadata = "---\n";
    std::string canvas =
        "Student,ID,SIS User ID,SIS Login ID,Section,Dots (991),Current Score\n    Points "
        "Possible,,,,,10,(read only)\n";
    for (std::size_t i = 0; i < colors.size(); ++i) {
        put("one/", dotsShader(colors[i], ".6,.1,.1"));
        for (const char* each : {"dots.glib", "dots.vert", "dots.frag"})
            folder.write(fmt::format("canvas/lastfirst{0}{1}_{2}_{3}_{4}", i, i == 1 ? "_LATE" : "", 70 + i,
                                     900 + i, each),
                         readFile(folder / "one" / each));
        canvas += fmt::format("\"Last{0}, First{0}\",{1},u{1},l{1},01,,\n", i, 70 + i);
        const std::string where = fmt::format("gradescope/assignment_9_export/submission_{}/", 400 + i);
        put(where, dotsShader(colors[i], ".6,.1,.1"));
        metadata += fmt::format(
            "submission_{}:\n  :submitters:\n  - :name: First{} Last\n    :sid: '{}'\n    :email: f{}@x.org\n"
            "  :created_at: 2026-11-{} 12:00:00.5 Z\n",
            400 + i, i, 70 + i, i, i == 1 ? 24 : 20);
    }
    folder.write("gradescope/assignment_9_export/submission_metadata.yml", metadata);
    folder.write("canvas.csv", canvas);
    zip("canvas.zip", "canvas/*");
    zip("gradescope.zip", "gradescope/assignment_9_export");
    const std::string common =
        " --reference solution/dots.glib -o site --size 96x96 --rubric class.toml --sweep 'uAd = [.12, .2]' ";
    const Finished first = glibra(
        folder.path(), "class canvas.zip" + common + "--names canvas --roster canvas.csv --assignment Dots");
    ASSERT_EQ(first.status, 0) << first.err;
    EXPECT_EQ(classroom::canvasGrades(readFile(folder / "site/import-canvas.csv"), "Dots (991)"),
              (std::map<std::string, double>{{"70", 10}, {"71", 9}, {"72", 10}}))
        << readFile(folder / "site/import-canvas.csv");
    const Finished second = glibra(folder.path(), "class gradescope.zip" + common + "--names gradescope");
    ASSERT_EQ(second.status, 0) << second.err;
    EXPECT_EQ(classroom::gradescopeGrades(readFile(folder / "site/import-gradescope.csv")),
              (std::map<std::string, double>{{"70", 10}, {"71", 6}, {"72", 10}}))
        << readFile(folder / "site/import-gradescope.csv");
    EXPECT_EQ(glibra(folder.path(), "class class.toml" + common).status, 2);
    folder.write("broken.zip", "PK\x03\x04 this ends too early");
    const Finished broken = glibra(folder.path(), "class broken.zip" + common);
    EXPECT_EQ(broken.status, 2);
    EXPECT_TRUE(contains(broken.err, "cannot unpack 'broken.zip'")) << broken.err;
}

}  // namespace
}  // namespace glibra::test
