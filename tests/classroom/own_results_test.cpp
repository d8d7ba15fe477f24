// What platforms read of a submission's checks, against the descriptions that the platforms publish.

#include "classroom/grades.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace glibra::classroom {
namespace {

using nlohmann::json;

constexpr const char* kRubric = R"([[check]]
drawn = true
points = 3
[[check]]
name = "looks like it"
like = 0.8
points = 4
[[check]]
uses = "smoothstep"
bonus = true
[[check]]
name = "report"
by-hand = true
points = 5
[late]
due = "2026-11-20 23:59"
)";

Classroom classOfOne(double likenessOf) {
    Classroom room;
    room.reference.submission.scene = "solution.glib";
    room.moments.resize(2);
    room.moments[1].label = "uAd=0.3";
    room.seconds = 1.5;
    Entry& entry = room.entries.emplace_back();
    entry.submission = {"ana", "ana", "ana/a.glib", {}};
    entry.pictures.resize(2);
    for (Picture& each : entry.pictures) {
        each.verdict = suite::Verdict::passed;
        each.score = Score{0, 0, 1};
    }
    entry.pictures[1].score->likeness = likenessOf;
    entry.programs = {{"P", {"fragment"}, {}}};
    entry.calls = {"smoothstep"};
    entry.diagnostics.push_back(diagnose("glib-W23", "no \xff uniform", {"a.frag", 3, 1}));
    return room;
}

/// The rubric with the marks given.
Rubric judged(Classroom& room, const char* text = kRubric) {
    Result<Rubric> rubric = readRubricText(text, "class.toml");
    giveMarks(*rubric, room, {}, room.entries[0]);
    return std::move(*rubric);
}

/// Gradescope's "Autograder Specifications", output format: the keys of the file and of a test, with the
/// types that they have; visibilities and formats are words of a list.
void expectGradescope(const json& result) {
    using Type = json::value_t;
    const std::map<std::string, std::set<Type>> whole{
        {"score", {Type::number_float, Type::number_unsigned}},
        {"execution_time", {Type::number_float, Type::number_unsigned}},
        {"output", {Type::string}},
        {"output_format", {Type::string}},
        {"visibility", {Type::string}},
        {"stdout_visibility", {Type::string}},
        {"tests", {Type::array}}};
    const std::map<std::string, std::set<Type>> test{
        {"score", {Type::number_float, Type::number_unsigned}},
        {"max_score", {Type::number_float, Type::number_unsigned}},
        {"status", {Type::string}},
        {"name", {Type::string}},
        {"number", {Type::string}},
        {"output", {Type::string}},
        {"output_format", {Type::string}},
        {"visibility", {Type::string}}};
    const auto expectKeys = [](const json& object, const auto& keys) {
        for (const auto& [key, value] : object.items()) {
            ASSERT_TRUE(keys.contains(key)) << key;
            EXPECT_TRUE(keys.at(key).contains(value.type())) << key << ": " << value;
        }
        const std::set<std::string> visibilities{"hidden", "after_due_date", "after_published", "visible"};
        EXPECT_TRUE(visibilities.contains(object.at("visibility").get<std::string>()));
        const std::set<std::string> formats{"text", "html", "simple_format", "md", "ansi"};
        EXPECT_TRUE(formats.contains(object.at("output_format").get<std::string>()));
    };
    expectKeys(result, whole);
    for (const json& each : result.at("tests")) {
        expectKeys(each, test);
        EXPECT_TRUE(each.at("status") == "passed" || each.at("status") == "failed");
    }
}

TEST(OwnResults, AreWhatGradescopeReads) {
    Classroom room = classOfOne(.6);
    const Rubric rubric = judged(room);
    const json result = json::parse(resultText(ResultFormat::gradescope, rubric, room));
    expectGradescope(result);
    ASSERT_EQ(result.at("tests").size(), 3U) << "a person gives the points of the report";
    double sum = 0, most = 0;
    for (const json& each : result.at("tests")) {
        sum += each.at("score").get<double>();
        most += each.at("max_score").get<double>();
    }
    EXPECT_DOUBLE_EQ(sum, 3 + 3 + 1);
    EXPECT_DOUBLE_EQ(result.at("score").get<double>(), sum);
    EXPECT_DOUBLE_EQ(most, 7) << "a bonus raises the score alone";
    EXPECT_EQ(result.at("tests")[1].at("status"), "failed");
    EXPECT_NE(result.at("tests")[1].at("output").get<std::string>().find("at uAd=0.3"), std::string::npos);
    EXPECT_NE(result.at("output").get<std::string>().find("report"), std::string::npos);
    EXPECT_NE(result.at("output").get<std::string>().find("glib-W23"), std::string::npos);
}

TEST(OwnResults, AreNotFullWithoutTheSmallestPoint) {
    Classroom room = classOfOne(0);
    judged(room, "[[check]]\nuses = \"texture\"\npoints = 0.004\n");
    EXPECT_FALSE(reachesAll(room));
    judged(room, "[[check]]\nuses = \"smoothstep\"\npoints = 0.004\n");
    EXPECT_TRUE(reachesAll(room));
}

TEST(OwnResults, AreWhatASubmittyValidatorWrites) {
    Classroom room = classOfOne(.6);
    const Rubric rubric = judged(room);
    const json result = json::parse(resultText(ResultFormat::submitty, rubric, room));
    // "Python Custom Validator Output": an object of success has a score from 0 to 1 and messages.
    EXPECT_EQ(result.size(), 2U);
    EXPECT_EQ(result.at("status"), "success");
    EXPECT_DOUBLE_EQ(result.at("data").at("score").get<double>(), 1) << "the bonus makes up, and no more";
    const std::set<std::string> kinds{"information", "failure", "warning", "success"};
    ASSERT_EQ(result.at("data").at("message").size(), 4U);
    for (const json& each : result.at("data").at("message")) {
        EXPECT_EQ(each.size(), 2U);
        EXPECT_TRUE(each.at("message").is_string());
        EXPECT_TRUE(kinds.contains(each.at("status").get<std::string>()));
    }
    EXPECT_EQ(result.at("data").at("message")[1].at("status"), "warning");
    Classroom worse = classOfOne(0);
    worse.entries[0].calls.clear();
    const Rubric same = judged(worse);
    EXPECT_NEAR(
        json::parse(resultText(ResultFormat::submitty, same, worse)).at("data").at("score").get<double>(),
        5. / 7, 1e-9);
    Classroom onlyByHand = classOfOne(1);
    const Rubric byHand = judged(onlyByHand, "[[check]]\nname = \"report\"\nby-hand = true\n");
    EXPECT_EQ(json::parse(resultText(ResultFormat::submitty, byHand, onlyByHand)).at("data").at("score"), 1);
}

TEST(OwnResults, AreWhatTheReporterOfGithubClassroomReads) {
    Classroom room = classOfOne(.6);
    const Rubric rubric = judged(room);
    const json result = json::parse(resultText(ResultFormat::github, rubric, room));
    // What autograding-grading-reporter uses: status, max_score, and name, status, score and message of
    // tests.
    EXPECT_EQ(result.at("version"), 1);
    EXPECT_EQ(result.at("status"), "fail");
    EXPECT_EQ(result.at("max_score"), 7);
    double sum = 0;
    for (const json& each : result.at("tests")) {
        EXPECT_TRUE(each.at("status") == "pass" || each.at("status") == "fail");
        EXPECT_TRUE(each.at("name").is_string() && each.at("message").is_string());
        sum += each.at("score").get<double>();
    }
    EXPECT_DOUBLE_EQ(sum, 7);
    Classroom right = classOfOne(.9);
    right.entries[0].calls.clear();
    const Rubric same = judged(right);
    EXPECT_TRUE(reachesAll(right)) << "a bonus need not be reached";
    EXPECT_EQ(json::parse(resultText(ResultFormat::github, same, right)).at("status"), "pass");
}

TEST(OwnResults, EveryCheckThatIsNotReachedSaysWhatToDo) {
    Classroom room = classOfOne(.6);
    room.entries[0].pictures[0].verdict = suite::Verdict::failed;
    room.sliders = {{"uAd", {{0, 1}}}};
    room.entries[0].reactions = {Change{.1, .1}};
    room.entries[0].diagnostics.front().id = "glib-W23";
    const Rubric rubric = judged(room, R"(
[[check]]
drawn = true
[[check]]
slider = "uTol"
range = [0.25, 1]
[[check]]
slider = "uAd"
[[check]]
stage = "geometry"
[[check]]
ignores = "uAd"
[[check]]
like = 0.8
[[check]]
name = "flip"
like = 0.1
measure = "flip"
at = ["nothing"]
[[check]]
without = ["glib-W*"]
[[check]]
uses = "dFdx"
[[check]]
avoids = "smoothstep"
)");
    const std::vector<std::string> lines = resultLines(rubric, room);
    ASSERT_EQ(lines.size(), rubric.checks.size() + 2);
    for (std::size_t i = 0; i < rubric.checks.size(); ++i) {
        const std::string advice = adviceOf(rubric.checks[i]);
        EXPECT_FALSE(advice.empty()) << i;
        EXPECT_TRUE(lines[i].ends_with(advice)) << lines[i];
    }
    EXPECT_NE(lines[1].find("uTol <0.25 VALUE 1>"), std::string::npos) << lines[1];
}

}  // namespace
}  // namespace glibra::classroom
