// Tries to escape. Each attempt runs in a process of its own, once free and once confined: it must succeed
// free, so that the test shows that the sandbox is what stops it.

#include "system/sandbox.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/capability.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <fstream>
#include <functional>
#include <thread>
#include <vector>

#include "base/contained_call.h"
#include "base/workers.h"
#include "system/memory.h"

namespace glibra::base {
namespace {

namespace fs = std::filesystem;
using namespace system;

constexpr int kConfinementFailed = 99;

/// Runs `attempt` in a child process and returns its exit status: 0 if it returned true, otherwise 1.
int inChild(const std::function<bool()>& attempt, const Sandbox* sandbox,
            std::span<const File* const> kept = {}) {
    const pid_t child = ::fork();
    if (child == 0) {
        if (sandbox && !enterSandbox(*sandbox, kept).empty()) ::_exit(kConfinementFailed);
        ::_exit(attempt() ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

class Confined : public testing::Test {
  protected:
    void SetUp() override {
        if (const std::string missing = missingForSandbox(); !missing.empty()) GTEST_SKIP() << missing;
        char name[] = "/tmp/glibra-sandbox-XXXXXX";
        ASSERT_NE(::mkdtemp(name), nullptr);
        root = name;
        for (const char* each : {"scene", "out", "elsewhere"}) fs::create_directory(root / each);
        std::ofstream(root / "scene/a.frag") << "mine";
        std::ofstream(root / "elsewhere/secret") << "secret";
        std::ofstream(root / "out/old") << "old";
        fs::create_symlink(root / "elsewhere/secret", root / "scene/link");
        fs::create_directory_symlink(root / "elsewhere", root / "scene/folder");
        sandbox.readable = {root / "scene"};
        sandbox.writable = {root / "out"};
    }
    void TearDown() override {
        std::error_code ignored;
        if (!root.empty()) fs::remove_all(root, ignored);
    }
    void isStopped(const char* what, const std::function<bool()>& attempt) {
        EXPECT_EQ(inChild(attempt, nullptr), 0) << what << " fails even without a sandbox";
        EXPECT_EQ(inChild(attempt, &sandbox), 1) << what;
    }
    void isAllowed(const char* what, const std::function<bool()>& attempt) {
        EXPECT_EQ(inChild(attempt, &sandbox), 0) << what;
    }
    static bool reads(const fs::path& file) {
        const int number = ::open(file.c_str(), O_RDONLY);
        char byte = 0;
        return number >= 0 && ::read(number, &byte, 1) == 1;
    }
    static bool writes(const fs::path& file) {
        const int number = ::open(file.c_str(), O_WRONLY | O_CREAT, 0600);
        return number >= 0 && ::write(number, "x", 1) == 1;
    }

    fs::path root;
    Sandbox sandbox;
};

TEST_F(Confined, ReadsTheFolderOfTheSceneAndWritesItsOutput) {
    isAllowed("a file of the scene", [&] { return reads(root / "scene/a.frag"); });
    isAllowed("a picture", [&] { return writes(root / "out/picture"); });
    isAllowed("a picture that is replaced", [&] {
        return writes(root / "out/new") &&
               ::rename((root / "out/new").c_str(), (root / "out/old").c_str()) == 0;
    });
    isAllowed("a library of the system", [] { return reads("/etc/ld.so.cache"); });
}

TEST_F(Confined, ReadsNoOtherFile) {
    isStopped("/etc/passwd", [] { return reads("/etc/passwd"); });
    isStopped("a file beside the scene's folder", [&] { return reads(root / "elsewhere/secret"); });
    isStopped("a way around by ..", [&] { return reads(root / "scene/../elsewhere/secret"); });
    isStopped("a link to a file", [&] { return reads(root / "scene/link"); });
    isStopped("a link to a folder", [&] { return reads(root / "scene/folder/secret"); });
    isStopped("a folder", [&] { return !fs::is_empty(root / "elsewhere"); });
    isStopped("this process's environment", [] { return reads("/proc/self/environ"); });
    isStopped("the root of another process", [&] {
        return reads("/proc/" + std::to_string(::getppid()) + "/root" + (root / "elsewhere/secret").string());
    });
    isStopped("the memory map of another process",
              [] { return reads("/proc/" + std::to_string(::getppid()) + "/maps"); });
    isStopped("a hard link that leads elsewhere", [&] {
        const fs::path name = root / "out/hard";
        ::unlink(name.c_str());
        return ::link((root / "elsewhere/secret").c_str(), name.c_str()) == 0 && reads(name);
    });
    isStopped("a new link", [&] {
        const fs::path name = root / "out/soft";
        ::unlink(name.c_str());
        return ::symlink((root / "elsewhere/secret").c_str(), name.c_str()) == 0;
    });
    isStopped("a file that is moved in", [&] {
        fs::copy_file(root / "scene/a.frag", root / "elsewhere/moved", fs::copy_options::overwrite_existing);
        return ::rename((root / "elsewhere/moved").c_str(), (root / "out/moved").c_str()) == 0;
    });
}

TEST_F(Confined, AFolderThatIsOnlyListedKeepsItsFiles) {
    sandbox.listable = {root / "elsewhere"};
    isAllowed("the names", [&] { return !fs::is_empty(root / "elsewhere"); });
    isStopped("a file", [&] { return reads(root / "elsewhere/secret"); });
}

TEST_F(Confined, WritesNoOtherFile) {
    isStopped("a new file elsewhere", [&] {
        const fs::path file = root / "elsewhere/new";
        const bool done = writes(file);
        ::unlink(file.c_str());
        return done;
    });
    isStopped("a file of the scene", [&] { return writes(root / "scene/a.frag"); });
    isStopped("a new file beside the scene", [&] {
        const bool done = writes(root / "scene/new");
        ::unlink((root / "scene/new").c_str());
        return done;
    });
    isStopped("a file of the home folder", [] {
        const char* home = std::getenv("HOME");
        const fs::path file = fs::path(home ? home : "/root") / ".glibra-sandbox-test";
        const bool done = writes(file);
        ::unlink(file.c_str());
        return done;
    });
    isStopped("a file that is emptied", [&] {
        std::ofstream(root / "scene/emptied") << "full";
        return ::truncate((root / "scene/emptied").c_str(), 0) == 0;
    });
    isStopped("a file that is emptied by reading",
              [&] { return ::open((root / "scene/a.frag").c_str(), O_RDONLY | O_TRUNC) >= 0; });
    isStopped("a file that is removed", [&] {
        std::ofstream(root / "scene/removed") << "x";
        return ::unlink((root / "scene/removed").c_str()) == 0;
    });
    isStopped("the mode of a file", [&] { return ::chmod((root / "scene/a.frag").c_str(), 0600) == 0; });
    isStopped("the mode of a file of its own", [&] {
        return writes(root / "out/program") && ::chmod((root / "out/program").c_str(), 0700) == 0;
    });
    isStopped("a time of a file",
              [&] { return ::utimensat(AT_FDCWD, (root / "scene/a.frag").c_str(), nullptr, 0) == 0; });
    isStopped("a pipe", [&] {
        ::unlink((root / "out/pipe").c_str());
        return ::mkfifo((root / "out/pipe").c_str(), 0600) == 0;
    });
}

TEST_F(Confined, HasNoNetwork) {
    for (const int family : {AF_INET, AF_INET6, AF_UNIX, AF_NETLINK})
        EXPECT_EQ(inChild([&] { return ::socket(family, SOCK_DGRAM, 0) >= 0; }, &sandbox), 1) << family;
    isStopped("a pair of sockets", [] {
        int pair[2];
        return ::socketpair(AF_UNIX, SOCK_STREAM, 0, pair) == 0;
    });
}

TEST_F(Confined, StartsNoProgramAndNoProcess) {
    isStopped("another program", [] {
        ::execl("/bin/true", "true", nullptr);
        return false;
    });
    isStopped("a program in memory", [] {
        const int memory = ::memfd_create("program", 0);
        const int program = ::open("/bin/true", O_RDONLY);
        char* const words[] = {const_cast<char*>("true"), nullptr};
        char* const none[] = {nullptr};
        std::array<char, 65536> bytes{};
        for (ssize_t got = 0; program >= 0 && (got = ::read(program, bytes.data(), bytes.size())) > 0;)
            if (::write(memory, bytes.data(), static_cast<std::size_t>(got)) != got) return false;
        ::fexecve(memory, words, none);
        return false;
    });
    isStopped("another process", [] {
        const pid_t child = ::fork();
        if (child == 0) ::_exit(0);
        return child > 0;
    });
    // Containers and chroot allow no name spaces anyway.
    const auto makesNameSpace = [] { return ::unshare(CLONE_FILES | CLONE_NEWUSER) == 0; };
    if (inChild(makesNameSpace, nullptr) == 0) isStopped("a name space", makesNameSpace);
}

TEST_F(Confined, ReachesNoOtherProcess) {
    // The victim is a child of this test that the attempts know by its number.
    const pid_t victim = ::fork();
    if (victim == 0)
        for (;;) ::pause();
    isStopped("a signal", [&] { return ::kill(victim, 0) == 0; });
    isStopped("a signal to the parent", [] { return ::kill(::getppid(), 0) == 0; });
    isStopped("a signal to the group", [] { return ::kill(0, 0) == 0; });
    isStopped("a signal to a thread of it", [&] { return ::syscall(SYS_tgkill, victim, victim, 0) == 0; });
    isStopped("tracing", [&] {
        const bool traced = ::ptrace(PTRACE_ATTACH, victim, nullptr, nullptr) == 0;
        if (traced) {
            ::waitpid(victim, nullptr, __WALL);
            ::ptrace(PTRACE_DETACH, victim, nullptr, nullptr);
        }
        return traced;
    });
    isStopped("being traced", [] { return ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0; });
    isStopped("its limits", [&] {
        struct rlimit limit{};
        return ::prlimit(victim, RLIMIT_NOFILE, nullptr, &limit) == 0;
    });
    isStopped("its memory", [&] {
        static char byte = 0;
        const iovec here{&byte, 1};
        return ::process_vm_readv(victim, &here, 1, &here, 1, 0) == 1;
    });
    ::kill(victim, SIGKILL);
    ::waitpid(victim, nullptr, 0);
}

TEST_F(Confined, HasNoDescriptorsButThoseThatItIsGiven) {
    const int secret = ::open((root / "elsewhere/secret").c_str(), O_RDWR);
    const int high = ::fcntl(secret, F_DUPFD, 500);
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const File writing(ends[1]);
    const std::array kept{&writing};
    EXPECT_EQ(inChild([&] { return ::write(ends[1], "k", 1) == 1; }, &sandbox, kept), 0);
    for (const int each : {secret, high, ends[0]}) {
        EXPECT_EQ(inChild([&] { return ::fcntl(each, F_GETFD) >= 0; }, &sandbox, kept), 1) << each;
    }
    for (const int each : {0, 1, 2})
        EXPECT_EQ(inChild(
                      [&] {
                          struct stat status{};
                          struct stat null{};
                          return ::fstat(each, &status) == 0 && ::stat("/dev/null", &null) == 0 &&
                                 status.st_rdev == null.st_rdev;
                      },
                      &sandbox),
                  0)
            << each;
    for (const int each : {secret, high, ends[0], ends[1]}) ::close(each);
}

TEST_F(Confined, DrawsWithThreadsAndMachineCodeOfItsOwn) {
    isAllowed("a thread", [] {
        std::atomic<int> seen = 0;
        std::thread([&] { seen = 1; }).join();
        return seen == 1;
    });
    isAllowed("a file of the scene, read by a thread", [&] {
        std::atomic<bool> seen = false;
        std::thread([&] { seen = reads(root / "scene/a.frag") && !reads("/etc/passwd"); }).join();
        return seen.load();
    });
    isAllowed("machine code made at run time", [] {
        void* code = ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        return ::mprotect(code, 4096, PROT_READ | PROT_EXEC) == 0;
    });
    EXPECT_EQ(inChild([]() -> bool { ::abort(); }, &sandbox), 128 + SIGABRT)
        << "a failed assertion must be seen as one";
}

TEST_F(Confined, HasNoMemoryThatItsLimitDoesNotCount) {
    constexpr std::size_t kBytes = 1U << 20U;
    const auto maps = [](int flags, int file) {
        return ::mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, flags, file, 0) != MAP_FAILED;
    };
    isStopped("a file in memory", [] { return ::memfd_create("x", 0) >= 0; });
    isStopped("shared memory", [&] { return maps(MAP_SHARED | MAP_ANONYMOUS, -1); });
    isStopped("shared memory with more flags",
              [&] { return maps(MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE | MAP_POPULATE, -1); });
    isStopped("shared zeros", [&] {
        const int zero = ::open("/dev/zero", O_RDWR);
        return zero >= 0 && maps(MAP_SHARED, zero);
    });
    isStopped("a segment of System V", [] { return ::syscall(SYS_shmget, 0, kBytes, 0600) >= 0; });
    isAllowed("private memory", [&] { return maps(MAP_PRIVATE | MAP_ANONYMOUS, -1); });
}

TEST_F(Confined, WritesNoFileBeyondTheLimit) {
    const auto grows = [&](off_t bytes) {
        ::signal(SIGXFSZ, SIG_IGN);
        const int file = ::open((root / "out/large").c_str(), O_RDWR | O_CREAT | O_TRUNC, 0600);
        return file >= 0 && ::ftruncate(file, bytes) == 0;
    };
    isStopped("a file of 2 GiB", [&] { return grows(off_t{2} << 30U); });
    isAllowed("a file of 1 GiB", [&] { return grows(static_cast<off_t>(kLargestWritten)); });
    isStopped("a limit that is raised again", [&] {
        const rlimit limit{RLIM_INFINITY, RLIM_INFINITY};
        return ::setrlimit(RLIMIT_FSIZE, &limit) == 0 && grows(off_t{2} << 30U);
    });
}

TEST_F(Confined, AWorkerThatFillsTheDiskIsEnded) {
    std::vector<Outcome::End> ends(2, Outcome::End::stopped);
    runInWorkers(
        2, {.sandbox = &sandbox},
        [&](std::size_t piece, const Step&) -> std::string {
            const std::vector<char> block(std::size_t{4} << 20U, 'x');
            const int file = ::open((root / "out/full").c_str(), O_WRONLY | O_CREAT, 0600);
            // Over and over, so that the test needs no disk of that size.
            while (piece == 0 && ::pwrite(file, block.data(), block.size(), 0) > 0) {
            }
            return {};
        },
        [&](std::size_t piece, const Outcome& outcome) { ends[piece] = outcome.end; },
        [](std::size_t, const std::string&) {});
    EXPECT_EQ(ends[0], Outcome::End::crashed);
    EXPECT_EQ(ends[1], Outcome::End::finished) << "others go on";
}

TEST_F(Confined, AWorkerThatMakesFilesWithoutEndIsEnded) {
    const fs::path made = root / "out/made";
    std::vector<Outcome::End> ends(3, Outcome::End::stopped);
    runInWorkers(
        3, {.workers = 2, .sandbox = &sandbox},
        [&](std::size_t piece, const Step&) -> std::string {
            if (piece == 2) return {};
            while (piece == 0 && !fs::exists(root / "out/begun")) ::usleep(1000);
            if (piece == 1) ::close(::open((root / "out/begun").c_str(), O_WRONLY | O_CREAT, 0600));
            for (int i = 0; piece == 1; ++i) {
                if (i % 1000 == 0 && ::mkdir((made.string() + std::to_string(i / 1000)).c_str(), 0700) != 0)
                    return "no folder";
                const std::string file =
                    made.string() + std::to_string(i / 1000) + "/" + std::to_string(i % 1000);
                const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT, 0600);
                if (opened < 0) return "no file";
                ::close(opened);
            }
            return {};
        },
        [&](std::size_t piece, const Outcome& outcome) { ends[piece] = outcome.end; },
        [](std::size_t, const std::string&) {});
    EXPECT_EQ(ends[0], Outcome::End::finished);
    EXPECT_EQ(ends[1], Outcome::End::crashed);
    EXPECT_EQ(ends[2], Outcome::End::finished) << "others go on";
    std::size_t files = 0;
    for (const auto& each : fs::recursive_directory_iterator(root / "out")) files += each.is_regular_file();
    EXPECT_GT(files, 200'000U);  // how many more depends on how fast the machine counts them
}

TEST_F(Confined, SandboxesCannotBeLeftOrWidened) {
    isAllowed("a second sandbox", [&] {
        Sandbox all;
        all.readable = {"/"};
        static_cast<void>(enterSandbox(all, {}));  // refused or without effect
        return !reads("/etc/passwd");
    });
}

TEST_F(Confined, ALinkBelowARootIsNotFollowedWhenTheRulesAreMade) {
    fs::create_directory(root / "scene/deep");
    std::ofstream(root / "scene/deep/b.frag") << "mine";
    fs::create_directory_symlink(root / "elsewhere", root / "scene/deep/out");
    fs::create_directory_symlink(root / "scene", root / "named");
    const auto readsOf = [&](const Reach& reach, const fs::path& file) {
        sandbox.readable = {reach};
        return inChild([&] { return reads(file); }, &sandbox) == 0;
    };
    // What the user names may be a link; what lies below may not.
    EXPECT_TRUE(readsOf(Reach(root / "named"), root / "scene/a.frag"));
    EXPECT_TRUE(readsOf(Reach(root / "named", "deep"), root / "scene/deep/b.frag"));
    EXPECT_TRUE(readsOf(Reach(root, "scene/deep/b.frag"), root / "scene/deep/b.frag"));
    EXPECT_TRUE(readsOf(Reach(root / "elsewhere"), root / "elsewhere/secret"));
    for (const fs::path& way : {fs::path("folder"), fs::path("folder/secret"), fs::path("link"),
                                fs::path("deep/out"), fs::path("deep/out/secret"), fs::path("../elsewhere"),
                                fs::path("deep/../../elsewhere"), root / "elsewhere"})
        EXPECT_FALSE(readsOf(Reach(root / "scene", way), root / "elsewhere/secret")) << way;
    // The same for folders that are written to.
    sandbox.readable = {root / "scene"};
    sandbox.writable = {Reach(root / "scene", "folder")};
    EXPECT_EQ(inChild([&] { return writes(root / "elsewhere/new"); }, &sandbox), 1);
}

TEST_F(Confined, AWorkerCannotLiftItsLimitOfMemory) {
    const rlimit none{0, 0};
    ASSERT_EQ(::setrlimit(RLIMIT_MEMLOCK, &none), 0);
    constexpr std::uint64_t kLimit = std::uint64_t{256} << 20;
    const auto lifts = [] {
        const rlimit most{RLIM_INFINITY, RLIM_INFINITY};
        rlimit now{};
        ::getrlimit(RLIMIT_DATA, &now);
        const rlimit hard{now.rlim_max, now.rlim_max};
        ::syscall(SYS_prlimit64, 0, RLIMIT_DATA, &most, nullptr);
        ::syscall(SYS_prlimit64, ::getpid(), RLIMIT_DATA, &hard, nullptr);
        ::syscall(SYS_setrlimit, RLIMIT_DATA, &most);
        constexpr std::size_t kMore = std::size_t{1} << 30;
        void* const memory =
            ::mmap(nullptr, kMore, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        return memory != MAP_FAILED;
    };
    // Whoever has the right to raise limits lifts them, unless it is taken away.
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> rights{};
    ASSERT_EQ(::syscall(SYS_capget, &header, rights.data()), 0);
    const bool mayLift = (rights[0].effective & (1U << CAP_SYS_RESOURCE)) != 0;
    EXPECT_EQ(inChild(
                  [&] {
                      MemoryLimit().setForever(kLimit);
                      return lifts();
                  },
                  nullptr),
              mayLift ? 0 : 1);
    // Not every machine gives that right to the superuser. Another one that is taken away with it:
    if ((rights[0].effective & (1U << CAP_IPC_LOCK)) != 0)
        isStopped("memory that stays in spite of a limit of 0", [] {
            static std::array<char, 8192> page;
            return ::syscall(SYS_mlock, page.data(), page.size()) == 0;  // sanitizers replace mlock()
        });
    WorkerOptions options;
    options.sandbox = &sandbox;
    options.memory = kLimit;
    const auto check = [&](const WorkerOptions& with) {
        std::string answers;
        runInWorkers(
            3, with, [&](std::size_t, const Step&) { return std::string(lifts() ? "lifted" : "kept"); },
            [&](std::size_t, const Outcome& outcome) { answers += outcome.answer + " "; },
            [](std::size_t, const std::string&) {});
        EXPECT_EQ(answers, "kept kept kept ");
    };
    check(options);
    // Also a piece that may take less than the one before it, or more.
    options.memoryOf = [](std::size_t piece) { return kLimit / (piece == 1 ? 1 : 2); };
    check(options);
}

TEST_F(Confined, PiecesWithOtherLimitsOfMemoryHaveTheirOwn) {
    WorkerOptions options;
    options.sandbox = &sandbox;
    options.memoryOf = [](std::size_t piece) { return std::uint64_t{64} << (20 + 2 * (piece % 2)); };
    std::string answers;
    runInWorkers(
        4, options,
        [](std::size_t, const Step&) {
            constexpr std::size_t kTaken = std::size_t{128} << 20;
            void* const memory =
                ::mmap(nullptr, kTaken, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
            return std::string(memory == MAP_FAILED ? "no " : "yes ");
        },
        [&](std::size_t, const Outcome& outcome) { answers += outcome.answer; },
        [](std::size_t, const std::string&) {});
    EXPECT_EQ(answers, "no yes no yes ");
}

TEST_F(Confined, WorkersAreConfinedBeforeTheirFirstPiece) {
    const WorkerOptions options{.workers = 2, .sandbox = &sandbox};
    std::vector<std::string> answers(4);
    runInWorkers(
        answers.size(), options,
        [&](std::size_t, const Step&) {
            return std::string(reads(root / "scene/a.frag") ? "own " : "") +
                   (reads("/etc/passwd") ? "other" : "");
        },
        [&](std::size_t index, const Outcome& outcome) { answers[index] = outcome.answer; },
        [](std::size_t, const std::string&) {});
    for (const std::string& each : answers) EXPECT_EQ(each, "own ");
}

/// Makes one system call fail with ENOSYS from now on, as on a kernel that does not have it.
void removeCall(long call) {
    sock_filter code[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    const sock_fprog program{std::size(code), code};
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
}

TEST_F(Confined, WhatTheKernelLacksIsNamed) {
    EXPECT_EQ(inChild(
                  [] {
                      removeCall(SYS_landlock_create_ruleset);
                      return missingForSandbox().find("Landlock") != std::string::npos &&
                             missingForSandbox().find("seccomp") == std::string::npos &&
                             !enterSandbox({}, {}).empty();
                  },
                  nullptr),
              0);
    EXPECT_EQ(inChild(
                  [] {
                      removeCall(SYS_seccomp);
                      return missingForSandbox().find("seccomp") != std::string::npos &&
                             missingForSandbox().find("Landlock") == std::string::npos &&
                             !enterSandbox({}, {}).empty();
                  },
                  nullptr),
              0);
}

}  // namespace
}  // namespace glibra::base
