// Whole files where there are permissions, owners, links, pipes and signals.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <fstream>
#include <string>
#include <vector>

#include "image/file.h"
#include "image/write.h"
#include "support.h"

namespace glibra::image {
namespace {

namespace fs = std::filesystem;
using testing::idsOf;

const FileLabel kLabel{"a", {"scene.glib", 3, 1}};

/// Lets files grow to so many bytes only, as a full disk does.
class SmallFiles {
  public:
    explicit SmallFiles(rlim_t bytes) : signal_(::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit small{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &small);
    }
    SmallFiles(const SmallFiles&) = delete;
    SmallFiles& operator=(const SmallFiles&) = delete;
    ~SmallFiles() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        ::signal(SIGXFSZ, signal_);
    }

  private:
    sighandler_t signal_;
    rlimit before_{};
};

struct stat statusOf(const fs::path& file) {
    struct stat status{};
    EXPECT_EQ(::stat(file.c_str(), &status), 0) << file;
    return status;
}

class FileOfPosix : public testing::InFolder {};

TEST_F(FileOfPosix, APipeDoesNotBlock) {
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(idsOf(readFile(folder / "pipe", kLabel).diagnostics), "file-E14");
    EXPECT_EQ(idsOf(readFile("/dev/zero", kLabel).diagnostics), "file-E14");
}

TEST_F(FileOfPosix, FollowsTheUsersFileMode) {
    const mode_t before = ::umask(027);
    EXPECT_TRUE(writeFileAtomically(folder / "out.png", testing::bytesOf({1})).empty());
    ::umask(before);
    EXPECT_EQ(statusOf(folder / "out.png").st_mode & 0777U, 0640U);
}

TEST_F(FileOfPosix, KeepsThePermissionsOfTheFileThatItReplaces) {
    const fs::path file = put("a", testing::bytesOf({1}));
    for (const mode_t mode : {0600U, 0444U, 0666U})
        for (const NamedBy named : {NamedBy::user, NamedBy::program}) {
            ASSERT_EQ(::chmod(file.c_str(), mode), 0);
            EXPECT_TRUE(writeFileAtomically(file, testing::bytesOf({2}), named).empty());
            EXPECT_EQ(statusOf(file).st_mode & 0777U, mode);
            EXPECT_TRUE(TemporaryFile(file, named).commit().empty());
            EXPECT_EQ(statusOf(file).st_mode & 0777U, mode);
        }
}

TEST_F(FileOfPosix, KeepsTheOwnerIfTheUserNamedIt) {
    if (::geteuid() != 0) GTEST_SKIP() << "only root may write for others";
    constexpr uid_t kOther = 4321;
    const fs::path file = put("a", testing::bytesOf({1}));
    ASSERT_EQ(::chown(file.c_str(), kOther, kOther), 0);
    EXPECT_TRUE(writeFileAtomically(file, testing::bytesOf({2})).empty());
    EXPECT_TRUE(TemporaryFile(file).commit().empty());
    EXPECT_EQ(statusOf(file).st_uid, kOther);
    EXPECT_EQ(statusOf(file).st_gid, kOther);
    EXPECT_TRUE(writeFileAtomically(file, testing::bytesOf({2}), NamedBy::program).empty());
    EXPECT_EQ(statusOf(file).st_uid, 0U);
}

TEST_F(FileOfPosix, WithSeveralNamesKeepsItsContentIfThereIsNoRoomForTheNewOne) {
    const fs::path file = put("a", testing::bytesOf({1, 2, 3}));
    fs::create_hard_link(file, folder / "b");
    Diagnostics problems;
    {
        const SmallFiles small(100);
        problems = writeFileAtomically(file, std::vector<std::byte>(200));
    }
    EXPECT_EQ(idsOf(problems), "file-E10");
    EXPECT_EQ(*readFile(file, kLabel), testing::bytesOf({1, 2, 3}));
}

TEST_F(FileOfPosix, ThroughALinkChangesTheTargetOfTheLink) {
    put("real", testing::bytesOf({1}));
    fs::create_symlink("real", folder / "link");
    EXPECT_TRUE(writeFileAtomically(folder / "link", testing::bytesOf({2})).empty());
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(*readFile(folder / "real", kLabel), testing::bytesOf({2}));
}

TEST_F(FileOfPosix, ALinkThatLeadsToItselfIsNotReplaced) {
    fs::create_symlink("there", folder / "here");
    fs::create_symlink("here", folder / "there");
    EXPECT_EQ(idsOf(writeFileAtomically(folder / "here", testing::bytesOf({1}))), "file-E10");
    EXPECT_EQ(idsOf(TemporaryFile(folder / "here").commit()), "file-E10");
    EXPECT_TRUE(fs::is_symlink(folder / "here"));
    EXPECT_EQ(fileCount(), 2U);
}

TEST_F(FileOfPosix, WhoseNameTheProgramChoseReplacesALink) {
    const std::string text = "new";
    const auto bytes = std::as_bytes(std::span(text));
    std::ofstream(folder / "target") << "kept";
    for (const char* target : {"target", "nowhere", "."}) {
        fs::remove(folder / "link");
        fs::create_symlink(target, folder / "link");
        EXPECT_TRUE(writeFileAtomically(folder / "link", bytes, NamedBy::program).empty()) << target;
        EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder / "link")));
        EXPECT_EQ(fs::file_size(folder / "link"), 3U);
        EXPECT_EQ(fs::file_size(folder / "target"), 4U);
        EXPECT_FALSE(fs::exists(folder / "nowhere"));
    }
    // A pipe is not waited for.
    fs::remove(folder / "link");
    ASSERT_EQ(::mkfifo((folder / "link").c_str(), 0600), 0);
    EXPECT_TRUE(writeFileAtomically(folder / "link", bytes, NamedBy::program).empty());
    EXPECT_EQ(fs::file_size(folder / "link"), 3U);
    fs::create_directory(folder / "sub");
    EXPECT_EQ(idsOf(writeFileAtomically(folder / "sub", bytes, NamedBy::program)), "file-E10");
}

TEST_F(FileOfPosix, OfAProcessThatIsKilledLeavesNothing) {
    // Killed at any moment while it writes: there is the old file, or the new one, and nothing else.
    const std::string before(1000, 'a'), after(std::size_t{8} << 20, 'b');
    for (int attempt = 0; attempt < 40; ++attempt) {
        std::ofstream(folder / "a") << before;
        const pid_t child = ::fork();
        if (child == 0) {
            for (;;) static_cast<void>(writeFileAtomically(folder / "a", std::as_bytes(std::span(after))));
        }
        ::usleep(static_cast<useconds_t>(1000 + 977 * attempt));
        ::kill(child, SIGKILL);
        int status = 0;
        ::waitpid(child, &status, 0);
        const auto size = fs::file_size(folder / "a");
        EXPECT_TRUE(size == before.size() || size == after.size()) << size;
    }
    // Without files that have no name, there may be one for each process that was killed.
    if (const int file = ::open(folder.c_str(), O_TMPFILE | O_WRONLY, 0600); file >= 0) {
        ::close(file);
        EXPECT_LE(fileCount(), 8U) << "the names of a moment may have stayed";
    }
}

TEST_F(FileOfPosix, AnUnwritableFolderStaysAsItIs) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_EQ(idsOf(writeFileAtomically(folder / "out.png", testing::bytesOf({1}))), "file-E10");
    fs::permissions(folder, fs::perms::owner_all);
    EXPECT_EQ(fileCount(), 0U);
}

TEST_F(FileOfPosix, AFullDiskIsReported) {
    const auto full = writeFileAtomically("/dev/full", testing::bytesOf({1}));
    ASSERT_EQ(idsOf(full), "file-E10");
    EXPECT_EQ(full[0].text, "cannot write '/dev/full': no space left on device");
    EXPECT_TRUE(writeFileAtomically("/dev/null", testing::bytesOf({1})).empty());
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

/// Some writers of OpenImageIO notice no error, those of ICO and HEIF none of a small file.
TEST_F(FileOfPosix, AFileThatCannotBeWrittenToItsEndIsAnErrorInEveryFormatAndNothingIsLeft) {
    GLIBRA_NEED_MODULE();
    for (const int side : {24, 128}) {
        const Image image = testing::noisyImage(side, side, 3, Component::u8);
        for (const FormatRow& format : formats()) {
            if (format.suffixes.empty()) continue;
            const std::string suffix(format.suffixes.substr(0, format.suffixes.find(' ')));
            Diagnostics problems;
            {
                const SmallFiles small(512);
                problems = writeImage(image, folder / ("a" + suffix), {{}, testing::moduleFolders()});
            }
            EXPECT_EQ(idsOf(problems), "file-E10") << suffix;
            EXPECT_EQ(fileCount(), 0U) << suffix;
        }
    }
}

}  // namespace
}  // namespace glibra::image
