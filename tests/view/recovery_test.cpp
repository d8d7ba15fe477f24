#include "view/edit/recovery.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <string>
#include <system_error>

#include "scene_folder.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;
using view::SafetyCopies;

std::size_t countIn(const fs::path& folder) {
    std::error_code missing;
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder, missing), fs::directory_iterator()));
}

/// Keeps the text in a process of its own, which is killed as soon as it has.
void keepAndDie(const fs::path& folder, const fs::path& file, const char* text) {
    const pid_t process = ::fork();
    if (process == 0) {
        SafetyCopies copies(folder);
        copies.keep(file, text);
        ::kill(::getpid(), SIGKILL);
    }
    ::waitpid(process, nullptr, 0);
}

class SafetyCopiesTest : public testing::Test {
  protected:
    SceneFolder files{"", {{"a.frag", "saved"}}};
    fs::path folder = files / "state", file = files / "a.frag";
};

TEST_F(SafetyCopiesTest, OfALivingWindowAreNotOffered) {
    SafetyCopies first(folder), second(folder);
    first.keep(file, "mine");
    const SafetyCopies::Others seen = second.othersOf(file);
    EXPECT_FALSE(seen.left);
    EXPECT_TRUE(seen.isOpen);
    // What the second window keeps and forgets is its own.
    second.keep(file, "another");
    EXPECT_TRUE(first.othersOf(file).isOpen);
    EXPECT_FALSE(first.othersOf(file).left);
    second.forget(file);
    second.forgetAll();
    EXPECT_TRUE(first.isKept(file));
    EXPECT_EQ(countIn(folder / "unsaved"), 1U);
    EXPECT_FALSE(first.othersOf(file).isOpen);
    EXPECT_FALSE(first.othersOf(files / "other.frag").isOpen);
}

TEST_F(SafetyCopiesTest, OfAWindowThatWasKilledAreOfferedTheNewestFirst) {
    keepAndDie(folder, file, "older");
    keepAndDie(folder, file, "newer");
    // The clock of a file system may stand still between the two.
    const fs::file_time_type time = fs::last_write_time(file);
    for (const auto& each : fs::directory_iterator(folder / "unsaved")) fs::last_write_time(each, time);
    const SafetyCopies copies(folder);
    SafetyCopies::Others others = copies.othersOf(file);
    EXPECT_FALSE(others.isOpen);
    ASSERT_TRUE(others.left);
    EXPECT_EQ(others.left->text, "newer");
    EXPECT_FALSE(others.left->when.empty());
    SafetyCopies::remove(*others.left);
    others = copies.othersOf(file);
    ASSERT_TRUE(others.left);
    EXPECT_EQ(others.left->text, "older");
    SafetyCopies::remove(*others.left);
    EXPECT_FALSE(copies.othersOf(file).left);
    EXPECT_EQ(countIn(folder / "windows"), 0U) << "locks of windows that have ended";
}

TEST_F(SafetyCopiesTest, AreOfferedUnderEachNameOfTheFile) {
    fs::create_directory_symlink(files / ".", files / "link");
    keepAndDie(folder, files / "link" / "a.frag", "by the link");
    const SafetyCopies::Others seen = SafetyCopies(folder).othersOf(file);
    ASSERT_TRUE(seen.left);
    EXPECT_EQ(seen.left->text, "by the link");
}

TEST_F(SafetyCopiesTest, OfAnEndedWindowAreOfferedBesideThoseOfALivingOne) {
    SafetyCopies living(folder), third(folder);
    living.keep(file, "of the living");
    keepAndDie(folder, file, "of the dead");
    const SafetyCopies::Others others = third.othersOf(file);
    EXPECT_TRUE(others.isOpen);
    ASSERT_TRUE(others.left);
    EXPECT_EQ(others.left->text, "of the dead");
}

TEST_F(SafetyCopiesTest, ThatSomebodyHasRemovedAreMissed) {
    SafetyCopies copies(folder);
    copies.keep(file, "mine");
    EXPECT_TRUE(copies.isKept(file));
    ASSERT_EQ(copies.copies().size(), 1U);
    fs::remove(copies.copies().front());
    EXPECT_FALSE(copies.isKept(file));
    copies.keep(file, "mine");
    EXPECT_TRUE(copies.isKept(file));
}

TEST_F(SafetyCopiesTest, OfEarlierVersionsHaveNoOwnerAndAreOffered) {
    SafetyCopies copies(folder);
    copies.keep(file, "of an earlier version");
    const fs::path copy = copies.copies().front();
    const std::string name = copy.filename().string();
    fs::rename(copy, copy.parent_path() / (name.substr(0, name.find('.')) + ".json"));
    ASSERT_TRUE(copies.othersOf(file).left);
    EXPECT_EQ(copies.othersOf(file).left->text, "of an earlier version");
}

}  // namespace
}  // namespace glibra::test
