// What a teacher has typed stays with the submission and the check that it was typed for, or is named.

#include "classroom/teacher_marks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "../suite/folder.h"
#include "classroom/moments.h"

namespace glibra::classroom {
namespace {

/// A submission with the checks "is drawn" (automatic, 2 points) and "report" (by hand, 5 points).
Entry entryWith(const std::string& name, const std::string& key, const std::string& number = {}) {
    Entry entry;
    entry.submission.name = name;
    entry.submission.key = key;
    entry.submission.number = number;
    entry.digest = "first";
    entry.marks = {{"is drawn", 2, 2, false, "", {}, false, false},
                   {"report", 0, 5, false, "not yet marked by hand", {}, false, true}};
    return entry;
}

Classroom roomOf(std::vector<Entry> entries) {
    Classroom room;
    room.entries = std::move(entries);
    return room;
}

std::string textsOf(const Diagnostics& remarks) {
    std::string all;
    for (const Diagnostic& each : remarks) all += each.text + "\n";
    return all;
}

TEST(TeachersMarks, ReplacePointsAndSurvive) {
    const suite::Folder made;
    TeacherMarks marks;
    marks["ana"].points = {{"is drawn", 1.5}, {"report", 9}};
    marks["ana"].comment = "well\ndone \"x\"";
    ASSERT_EQ(writeTeacherMarks(marks, made.path()), 0);
    const Result<TeacherMarks> read = readTeacherMarks(made.path());
    ASSERT_TRUE(read);
    Classroom room = roomOf({entryWith("ana", "ana")});
    EXPECT_TRUE(applyTeacherMarks(*read, room).empty());
    EXPECT_EQ(pointsOf(room.entries[0]), 1.5 + 5) << "no more than the check has";
    EXPECT_TRUE(room.entries[0].marks[0].isOwn);
    EXPECT_EQ(openCount(room.entries[0]), 0U);
    EXPECT_EQ(room.entries[0].comment, "well\ndone \"x\"");
    EXPECT_TRUE(readTeacherMarks(made / "missing")->empty());
    suite::writeText(made / kMarksFile, "{\"ana\": 3}");
    EXPECT_FALSE(readTeacherMarks(made.path()));
}

/// The text of the error of a file with that content: "3:7 text".
std::string errorOf(const Diagnostics& found) {
    if (found.size() != 1) return fmt::format("{} messages", found.size());
    EXPECT_TRUE(found[0].place.file.ends_with(".json")) << found[0].place.file;
    return fmt::format("{}:{} {}", found[0].place.line, found[0].place.column,
                       found[0].text.substr(found[0].text.find(": ") + 2));
}

TEST(TeachersMarks, OfAFileThatIsWrongNameWhatIsWrong) {
    const suite::Folder made;
    for (const auto& [text, error] : {
             std::pair{"", "1:1 it is not JSON"},
             {"{\"ana\": {},\n \"bo\": !}", "2:8 it is not JSON"},
             {"[]", "1:1 expected an object"},
             {"{\"ana\": 3}", "1:1 'ana': expected an object"},
             {"{\"ana\": {\"points\": 5}}", "1:1 'ana': 'points': expected an object"},
             {"{\"ana\": {\"points\": [5]}}", "1:1 'ana': 'points': expected an object"},
             {"{\"ana\": {\"points\": {\"r\": \"2\"}}}",
              "1:1 'ana': 'points': 'r': expected number, found string"},
             {"{\"ana\": {\"comment\": 2}}", "1:1 'ana': 'comment': expected string, found number"},
             {"{\"ana\": {\"handedIn\": 2}}", "1:1 'ana': 'handedIn': expected object, found number"},
         }) {
        suite::writeText(made / kMarksFile, text);
        const Result<TeacherMarks> read = readTeacherMarks(made.path());
        EXPECT_FALSE(read) << text;
        EXPECT_EQ(errorOf(read.diagnostics), error) << text;
    }
}

TEST(ReferencePictures, OfAFileThatIsWrongNameWhatIsWrong) {
    const suite::Folder made;
    const auto with = [](const std::string& pictures) {
        return "{\"scene\": \"a.glib\", \"pictures\": " + pictures + "}";
    };
    for (const auto& [text, error] : {
             std::pair<std::string, std::string>{"", "1:1 it is not JSON"},
             {"{\n\"scene\": a", "2:10 it is not JSON"},
             {"3", "1:1 expected an object"},
             {"{}", "1:1 the member 'scene' is missing"},
             {"{\"scene\": []}", "1:1 'scene': expected string, found array"},
             {with("7"), "1:1 'pictures': expected array, found number"},
             {with("[]"), "1:1 there are none"},
             {with("[7]"), "1:1 expected an object"},
             {with("[{}]"), "1:1 the member 'label' is missing"},
             {with("[{\"label\": \"\", \"options\": {}}]"), "1:1 'options': expected array, found object"},
             {with("[{\"label\": \"\", \"options\": [], \"has\": {\"color\": 1}}]"),
              "1:1 'has': 'color': expected array, found number"},
             {with("[{\"label\": \"\", \"options\": [\"--out\"]}]"), "1:1 '--out' is no option of a picture"},
         }) {
        suite::writeText(made / kReferenceFile, text);
        const Result<ReferencePictures> read = readReferencePictures(made.path());
        EXPECT_FALSE(read) << text;
        EXPECT_EQ(errorOf(read.diagnostics), error) << text;
    }
}

TEST(TeachersMarks, WhatFindsNoPlaceIsNamedAndKept) {
    TeacherMarks marks;
    marks["ana"].points = {{"is drawn", 1}, {"essay", 4}};
    marks["zed"].points = {{"report", 3}};
    marks["zoe"].comment = "good";
    Classroom room = roomOf({entryWith("ana", "ana")});
    const std::string remarks = textsOf(applyTeacherMarks(marks, room));
    EXPECT_NE(remarks.find("no check for the 4 points for 'essay' of 'ana'"), std::string::npos) << remarks;
    EXPECT_NE(remarks.find("no submission is 'zed', which has 3 points for 'report'"), std::string::npos)
        << remarks;
    EXPECT_NE(remarks.find("no submission is 'zoe', which has a comment"), std::string::npos) << remarks;
    EXPECT_EQ(room.unplaced.size(), 3U);
    EXPECT_EQ(pointsOf(room.entries[0]), 1);
    const auto kept = parseTeacherMarks(toText(marks));
    EXPECT_EQ(kept->at("zed").points, marks["zed"].points);
    EXPECT_EQ(kept->at("ana").points, marks["ana"].points);
    applyTeacherMarks({}, room);
    EXPECT_TRUE(room.unplaced.empty());
}

TEST(TeachersMarks, FollowTheStudentWhenNamesChange) {
    // Marked by the names of folders, as they were before --names.
    TeacherMarks marks;
    marks["Ana Lee_12_assignsubmission_file_"].points = {{"report", 4}};
    marks["7"].points = {{"report", 3}};
    Classroom room = roomOf({entryWith("Ana Lee", "Ana Lee_12_assignsubmission_file_", "12"),
                             entryWith("Bo", "Bo_7_assignsubmission_file_", "7")});
    EXPECT_TRUE(applyTeacherMarks(marks, room).empty());
    EXPECT_EQ(pointsOf(room.entries[0]), 6);
    EXPECT_EQ(pointsOf(room.entries[1]), 5);
    // What is typed now has the number, so that a corrected name, and another folder, change nothing.
    typePoints(marksOf(marks, room, 0), room.entries[0], "report", 4.5);
    ASSERT_EQ(marks.size(), 2U) << "the same marks";
    marks = *parseTeacherMarks(toText(marks));
    Classroom later = roomOf({entryWith("Anna Lee", "submission_99", "12"), entryWith("Bo", "Bo_7", "7")});
    EXPECT_TRUE(applyTeacherMarks(marks, later).empty());
    EXPECT_EQ(pointsOf(later.entries[0]), 6.5);
    // Without numbers the folder lasts.
    Classroom plain = roomOf({entryWith("A. Lee", "Ana Lee_12_assignsubmission_file_")});
    applyTeacherMarks(marks, plain);
    EXPECT_EQ(pointsOf(plain.entries[0]), 6.5);
}

TEST(TeachersMarks, OfOneStudentAreNotThoseOfAnotherWithThisName) {
    TeacherMarks marks;
    Classroom room = roomOf({entryWith("Ana Lee", "a", "12")});
    typePoints(marksOf(marks, room, 0), room.entries[0], "report", 4);
    Classroom other = roomOf({entryWith("Ana Lee", "b", "13")});
    EXPECT_NE(textsOf(applyTeacherMarks(marks, other)).find("no submission is 'Ana Lee'"), std::string::npos);
    EXPECT_EQ(openCount(other.entries[0]), 1U);
    // New ones do not replace those that belong to nobody.
    typePoints(marksOf(marks, other, 0), other.entries[0], "report", 2);
    EXPECT_EQ(marks.size(), 2U);
    applyTeacherMarks(marks, room);
    EXPECT_EQ(pointsOf(room.entries[0]), 6);
}

TEST(TeachersMarks, EndOrAreMarkedWhenSomethingElseIsHandedIn) {
    TeacherMarks marks;
    Classroom room = roomOf({entryWith("ana", "ana")});
    typePoints(marksOf(marks, room, 0), room.entries[0], "is drawn", 0.5);
    typePoints(marksOf(marks, room, 0), room.entries[0], "report", 4);
    room.entries[0] = entryWith("ana", "ana");
    EXPECT_TRUE(applyTeacherMarks(marks, room).empty());
    EXPECT_EQ(pointsOf(room.entries[0]), 4.5);
    room.entries[0] = entryWith("ana", "ana");
    room.entries[0].digest = "second";
    const std::string remarks = textsOf(applyTeacherMarks(marks, room));
    EXPECT_NE(remarks.find("'ana' was handed in again after you typed 0.5 points for 'is drawn'"),
              std::string::npos)
        << remarks;
    EXPECT_EQ(room.entries[0].marks[0].points, 2) << "those of the check count again";
    EXPECT_NE(room.entries[0].marks[0].reason.find("0.5 for an earlier hand-in"), std::string::npos);
    EXPECT_EQ(room.entries[0].marks[1].points, 4) << "what is marked by hand stays";
    EXPECT_NE(room.entries[0].marks[1].reason.find("an earlier hand-in"), std::string::npos);
    EXPECT_EQ(std::count(remarks.begin(), remarks.end(), '\n'), 2) << remarks;
}

TEST(TeachersMarks, ThatAnEditorWroteCountForTheLastRun) {
    const suite::Folder made;
    Classroom room = roomOf({entryWith("ana", "ana")});
    writeDigests(room, made.path());
    TeacherMarks marks = *parseTeacherMarks("{\"ana\": {\"points\": {\"is drawn\": 1}}}");
    room.entries[0].digest = "second";
    addDigests(marks, room, readDigests(made.path()));
    EXPECT_EQ(marks["ana"].handedIn["is drawn"], "first");
    EXPECT_EQ(applyTeacherMarks(marks, room).size(), 1U);
    // At the first run of all they count for what is there.
    TeacherMarks others = *parseTeacherMarks("{\"ana\": {\"points\": {\"is drawn\": 1}}}");
    addDigests(others, room, readDigests(made / "missing"));
    EXPECT_TRUE(applyTeacherMarks(others, room).empty());
    suite::writeText(made / kDigestsFile, "no JSON");
    EXPECT_TRUE(readDigests(made.path()).empty());
}

}  // namespace
}  // namespace glibra::classroom
