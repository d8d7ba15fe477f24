// The tables that grade books import, read by strict readers of their documented columns.

#include "classroom/grades.h"

#include <gtest/gtest.h>

#include <map>

#include "../suite/folder.h"
#include "strict_csv.h"

namespace glibra::classroom {
namespace {

Classroom markedClass() {
    Classroom room;
    const auto add = [&](const std::string& name, const std::string& number, double points) {
        Entry& entry = room.entries.emplace_back();
        entry.submission = {name, {}, "a.glib", {}};
        entry.submission.number = number;
        entry.marks = {{"dots, \"round\"", points, 8, false, "like the reference", {}, false},
                       {"more", 1, 2, true, "", {}, false}};
    };
    add("Ana Lee", "7", 6.5);
    add("=Bob; Ray", "8", 3);
    room.entries[1].lateFactor = .5;
    room.entries[1].lateReason = "2 days late";
    room.entries[1].comment = "nice, but late";
    return room;
}

TEST(ImportTables, MoodleHasIdentifiersGradesAndComments) {
    const std::string table = importTable(markedClass(), {.book = GradeBook::moodle, .assignment = {}});
    EXPECT_NE(table.substr(0, 3), "\xEF\xBB\xBF");
    EXPECT_EQ(moodleGrades(table), (std::map<std::string, double>{{"7", 7.5}, {"8", 2}}));
    const auto rows = strictly(table);
    EXPECT_EQ(rows[1].at("Full name"), "'=Bob; Ray");
    EXPECT_EQ(rows[1].at("Feedback comments"),
              "dots, \"round\": 3 of 8, like the reference; more: 1 of 2; 2 days late. nice, but late");
}

TEST(ImportTables, CanvasHasItsFiveColumnsTheAssignmentAndThePointsPossible) {
    const auto rows =
        strictly(importTable(markedClass(), {.book = GradeBook::canvas, .assignment = "P2 (991)"}));
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].at("Student"), "    Points Possible");
    EXPECT_EQ(rows[0].at("P2 (991)"), "8");
    EXPECT_EQ(rows[1].at("ID"), "7");
    EXPECT_EQ(rows[1].at("P2 (991)"), "7.50");
    for (const char* each : {"SIS User ID", "SIS Login ID", "Section"}) EXPECT_EQ(rows[1].at(each), "");
}

TEST(ImportTables, GradescopeHasFirstAndLastNames) {
    const auto rows = strictly(importTable(markedClass(), {.book = GradeBook::gradescope, .assignment = {}}));
    EXPECT_EQ(rows[0].at("First Name"), "Ana");
    EXPECT_EQ(rows[0].at("Last Name"), "Lee");
    EXPECT_EQ(rows[0].at("SID"), "7");
    EXPECT_EQ(rows[0].at("Total Score"), "7.50");
    EXPECT_EQ(rows[0].at("Max Points"), "8");
}

TEST(ImportTables, EveryMemberOfAGroupHasALineWithTheGrade) {
    Classroom room = markedClass();
    room.entries[0].submission.name = "Bob Ng, Cy Two";
    room.entries[0].submission.members = {{"Bob Ng", "778", "bob@x"}, {"Cy Two", "779", "cy@x"}};
    const auto gradescope = strictly(importTable(room, {.book = GradeBook::gradescope, .assignment = {}}));
    ASSERT_EQ(gradescope.size(), 3U);
    EXPECT_EQ(gradescope[0].at("First Name") + " " + gradescope[0].at("Last Name"), "Bob Ng");
    EXPECT_EQ(gradescope[1].at("First Name") + " " + gradescope[1].at("Last Name"), "Cy Two");
    EXPECT_EQ(gradescope[1].at("SID"), "779");
    EXPECT_EQ(gradescope[1].at("Email"), "cy@x");
    EXPECT_EQ(gradescope[1].at("Total Score"), "7.50");
    EXPECT_EQ(moodleGrades(importTable(room, {.book = GradeBook::moodle, .assignment = {}})),
              (std::map<std::string, double>{{"778", 7.5}, {"779", 7.5}, {"8", 2}}));
    const auto canvas = strictly(importTable(room, {.book = GradeBook::canvas, .assignment = "P2"}));
    ASSERT_EQ(canvas.size(), 4U) << "with the points possible";
    EXPECT_EQ(canvas[2].at("ID"), "779");
    const std::string own = gradesCsv(room);
    EXPECT_NE(own.find("\"778, 779\",\"bob@x, cy@x\""), std::string::npos) << own;
}

TEST(ImportTables, ThePlatformsOwnTableKeepsItsColumnsAndLines) {
    const suite::Folder made;
    suite::writeText(
        made / "grades.csv",
        "Identifier,Full name,Status,Grade,Maximum Grade,Last modified (grade),Feedback comments\r\n"
        "Participant 7,\"Lee, Ana\",Submitted,,10.00,-,\r\n"
        "Participant 9,Zoe,No submission,4,10.00,-,\"a \"\"b\"\"\"\r\n");
    const Roster roster = *readRoster(made / "grades.csv");
    const ImportOptions options{
        .book = GradeBook::moodle, .assignment = {}, .roster = &roster, .handed = {0, std::nullopt}};
    const std::string table = importTable(markedClass(), options);
    EXPECT_EQ(moodleGrades(table), (std::map<std::string, double>{{"7", 7.5}, {"9", 4}}));
    const auto rows = strictly(table);
    EXPECT_EQ(rows[0].at("Full name"), "Lee, Ana");
    EXPECT_EQ(rows[0].at("Maximum Grade"), "10.00");
    EXPECT_EQ(rows[1].at("Feedback comments"), "a \"b\"");
}

TEST(ImportTables, AnotherMaximumOfThePlatformIsNamed) {
    const suite::Folder made;
    suite::writeText(made / "moodle.csv",
                     "Identifier,Full name,Grade,Maximum Grade\nParticipant 7,Ana,,100.00\n");
    suite::writeText(made / "canvas.csv",
                     "Student,ID,P1 (990),P2 (991)\n    Points Possible,,5.00,8.00\nAna,7,,\n");
    suite::writeText(made / "gradescope.csv", "Name,SID,Total Score,Max Points\nAna,7,,10.0\n");
    const auto said = [&](GradeBook book, const std::string& assignment) {
        const Roster roster = *readRoster(made / (std::string(name(book)) + ".csv"));
        return whyOtherMaximum(markedClass(),
                               {.book = book, .assignment = assignment, .roster = &roster, .handed = {}});
    };
    EXPECT_EQ(
        said(GradeBook::moodle, ""),
        "the roster says that there are at most 100 points, and the rubric has 8; grades are not scaled");
    EXPECT_EQ(said(GradeBook::canvas, "P2"), "") << "8, too";
    EXPECT_NE(said(GradeBook::canvas, "P1").find("at most 5 points"), std::string::npos);
    EXPECT_NE(said(GradeBook::gradescope, "").find("at most 10 points"), std::string::npos);
    EXPECT_EQ(whyOtherMaximum(markedClass(), {.book = GradeBook::moodle, .assignment = {}}), "");
}

TEST(ImportTables, CanvassOwnTableKeepsItsColumnsAndGetsTheGradesOfOneAssignment) {
    const suite::Folder made;
    // As Canvas exports it, with a line about posting and one about points.
    suite::writeText(made / "grades.csv",
                     "Student,ID,SIS User ID,SIS Login ID,Section,P1 (990),P2 (991),Current Score\n"
                     ",,,,,Manual Posting,,\n    Points Possible,,,,,5.00,8.00,(read only)\n"
                     "\"Lee, Ana\",7,u7,ana,01,4,,80\n\"Ray, Zoe\",9,u9,zoe,01,2,1,40\n");
    const Roster roster = *readRoster(made / "grades.csv");
    ASSERT_EQ(roster.students.size(), 2U);
    EXPECT_EQ(roster.students[0].number, "7");
    for (const char* each : {"P2 (991)", "P2", "991"}) {
        const ImportOptions options{
            .book = GradeBook::canvas, .assignment = each, .roster = &roster, .handed = {0, std::nullopt}};
        EXPECT_EQ(whyNoAssignment(options), "");
        const auto rows = strictly(importTable(markedClass(), options));
        ASSERT_EQ(rows.size(), 4U);
        EXPECT_EQ(rows[0].at("P1 (990)"), "Manual Posting");
        EXPECT_EQ(rows[1].at("Student"), "    Points Possible");
        EXPECT_EQ(rows[1].at("P2 (991)"), "8.00");
        EXPECT_EQ(rows[2].at("P2 (991)"), "7.50");
        EXPECT_EQ(rows[2].at("P1 (990)"), "4");
        EXPECT_EQ(rows[3].at("P2 (991)"), "1") << "nothing was handed in";
    }
    const std::string why =
        whyNoAssignment({.book = GradeBook::canvas, .assignment = "all", .roster = &roster, .handed = {}});
    EXPECT_NE(why.find("'all'"), std::string::npos) << why;
    EXPECT_NE(why.find("'P1 (990)', 'P2 (991)'"), std::string::npos) << why;
}

TEST(ImportTables, WithoutARubricTheGradeIsEmptyAndTheStateIsTheComment) {
    Classroom room = markedClass();
    for (Entry& each : room.entries) each.marks.clear();
    room.entries[0].submission.scene.clear();
    room.entries[0].submission.problem = "the folder has no scene";
    const std::string table = importTable(room, {.book = GradeBook::moodle, .assignment = {}});
    EXPECT_TRUE(moodleGrades(table).empty());
    EXPECT_EQ(strictly(table)[0].at("Feedback comments"), "no-scene: the folder has no scene");
}

}  // namespace
}  // namespace glibra::classroom
