// The names that learning platforms give to what was handed in, and rosters.

#include "classroom/names.h"

#include <gtest/gtest.h>

#include "../suite/folder.h"
#include "classroom/roster.h"
#include "classroom/rubric.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;

Person split(const std::string& rule, const std::string& name) {
    const Result<NameRule> made = NameRule::of(rule);
    if (!made) return {"no rule", {}};
    return made->split(name).value_or(Person{"no match", {}});
}

TEST(NameRules, SplitTheNamesOfMoodle) {
    const Person folder = split("moodle", "Ana-Maria Lee_1234567_assignsubmission_file_");
    EXPECT_EQ(folder.name, "Ana-Maria Lee");
    EXPECT_EQ(folder.number, "1234567");
    EXPECT_EQ(folder.file, "");
    EXPECT_EQ(split("moodle", "Ana_Lee_12_assignsubmission_file").name, "Ana_Lee");
    const Person file = split("moodle", "Bob_12_assignsubmission_file_my_scene.glib");
    EXPECT_EQ(file.name, "Bob");
    EXPECT_EQ(file.file, "my_scene.glib");
    EXPECT_EQ(split("moodle", "handout").name, "no match");
}

TEST(NameRules, SplitTheNamesOfCanvas) {
    const Person early = split("canvas", "leeana_123_45678_my_scene-1.glib");
    EXPECT_EQ(early.name, "leeana");
    EXPECT_EQ(early.number, "123");
    EXPECT_EQ(early.file, "my_scene-1.glib");
    EXPECT_FALSE(early.isLate);
    EXPECT_TRUE(split("canvas", "leeana_LATE_123_45678_a.zip").isLate);
    EXPECT_EQ(split("canvas", "leeana_LATE_123_45678_a.zip").number, "123");
    EXPECT_EQ(split("canvas", "my_team_123_45678_a.zip").name, "my_team");
    EXPECT_EQ(split("canvas", "readme.txt").name, "no match");
    EXPECT_EQ(split("canvas", "123_45678_a.glib").name, "no match");
    // lib/content_zipper.rb of Canvas: names are left out where grading is anonymous.
    const Person hidden = split("canvas", "LATE_anon_a1B2c_45678_a.glib");
    EXPECT_EQ(hidden.name, "anon_a1B2c");
    EXPECT_EQ(hidden.number, "anon_a1B2c");
    EXPECT_TRUE(hidden.isLate);
    EXPECT_EQ(split("canvas", "anon_a1B2c_45678_my_scene.glib").file, "my_scene.glib");
    EXPECT_FALSE(split("canvas", "anon_a1B2c_45678_my_scene.glib").isLate);
}

TEST(NameRules, SplitTheNamesOfGradescope) {
    EXPECT_EQ(split("gradescope", "submission_77").name, "submission_77");
    EXPECT_EQ(split("gradescope", "submission_77").number, "") << "that of the submission is no student's";
    const suite::Folder made;
    suite::writeText(made / "submission_metadata.yml",
                     "---\nsubmission_77:\n  :submitters:\n  - :name: Ana Lee\n    :sid: '0042'\n"
                     "    :email: ana@example.org\n  - :name: Bob Ray\n    :sid: '0043'\n"
                     "  :created_at: 2026-11-20 17:34:00.861687000 Z\n  :score: 1.0\n  :results:\n"
                     "    output: |-\n      :name: Somebody else\n  :history:\n  - :created_at: 2026-11-01 "
                     "08:00:00 Z\n    :submitters:\n    - :name: Ana Lee\n"
                     "submission_78:\n  :submitters:\n  - :name: \"Cem \xC3\x96z\"\n    :sid:\n");
    NameRule rule = *NameRule::of("gradescope");
    rule.readBeside(made.path());
    EXPECT_EQ(rule.split("submission_77")->name, "Ana Lee, Bob Ray");
    EXPECT_EQ(rule.split("submission_77")->number, "0042");
    EXPECT_EQ(rule.split("submission_77")->email, "ana@example.org");
    EXPECT_EQ(rule.split("submission_77")->time, "2026-11-20 17:34:00.861687000 Z");
    const std::vector<Member> group = rule.split("submission_77")->members;
    ASSERT_EQ(group.size(), 2U);
    EXPECT_EQ(group[1].name + " " + group[1].number + group[1].email, "Bob Ray 0043");
    EXPECT_TRUE(rule.split("submission_78")->members.empty()) << "one student is no group";
    EXPECT_EQ(rule.split("submission_78")->name, "Cem \xC3\x96z");
    EXPECT_EQ(rule.split("submission_78")->number, "");
}

TEST(NameRules, AnExpressionHasGroups) {
    EXPECT_EQ(split("(.*)-([0-9]+)", "ana-7").name, "ana");
    EXPECT_EQ(split("(.*)-([0-9]+)", "ana-7").number, "7");
    EXPECT_EQ(split("w\\d\\d (.*)", "w07 ana").name, "ana");
    EXPECT_FALSE(NameRule::of("moodel"));
    EXPECT_FALSE(NameRule::of("(.*"));
    EXPECT_EQ(split("(.*)", std::string(100'000, 'a')).name, "no match");
}

TEST(Rosters, AreReadByTheNamesOfTheirColumns) {
    const suite::Folder made;
    suite::writeText(made / "a.csv",
                     "\xEF\xBB\xBFSurname;First name;ID number;Email address\r\n"
                     "Lee;Ana;007;ana@example.org\r\n\"O\"\"Neil; jr\";Bob;8;\r\n\r\n");
    const Result<Roster> roster = readRoster(made / "a.csv");
    ASSERT_TRUE(roster);
    ASSERT_EQ(roster->students.size(), 2U);
    EXPECT_EQ(roster->students[0].name, "Ana Lee");
    EXPECT_EQ(roster->students[0].number, "007");
    EXPECT_EQ(roster->students[1].name, "Bob O\"Neil; jr");
    suite::writeText(made / "b.csv", "colour,size\nred,1\n");
    EXPECT_FALSE(readRoster(made / "b.csv"));
    EXPECT_FALSE(readRoster(made / "missing.csv"));
}

TEST(Rosters, KnowWhenSomethingWasHandedIn) {
    const suite::Folder made;
    // mod/assign/gradingtable.php of Moodle, Gradescope's export of scores, and a teacher's own table.
    suite::writeText(
        made / "moodle.csv",
        "Identifier,\"Full name\",\"Email address\",Status,Grade,\"Last modified (submission)\",\"Last "
        "modified (grade)\",\"Feedback comments\"\n"
        "\"Participant 7\",\"Ana Lee\",ana@x.org,\"Submitted for grading - 1 day 3 hours "
        "late\",,\"Sunday, 22 November 2026, 2:59 AM\",-,\n"
        "\"Participant 8\",Bob,,\"No submission\",,-,-,\n");
    suite::writeText(
        made / "gradescope.csv",
        "First Name,Last Name,SID,Email,Total Score,Max Points,Status,Submission ID,Submission "
        "Time,Lateness (H:M:S),View Count\n"
        "Ana,Lee,7,a@x,,10,Ungraded,1,2026-11-22 02:59:00 -0800,27:00:00,0\nBob,Ray,8,,,10,Missing,,,,\n");
    suite::writeText(made / "own.csv",
                     "name;submitted;days late\nAna;20.11.2026 23:59;\nBob;;2\nCem;yesterday;\n");
    const Roster moodle = *readRoster(made / "moodle.csv");
    ASSERT_EQ(moodle.students.size(), 2U);
    EXPECT_EQ(moodle.students[0].time, "Sunday, 22 November 2026, 2:59 AM");
    EXPECT_EQ(moodle.students[0].status, "Submitted for grading - 1 day 3 hours late");
    EXPECT_EQ(moodle.students[1].time, std::nullopt);
    const Roster gradescope = *readRoster(made / "gradescope.csv");
    EXPECT_EQ(gradescope.students[0].time, "2026-11-22 02:59:00 -0800");
    EXPECT_EQ(gradescope.students[0].daysLate, 2);
    EXPECT_EQ(gradescope.students[1].daysLate, std::nullopt);
    const Result<Roster> own = readRoster(made / "own.csv");
    EXPECT_EQ(own->students[0].time, "20.11.2026 23:59");
    EXPECT_EQ(own->students[1].daysLate, 2);
    EXPECT_EQ(own->students[2].time, std::nullopt);
    ASSERT_EQ(own.diagnostics.size(), 1U) << "a time that cannot be read is named";
    EXPECT_EQ(own.diagnostics[0].severity, Severity::warning);
    EXPECT_EQ(own.diagnostics[0].place.line, 4);
}

TEST(Rosters, NameWhatTheyCannotRead) {
    const suite::Folder made;
    suite::writeText(made / "a.csv",
                     "name;submitted;days late;lateness (h:m:s)\nAna;;1,5;\nBob;soon;two;\nCem;later;-;\n"
                     "Dee;-;-1;\nEve;;;long\nFay;;0;\n");
    const Result<Roster> roster = readRoster(made / "a.csv");
    ASSERT_TRUE(roster);
    EXPECT_EQ(roster->students[0].daysLate, 1.5) << "as a spreadsheet in German writes it";
    EXPECT_EQ(roster->students[5].daysLate, 0);
    std::string named;
    for (const Diagnostic& each : roster.diagnostics) {
        EXPECT_EQ(each.severity, Severity::warning);
        named += std::to_string(each.place.line) + each.text.substr(0, each.text.find(" in the")) + "\n";
    }
    EXPECT_EQ(named,
              "3cannot read 'two'\n3cannot read 'soon'\n4cannot read 'later'\n5cannot read '-1'\n"
              "6cannot read 'long'\n");
    std::string many = "name,days late\n";
    for (int i = 0; i < 1'000; ++i) many += std::to_string(i) + ",many\n";
    suite::writeText(made / "b.csv", many);
    EXPECT_EQ(readRoster(made / "b.csv").diagnostics.size(), 20U);
}

TEST(Rosters, AreLatin1IfTheyAreNotUtf8) {
    const suite::Folder made;
    suite::writeText(made / "a.csv", "name;days late\nJ\xF6rg M\xFCller;2\n");
    const Result<Roster> roster = readRoster(made / "a.csv");
    ASSERT_TRUE(roster);
    EXPECT_EQ(roster->students[0].name, "J\xC3\xB6rg M\xC3\xBCller");
    EXPECT_EQ(studentOf(*roster, {"M\xC3\xBCller J\xC3\xB6rg", "", ""}), std::optional<std::size_t>(0));
    ASSERT_EQ(roster.diagnostics.size(), 1U);
    EXPECT_EQ(roster.diagnostics[0].severity, Severity::note);
}

TEST(Rosters, KnowTheirStudents) {
    const Roster roster{{},
                        {{"Ana Lee", "7", "", "", {}, {}, 1},
                         {"Lee, Bob", "8", "", "", {}, {}, 2},
                         {"Cem \xC3\x96z", "9", "cem@x.org", "", {}, {}, 3},
                         {"Dora Ray", "10", "", "", {}, {}, 4},
                         {"Ray Dora", "11", "", "", {}, {}, 5}}};
    const auto student = [&](const std::string& name, const std::string& number = {},
                             const std::string& email = {}) {
        const auto found = studentOf(roster, Member{name, number, email});
        return found ? static_cast<int>(*found) : -1;
    };
    EXPECT_EQ(student("somebody", "7"), 0);
    EXPECT_EQ(student("leebob"), 1);
    EXPECT_EQ(student("\xC3\x96z Cem"), 2);
    EXPECT_EQ(student("x", "", "CEM@x.org"), 2);
    EXPECT_EQ(student("9"), 2) << "a folder named by the number";
    EXPECT_EQ(student("Dora Ray"), -1) << "two have these letters";
    EXPECT_EQ(student("nobody"), -1);
}

TEST(Rosters, GiveNamesAndShowWhoIsAbsent) {
    const Roster roster{{}, {{"Ana Lee", "7", "a@x", "", {}, {}, 1}, {"Bob Ray", "8", "", "", {}, {}, 2}}};
    Submissions all;
    all.all = {{"leeana", {}, {}, {}}, {"zoe", {}, {}, {}}};
    const auto handed = applyRoster(roster, all);
    EXPECT_EQ(all.all[0].name, "Ana Lee");
    EXPECT_EQ(all.all[0].number, "7");
    EXPECT_EQ(all.all[0].email, "a@x");
    EXPECT_EQ(handed[0], std::optional<std::size_t>(0));
    EXPECT_FALSE(handed[1]);
}

TEST(Rosters, KeepStudentsOfOneNameApart) {
    const Roster roster{{},
                        {{"Muster, Max", "1", "", "", {}, {}, 1},
                         {"Muster, Max", "2", "", "", {}, {}, 2},
                         {"Ana Lee", "", "", "", {}, {}, 3},
                         {"b", "4", "", "", {}, {}, 4}}};
    Submissions all;
    all.all = {{"Max Muster (1)", {}, {}, {}},
               {"Max Muster (2)", {}, {}, {}},
               {"ana lee", {}, {}, {}},
               {"ana lee.glib", {}, {}, {}},
               {"4", {}, {}, {}},
               {"b", {}, {}, {}}};
    all.all[0].number = "1";
    all.all[1].number = "2";
    all.all[3].members = {{"Lee Ana", "", ""}};
    const auto handed = applyRoster(roster, all);
    std::vector<std::string> names;
    for (const Submission& each : all.all) names.push_back(each.name);
    EXPECT_EQ(names, (std::vector<std::string>{"Ana Lee", "Muster, Max (1)", "Muster, Max (2)",
                                               "ana lee.glib", "b", "b (2)"}));
    EXPECT_EQ(handed[0], std::optional<std::size_t>(1));
    EXPECT_EQ(handed[1], std::optional<std::size_t>(2));
}

TEST(Rosters, FindTheSubmissionThatATeacherMeans) {
    const Roster roster{{}, {{"Ana Lee", "7", "a@x", "", {}, {}, 1}, {"Cy Two", "9", "", "", {}, {}, 2}}};
    Submissions all;
    all.all = {{"leeana", {}, {}, {}}, {"Bob Ng (8)", {}, {}, {}}};
    all.all[1].number = "8";
    all.all[1].key = "submission_102";
    all.all[1].members = {{"Bob Ng", "8", ""}, {"Cy Two", "9", ""}};
    const auto index = [&](const std::string& student, const Roster* list) {
        const auto found = submissionOf(all, list, student);
        return found ? static_cast<int>(*found) : -1;
    };
    for (const char* each : {"Bob Ng (8)", "Bob Ng", "8", "submission_102", "Cy Two", "9"})
        EXPECT_EQ(index(each, nullptr), 1) << each;
    EXPECT_EQ(index("Ana Lee", nullptr), -1);
    for (const char* each : {"Ana Lee", "7", "a@x", "leeana"}) EXPECT_EQ(index(each, &roster), 0) << each;
    EXPECT_EQ(index("Nobody", &roster), -1);
}

TEST(Rosters, KnowEveryMemberOfAGroup) {
    const Roster roster{{},
                        {{"Bob Ng", "778", "bob@x", "", {}, {}, 1},
                         {"Two, Cy", "779", "cy@x", "", {}, {}, 2},
                         {"Dee Oh", "780", "", "", {}, {}, 3}}};
    Submissions all;
    Submission& group = all.all.emplace_back();
    group.name = "Bob Ng, Cy Two";
    group.number = "778";
    group.members = {{"Bob Ng", "778", ""}, {"Cy Two", "", ""}};
    const auto handed = applyRoster(roster, all);
    EXPECT_EQ(handed[0], std::optional<std::size_t>(0));
    EXPECT_EQ(handed[1], std::optional<std::size_t>(0)) << "the second member has handed it in, too";
    EXPECT_FALSE(handed[2]);
    EXPECT_EQ(all.all[0].name, "Bob Ng, Two, Cy") << "both names are on the page";
    EXPECT_EQ(joined(all.all[0].members, &Member::number), "778, 779");
    EXPECT_EQ(joined(all.all[0].members, &Member::email), "bob@x, cy@x");
}

TEST(NameRules, EndWhateverTheExpressionAndTheName) {
    const std::string letters(40, 'a');
    for (const char* rule : {"(a+)+b", "(.*)*x", "(a|a)*b", "(a|aa)+$b"}) {
        const Result<NameRule> made = NameRule::of(rule);
        ASSERT_TRUE(made) << rule;
        EXPECT_FALSE(made->split(letters)) << rule;
    }
    EXPECT_EQ(NameRule::of("(.*)_([0-9]+)")->split(std::string(200, 'a') + "_7")->number, "7");
}

TEST(RostersAndRubrics, AreOrdinaryFiles) {
    EXPECT_FALSE(readRoster("/dev/zero"));
    EXPECT_FALSE(givenText("/dev/zero", 1U << 20U));
    EXPECT_FALSE(readRoster("/tmp"));
    EXPECT_FALSE(givenText("no such file", 1U << 20U));
}

}  // namespace
}  // namespace glibra::classroom
