// The page and the table of a class, from values: what strangers wrote stays text.

#include "classroom/class_page.h"

#include <gtest/gtest.h>

#include "../suite/folder.h"
#include "classroom/grades.h"
#include "classroom/moments.h"
#include "classroom/review.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;
using suite::Verdict;

Picture drawn(const std::string& file, const std::optional<Score>& score = std::nullopt) {
    Picture picture;
    picture.verdict = Verdict::passed;
    picture.file = file;
    picture.width = picture.height = 64;
    picture.score = score;
    return picture;
}

Entry entryNamed(const std::string& name) {
    Entry entry;
    entry.submission = {name, "class/" + name, "class/" + name + "/a.glib", {}};
    return entry;
}

/// Two that were drawn, one that ended its process, one without a scene.
Classroom sample() {
    Classroom room;
    room.folder = "class";
    room.moments.resize(2);
    room.moments[0].label = "uTol=0";
    room.moments[1].label = "uTol=0.1";
    room.reference = entryNamed("solution.glib");
    room.reference.pictures = {drawn("pictures/0000-1.png"), drawn("pictures/0000-2.png")};
    room.reference.programs = {{"Dots", {"vertex", "fragment"}, {{"uTol", "float"}, {"uMore", "vec3"}}}};
    room.entries.push_back(entryNamed("<img src=x onerror=alert(1)>"));
    room.entries[0].pictures = {drawn("pictures/0001-1.png", Score{0.25, 0.5, 0.75}),
                                drawn("pictures/0001-2.png", Score{0.75, 0.25, 0.25})};
    room.entries[0].programs = {{"</script>", {"fragment"}, {{"uTol", "float"}}}};
    room.entries[0].diagnostics = {diagnose("glib-W02", "a \"<b>warning</b>\"", {"class/x/a.glib", 2, 1})};
    room.entries.push_back(entryNamed("=HYPERLINK(\"http://x\")"));
    room.entries[1].pictures = {drawn("pictures/0002-1.png", Score{0, 0, 1}), Picture{}};
    room.entries[1].pictures[1].verdict = Verdict::crashed;
    room.entries[1].pictures[1].reason = "the process that drew it ended, by signal 11";
    room.entries.emplace_back().submission = {"cem", "class/cem", {}, "the folder has no scene"};
    room.fingerprints.resize(3);
    return room;
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

TEST(ClassSummary, CountsEveryState) {
    const Classroom room = sample();
    EXPECT_EQ(summary(room), "3 submissions: 1 drawn, 1 crashed, 1 without a scene");
    const Scores scores = scoresOf(room.entries[0]).value();
    EXPECT_DOUBLE_EQ(scores.flip, 0.5);
    EXPECT_DOUBLE_EQ(scores.worstFlip, 0.75);
    EXPECT_DOUBLE_EQ(scores.structure, 0.375);
    EXPECT_DOUBLE_EQ(scores.worstStructure, 0.5);
    EXPECT_FALSE(scoresOf(room.entries[2]));
}

TEST(ClassPage, ShowsEveryoneAndWhatStrangersWroteAsText) {
    const std::string page = classPage(sample());
    EXPECT_FALSE(contains(page, "<img src=x"));
    EXPECT_FALSE(contains(page, "<b>warning"));
    EXPECT_EQ(page.find("</script>"), page.rfind("</script>")) << "the end of its own";
    EXPECT_FALSE(contains(page, "{{"));
    EXPECT_TRUE(contains(page, "&lt;img src=x onerror=alert(1)&gt;"));
    EXPECT_TRUE(contains(page, "Only in the reference: <code>uMore</code>"));
    EXPECT_TRUE(contains(page, "1 of 2 drawn"));
    EXPECT_TRUE(contains(page, "the folder has no scene"));
    EXPECT_TRUE(contains(page, "the process that drew it ended, by signal 11"));
    EXPECT_TRUE(contains(page, "likeness 0.750, FLIP 0.250, structure 0.500"));
    for (int i = 1; i <= 3; ++i) EXPECT_TRUE(contains(page, "id=\"s000" + std::to_string(i) + "\"")) << i;
    EXPECT_EQ(page.find("<script"), page.rfind("<script")) << "only its own";
    EXPECT_TRUE(contains(page, "<script src=\"class.js\" defer></script>"));
}

TEST(ClassPage, EachPictureIsBesideTheReferencesAlsoOfWhatFailed) {
    Classroom room = sample();
    room.moments.resize(6);
    room.reference.pictures.clear();
    Entry& failed = room.entries[1];
    failed.submission.name = "dan";
    failed.pictures.clear();
    for (int i = 1; i <= 6; ++i) {
        room.reference.pictures.push_back(drawn("pictures/0000-" + std::to_string(i) + ".png"));
        failed.pictures.push_back(drawn("pictures/0002-" + std::to_string(i) + ".png"));
        failed.pictures.back().verdict = Verdict::failed;
        failed.pictures.back().isIncomplete = true;
    }
    failed.pictures[5] = Picture{};
    const std::string page = classPage(room);
    const std::size_t card = page.find("id=\"s0002\"");
    const std::string html = page.substr(card, page.find("</article>", card) - card);
    std::size_t pairs = 0;
    for (std::size_t at = html.find("class=\"pair compared\""); at != std::string::npos;
         at = html.find("class=\"pair compared\"", at + 1)) {
        ++pairs;
        const std::size_t reference = html.find("0000-" + std::to_string(pairs) + ".png", at);
        const std::size_t own = html.find("0002-" + std::to_string(pairs) + ".png", at);
        EXPECT_LT(reference, own) << pairs;
        EXPECT_NE(own, std::string::npos) << pairs;
    }
    EXPECT_EQ(pairs, 5U);
    EXPECT_FALSE(contains(html, "0000-6.png")) << "there is no picture to compare with";
    EXPECT_TRUE(contains(html, "no picture"));
}

TEST(ClassPage, ItsFirstPicturesDoNotWaitUntilTheyAreInView) {
    Classroom room = sample();
    for (int i = 0; i < 10; ++i) room.entries.push_back(room.entries[0]);
    room.fingerprints.resize(room.entries.size());
    const std::string page = classPage(room);
    const auto count = [&](std::string_view part, std::size_t begin) {
        int found = 0;
        for (std::size_t at = page.find(part, begin); at != std::string::npos; at = page.find(part, at + 1))
            ++found;
        return found;
    };
    const int pictures = count("<img ", 0);
    EXPECT_EQ(count("loading=\"lazy\"", 0), pictures - 24);
    EXPECT_EQ(count("<img ", page.find("loading=\"lazy\"")), pictures - 25) << "the first ones of the page";
}

TEST(ClassPage, PassagesAreReadFromTheSubmissionsOwnFoldersOnly) {
    const suite::Folder made;
    const fs::path& folder = made.path();
    fs::create_directories(folder / "bob");
    suite::writeText(folder / "ana/a.frag", "one <line>\ntwo\nthree\n");
    suite::writeText(folder / "secret.txt", "the secret\nof the teacher\n");
    fs::create_symlink(folder / "secret.txt", folder / "bob/b.frag");
    Classroom room = sample();
    room.entries.resize(2);
    room.fingerprints.resize(2);
    const auto give = [&](std::size_t entry, const fs::path& own, const fs::path& file) {
        room.entries[entry].submission.folder = own;
        room.entries[entry].files = {{file.string(), {}}};
        for (std::uint32_t i = 0; i < kGram; ++i)
            room.entries[entry].files[0].tokens.push_back({i + 10, i < 8 ? 1 : 2});
        room.fingerprints[entry] = fingerprintsOf(room.entries[entry].files, {});
    };
    give(0, folder / "ana", folder / "ana/a.frag");
    room.pairs = {{0, 1, 5, 0.9, 0.8}};
    for (const fs::path& outside : {folder / "secret.txt", folder / "bob/b.frag", fs::path("/etc/passwd"),
                                    folder / "bob/../secret.txt"}) {
        give(1, folder / "bob", outside);
        const std::string page = classPage(room);
        EXPECT_TRUE(contains(page, "one &lt;line&gt;"));
        EXPECT_TRUE(contains(page, "<li data-line=\"2\" class=\"p0\">two</li>")) << "a line of the passage";
        EXPECT_TRUE(contains(page, "<li data-line=\"3\">three</li>")) << "one that is not in it";
        EXPECT_TRUE(contains(page, "the file cannot be read")) << outside;
        EXPECT_FALSE(contains(page, "secret\n") || contains(page, "the secret") || contains(page, "root:"))
            << outside;
    }
}

TEST(Grades, HaveALinePerSubmissionAndColumnsPerMoment) {
    const std::string table = gradesCsv(sample());
    EXPECT_EQ(
        table,
        "submission,state,reason,scene,pictures,drawn,flip,worst flip,structure,worst "
        "structure,likeness,errors,"
        "warnings,stages,uniforms,most similar,similarity,not compared,flip uTol=0,structure uTol=0,"
        "likeness uTol=0,flip uTol=0.1,structure uTol=0.1,likeness uTol=0.1\r\n"
        "<img src=x "
        "onerror=alert(1)>,drawn,,a.glib,2,2,0.50000,0.75000,0.37500,0.50000,0.50000,0,1,fragment,uTol,,,,"
        "0.25000,0.50000,0.75000,0.75000,0.25000,0.25000\r\n"
        "\"'=HYPERLINK(\"\"http://x\"\")\",crashed,\"the process that drew it ended, by signal "
        "11\",a.glib,2,1,"
        "0.00000,0.00000,0.00000,0.00000,1.00000,0,0,,,,,,0.00000,0.00000,1.00000,,,\r\n"
        "cem,no-scene,the folder has no scene,,2,0,,,,,,0,0,,,,,,,,,,,\r\n");
}

TEST(Grades, AFieldIsNeverAFormulaNorALine) {
    EXPECT_EQ(csvField("ana"), "ana");
    EXPECT_EQ(csvField("a,b"), "\"a,b\"");
    EXPECT_EQ(csvField("a;b"), "\"a;b\"");
    EXPECT_EQ(csvField("say \"hi\""), "\"say \"\"hi\"\"\"");
    EXPECT_EQ(csvField("two\r\nlines\ttab"), "two  lines tab");
    for (const char* each : {"=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "  =1", "\r\n@x",
                             "\xEF\xBC\x9D"
                             "1"})
        EXPECT_NE(csvField(each).find('\''), std::string::npos) << each;
    EXPECT_EQ(csvField("=1+1"), "'=1+1");
    EXPECT_EQ(csvField("a=1"), "a=1");
    EXPECT_EQ(csvField(""), "");
    EXPECT_EQ(csvField("\x1b[31m\xFF"), " [31m\xEF\xBF\xBD");
}

TEST(Reviews, ComeBackAsTheyWereAndDamagedOnesAreNone) {
    Review made;
    made.programs = {{"Dots", {"vertex", "tessellation control"}, {{"uTol", "float"}}}};
    made.files = {{"a.frag", {{4'000'000'000U, 3}, {7, 12}}}};
    made.scores = {Score{0.125, 1, 0.5}, std::nullopt};
    made.showNothing = {false, true};
    made.reactions = {Change{0.25, 0.5, true}, std::nullopt};
    made.scores[0]->effect = 0.75;
    made.readPictures = {{"a.png", "12ab", true}};
    made.digest = "34cd";
    made.small = {"data:image/png;base64,iVBO+/=", "data:image/svg+xml;base64,PHN2Zz4=",
                  "data:image/gif;base64,R0\" onerror=\"x", ""};
    made.files[0].others = {"b.glsl"};
    made.files[0].tokens[1].file = 1;
    made.programs[0].idle = {"vertex"};
    const std::optional<Review> back = parseReview(toText(made));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->programs[0].name, "Dots");
    EXPECT_EQ(back->programs[0].stages, made.programs[0].stages);
    EXPECT_EQ(back->programs[0].uniforms, made.programs[0].uniforms);
    EXPECT_EQ(back->files[0].tokens, made.files[0].tokens);
    EXPECT_EQ(back->scores[0]->flip, 0.125);
    EXPECT_EQ(back->scores[0]->likeness, 0.5);
    EXPECT_FALSE(back->scores[1]);
    EXPECT_EQ(back->showNothing, made.showNothing);
    ASSERT_EQ(back->reactions.size(), 2U);
    EXPECT_EQ(back->reactions[0]->mean, 0.25);
    EXPECT_EQ(back->reactions[0]->strength, 0.5);
    EXPECT_TRUE(back->reactions[0]->isOtherwise);
    EXPECT_FALSE(back->reactions[1]);
    EXPECT_EQ(back->scores[0]->effect, 0.75);
    EXPECT_EQ(back->readPictures.at(0).name, "a.png");
    EXPECT_TRUE(back->readPictures.at(0).isLikeReference);
    EXPECT_EQ(back->digest, "34cd");
    EXPECT_EQ(back->small, (std::vector<std::string>{made.small[0], "", "", ""}))
        << "pictures, and nothing else";
    EXPECT_EQ(back->files[0].others, made.files[0].others);
    EXPECT_EQ(back->programs[0].idle, made.programs[0].idle);
    for (const char* each :
         {"", "{", "[]", "{\"programs\":[],\"files\":[]}", "{\"programs\":1,\"files\":[],\"scores\":[]}",
          "{\"programs\":[],\"files\":[{\"path\":\"a\",\"codes\":[1],\"lines\":[]}],\"scores\":[]}",
          "{\"programs\":[],\"files\":[],\"scores\":[[1]]}"})
        EXPECT_FALSE(parseReview(each)) << each;
}

TEST(Moments, AreEveryValueAtEveryTimeWithTheirNames) {
    suite::Shot picture;
    picture.options.set = {"uKd=1"};
    const std::vector<double> times{0, 2.5};
    const std::vector<std::string> sweeps{"uTol = [0, 0.1]", "uColor = [[1, 0, 0], [0, 1, 0]]"};
    const Result<std::vector<Moment>> moments = momentsOf(picture, times, sweeps);
    ASSERT_TRUE(moments);
    ASSERT_EQ(moments->size(), 8U);
    EXPECT_EQ((*moments)[0].label, "uTol=0, uColor=1,0,0, time=0");
    EXPECT_EQ((*moments)[7].label, "uTol=0.1, uColor=0,1,0, time=2.5");
    EXPECT_EQ((*moments)[7].shot.options.time, 2.5);
    EXPECT_EQ((*moments)[7].shot.options.set,
              (std::vector<std::string>{"uKd=1", "uTol=0.1", "uColor=0,1,0"}));
    const Result<std::vector<Moment>> one = momentsOf(picture, {}, {});
    ASSERT_TRUE(one);
    ASSERT_EQ(one->size(), 1U);
    EXPECT_EQ((*one)[0].label, "");
}

TEST(Moments, MistakesAreThoseOfASuite) {
    const auto idOf = [](const std::string& sweep) {
        const Result<std::vector<Moment>> moments = momentsOf({}, {}, std::vector{sweep});
        return moments || moments.diagnostics.empty() ? std::string("none") : moments.diagnostics[0].id;
    };
    EXPECT_EQ(idOf("uTol = 0.1"), "suite-E03");
    EXPECT_EQ(idOf("uTol = []"), "suite-E04");
    EXPECT_EQ(idOf("uTol = [0,"), "suite-E01");
    std::string many = "uTol = [0";
    for (std::size_t i = 0; i < suite::kMostMoments; ++i) many += ", " + std::to_string(i);
    EXPECT_FALSE(momentsOf({}, {}, std::vector{many + "]"}));
}

}  // namespace
}  // namespace glibra::classroom
