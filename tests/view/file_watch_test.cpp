#include "view/scene/file_watch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "scene_folder.h"

namespace glibra::test {
namespace {

/// Waits until the watch reports a change. The test's time limit ends a wait that is too long.
class Woken {
  public:
    void wake() {
        const std::scoped_lock lock(mutex_);
        ++count_;
        changed_.notify_all();
    }
    void wait() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return count_ > 0; });
        --count_;
    }
    /// False if nothing is reported in time.
    bool waitsShortly() {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, std::chrono::seconds(20),
                                 [this] { return std::exchange(count_, 0) > 0; });
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    int count_ = 0;
};

TEST(FileWatch, ReportsSavesInPlaceAndByRename) {
    const SceneFolder folder("", {{"a.frag", "1"}, {"other.txt", ""}});
    Woken woken;
    view::FileWatch watch([&] { woken.wake(); });
    ASSERT_TRUE(watch.isWorking()) << "no inotify";
    watch.watch({folder / "a.frag"});
    folder.write("other.txt", "not watched");
    folder.write("a.frag", "2");
    woken.wait();
    EXPECT_EQ(watch.takeChanged().files, std::vector<std::filesystem::path>{folder / "a.frag"});

    folder.write("a.frag.new", "3");
    std::filesystem::rename(folder / "a.frag.new", folder / "a.frag");
    woken.wait();
    EXPECT_EQ(watch.takeChanged().files, std::vector<std::filesystem::path>{folder / "a.frag"});
    EXPECT_TRUE(watch.takeChanged().files.empty());
}

TEST(FileWatch, ReportsAMissingFileThatAppears) {
    const SceneFolder folder("");
    Woken woken;
    view::FileWatch watch([&] { woken.wake(); });
    ASSERT_TRUE(watch.isWorking()) << "no inotify";
    watch.watch({folder.scene(), folder / "cow.obj"});
    folder.write("cow.obj", "v 0 0 0\n");
    woken.wait();
    EXPECT_EQ(watch.takeChanged().files, std::vector<std::filesystem::path>{folder / "cow.obj"});
}

TEST(FileWatch, ReportsAFileThatIsRemovedOrMovedAwayAndThatComesBack) {
    const SceneFolder folder("", {{"pictures/wood.bmp", "1"}});
    const std::filesystem::path wood = folder / "pictures/wood.bmp";
    Woken woken;
    view::FileWatch watch([&] { woken.wake(); });
    ASSERT_TRUE(watch.isWorking()) << "no inotify";
    watch.watch({folder.scene(), wood});
    std::filesystem::remove(wood);
    woken.wait();
    EXPECT_EQ(watch.takeChanged().files, std::vector<std::filesystem::path>{wood});
    // The scene names the file no more; a text editor may bring both back.
    watch.watch({folder.scene()});
    folder.write("pictures/wood.bmp", "2");
    woken.wait();
    EXPECT_EQ(watch.takeChanged().files, std::vector<std::filesystem::path>{wood});
    watch.watch({folder.scene(), wood});
    std::filesystem::rename(wood, folder / "pictures/other.bmp");
    woken.wait();
    EXPECT_EQ(watch.takeChanged().files, std::vector<std::filesystem::path>{wood});
}

TEST(FileWatch, AFileThatAnEditorWritesAnewIsReportedOnceWhenItIsThere) {
    const SceneFolder folder("", {{"a.frag", "1"}, {"b.frag", "1"}});
    Woken woken;
    view::FileWatch watch([&] { woken.wake(); });
    ASSERT_TRUE(watch.isWorking()) << "no inotify";
    watch.watch({folder / "a.frag", folder / "b.frag"});
    std::filesystem::rename(folder / "a.frag", folder / "a.frag~");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_TRUE(watch.takeChanged().files.empty()) << "it may come back";
    folder.write("a.frag", "2");
    woken.wait();
    EXPECT_EQ(watch.takeChanged().files, std::vector<std::filesystem::path>{folder / "a.frag"});
    // A file that stays away ends the wait for what else may be reported about the first.
    std::filesystem::remove(folder / "b.frag");
    woken.wait();
    EXPECT_EQ(watch.takeChanged().files, std::vector<std::filesystem::path>{folder / "b.frag"});
}

TEST(FileWatch, WaitsUntilTheWriterHasClosed) {
    const SceneFolder folder("", {{"a.frag", "1"}});
    Woken woken;
    view::FileWatch watch([&] { woken.wake(); });
    ASSERT_TRUE(watch.isWorking()) << "no inotify";
    watch.watch({folder / "a.frag"});
    {
        std::ofstream half(folder / "a.frag");
        half << "half" << std::flush;
        EXPECT_TRUE(watch.takeChanged().files.empty());
    }
    woken.wait();
    EXPECT_EQ(watch.takeChanged().files.size(), 1U);
}

namespace fs = std::filesystem;

/// A file below several folders, one of which is a link, and a watch of it.
class ReplacedFolders : public testing::Test {
  protected:
    ReplacedFolders() : folder("", {{"work/v1/sub/a.frag", "1"}}), watch([this] { woken.wake(); }) {
        fs::create_directory_symlink("v1", folder / "work/current");
        file = folder / "work/current/sub/a.frag";
        watch.watch({file, folder / "work/later/sub/b.frag"});
    }
    /// Whether the watch reports the file in time, after it may have reported more about it.
    bool isReported(const fs::path& wanted) {
        for (;;) {
            const std::vector<fs::path> files = watch.takeChanged().files;
            if (std::ranges::find(files, wanted) != files.end()) return true;
            if (!woken.waitsShortly()) return false;
        }
    }
    void takeAll() {
        std::this_thread::sleep_for(std::chrono::milliseconds(400));  // what is removed is reported late
        watch.takeChanged();
    }
    SceneFolder folder;
    fs::path file;
    Woken woken;
    view::FileWatch watch;
};

TEST_F(ReplacedFolders, AreFollowedAtEachLevel) {
    ASSERT_TRUE(watch.isWorking()) << "no inotify";
    int number = 1;
    for (const char* replaced : {"work/v1/sub", "work/v1", "work", "work/v1/sub"}) {
        fs::rename(folder / replaced, folder / "old");
        fs::copy(folder / "old", folder / replaced,
                 fs::copy_options::recursive | fs::copy_options::copy_symlinks);
        fs::remove_all(folder / "old");
        EXPECT_TRUE(isReported(file)) << replaced << " is another folder with another file";
        takeAll();
        folder.write("work/v1/sub/a.frag", std::to_string(++number));
        EXPECT_TRUE(isReported(file)) << "an edit after " << replaced << " was replaced";
        takeAll();
    }
}

TEST_F(ReplacedFolders, ThatStayAwayAreReportedAndAwaited) {
    fs::remove_all(folder / "work");
    EXPECT_TRUE(isReported(file));
    folder.write("work/v1/sub/a.frag", "2");
    fs::create_directory_symlink("v1", folder / "work/current");
    EXPECT_TRUE(isReported(file));
    takeAll();
    folder.write("work/v1/sub/a.frag", "3");
    EXPECT_TRUE(isReported(file));
}

TEST_F(ReplacedFolders, ALinkThatLeadsElsewhereIsFollowed) {
    folder.write("work/v2/sub/a.frag", "2");
    fs::create_directory_symlink("v2", folder / "work/next");
    fs::rename(folder / "work/next", folder / "work/current");
    EXPECT_TRUE(isReported(file));
    takeAll();
    folder.write("work/v2/sub/a.frag", "3");
    EXPECT_TRUE(isReported(file));
    takeAll();
    folder.write("work/v1/sub/a.frag", "the path does not lead here any more");
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_TRUE(watch.takeChanged().files.empty());
}

TEST_F(ReplacedFolders, AMissingFileIsReportedWhenItsFoldersAreMadeLater) {
    folder.write("work/later/sub/b.frag", "1");
    EXPECT_TRUE(isReported(folder / "work/later/sub/b.frag"));
}

TEST_F(ReplacedFolders, AFurtherNameOfAFileAndALinkAreReported) {
    const fs::path other = folder / "other.frag";
    folder.write("other.frag", "linked");
    fs::remove(folder / "work/v1/sub/a.frag");
    fs::create_hard_link(other, folder / "work/v1/sub/a.frag");
    EXPECT_TRUE(isReported(file));
    takeAll();
    fs::remove(folder / "work/v1/sub/a.frag");
    folder.write("work/v1/third.frag", "another one");
    fs::create_symlink(folder / "work/v1/third.frag", folder / "work/v1/sub/a.frag");
    EXPECT_TRUE(isReported(file));
    takeAll();
    folder.write("work/v1/third.frag", "the target is saved");
    EXPECT_TRUE(isReported(file));
}

TEST(FileWatch, AMissingFileIsReportedInAnotherCase) {
    const SceneFolder folder("");
    Woken woken;
    view::FileWatch watch([&] { woken.wake(); });
    watch.watch({folder / "Wood.bmp"});
    folder.write("wood.bmp", "");
    woken.wait();
    EXPECT_EQ(watch.takeChanged().files, std::vector<fs::path>{folder / "Wood.bmp"});
}

}  // namespace
}  // namespace glibra::test
