#include "system/process.h"

#include <sys/wait.h>

#include <cerrno>
#include <chrono>
#include <thread>

#include "scene_folder.h"

namespace glibra::test {
namespace {

/// The content of a file, once it exists.
std::string awaited(const SceneFolder& folder, const char* name) {
    constexpr int kTries = 6000;
    for (int i = 0; i < kTries && !std::filesystem::exists(folder / name); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return folder.read(name);
}

TEST(DetachedProcess, RunsAndLeavesNoChild) {
    const SceneFolder folder("");
    const std::string file = (folder / "out").string();
    const std::string command =
        "printf '%s %s' \"$0\" \"$1\" >" + file + ".part && mv " + file + ".part " + file;
    EXPECT_EQ(system::startDetached({"sh", "-c", command, "a b", "c"}), "");
    errno = 0;
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
    EXPECT_EQ(errno, ECHILD) << "this program has no child process, running or ended";
    EXPECT_EQ(awaited(folder, "out"), "a b c");
}

TEST(DetachedProcess, ReportsWhyAProgramCannotBeStarted) {
    EXPECT_EQ(system::startDetached({"glibra-no-such-program"}), "No such file or directory");
    EXPECT_EQ(system::startDetached({"/"}), "Permission denied");
    errno = 0;
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
    EXPECT_EQ(errno, ECHILD);
}

}  // namespace
}  // namespace glibra::test
