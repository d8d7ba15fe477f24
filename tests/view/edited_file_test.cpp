#include "view/edit/edited_file.h"

#include "scene_folder.h"

namespace glibra::test {
namespace {

using view::EditedFile;

/// Opens the file, appends to its text and saves it. Returns the file's new content.
std::string edited(const SceneFolder& folder, const std::string& before, const std::string& added) {
    folder.write("a.frag", before);
    EditedFile file(folder / "a.frag");
    EXPECT_EQ(file.whyReadOnly(), "");
    EXPECT_FALSE(file.isChanged());
    file.text() += added;
    EXPECT_TRUE(file.isChanged());
    EXPECT_TRUE(file.save().empty());
    EXPECT_FALSE(file.isChanged());
    return folder.read("a.frag");
}

TEST(EditedFile, KeepsEveryByteThatWasNotEdited) {
    const SceneFolder folder("");
    EXPECT_EQ(edited(folder, "a\nb\n", "c"), "a\nb\nc");
    EXPECT_EQ(edited(folder, "a\r\nb\r\n", "c\n"), "a\r\nb\r\nc\r\n");
    EXPECT_EQ(edited(folder, "\xEF\xBB\xBF#version 330\n", "x"), "\xEF\xBB\xBF#version 330\nx");
    EXPECT_EQ(edited(folder, "// gr\xC3\xB6\xC3\x9F er\n", "\xC3\xA4"), "// gr\xC3\xB6\xC3\x9F er\n\xC3\xA4");
    EXPECT_EQ(edited(folder, "// gr\xF6\xDF er\n", "\xC3\xA4"), "// gr\xF6\xDF er\n\xE4")
        << "a Latin-1 file stays Latin-1";
    EXPECT_EQ(edited(folder, "// \xF6\n", "\xE2\x82\xAC"), "// \xC3\xB6\n\xE2\x82\xAC")
        << "a character outside Latin-1 makes it UTF-8";
    EXPECT_EQ(edited(folder, "", "void"), "void");
}

TEST(EditedFile, WhatItWouldDamageIsReadOnly) {
    const SceneFolder folder("");
    for (const std::string& each :
         {std::string("a\0b", 3), std::string("a\r\nb\nc\r"), std::string("\xF0\x9F\x98\x80")}) {
        folder.write("a.frag", each);
        EditedFile file(folder / "a.frag");
        EXPECT_NE(file.whyReadOnly(), "");
        file.text() += "x";
        EXPECT_FALSE(file.isChanged());
        EXPECT_TRUE(file.save().empty());
        EXPECT_EQ(folder.read("a.frag"), each);
    }
    EXPECT_NE(EditedFile(folder / "none.frag").whyReadOnly(), "");
}

TEST(EditedFile, TakesWhatOthersSaveWhileNothingIsTyped) {
    const SceneFolder folder("", {{"a.frag", "one"}});
    EditedFile file(folder / "a.frag");
    EXPECT_FALSE(file.lookAtDisk());
    folder.write("a.frag", "two");
    EXPECT_TRUE(file.lookAtDisk());
    EXPECT_EQ(file.text(), "two");
    EXPECT_FALSE(file.hasConflict());
    EXPECT_FALSE(file.isChanged());
}

TEST(EditedFile, AsksWhenBothHaveChanged) {
    const SceneFolder folder("", {{"a.frag", "one"}});
    EditedFile mine(folder / "a.frag");
    EditedFile theirs(folder / "a.frag");
    mine.text() = theirs.text() = "typed";
    folder.write("a.frag", "another's");
    EXPECT_TRUE(mine.save().empty());
    EXPECT_TRUE(mine.hasConflict()) << "saving detects the conflict at the latest";
    EXPECT_EQ(folder.read("a.frag"), "another's");
    EXPECT_TRUE(theirs.lookAtDisk());
    EXPECT_TRUE(theirs.hasConflict());
    EXPECT_EQ(theirs.text(), "typed");

    theirs.takeDisk();
    EXPECT_EQ(theirs.text(), "another's");
    EXPECT_FALSE(theirs.hasConflict() || theirs.isChanged());

    mine.keepMine();
    EXPECT_FALSE(mine.hasConflict());
    EXPECT_TRUE(mine.isChanged());
    EXPECT_TRUE(mine.save().empty());
    EXPECT_EQ(folder.read("a.frag"), "typed");
}

TEST(EditedFile, WhatSomebodyElseSavedInTheSameWordsIsNoConflict) {
    const SceneFolder folder("", {{"a.frag", "one"}});
    EditedFile file(folder / "a.frag");
    file.text() = "two";
    folder.write("a.frag", "two");
    file.lookAtDisk();
    EXPECT_FALSE(file.hasConflict());
    EXPECT_FALSE(file.isChanged());
}

TEST(EditedFile, ADeletedFileIsWrittenAgain) {
    const SceneFolder folder("", {{"a.frag", "one"}});
    EditedFile file(folder / "a.frag");
    std::filesystem::remove(folder / "a.frag");
    EXPECT_FALSE(file.lookAtDisk());
    EXPECT_EQ(file.text(), "one");
    file.text() = "two";
    EXPECT_TRUE(file.save().empty());
    EXPECT_EQ(folder.read("a.frag"), "two");
}

TEST(EditedFile, AChangeByThisProgramIsNoConflictAndReachesUnsavedText) {
    const SceneFolder folder("", {{"a.glib", "one\r\nvalue 1\r\nthree\r\nvalue 1\r\n"}});
    EditedFile file(folder / "a.glib");
    file.text() = "new\none\nvalue 1\nthree, typed\nvalue 1\n";
    const Diagnostics problems = file.changeFile("one\r\nvalue 1\r\nthree\r\nvalue 2\r\n");
    EXPECT_TRUE(problems.empty()) << text(problems);
    EXPECT_EQ(folder.read("a.glib"), "one\r\nvalue 1\r\nthree\r\nvalue 2\r\n");
    EXPECT_EQ(file.text(), "new\none\nvalue 1\nthree, typed\nvalue 2\n");
    file.lookAtDisk();
    EXPECT_FALSE(file.hasConflict());
    EXPECT_TRUE(file.isChanged()) << "what was typed is not saved";
    EXPECT_TRUE(file.save().empty());
    EXPECT_FALSE(file.hasConflict());
    EXPECT_EQ(folder.read("a.glib"), "new\r\none\r\nvalue 1\r\nthree, typed\r\nvalue 2\r\n");
}

TEST(EditedFile, AChangeOfALineThatWasTypedInIsRefused) {
    const SceneFolder folder("", {{"a.glib", "one\nvalue 1\n"}});
    EditedFile file(folder / "a.glib");
    file.text() = "one\nvalue 1  # typed\n";
    EXPECT_TRUE(hasError(file.changeFile("one\nvalue 2\n")));
    EXPECT_EQ(folder.read("a.glib"), "one\nvalue 1\n");
    EXPECT_EQ(file.text(), "one\nvalue 1  # typed\n");
    EXPECT_TRUE(file.isChanged());
    folder.write("a.glib", "of another program\n");
    EXPECT_TRUE(hasError(file.changeFile("one\nvalue 2\n")));
    EXPECT_TRUE(file.hasConflict());
    EXPECT_EQ(folder.read("a.glib"), "of another program\n");
}

}  // namespace
}  // namespace glibra::test
