#include "view/scene/file_watch.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <fstream>
#include <mutex>

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
    if (!watch.isWorking()) GTEST_SKIP() << "no inotify";
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
    if (!watch.isWorking()) GTEST_SKIP() << "no inotify";
    watch.watch({folder.scene()}, {"cow.obj"});
    folder.write("cow.obj", "v 0 0 0\n");
    woken.wait();
    EXPECT_EQ(watch.takeChanged().files, std::vector<std::filesystem::path>{folder / "cow.obj"});
}

TEST(FileWatch, WaitsUntilTheWriterHasClosed) {
    const SceneFolder folder("", {{"a.frag", "1"}});
    Woken woken;
    view::FileWatch watch([&] { woken.wake(); });
    if (!watch.isWorking()) GTEST_SKIP() << "no inotify";
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
