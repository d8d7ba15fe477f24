#include "view/scene/file_watch.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <thread>

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
    watch.watch({folder / "a.frag"}, {});
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
    watch.watch({folder.scene()}, {"cow.obj"});
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
    watch.watch({folder.scene(), wood}, {});
    std::filesystem::remove(wood);
    woken.wait();
    EXPECT_EQ(watch.takeChanged().files, std::vector<std::filesystem::path>{wood});
    // The scene does not find the file any more, so it is only known by its name.
    watch.watch({folder.scene()}, {"wood.bmp"});
    folder.write("pictures/wood.bmp", "2");
    woken.wait();
    EXPECT_EQ(watch.takeChanged().files, std::vector<std::filesystem::path>{wood});
    watch.watch({folder.scene(), wood}, {});
    std::filesystem::rename(wood, folder / "pictures/other.bmp");
    woken.wait();
    EXPECT_EQ(watch.takeChanged().files, std::vector<std::filesystem::path>{wood});
}

TEST(FileWatch, AFileThatAnEditorWritesAnewIsReportedOnceWhenItIsThere) {
    const SceneFolder folder("", {{"a.frag", "1"}, {"b.frag", "1"}});
    Woken woken;
    view::FileWatch watch([&] { woken.wake(); });
    ASSERT_TRUE(watch.isWorking()) << "no inotify";
    watch.watch({folder / "a.frag", folder / "b.frag"}, {});
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
    watch.watch({folder / "a.frag"}, {});
    {
        std::ofstream half(folder / "a.frag");
        half << "half" << std::flush;
        EXPECT_TRUE(watch.takeChanged().files.empty());
    }
    woken.wait();
    EXPECT_EQ(watch.takeChanged().files.size(), 1U);
}

}  // namespace
}  // namespace glibra::test
