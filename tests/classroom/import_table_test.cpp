// The tables that grade books import, read by strict readers of their documented columns.

#include "classroom/import_table.h"

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
